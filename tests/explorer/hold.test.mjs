// The arm in the hand: within limits always, back where it came from, and a reason where it stops.

import assert from "node:assert/strict";
import { test } from "node:test";
import { range } from "../../explorer/src/arm.js";
import { dragLink, dragTip, inFrame, swingElbow, whyStopped } from "../../explorer/src/hold.js";
import { joints, linkFrames, minus, norm } from "../../explorer/src/kinematics.js";
import { stopVerdict } from "../../explorer/src/verdicts.js";
import { ARMS, ELBOW, PANDA, STANFORD } from "./arms.mjs";

const pixel = ([x, y, z]) => [300 * x + 120 * y, 400 - 300 * z + 60 * y]; // a camera far away
const tip = (arm, q) => linkFrames(arm, q).at(-1);
const inside = (arm, q) =>
  joints(arm).every((row, k) => {
    const [lower, upper] = range(arm.rows[row]);
    return q[k] >= Math.min(lower, arm.home[k]) - 1e-12 && q[k] <= Math.max(upper, arm.home[k]) + 1e-12;
  });

// Drag the tip along points, 60 frames for each.
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
  test(`${arm.name}: a tip taken out of reach and back finds its joints again`, () => {
    const start = arm === STANFORD ? [0.3, 0.6, 0.5, 0.2, 0.4, 0.1] : arm === ELBOW ? arm.home : [0.1, -0.4, 0.3, 1.6, 0.2, 1.9, 0.4];
    const { o } = tip(arm, start);
    const far = [o[0] + 2, o[1] + 1, o[2] + 0.5];
    const out = dragged(arm, start, line(o, far));
    assert.ok(norm(minus(tip(arm, out).o, far)) > 0.3, "it is out of reach");
    const back = dragged(arm, out, Object.assign(line(far, o), { rest: start }));
    assert.ok(norm(minus(tip(arm, back).o, o)) < 2e-3);
    assert.ok(Math.max(...back.map((v, k) => Math.abs(v - start[k]))) < 2e-3);
  });
}

test("a tip within reach arrives, and a stretched arm leaves its singular pose", () => {
  const near = dragged(ELBOW, ELBOW.home, [[0.3, 0.2, 0.6]]);
  assert.ok(norm(minus(tip(ELBOW, near).o, [0.3, 0.2, 0.6])) < 1e-3);
  const straight = [0, 0.5, 0];
  const { o } = tip(ELBOW, straight);
  const target = o.map((v, k) => 0.8 * (v - [0, 0, 0.5][k]) + [0, 0, 0.5][k]); // towards the shoulder
  assert.ok(norm(minus(tip(ELBOW, dragged(ELBOW, straight, [target])).o, target)) < 2e-3);
});

test("a kept direction stays within a degree where the arm can", () => {
  const start = [0.1, -0.4, 0.3, 1.6, 0.2, 1.9, 0.4];
  const { o, x } = tip(PANDA, start);
  const q = dragged(PANDA, start, [[o[0] - 0.05, o[1] + 0.05, o[2] - 0.04]], { turns: true });
  const cosine = tip(PANDA, q).x.reduce((s, v, k) => s + v * x[k], 0);
  assert.ok(cosine > Math.cos(Math.PI / 180));
});

test("why a tip stops: a straight elbow, and a joint at its limit", () => {
  const { o } = tip(ELBOW, ELBOW.home);
  const far = [o[0] + 1, o[1], o[2]];
  const out = dragged(ELBOW, ELBOW.home, [far]);
  const why = whyStopped(ELBOW, out, far);
  assert.deepEqual(why.stops, ["joint 3 straight"]);
  assert.match(stopVerdict(why), /^Joint 3 straight: \d+ mm short\.$/);
  const stiff = { ...ELBOW, rows: ELBOW.rows.map((row, i) => (i === 1 ? { ...row, lower: 0.7, upper: 1 } : row)) };
  const low = [o[0], o[1], o[2] - 0.6];
  const stopped = whyStopped(stiff, dragged(stiff, ELBOW.home, [low]), low);
  assert.ok(stopped.stops.some((words) => words === "joint 2 at its limit"), stopped.stops.join());
  assert.equal(stopVerdict({ stops: [], short: 0.001 }), "");
});

test("a link under the pointer turns its joint alone", () => {
  const q = ELBOW.home;
  const row = 1;
  const { o } = linkFrames(ELBOW, q)[row + 1];
  const local = inFrame(linkFrames(ELBOW, q)[row + 1], o);
  const wanted = [q[0], q[1] + 0.3, q[2]];
  const to = pixel(linkFrames(ELBOW, wanted)[row + 1].o);
  let next = q;
  for (let frame = 0; frame < 12; frame++) next = dragLink(ELBOW, next, { row, local, to, joint: 1, pixel });
  assert.ok(Math.abs(next[1] - wanted[1]) < 0.02, String(next));
  assert.deepEqual([next[0], next[2]], [q[0], q[2]]);
  const stiff = { ...ELBOW, rows: ELBOW.rows.map((r, i) => (i === 1 ? { ...r, lower: 0.7, upper: 0.9 } : r)) };
  for (let frame = 0; frame < 12; frame++) next = dragLink(stiff, next, { row, local, to, joint: 1, pixel });
  assert.ok(next[1] <= Math.max(0.9, wanted[1]));
});

test("the Panda's elbow swings while its tip stays", () => {
  const start = [0.1, -0.4, 0.3, 1.6, 0.2, 1.9, 0.4];
  const held = tip(PANDA, start);
  const row = 2; // the elbow
  const frame = linkFrames(PANDA, start)[row + 1];
  const to = pixel(frame.o).map((v, i) => v + [40, 25][i]);
  let q = start;
  for (let n = 0; n < 20; n++) {
    const { q: next, free } = swingElbow(PANDA, q, { row, local: [0, 0, 0], to, pixel }, held);
    assert.equal(free, 1);
    q = next;
  }
  const there = tip(PANDA, q);
  assert.ok(norm(minus(there.o, held.o)) < 1e-6);
  assert.ok(norm(minus(there.z, held.z)) < 1e-6);
  assert.ok(Math.max(...q.map((v, k) => Math.abs(v - start[k]))) > 0.1, "it moved");
  assert.ok(inside(PANDA, q));
  const none = swingElbow(ELBOW, ELBOW.home, { row: 1, local: [0, 0, 0], to, pixel }, tip(ELBOW, ELBOW.home), { turns: false });
  assert.equal(none.free, 0, "three joints and a place leave nothing");
});
