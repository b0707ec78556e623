// Tests the words that contradict the numbers beside them, each once.

import assert from "node:assert/strict";
import { test } from "node:test";
import { refuseContraryDefinitions, refuseContraryWords } from "../../judge/reading/contradictions.js";

const HALF = "0.1 0.2 0.3\n0.4 0.5 0.6\n0.7 0.8 0.9";

// Return whether the words in a text with a Jacobian of three joints contradict its numbers.
function isContrary(text, options = {}) {
  const tokens = [...text.matchAll(/\d\.\d/g)].map(({ index }, k) => ({
    ...{ owner: "entry", index: k, column: k % 3, from: index, to: index + 3 },
  }));
  const typed = { tokens, shape: [6, 3], taken: [] };
  return throws(() => refuseContraryWords(text, { topic: "Jacobian", typed }, options));
}

function throws(run) {
  try {
    run();
    return false;
  } catch (error) {
    assert.equal(error.constructor.name, "ArmError", error.stack);
    return true;
  }
}

const around = (words) => `${words}\n${HALF}\n${HALF}`;
const assertContrary = (all) => all.forEach((words) => assert.ok(isContrary(around(words)), words));
const assertHarmless = (all) => all.forEach((words) => assert.ok(!isContrary(around(words)), words));

test("joints that are counted from the tip", () => {
  assertContrary(["counted", "numbered", "listed", "ordered", "starting", "beginning", "order"].map((verb) => `joints ${verb} from the tool`));
  assertContrary(["tip", "wrist", "hand", "end-effector", "end effector", "endeffector", "flange", "gripper", "last joint"].map((tip) => `counted from ${tip}`));
  assertContrary(["tool -> base", "tool → base", "tool .. base", "tool … base", "wrist 3 -> base", "last joint first"]);
  assertHarmless(["counted from the base", "base -> tool", "from tool to base"]);
});

test("columns in a different order of the joints", () => {
  assertContrary(["columns: q3 q2 q1", "column q3, q2", "order: θ3; θ2", "Spalten q_3|q_2", "columns q3 & q1 & q2"]);
  assertHarmless(["columns: q1 q2 q3", "q3 q2 q1", "columns"]);
});

test("rows in the frame of the tool", () => {
  assertContrary(["in", "in the", "into", "to the", "wrt", "w.r.t. the"].map((where) => `J ${where} tool frame`));
  assertContrary(["tip", "end-effector", "end effector", "ee", "body", "hand", "flange", "tool's"].map((tip) => `in ${tip} axes`));
  assertContrary(["(tool coordinates)", "(4 digits, tool frame)"]);
  assertHarmless(["the velocity of the tool frame", "in the base frame, of the tool", "in tool axes, world", "in tool axes, space", "in tool axes, frame 0"]);
  assert.ok(!isContrary(around("in tool axes"), { frame: 3 }));
});

const LINEAR = ["J_v", "Jp", "J_{v}", "v", "linear", "linear part", "linear rows", "translation", "translational part"];
const ANGULAR = ["J_w", "Jω", "J_omega", "J_\\omega", "w", "ω", "omega", "\\omega", "angular", "angular rows", "rotation", "rotational part"];

test("halves that the words exchange", () => {
  assertContrary(LINEAR.map((linear) => `angular above ${linear}`));
  assertContrary(ANGULAR.map((angular) => `${angular} above v`));
  assertContrary(["over", "on top of", "before", "above the", ";"].map((above) => `ω ${above} v`));
  assertContrary(["[ω, v]", "(ω, v)"]);
  assertHarmless(["v above ω", "[v, ω]", "ω and v"]);
  assert.ok(isContrary(around("v above ω"), { angularFirst: true }));
  assert.ok(!isContrary(around("ω above v"), { angularFirst: true }));
});

test("a name above each half", () => {
  assert.ok(isContrary(`J_w\n${HALF}\nJ_v\n${HALF}`));
  assert.ok(!isContrary(`J_v\n${HALF}\nJ_w\n${HALF}`));
  assert.ok(!isContrary(`J_w\n${HALF}\nthen\n${HALF}`));
});

test("the name of a transposed Jacobian", () => {
  assertContrary(["J^T =", "J^{T} =", "J^\\top:", "J^{\\top} =", "Jᵀ =", "J.T =", "J_b^T(q) ="]);
  assertHarmless(["J =", "tau = J^T F", "J^T follows"]);
});

test("a symbol with a different value than in the question", () => {
  const meanings = new Map([["c23", Math.cos(0.3)], ["a2", 0.4]]);
  const known = () => new Map([["q2", 0.7], ["q3", -0.4]]);
  const isContraryDefinition = (text) => throws(() => refuseContraryDefinitions(text, meanings, known));
  for (const text of ["c23 = cos(q2 - q3)", "c_23 := sin(q2 + q3)", "a2 = 0.45", "a_{2} = .45"]) assert.ok(isContraryDefinition(text), text);
  for (const text of ["c23 = cos(q2 + q3)", "a2 = 0.4", "a2 = 0.45 mm", "a2 = 0.8/2", "b2 = 0.45", "a2 = 0.4e0"]) assert.ok(!isContraryDefinition(text), text);
});
