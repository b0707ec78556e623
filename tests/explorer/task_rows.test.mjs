// The rows of an arm's Jacobian that count, and the rank that the explorer shows.

import assert from "node:assert/strict";
import { test } from "node:test";
import { isPlanar, taskRows } from "../../judge/geometry/task_rows.js";
import { findBranches } from "../../page/src/motion.js";
import { makeInitialState, Store } from "../../page/src/state.js";
import { describeRank } from "../../page/src/statements.js";
import { ELBOW, PANDA, STANFORD } from "./arms.mjs";

const link = (a, entries = {}) => ({ kind: "revolute", a, alpha: 0, d: 0, theta: 0, lower: null, upper: null, ...entries });
const TWO = { name: "two", home: [0, 1], rows: [link(0.5), link(0.4)] };
const THREE = { name: "three", home: [0, 1, 1], rows: [link(0.5), link(0.4), link(0.2)] };
const UPRIGHT = { name: "upright", home: [0, 1, 1], rows: [link(0, { kind: "fixed", alpha: Math.PI / 2 }), ...THREE.rows] };
const SCARA = { name: "scara", home: [0, 1, 0.1, 0], rows: [link(0.3), link(0.2, { alpha: Math.PI }), link(0, { kind: "prismatic" }), link(0)] };

const rankAt = (arm, q) => describeRank(new Store(makeInitialState({ arm, q })).derived);

test("an arm is solved for its possible motions", () => {
  const rows = [TWO, THREE, UPRIGHT, SCARA, ELBOW, STANFORD, PANDA].map(taskRows);
  const all = [0, 1, 2, 3, 4, 5];
  assert.deepEqual(rows, [[0, 1], [0, 1, 5], [0, 2, 4], [0, 1, 2, 5], [0, 1, 2], all, all]);
  assert.deepEqual([TWO, THREE, UPRIGHT, SCARA, ELBOW].map(isPlanar), [true, true, true, false, false]);
});

test("only a straight planar arm is singular", () => {
  assert.deepEqual(rankAt(THREE, [0.3, 0.5, -0.4]), { singular: false, text: "Rank 3: the tip can move along every direction of its plane and turn in it." });
  assert.equal(rankAt(TWO, [0.3, 0]).singular, true);
  assert.match(rankAt(TWO, [0, 0]).text, /rank 1 of 2. Here the tip cannot move along x/);
  assert.equal(rankAt(SCARA, [0.3, 0.5, 0.1, 0.2]).singular, false);
});

test("planar arms and SCARA arms have two branches", () => {
  for (const arm of [TWO, THREE, UPRIGHT, SCARA]) {
    const { list, families, hasOrientation } = findBranches(arm, arm.home);
    assert.deepEqual([list.length, families.length, hasOrientation], [2, 0, arm !== TWO], arm.name);
  }
});
