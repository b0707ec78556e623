// Tables and the text around them, module by module: each spelling once, with the rows it means or the text that its refusal quotes.

import assert from "node:assert/strict";
import { test } from "node:test";
import { SpannedText } from "../../judge/reading/spans.js";
import { readTables } from "../../judge/reading/table.js";
import { listDefinitions } from "../../judge/reading/table_definitions.js";

const NAMES = ["a", "alpha", "d", "theta"];
const round = (x) => Number(x.toFixed(4)) || 0;

// Check the rows a, alpha, d, theta of a table, or a part of the message that refuses it.
function checkTable(text, expected, { values = [], ...options } = {}) {
  const read = () => readTables(text, options, values);
  if (typeof expected === "string") return assert.throws(read, (error) => error.message.includes(expected), `${text}\n${tryRead(read)}`);
  const [{ rows }] = read();
  assert.deepEqual(rows.map(({ numbers }) => NAMES.map((name) => round(numbers[name]))), expected, text);
}

function tryRead(read) {
  try {
    return JSON.stringify(read()[0].rows.map(({ numbers }) => numbers));
  } catch (error) {
    return error.message;
  }
}

// Each of these is also typed with a colon: l1: d_f + 0.1, d_f: 0.2.
const DEFINED_BY_BOTH_SIGNS = {
  "l₁ = 0.5": { l_1: 0.5 },
  "d_f = 0.1": { d_f: 0.1 },
  "l1 = d_f + 0.1, d_f = 0.2": { l1: 0.3, d_f: 0.2 },
  "l1 = 0.1 + d_f, d_f = 0.2": { l1: 0.3, d_f: 0.2 },
  "l1 = .5": { l1: 0.5 },
  "l1 = 0,5": { l1: 0.5 },
  "l1 = 0.1 + 0,5": { l1: 0.6 },
  "l1 = 0.1 + .5": { l1: 0.6 },
  "l1 = sqrt(.09)": { l1: 0.3 },
  "l1 = 50 cm": { l1: 0.5 },
  "l1 = 1,000.5": {},
};
const withColons = (text) =>
  text
    .split(", ")
    .map((definition) => definition.replace(" =", ":"))
    .join(", ");
const DEFINED = {
  "L₁₂ = l₁ + 0.1, l₁ = 0.4": { L_1_2: 0.5, l_1: 0.4 },
  "l1: l₂; l₂ = .4": { l1: 0.4, l_2: 0.4 },
  "l1: 0.5.": { l1: 0.5 },
  "l1 = 1e-1": { l1: 0.1 },
  "l1 = 0.2 + sqrt(0.09)": { l1: 0.5 },
  "l1: 0.2 + sqrt(.09)": { l1: 0.5 },
  "l1 = 0.2 + sqrt(.09) = 0.5": { l1: 0.5 },
  "l1: 0.2 + 0.3 = 0.5": { l1: 0.5 },
  "l1 = 0.1 + 0.2 = 0.3": { l1: 0.3 },
  "l1 = sqrt(0.09) = .3": { l1: 0.3 },
  "l1 = 0.3 = sqrt(.09)": { l1: 0.3 },
  "l1 = 0.3 = 0.2 + sqrt(0.01)": { l1: 0.3 },
  "l1 = 0.3 = 0.2 + .1": { l1: 0.3 },
  "l1 = 0.3 = 0,2 + 0,1": { l1: 0.3 },
  "l1 = 0.3 = 0,3": { l1: 0.3 },
  "l1 = 0.3 = 0.2 + l2, l2 = 0.1": { l1: 0.3, l2: 0.1 },
  "l1 = 0.2 + 0.3 = 0.6": {},
  "l1: sqrt(0.04) = 0,2": { l1: 0.2 },
  "l1: 0.2 = sqrt(.04)": { l1: 0.2 },
  "l1: 0.2 = .2": { l1: 0.2 },
  "l1: 0.2 = 0,1 + sqrt(0.01)": { l1: 0.2 },
  "l1: 0.2 = 0,1 + .1": { l1: 0.2 },
  "l1: 0.2 = 0.1 + 0,1": { l1: 0.2 },
  "l1: 0.2 = 0.1 + l2, l2: 0.1": { l1: 0.2, l2: 0.1 },
  "l1: 0.2 = 0.1 + l₂, l₂ = 0.1": { l1: 0.2, l_2: 0.1 },
  "l1: 0.2 = 0.1 + d_f, d_f = 0.1": { l1: 0.2, d_f: 0.1 },
  "l1 = 0.2 = 0.1 + l₂, l₂ = 0.1": { l1: 0.2, l_2: 0.1 },
  "l1 = 0.2 = 0.1 + d_f, d_f = 0.1": { l1: 0.2, d_f: 0.1 },
  "l1 = l2 = 0.5": { l1: 0.5, l2: 0.5 },
  "l₁ = l₂ = 0.5": { l_1: 0.5, l_2: 0.5 },
  "l1 = d_f = 0.5": { l1: 0.5, d_f: 0.5 },
  "l1 -> 500 mm": { l1: 0.5 },
  "l1: 0.5 m": { l1: 0.5 },
  "l1 = l2 m, l2 = 0.4": { l1: 0.4, l2: 0.4 },
  "l1 = l2 mm, l2 = 400 mm": { l2: 0.4 }, // l2 has a unit of its own
  "l1 = l_{2": {},
  "l1 = l_{2 mm": {},
  "l1 = 0.5 0.3": {},
  "l1 = 0.5 ^ 2": {},
  "l1 = 0.5 x 2": {},
  "l1: 1,000,5": {},
  "l1 = 0.1 + 1,000,5": {},
  "l1 = 0.5 (flange) + 0.1": {},
  "(l1, l2) = (0.5, .4)": { l1: 0.5, l2: 0.4 },
  "l₁, d_f = 0.5, 0.4": { l_1: 0.5, d_f: 0.4 },
  "d_f, l₁ = .5, 0.4": { d_f: 0.5, l_1: 0.4 },
  "l1, l2 = 0.5, 0.4 m": { l1: 0.5, l2: 0.4 },
  "l₁, l₂: 0.5": {},
  "l1, d_f: 0.5": {},
  "(l1, l2) = (0.5, 0.4, 0.3)": {},
  "(l1, l2) = (0.5, 0.4) * 2": {},
  "(l1, l2) = (500, 400) mm": {},
  "l1, l2 = 50, 40 [cm]": {},
  "l1, l2 = 0,5; 0,4": {},
  "l1, l2 = 0.5, 0.4 0.3": {},
  "l1, l2 = 0.5, 0.4 + 1": {},
  "l1, l2 = 0.5, 0.4 (flange) + 0.1": {},
  "l1, l2 = 0.5, 0.4.3": {},
  "l1, l2 = 0.5, 0.4°": {},
};

function checkLengths(text, expected) {
  const definitions = listDefinitions(new SpannedText(text));
  const entries = definitions.map(({ name, length }) => [name, round(length)]);
  assert.deepEqual(Object.fromEntries(entries), expected, text);
}

test("each spelling defines a length unless the text changes it", () => {
  for (const [text, expected] of Object.entries(DEFINED)) checkLengths(text, expected);
  for (const [text, expected] of Object.entries(DEFINED_BY_BOTH_SIGNS)) {
    checkLengths(text, expected);
    checkLengths(withColons(text), expected);
  }
});

const PLANAR_ROWS = [
  [0.5, 0, 0, 0],
  [0.4, 0, 0, 0],
];
const QUARTER = 1.5708;
const PRISMATIC = "i type a alpha d theta\n1 KIND1 0.5 0 0 q1\n2 KIND2 0.4 0 q2 0";
const WITH_TOOL =
  "i | a | alpha | d | theta\n1 | 0.5 | 0 | 0 | q1\n2 | 0.4 | 0 | 0 | q2\nTOOL | 0 | 0 | 0.1 | 0";
const PLANAR_LAYOUTS = [
  "# a alpha d theta\n0.5 0 0 q1\n0.4 0 0 q2",
  "% a alpha d theta\n0.5 0 0 q1\n0.4 0 0 q2",
  "// a alpha d theta\n0.5 0 0 q1\n0.4 0 0 q2",
  `"a","alpha","d","theta"\n"0.5","0","0","q1"\n"0.4","0","0","q2"`,
  "a alpha d theta\n0.5 0 0 \\theta_1^*\n0.4 0 0 \\theta_2^{*}",
  "a alpha d theta\n0.5 0 0 *\n0.4 0 0 *",
  "i a alpha d theta\njoint1 0.5 0 0 q1\njoint2 0.4 0 0 q2",
  "i a alpha d theta\nrow_1 0.5 0 0 q1\nrow_2 0.4 0 0 q2",
  "i a alpha d theta\nframe1 0.5 0 0 q1\nframe2 0.4 0 0 q2",
  "i | a | alpha | d | theta\n1 | 0.5 | | | q1\n2 | 0.4 | 0 | 0 | q2",
  "a_prev alpha_prev d theta\n0.5 0 0 q1\n0.4 0 0 q2",
  "aprev alphaprev d theta\n0.5 0 0 q1\n0.4 0 0 q2",
  "joint, a, alpha, d, theta\n0.5, 0, 0, q1\n0.4, 0, 0, q2",
  "q1 = 0.5, q2 = 0.4\na alpha d theta\n0.5 0 0 q1\n0.4 0 0 q2",
];

test("tables are read in each layout", () => {
  for (const text of PLANAR_LAYOUTS) checkTable(text, PLANAR_ROWS);
  for (const [revolute, prismatic] of [
    ["R", "P"],
    ["r", "p"],
    ["revolute", "prismatic"],
  ])
    checkTable(PRISMATIC.replace("KIND1", revolute).replace("KIND2", prismatic), PLANAR_ROWS);
  checkTable("i type a alpha d theta\n1 revolute 0.5 0 0 q1\n2 fixed 0.4 0 0 0", PLANAR_ROWS);
  for (const tool of ["T", "EE", "TCP", "flange", "tool"])
    checkTable(WITH_TOOL.replace("TOOL", tool), [...PLANAR_ROWS, [0, 0, 0.1, 0]]);
  checkTable("i a alpha d theta\nbase 0 0 0.3 0\n1 0.5 0 0 q1\n2 0.4 0 0 q2", [
    [0, 0, 0.3, 0],
    ...PLANAR_ROWS,
  ]);
  checkTable("a alpha d theta\n0.5 90 deg 0 q1\n0.4 0 deg 0 q2", [
    [0.5, QUARTER, 0, 0],
    [0.4, 0, 0, 0],
  ]);
  checkTable("a [mm] | 500 | 400\nalpha | 0 | 0\nd | 0 | 0\ntheta | q1 | q2", [
    [500, 0, 0, 0],
    [400, 0, 0, 0],
  ]);
});

test("offsets are added to joints; unlike rows are refused", () => {
  const write = (first, second) => `a | alpha | d | theta | offset\n${first}\n${second}`;
  checkTable(write("0.5 | 0 | 0 | q1 | -", "0.4 | 0 | 0 | q2 | pi/2"), [
    [0.5, 0, 0, 0],
    [0.4, 0, 0, QUARTER],
  ]);
  checkTable(write("0.5 | 0 | 0 | q1 | ", "0.4 | 0 | 0 | q2 | pi/2"), [
    [0.5, 0, 0, 0],
    [0.4, 0, 0, QUARTER],
  ]);
  checkTable(write("0.5 | 0 | 0 | q1 | 0", "0.4 | 0 | q2 | 0 | 0.1"), [
    [0.5, 0, 0, 0],
    [0.4, 0, 0.1, 0],
  ]);
  checkTable("0.5 π/2 0 q1\n0.4 0 0 q2", [
    [0.5, QUARTER, 0, 0],
    [0.4, 0, 0, 0],
  ]);
  checkTable("0.5 90° 0 q1\n0.4 0 0 q2", [
    [0.5, QUARTER, 0, 0],
    [0.4, 0, 0, 0],
  ]);
  checkTable("x, a, alpha, d, theta\n1, 0.5, 0, 0\n2, 0.4, 0, 0", "5 column headers");
  checkTable("0.5 0 0 q1 1 2\n0.4 0 0 q2 3 4", "have 6 entries");
});
