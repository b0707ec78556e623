// The figure of two ellipses: each crossing is a solution for the tip's position.

import assert from "node:assert/strict";
import { test } from "node:test";
import { linkFrames } from "../../judge/geometry/kinematics.js";
import { findBranches } from "../../page/src/motion.js";
import { findCrossings, sampleEllipses } from "../../page/src/more/ellipse_curves.js";

const turn = (a, alpha, d = 0) => ({
  kind: "revolute",
  a,
  alpha,
  d,
  theta: 0,
  lower: null,
  upper: null,
});
const makeArm = (twist) => ({
  name: "arm",
  home: [],
  rows: [turn(0.15, Math.PI / 2, 0.4), turn(0.4, twist), turn(0.35, 0)],
});

test("the ellipses cross once for each branch", () => {
  for (const twist of [0.7, 0.3, 0])
    for (const q of [
      [0.4, 0.5, 1],
      [-1.2, 1.1, -0.7],
      [2, -0.4, 2.2],
    ]) {
      const arm = makeArm(twist);
      const crossings = findCrossings(...sampleEllipses(arm, linkFrames(arm, q).at(-1).o));
      assert.equal(crossings.length, findBranches(arm, q).list.length, `${twist}, ${q}`);
    }
});

test("the ellipses do not cross out of reach", () => {
  const [one, other] = sampleEllipses(makeArm(0.7), [2, 0, 0.4]);
  assert.deepEqual(findCrossings(one, other), []);
});
