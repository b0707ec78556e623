// Joint vectors in the layouts in which programs and people write them: each layout once, with its values or null if it is refused.

import assert from "node:assert/strict";
import { test } from "node:test";
import { numbers, readConfiguration } from "../../judge/reading/numbers.js";
import { readJointVectors } from "../../judge/reading/joint_vectors.js";
import { readSymbolValues } from "../../judge/reading/values.js";

const KINDS = { R: "revolute", P: "prismatic", F: "fixed" };
const makeArm = (kinds) => ({ name: "arm", rows: [...kinds].map((letter) => ({ kind: KINDS[letter] })) });
const A = [0.1, 0.2, 0.3];
const B = [0.4, 0.5, 0.6];
const TURNS = [0.183, 0.358, 0.532]; // 10.5, 20.5 and 30.5 degrees
const EACH = "one answer in each column";
const LOCKED = "all joints; 2 is locked, so its 0 is set aside";

function checkVectors(text, expected, { kinds = "RRR", taken, ...options } = {}) {
  const read = () => readJointVectors(text, makeArm(kinds), options.angles ?? "rad", options);
  if (!expected) return assert.throws(read, /expected|several answers|two values|no list/, JSON.stringify(text));
  const { answers, taken: notes } = read();
  const rounded = answers.map(({ values }) => values.map((x) => Number(x.toFixed(3))));
  assert.deepEqual(rounded, expected, JSON.stringify(text));
  if (taken) assert.deepEqual(notes, taken, JSON.stringify(text));
}
const checkAll = (cases) => cases.forEach((each) => checkVectors(...each));

test("numbers that count joints or solutions are no values", () => {
  const series = Array.from({ length: 10 }, (_, k) => Number((0.9 - 0.07 * k).toFixed(2)));
  const two = { kinds: "RR" };
  checkAll([
    ["1 2 3\n0.1 0.2 0.3\n0.4 0.5 0.6", [A, B]],
    ["1 2 3\n10 20 30", [[1, 2, 3], [10, 20, 30]]], // whole numbers may be values
    ["1. 2. 3.\n0.1 0.2 0.3", [A]],
    ["1 2 4\n0.1 0.2 0.3\n0.4 0.5 0.6", [A, B]], // the moving joints of four
    ["2 1 3\n0.1 0.2 0.3", [[2, 1, 3], A]],
    ["0 1 2\n0.1 0.2 0.3", [A]],
    [`1 2 3 4 5 6 7 8 9 10\n${series.join(" ")}\n${series.join(" ")}`, series.map((x) => [x, x]), two],
    ["(1) 0.1 0.2 0.3\n(2) 0.4 0.5 0.6", [A, B]],
    ["1\n0.1\n2\n0.2\n3\n0.3", [A]],
    ["1\n2\n3\n0.1\n0.2\n0.3", [A]],
    ["1\n10\n2\n20\n3\n30", null],
    ["1\n0.5\n2\n0.25\n3", null, two],
    ["1\n0.5", [[1], [0.5]], { kinds: "R" }],
    ["1\n0.5\n0.7", null, two],
    ["1 0.1 0.2\n2 0.4 0.5", [[0.1, 0.2], [0.4, 0.5]], two],
    ["a 0.1 0.2\nb 0.4 0.5", [[0.1, 0.2], [0.4, 0.5]], two],
    ["q1 0.1 0.2\nq2 0.4 0.5", [[0.1, 0.4], [0.2, 0.5]], two],
    ["0 0.0 0.3 0.2\n1 0.2 0.3 0.4\n2 0.4 0.5 0.6\n3 0.6 0.1 0.2", [[0.3, 0.2], [0.3, 0.4], [0.5, 0.6], [0.1, 0.2]], two],
  ]);
});

test("a column of equal steps holds times", () => {
  const [two, rest] = [{ kinds: "RR" }, [[0.3, 0.2], [0.3, 0.4], [0.5, 0.6], [0.1, 0.2]]];
  const write = (times) => times.split(" ").map((time, k) => `${time} ${rest[k].join(" ")}`).join("\n");
  checkAll([
    [write("0.1 0.3 0.5 0.7"), rest, two],
    [write("0.00 0.33 0.67 1.00"), rest, two],
    [write("0.1 0.3 0.9 1.0"), null, two],
    [write("0.5 0.5 0.5 0.5"), null, two],
    [write("4 3 2 1"), null, two],
    [write("0.1 0.3 0.5"), null, two], // three numbers may have equal steps by chance
  ]);
});

test("columns of a table are chosen by their headers", () => {
  checkAll([
    ["joint q qd\n1 0.1 5.5\n2 0.2 6.5\n3 0.3 7.5", [A]],
    ["joint  q0   q\n1 5.5 0.1\n2 6.5 0.2\n3 7.5 0.3", [A]],
    ["the q values\n0.1 0.2 0.3\n0.4 0.5 0.6\n0.7 0.8 0.9", [A, B, [0.7, 0.8, 0.9]]], // a title
    ["i q_(deg) tau\n1 10.5 5.5\n2 20.5 6.5\n3 30.5 7.5", [TURNS]],
    ["i $q$ tau\n1 0.1 5.5\n2 0.2 6.5\n3 0.3 7.5", [A]],
    ["i q err note\n1 0.1 5.5 up\n2 0.2 6.5 up\n3 0.3 7.5 up", [A]],
    ["q_old q_new e f\n0.1 5.5 0.7 1.5\n0.2 6.5 0.8 1.5\n0.3 7.5 0.9 1.5", null], // either may be meant
    ["theta_{i} d_{i}\n0.1 5.5\n0.2 6.5\n0.3 7.5", [A]],
    ["i angle force\n1 0.1 5.5\n2 0.2 6.5\n3 0.3 7.5", [A]],
    ["deg N\n1 10.5 0.1\n2 20.5 0.3\n3 30.5 0.5", [TURNS]],
    ["i deg rad\n1 10.50 0.1833\n2 20.50 0.3578\n3 30.50 0.5323", [TURNS]],
    ["n q1 q2 q3 err\n1 0.1 0.2 0.3 0.01\n2 0.4 0.5 0.6 0.02", [A, B]],
    ["q1 q2 q3 err\n1 0.1 0.2 0.3 0.01\n2 0.4 0.5 0.6 0.02", [A, B]],
    ["q1 q2 q3 err branch\n0.1 0.2 0.3 0.01 up\n0.4 0.5 0.6 0.02 down", [A, B]],
    ["q1 q2 q3 q1 q2 q3\n0.1 0.2 0.3 0.4 0.5 0.6", null],
    ["q1 q2 q3 x1 x2 x3\n0.1 0.2 0.3 0.4 0.5 0.6\n0.4 0.5 0.6 0.4 0.5 0.7", [A, B]],
    ["q1_deg q2_deg q3_deg q1_rad q2_rad q3_rad\n10.50 20.50 30.50 0.1833 0.3578 0.5323", [TURNS]],
    ["q3 q2 q1 err\n0.3 0.2 0.1 1.5\n0.6 0.5 0.4 1.5", [A, B]],
  ]);
  const wants = [{ rows: 3, columns: 1 }];
  assert.throws(() => numbers("i deg N\n1 1.5 5\n2 2.5 6\n3 3.5 7", "tau", undefined, undefined, { wants, names: /^tau/ }), /expected/);
});

test("values with names of joints are a vector", () => {
  const [last, first] = [{ kinds: "RRP" }, { kinds: "PRR" }];
  checkAll([
    ["q1 = 0.1\nq2 = 0.2\nq3 = 0.3\nq1 = 0.4\nq2 = 0.5\nq3 = 0.6", [A, B]],
    ["q1 = 0.1\nq2 = 0.2\nq3 = 0.3\nq1 = 0.4\nq2 = 0.5", null],
    ["q1 = 0.1\nerror = 0.7\nq2 = 0.2\nq3 = 0.3", [A]],
    ["q1 = 0.1\nq2 = 0.2\nd3 = 0.3", [A], last],
    ["d1 = 0.1\nq2 = 0.2\nq3 = 0.3", [A], first],
    ["d1 = 0.7\nq1 = 0.1\nq2 = 0.2\nq3 = 0.3", [A]], // a length
    ["q1 = 0.1\nq2 = 0.2\nq3 = 0.3\nd5 = 0.7", [A]],
  ]);
});

test("tables with one cell a line are read", () => {
  const rows = "up\n0.1\n0.2\n0.3\ndown\n0.4\n0.5\n0.6";
  checkAll([
    [`q1\nq2\nq3\n${rows}`, [A, B]],
    [`a title\n\njoint\nq3\nq2\nq1\n${rows}`, [[...A].reverse(), [...B].reverse()]],
    ["no\nq1\nq2\nq3\n1\n0.1\n0.2\n0.3\n2\n0.4\n0.5\n0.6", [A, B]],
    ["q1\nq2\nq3\n1\n0.1\n0.2\n0.3\n2\n0.4\n0.5\n0.6", [A, B]],
    ["q1\nq2\nq3\n2\n0.1\n0.2\n0.3\n1\n0.4\n0.5\n0.6", null],
    ["q1\nq2\nq3\n1\n0.1\n0.2\n0.3\n2\n0.4\n0.5", null],
    ["q1\nq2\nq3\nup\n0.1\n0.2\n0.3\ndown\n0.4\n0.5", null],
    ["up\n0.1\n0.2\n\n0.3\ndown\n0.4\n0.5\n0.6", null],
  ]);
});

test("single values with two indices are a matrix", () => {
  const read = (text, rows) =>
    numbers(text, "J", undefined, undefined, { wants: [{ rows, columns: 2 }] }).values;
  assert.deepEqual(
    read("J[1,1] = 0.5\nJ[1,2] = 0.6\nJ[2,1] = 0.7\nJ[2,2] = 0.8", 2),
    [0.5, 0.6, 0.7, 0.8],
  );
  assert.deepEqual(read("J(0,1) = 0.5\nJ(0,0) = 0.6", 1), [0.6, 0.5]);
  for (const last of ["", "\nJ[2,1] = 0.8"])
    // an entry is missing, and twice there
    assert.throws(() => read(`J[1,1] = 0.5\nJ[1,2] = 0.6\nJ[2,1] = 0.7${last}`, 2), /expected/);
});

test("a value in radians and degrees is one value", () => {
  const [turned, other] = [[0.5, 0.2, 0.3], ", 0.2 rad, 0.3 rad"];
  const pairs = [
    "0.500 rad (28.65°)",
    "0.500 (28.65°)",
    "0.500 rad = 28.65°",
    "0.500 radians ≈ 28.65 deg",
    "28.65° (0.500 rad)",
    "28.65° = 0.500 rad",
    "28.65 degrees / 0.500 rad",
    String.raw`0.500 rad [ = 28.65^\circ ]`,
    String.raw`0.500\,rad\;(28.65^{\circ})`,
  ];
  for (const pair of pairs) checkVectors(pair + other, [turned]);
  checkVectors("0,500 rad (28,65°); 0,2 rad; 0,3 rad", [turned]);
  checkVectors(`0.500 rad (29.65°)${other}`, null);
  checkVectors(`2(45°)${other}`, [[1.571, 0.2, 0.3]]);
});

test("a joint vector is a row or a column", () => {
  const locked = { kinds: "RFR", taken: [LOCKED] };
  checkAll([
    [A, [A]],
    [[[0.1], [0.2], [0.3]], [A], { taken: [] }],
    [[[A], [B]], [A, B]],
    [[[0.1, 0.4], [0.2, 0.5], [0.3, 0.6]], [A, B], { taken: [EACH] }],
    [[A, B, A], [A, B, A]],
    [[[0.1, 0.4, 0.7], [0.2, 0.5, 0.8], [0.3, 0.6, 0.9]], [A, B, [0.7, 0.8, 0.9]], { byColumns: true }],
    [[[0.1], [0.2], [0.3], [0.4], [0.5], [0.6]], [A, B]],
    [[], []],
    [[0.1, 0.2], null],
    [[[0.1], [0.2], [0.3], [0.4]], null],
    [Array(2).fill([[0.1, 0.4], [0.2, 0.5], [0.3, 0.6]]), null],
    [[A, B], [A, B], { byColumns: true }],
    [[A, [0.4]], null],
    [[0.1, null, 0.3], null],
    [[{ odd: "None" }, 0.2, 0.3], null],
    [[["q1", 0.1], ["q2", 0.2], ["q3", 0.3]], [A]],
    [["1/10", { tree: ["num", 0.2] }, "pi"], [[0.1, 0.2, 3.142]]],
    [[0.1, 0, 0.3], [[0.1, 0.3]], locked],
    [[[0.1, 0, 0.3], [0.4, 0, 0.6]], [[0.1, 0.3], [0.4, 0.6]], locked],
    [[[0.1, 0, 0.3], [0.4, 0, 0.6], [0.7, 0, 0.9]], [[0.1, 0.3], [0.4, 0.6], [0.7, 0.9]], locked],
    [[[0.1, 0.4], [0.3, 0.6]], [[0.1, 0.3], [0.4, 0.6]], { kinds: "RFR", byColumns: true }],
    [[[0.1, 0.4, 0.7], [0.3, 0.6, 0.9]], [[0.1, 0.3], [0.4, 0.6], [0.7, 0.9]], { kinds: "RFR", taken: [EACH] }],
  ]);
});

test("a stated unit applies to values without one", () => {
  const slide = { kinds: "RRP" };
  const turned = [0.183, 0.358, 0.4];
  checkAll([
    ["0.1 0.2 300 mm", [A], { ...slide, taken: [] }],
    ["q1, q2 (rad), d3 (mm)\n0.1 0.2 300", [A], { ...slide, taken: ["lengths in mm"] }],
    ["q [deg], d [cm]\n10.5 20.5 40", [turned], { ...slide, taken: ["angles in degrees", "lengths in cm"] }],
    ["10.5 20.5 0.4", [turned], { ...slide, angles: "deg", taken: [] }],
    ["10.5° 20.5° 0.4", [turned], slide],
    ["q [rad]: 0.1 0.2 0.3", [A], { angles: "deg", taken: ["angles in radians"] }],
    ["q [deg]: 10.5 20.5 30.5", [TURNS], { angles: "deg", taken: [] }],
    ["q [mm]: 0.1 0.2 0.3", [A], { taken: [] }],
  ]);
  const { answers } = readJointVectors("10.5° 20.55° 0.4", makeArm("RRP"), "rad");
  assert.deepEqual(answers[0].units.map((unit) => Number(unit.toPrecision(3))), [0.00175, 0.000175, 0.1]);
});

test("a configuration is one vector", () => {
  const read = (q, kinds, angles) => readConfiguration(q, makeArm(kinds), angles);
  for (const q of [A, [A], [[0.1], [0.2], [0.3]], "0.1 0.2 0.3"]) assert.deepEqual(read(q, "RRR").values, A);
  for (const q of [[0.1, 0, 0.3], "0.1 0 0.3"]) assert.deepEqual(read(q, "RFR"), { ...read(q, "RFR"), values: [0.1, 0.3], locked: [LOCKED] });
  assert.deepEqual(read([0.1, 0.3], "RFR").values, [0.1, 0.3]);
  assert.match(read([0.1, 1, 2, 3, 4, 0.3], "RFFFFR").locked[0], /2, 3, 4 and 5 .* 1, 2, 3, … /);
  assert.equal(read("90", "R", "deg").values[0], Math.PI / 2);
  for (const [q, kinds] of [[[...A, 0.4], "RRR"], [[0.1, 0.2], "RRR"], [[[0.1, 0, 0.3], [0.1, 0, 0.3]], "RFR"]])
    assert.throws(() => read(q, kinds), /expected one value for each of q_1/);
  for (const name of ["q", "th", "θ", "sol", "position", "ans", "s", "s1"])
    assert.deepEqual(read(`x = 0.4 0.5 0.6\n${name} = 0.1 0.2 0.3`, "RRR").values, A, name);
});

test("names and their numbers are read", () => {
  const values = {
    "h = 0.5, phi_0 = 1/4": [["h", 0.5], ["phi_0", 0.25]],
    "{'h': 0.5, \"L_1\": 2}": [["h", 0.5], ["L_1", 2]],
    "a=1; b=2\nc: 3,": [["a", 1], ["b", 2], ["c", 3]],
    "": [],
  };
  for (const [text, expected] of Object.entries(values)) assert.deepEqual(readSymbolValues(text), expected);
  for (const text of ["h", "h =", "h = x", "h = 1 = 2", "1h = 2", "h = 1/0"]) assert.throws(() => readSymbolValues(text), /is not read/, text);
});
