// The questions of practice: the same at every visit, and what is right by other means is judged right.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import "../../page/src/check/scripts/jacobian.js";
import "../../page/src/check/scripts/motion.js";
import "../../page/src/check/scripts/table.js";
import { EMPTY, judge } from "../../page/src/check/question.js";
import { learn } from "../../judge/sentences.js";
import { fromLink } from "../../page/src/check/extras/practice.js";
import { tellingPose } from "../../page/src/check/extras/poses.js";
import { questionOf, rolls, TOPICS } from "../../page/src/check/extras/series.js";
import { linkFrames } from "../../judge/geometry/kinematics.js";
import { traceCircle } from "../../page/src/motion.js";

learn(JSON.parse(readFileSync(new URL("../../judge/sentences.json", import.meta.url), "utf8")));
const KEYS = { "Panda": "PANDA", "UR10e": "UR10E", "UR10e (homework)": "UR10E_HOMEWORK", "Stanford arm": "STANFORD", "Elbow arm": "ELBOW" }; // prettier-ignore
const LIST = JSON.parse(readFileSync(new URL("../../page/src/more/arms.json", import.meta.url), "utf8"));
const ARMS = LIST.filter(({ name }) => KEYS[name]).map((arm) => ({ ...arm, key: KEYS[arm.name], title: arm.name }));
const FEW = Array.from({ length: 12 }, (_, i) => i + 1);
const list = (text) => text.split(/[,\n]/).map(Number);
const graded = (asked, answer) => {
  const { report, error } = judge({ ...EMPTY, ...asked, answer }, ARMS);
  assert.equal(error, undefined);
  return report;
};
const lines = (rows) => rows.map((row) => row.join(", ")).join("\n");

// The energy of a wrench and the weight under a small turn of each joint; the tip's motion too.
function differences(arm, q, h = 1e-6) {
  return q.map((_, k) => {
    const at = (step) => linkFrames(arm, q.map((v, i) => (i === k ? v + step : v))); // prettier-ignore
    const [ahead, behind, here] = [at(h), at(-h), at(0)];
    const rate = (get) => get(ahead).map((v, i) => (v - get(behind)[i]) / (2 * h));
    const v = rate((T) => T.at(-1).o);
    const [x, y, z] = ["x", "y", "z"].map((axis) => rate((T) => T.at(-1)[axis]));
    const R = here.at(-1);
    const S = (i, j) => x[i] * R.x[j] + y[i] * R.y[j] + z[i] * R.z[j];
    const height = (T) => [arm.rows.reduce((sum, { body = [0, 0, 0, 0] }, i) => sum + 9.81 * body[0] * mass(T[i + 1], body), 0)];
    return { twist: [...v, S(2, 1), S(0, 2), S(1, 0)], lift: rate(height)[0] };
  });
}
const mass = ({ x, y, z, o }, [, a, b, c]) => o[2] + a * x[2] + b * y[2] + c * z[2];

test("a question is the same at every visit, and no two are alike", () => {
  for (const topic of TOPICS) {
    const seen = FEW.map((n) => JSON.stringify(questionOf(topic, n, ARMS).asked));
    assert.deepEqual(seen, FEW.map((n) => JSON.stringify(questionOf(topic, n, ARMS).asked))); // prettier-ignore
    assert.equal(new Set(seen).size, FEW.length);
  }
  const roll = rolls("jacobian 1");
  assert.deepEqual([roll(), roll(), roll()].map((x) => x.toFixed(6)), ROLLS);
});
const ROLLS = ["0.480089", "0.578025", "0.697135"]; // by the same recipe in Python

test("Jacobians and torques by differences are right", () => {
  for (const n of FEW) {
    const { asked, arm } = questionOf("jacobian", n, ARMS);
    const columns = differences(arm, list(asked.q)).map(({ twist }) => twist);
    const rows = [0, 1, 2, 3, 4, 5].map((i) => columns.map((c) => c[i].toFixed(4)));
    assert.equal(graded(asked, lines(rows)).grade, "right", JSON.stringify(asked));
    const pushed = questionOf("torques", n, ARMS);
    const wrench = list(pushed.asked.wrench);
    const torques = differences(pushed.arm, list(pushed.asked.q)).map(({ twist, lift }) =>
      twist.reduce((sum, v, i) => sum - v * wrench[i], lift),
    );
    assert.equal(graded(pushed.asked, torques.map((t) => t.toFixed(3)).join(", ")).grade, "right");
  }
});

test("targets can be reached, and a circle can be drawn", () => {
  for (const n of FEW) {
    const { asked } = questionOf("branches", n, ARMS);
    const found = graded(asked, JSON.stringify(ARMS.find(({ key }) => key === asked.arm).home.map(() => 0.1)));
    assert.ok(found.figures.of >= 1, JSON.stringify(asked));
    const one = questionOf("trace", n, ARMS);
    const normal = one.asked.plane === "zy" ? "x" : "y";
    const { path } = traceCircle(one.arm, list(one.asked.q), { normal, radius: Number(one.asked.radius), count: 121 });
    assert.equal(graded(one.asked, lines(path.map((q) => q.map((v) => v.toFixed(5))))).grade, "right", JSON.stringify(one.asked));
  }
});

test("a table is judged against the arm that its axes describe", () => {
  for (const n of FEW) {
    const { asked } = questionOf("table", n, ARMS);
    assert.equal(graded(asked, asked.table).grade, "right", asked.table);
    const wrong = asked.table.replace(/^(\S+), (\S+), /, (_, a, alpha) => `${Number(a) + 0.13}, ${alpha}, `);
    assert.equal(graded(asked, wrong).grade, "wrong");
  }
});

test("a link carries the number and the answer", () => {
  assert.deepEqual(fromLink("#practice=pose:17&answer=1%2C%202%0A3"), { topic: "pose", number: 17, answer: "1, 2\n3" });
  assert.deepEqual(fromLink("#practice=table:3"), { topic: "table", number: 3, answer: "" });
  for (const odd of ["#practice=sums:1", "#practice=pose:x", "#practice=pose:1&q=2", "#ask=pose"])
    assert.equal(fromLink(odd), null);
});

test("there is a pose that shows what home hides", () => {
  const arm = ARMS.find(({ key }) => key === "UR10E_HOMEWORK");
  const { q, hidden } = tellingPose({ ...EMPTY, ask: "jacobian", arm: arm.key }, ARMS, arm);
  assert.equal(hidden, 0);
  assert.equal(q.length, 6);
});
