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

const PLANAR = "a alpha d theta\n0.5 0 0 q1\n0.4 0 0 q2";
const PLANAR_ROWS = [
  [0.5, 0, 0, 0],
  [0.4, 0, 0, 0],
];
const QUARTER = 1.5708;
const CHANGES = [
  "theta_1 = q_1 + pi/2",
  "theta_2 = q_2 - 90",
  "th2 = q2 + 90",
  "phi2 = q2 - 90",
  "q2 = th2 + 90",
  "theta_2 = phi_2 + .5",
  "theta2 = q2 + .5",
  "phi2 = phi2 + pi",
  "theta_2 = 90 - q_2",
  "q2 = pi - q2",
  "theta2 = pi/2 - th2",
  "theta2 = pi - phi2",
  "phi2 = .5 - q2",
  "#2 theta_2 = q_2 - 90",
  "q2: offset of pi/2",
  "theta2 has an offset of 90",
  "phi2: an offset of .5",
  "offset of theta2: 90",
  "offset for phi_2",
  "offset for q2: 90",
  "L(2).offset = pi/6",
  "L3.a = 0.35",
  "L3.d = 0.35",
  "L3.alpha = pi/2",
  "L3.theta = 1",
  "r.tool = transl(0, 0, 0.1)",
  "r.base = trotx(pi)",
  "L3.alpha = π/2",
  "a(2) = 0.45",
  "r(2) = 0.45",
  "d(2) = 0.45",
  "alpha[2] = pi/2",
  "theta(2) = π/2",
  "offset(2) = 1",
  "tool: 0.1",
  "base: 0.1",
  "tool = 100 mm",
  "tool: transl(0, 0, 1)",
  "base = SE3(0, 0, 1)",
  "tool: 0 0 1",
  "the base is 300 mm high",
  "the floor is 0.3 m below",
  "flip = True",
  "flip = true",
  "flip=1",
  "correction: a2 = 0.45",
  "corrected: a2 = 0.45",
  "erratum: a2 = 0.45",
  "lengths are halved",
  "row 2 is wrong",
];
const NO_CHANGES = [
  "theta_9 = q_9 + 90",
  "r.offset = [0 0]",
  "a[2] == 0.45",
  "tool: 0, 0, 0",
  "tool: 0",
  "flip = 0",
  "the tool is 0 mm away",
  "% theta_2 = q_2 - 90",
  "# theta_2 = q_2 - 90",
  "// theta_2 = q_2 - 90",
];

test("a line that changes a table is refused", () => {
  for (const text of CHANGES) checkTable(`${PLANAR}\n${text}`, `line 4 '${text}' seems to change`);
  for (const text of NO_CHANGES) checkTable(`${PLANAR}\n${text}`, PLANAR_ROWS);
  checkTable(`${PLANAR} - pi/2\ntheta_2 = q_2 - pi/2`, [
    [0.5, 0, 0, 0],
    [0.4, 0, 0, -QUARTER],
  ]);
  checkTable(
    `${PLANAR} - pi/2\ntheta_1 = q_1 - pi/2`,
    "line 4 'theta_1 = q_1 - pi/2' seems to change",
  );
});

test("a note that changes a row's entries is refused", () => {
  for (const note of ["offset 90", "plus 90", "minus 90", "should be 0.5"])
    checkTable(`${PLANAR} ${note}`, `line 3 '0.4 0 0 q2 ${note}' seems to change`);
  checkTable(`${PLANAR} offset 0`, PLANAR_ROWS);
  for (const note of ["theta is q2 + 90", "theta is phi_2 - pi", "theta is th2 - .5"])
    checkTable(
      `| a | alpha | d | theta | note |\n| 0.5 | 0 | 0 | q1 | |\n| 0.4 | 0 | 0 | q2 | ${note} |`,
      "seems to change",
    );
});

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
