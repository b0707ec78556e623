// Dragged tips: joints stay within their limits and return to where they were.

import assert from "node:assert/strict";
import { test } from "node:test";
import { jointRange } from "../../judge/geometry/arm.js";
import { dragLink, dragTip } from "../../page/src/dragging.js";
import { movingRows, linkFrames, minus, norm } from "../../judge/geometry/kinematics.js";
import { ARMS, ELBOW, PANDA } from "./arms.mjs";

const tip = (arm, q) => linkFrames(arm, q).at(-1);
const inside = (arm, q) =>
  movingRows(arm).every((row, k) => {
    const [lower, upper] = jointRange(arm.rows[row]);
    return q[k] >= Math.min(lower, arm.home[k]) - 1e-12 && q[k] <= Math.max(upper, arm.home[k]) + 1e-12;
  });

const BENT = { Panda: [0.1, -0.4, 0.3, 1.6, 0.2, 1.9, 0.4], "Stanford arm": [0.3, 0.6, 0.5, 0.2, 0.4, 0.1] };

// Drag the tip from point to point in 60 frames each.
function dragged(arm, start, points, options) {
  let q = start;
  for (const o of points) {
    for (let frame = 0; frame < 60; frame++) {
      q = dragTip(arm, q, { ...tip(arm, start), o }, points.rest ?? start, options).q;
      assert.ok(inside(arm, q), "past a limit");
    }
  }
  return q;
}
const line = (from, to, n = 12) =>
  Array.from({ length: n }, (_, i) => from.map((v, k) => v + ((i + 1) / n) * (to[k] - v)));

for (const arm of ARMS) {
  test(`${arm.name}: dragging out of reach and back restores joints`, () => {
    const start = BENT[arm.name] ?? arm.home;
    const { o } = tip(arm, start);
    const far = [o[0] + 2, o[1] + 1, o[2] + 0.5];
    const out = dragged(arm, start, line(o, far));
    assert.ok(norm(minus(tip(arm, out).o, far)) > 0.3, "it is out of reach");
    const back = dragged(arm, out, Object.assign(line(far, o), { rest: start }));
    assert.ok(norm(minus(tip(arm, back).o, o)) < 2e-3);
    assert.ok(Math.max(...back.map((v, k) => Math.abs(v - start[k]))) < 2e-3);
  });
}

test("a dragged tip arrives, also from a singular configuration", () => {
  const near = dragged(ELBOW, ELBOW.home, [[0.3, 0.2, 0.6]]);
  assert.ok(norm(minus(tip(ELBOW, near).o, [0.3, 0.2, 0.6])) < 1e-3);
  const straight = [0, 0.5, 0];
  const { o } = tip(ELBOW, straight);
  const target = o.map((v, k) => 0.8 * (v - [0, 0, 0.5][k]) + [0, 0, 0.5][k]); // towards the shoulder
  assert.ok(norm(minus(tip(ELBOW, dragged(ELBOW, straight, [target])).o, target)) < 2e-3);
});

test("a kept tool direction stays within one degree", () => {
  const { o, x } = tip(PANDA, BENT.Panda);
  const q = dragged(PANDA, BENT.Panda, [[o[0] - 0.05, o[1] + 0.05, o[2] - 0.04]], { turns: true });
  const cosine = tip(PANDA, q).x.reduce((s, v, k) => s + v * x[k], 0);
  assert.ok(cosine > Math.cos(Math.PI / 180));
});

test("a dragged link stops at its joint's limit", () => {
  const [joint, q] = [1, BENT.Panda];
  const row = movingRows(PANDA)[joint];
  const local = [0.1, 0.2, 0];
  const pixel = (p) => [1000 * p[0], 1000 * p[2]]; // view along y at 1000 pixels per metre
  const [lower, upper] = jointRange(PANDA.rows[row]);
  const stops = [[5000, 5000], [-5000, 5000], [5000, -5000], [-5000, -5000]].map((to) => {
    let moved = q;
    for (let frame = 0; frame < 60; frame++) moved = dragLink(PANDA, moved, { row, local, to, joint, pixel });
    return moved[joint];
  });
  assert.ok(stops.every((stop) => stop >= lower && stop <= upper), "past the limit");
  assert.ok(stops.includes(upper), "one of the drags reaches the limit");
});
