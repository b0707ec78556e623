// The chapters' closed forms against the solver by structure, which is independent of them.

import assert from "node:assert/strict";
import { test } from "node:test";
import { findClosedForm, needsPose, solveInverse } from "../../judge/geometry/inverse.js";
import { solveByStructure } from "../../judge/geometry/inverse_structure.js";
import { linkFrames } from "../../judge/geometry/kinematics.js";
import { ELBOW, STANFORD } from "./arms.mjs";

const WRIST = {
  ...STANFORD,
  name: "elbow with a wrist",
  rows: [
    ...ELBOW.rows.slice(0, 2),
    { ...ELBOW.rows[2], a: 0.1, alpha: Math.PI / 2 },
    { ...STANFORD.rows[3], d: 0.4 },
    ...STANFORD.rows.slice(4),
  ],
};
const QUARTERS = [-Math.PI / 2, 0, Math.PI / 2, Math.PI];

// Return a generator of numbers from 0 to 1 with a fixed seed (Park and Miller).
function makeRandom(seed) {
  let state = seed;
  return () => (state = (state * 48271) % 2147483647) / 2147483647;
}

function solveBoth(arm, q) {
  const form = findClosedForm(arm);
  const tip = linkFrames(arm, q).at(-1);
  const target = needsPose(form) ? tip : tip.o;
  return [solveInverse(arm, form, target), solveByStructure(arm, target)];
}

// Return joint values as cosines and sines, so that whole turns do not count; free joints are left
// out.
const onCircle = (arm, { q, free }) =>
  q.flatMap((x, i) =>
    free[i] ? [] : arm.rows[i].kind === "prismatic" ? [x] : [Math.cos(x), Math.sin(x)],
  );
const distance = (u, v) => Math.max(...u.map((x, i) => Math.abs(x - v[i])));

function assertSame(arm, q) {
  const [closed, structured] = solveBoth(arm, q);
  const summary = (branches) => branches.map(({ free, times }) => `${free} ${times}`).sort();
  assert.deepEqual(summary(structured), summary(closed), `${arm.name} at ${q}`);
  if (closed.some(({ free }) => free.some(Boolean))) return; // a free joint moves the remaining joints
  for (const branch of closed) {
    const gaps = structured.map((other) => distance(onCircle(arm, branch), onCircle(arm, other)));
    assert.ok(Math.min(...gaps) < 1e-8, `${arm.name} at ${q}: ${branch.name}`);
  }
}

test("these arms have a closed form", () => {
  assert.deepEqual([ELBOW, STANFORD, WRIST].map(findClosedForm), ["elbow", "stanford", "spherical_wrist"]);
});

test("closed forms and structure agree at singular configurations", () => {
  const random = makeRandom(8);
  for (const arm of [ELBOW, STANFORD, WRIST]) {
    for (let k = 0; k < 50; k++)
      assertSame(
        arm,
        arm.rows.map(({ kind }) =>
          kind === "prismatic" ? 0.3 : QUARTERS[Math.floor(4 * random())],
        ),
      );
  }
});
