// The arm in the hand: within limits always, back where it came from, and a reason where it stops.

import assert from "node:assert/strict";
import { test } from "node:test";
import { range } from "../../judge/geometry/arm.js";
import { dragLink, dragTip, fadingWays, inFrame, swingElbow, whyStopped } from "../../page/src/dragging.js";
import {
  dot,
  jacobianColumns,
  joints,
  linkFrames,
  minus,
  norm,
  plus,
  scaled,
} from "../../judge/geometry/kinematics.js";
import { followTip } from "../../page/src/pointers.js";
import { startingState, Store } from "../../page/src/state.js";
import { holdVerdict, stopVerdict } from "../../page/src/verdicts.js";
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
    const start =
      arm === STANFORD
        ? [0.3, 0.6, 0.5, 0.2, 0.4, 0.1]
        : arm === ELBOW
          ? arm.home
          : [0.1, -0.4, 0.3, 1.6, 0.2, 1.9, 0.4];
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
  const stiff = {
    ...ELBOW,
    rows: ELBOW.rows.map((row, i) => (i === 1 ? { ...row, lower: 0.7, upper: 1 } : row)),
  };
  const low = [o[0], o[1], o[2] - 0.6];
  const stopped = whyStopped(stiff, dragged(stiff, ELBOW.home, [low]), low);
  assert.ok(
    stopped.stops.some((words) => words === "joint 2 at its limit"),
    stopped.stops.join(),
  );
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
  const stiff = {
    ...ELBOW,
    rows: ELBOW.rows.map((r, i) => (i === 1 ? { ...r, lower: 0.7, upper: 0.9 } : r)),
  };
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
  const none = swingElbow(
    ELBOW,
    ELBOW.home,
    { row: 1, local: [0, 0, 0], to, pixel },
    tip(ELBOW, ELBOW.home),
    { turns: false },
  );
  assert.equal(none.free, 0, "three joints and a place leave nothing");
});

const fadingAt = (arm, q, turns = false) => fadingWays(jacobianColumns(arm, linkFrames(arm, q)), turns);

test("what fades at a nearly straight elbow is the way from the shoulder to the tip", () => {
  const q = [0.4, 0.6, -0.02];
  const [lost, ...more] = fadingAt(ELBOW, q);
  assert.equal(more.length, 0);
  const arm = minus(tip(ELBOW, q).o, [0, 0, 0.5]);
  assert.ok(Math.abs(dot(lost.way, arm)) / norm(arm) > 0.9999);
  assert.ok(lost.share > 0 && lost.share < 0.01);
  assert.deepEqual(fadingAt(ELBOW, [0.4, 0.6, -1.2]), []);
});

test("with the tool's direction kept, no rates that keep it are quick along what fades", () => {
  const q = [0.3, 0.5, 0.5, 0.2, 0.03, -0.4]; // axes 4 and 6 of the Stanford arm nearly one line
  const columns = jacobianColumns(STANFORD, linkFrames(STANFORD, q));
  const [{ way, share }] = fadingAt(STANFORD, q, true);
  // The rotation of joints 1, 2, 4, 5 and 6 leaves two ways to go about it beside the slide.
  let [along, fastest] = [0, 0];
  for (const kept of turnless(columns)) {
    along = Math.max(along, Math.abs(dot(way, kept)));
    fastest = Math.max(fastest, norm(kept));
  }
  assert.ok(along / fastest < 2 * share && share < 0.1, `${along / fastest}, ${share}`);
  assert.deepEqual(fadingAt(STANFORD, [0.3, 0.5, 0.5, 0.2, 1.2, -0.4], true), []);
});

// Velocities of the tip for many joint rates of unit length that do not turn the tool: the wrist takes back what the
// first joints turn, by Cramer's rule.
function turnless(columns) {
  const turn = columns.map((c) => c.slice(3));
  const triple = (a, b, c) => a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]); // prettier-ignore
  const [u, v, w] = turn.slice(3);
  const size = triple(u, v, w);
  return Array.from({ length: 400 }, (_, i) => {
    const first = [Math.sin(7 * i), Math.cos(11 * i), Math.sin(13 * i + 1)];
    const away = [0, 1, 2].reduce((sum, k) => plus(sum, scaled(first[k], turn[k])), [0, 0, 0]);
    const back = [triple(away, v, w), triple(u, away, w), triple(u, v, away)].map((x) => -x / size);
    const rates = [...first, ...back];
    const length = Math.hypot(...rates);
    return rates.reduce((sum, rate, k) => plus(sum, scaled(rate / length, columns[k])), [0, 0, 0]);
  });
}

test("a tip dragged outwards says what fades before it says why it stops", () => {
  const start = [0.2, 0.3, -0.6];
  const store = new Store(startingState({ arm: ELBOW, q: start }));
  const { o, ...axes } = tip(ELBOW, start);
  const way = scaled(1 / norm(minus(o, [0, 0, 0.5])), minus(o, [0, 0, 0.5]));
  const said = [];
  for (let far = 0; far < 0.06; far += 0.002) {
    const target = { ...axes, o: plus(o, scaled(far, way)) };
    for (let frame = 0; frame < 30; frame++) if (followTip(store, store.state, target, { rest: start, gesture: "drag" })) break;
    said.push(holdVerdict(store.state.hold));
  }
  assert.equal(said[0], "");
  assert.match(said.at(-1), /^Joint 3 straight: \d+ mm short\.$/);
  assert.ok(said.includes("Nearly singular along the arrow."), said.join("|"));
});
