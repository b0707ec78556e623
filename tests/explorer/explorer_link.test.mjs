// Links from a verdict to the explorer: they show the mistake beside the right arm, at a
// configuration with a large difference.

import assert from "node:assert/strict";
import { test } from "node:test";
import { linkFrames, minus, norm } from "../../judge/geometry/kinematics.js";
import { findLargestDifference, makeConfigurationLink, makeMistakeLink } from "../../page/src/check/explorer_link.js";
import { EMPTY, judgeQuestion } from "../../page/src/check/question.js";
import { simulateCircle } from "../../page/src/homework_run.js";
import { parseFragment } from "../../page/src/link.js";
import { ELBOW, PANDA } from "./arms.mjs";

const listed = (arm, more) => ({ ...arm, key: arm.name, title: arm.name, explorer: arm.name, ...more });
const LOCKED = listed(
  { ...PANDA, rows: PANDA.rows.map((row, i) => (i === 2 ? { ...row, kind: "fixed" } : row)) },
  { key: "locked", locked: 3 },
);
const LIST = [listed(ELBOW), listed(PANDA), LOCKED];
const read = (fragment) => parseFragment(fragment, [PANDA, ELBOW], ["table", "jacobian", "torque", "homework"]);
const ask = (answer, more = {}) => {
  const question = { ...EMPTY, ask: "table", arm: "Elbow arm", answer, ...more };
  return [question, judgeQuestion(question, LIST), LIST];
};
const change = (arm, i, entries) => ({ ...arm, rows: arm.rows.map((row, k) => (k === i ? { ...row, ...entries } : row)) });
const measureGap = (arm, other, q) => norm(minus(...[arm, other].map((one) => linkFrames(one, q).at(-1).o)));

test("a wrong length of 0.1 m gives a distance of 0.1 m", () => {
  const { q } = findLargestDifference(change(ELBOW, 2, { a: 0.2 }), ELBOW);
  assert.ok(Math.abs(measureGap(change(ELBOW, 2, { a: 0.2 }), ELBOW, q) - 0.1) < 1e-12);
});

test("a quarter turn of the shoulder is shown with the arm nearly stretched", () => {
  const wrong = change(ELBOW, 1, { theta: Math.PI / 2 });
  const { q } = findLargestDifference(wrong, ELBOW);
  const largest = 0.7 * Math.SQRT2; // chord of a quarter circle with the stretched arm's radius
  assert.ok(measureGap(wrong, ELBOW, q) > 0.97 * largest, String(measureGap(wrong, ELBOW, q)));
});

test("the chosen configuration is within the limits of the right arm", () => {
  const { q } = findLargestDifference(change(PANDA, 1, { alpha: 0 }), PANDA);
  q.forEach((value, k) => assert.ok(value >= PANDA.rows[k].lower && value <= PANDA.rows[k].upper));
});

test("a wrong table is linked with its rows and the right arm as the ghost", () => {
  const { patch, message } = read(makeMistakeLink(...ask("a alpha d theta\n0 pi/2 0.5 q1\n0.4 0 0 q2\n0.2 0 0 q3")));
  assert.equal(message, "");
  assert.deepEqual([patch.arm.rows.map(({ a }) => a), patch.reference, patch.view], [[0, 0.4, 0.2], ELBOW, "table"]);
});

test("a right table and a table of other joints have no link", () => {
  assert.equal(makeMistakeLink(...ask("a alpha d theta\n0 pi/2 0.5 q1\n0.4 0 0 q2\n0.3 0 0 q3")), "");
  assert.equal(makeMistakeLink(...ask("a alpha d theta\n0 pi/2 0.5 q1\n0.2 0 0 q2")), "");
});

test("a locked joint stands at 0 in the explorer's arm", () => {
  const q = "0.4, -0.6, 1.9, 0.3, 1.8, 0.7";
  const { patch, message } = read(makeConfigurationLink(...ask("1", { ask: "jacobian", arm: "locked", q })));
  assert.equal(message, "");
  assert.deepEqual(patch.q, [0.4, -0.6, 0, 1.9, 0.3, 1.8, 0.7]);
  const rows = PANDA.rows.map(({ a, alpha, d }, i) => `${a} ${alpha} ${i ? d : 0.4} ${i === 2 ? 0 : `q${i + 1}`}`);
  const shown = read(makeMistakeLink(...ask(`a alpha d theta\n${rows.join("\n")}`, { arm: "locked" })));
  assert.equal(shown.message, "");
  assert.deepEqual(shown.patch.arm.rows.map(({ kind }) => kind), Array(7).fill("revolute"));
});

// The elbow arm's Jacobian at q = 0 by hand: the arm is stretched and 0.7 m long.
const STRETCHED = "0 0 0\n0.7000 0 0\n0 0.7000 0.3000\n0 0 0\n0 -1 -1\n1 0 0";

test("a wrong Jacobian is linked with its numbers, in the order of the explorer", () => {
  const wrong = STRETCHED.replace("0.3000", "0.4520");
  const [v, omega] = [wrong.split("\n").slice(0, 3), wrong.split("\n").slice(3)];
  for (const [answer, first] of [[wrong, "v"], [[...omega, ...v].join("\n"), "omega"]]) {
    const { patch, message } = read(makeMistakeLink(...ask(answer, { ask: "jacobian", q: "0, 0, 0", first })));
    assert.equal(message, "");
    assert.equal(patch.view, "jacobian");
    assert.deepEqual(patch.answer, wrong.split(/\s+/).map(Number));
  }
  assert.equal(makeMistakeLink(...ask(STRETCHED, { ask: "jacobian", q: "0, 0, 0" })), "");
});

test("wrong formulas are shown where they are wrong", () => {
  const formulas = `-s_1*(a_2*c_2+a_3*c_23), -c_1*(a_2*s_2+a_3*s_23), -a_3*c_1*s_23
  c_1*(a_2*c_2+a_3*c_23), 0, 0
  0, a_2*c_2+a_3*c_23, a_3*c_23\n0, s_1, s_1\n0, -c_1, -c_1\n1, 0, 0`; // two terms with s_1 are missing, which are 0 at q = 0
  const values = { ask: "jacobian", q: "0, 0, 0", values: "a_2 = 0.4, a_3 = 0.3" };
  const { patch } = read(makeMistakeLink(...ask(formulas, values)));
  assert.ok(Math.abs(Math.sin(patch.q[0])) > 0.1, String(patch.q));
});

test("wrong torques are linked with their numbers and the wrench", () => {
  const bodies = { ...ELBOW, rows: ELBOW.rows.map((row) => ({ ...row, body: [1, 0, 0, 0] })) };
  const question = { ...EMPTY, ask: "torques", arm: "Elbow arm", q: "0, 0, 0", wrench: "0, 0, -10, 0, 0, 0", answer: "1 2 3" };
  const list = [listed(bodies)];
  const { patch } = read(makeMistakeLink(question, judgeQuestion(question, list), list));
  assert.deepEqual([patch.view, patch.answer, patch.wrench], ["torque", [1, 2, 3], [0, 0, -10, 0, 0, 0]]);
});

test("a run with a known mistake is linked beside the right run, from the same start", () => {
  const q = [0.4, -0.6, 0, 1.9, 0.3, 1.8, 0.7];
  const free = (row) => row.filter((_, i) => i !== 2).join(" ");
  const askRun = (mistake, more = {}) => {
    const settings = { radius: 0.05, seconds: 5, steps: 100, locked: 2, rates: "pseudo", cutoff: 1e-3 };
    const run = simulateCircle(PANDA, q, { ...settings, mistake });
    const fields = { radius: "0.05", period: "5", steps: "100", arm: "locked", q: free(q) };
    return ask(run.path.map(free).join("\n"), { ask: "trace", ...fields, ...more });
  };
  for (const mistake of ["next", "angular", "o_i", "sign"]) {
    const { patch, message } = read(makeMistakeLink(...askRun(mistake)));
    assert.equal(message, "");
    assert.deepEqual([patch.view, patch.q], ["homework", q]);
    const shown = patch.runs.map((run) => [run.mistake, run.radius, run.seconds, run.steps, run.normal, run.locked]);
    assert.deepEqual(shown, ["", mistake].map((name) => [name, 0.05, 5, 100, "x", 2]));
  }
  assert.equal(makeMistakeLink(...askRun("")), "");
  assert.equal(makeMistakeLink(...askRun("next", { plane: "yz" })), ""); // the explorer has no such circle
});
