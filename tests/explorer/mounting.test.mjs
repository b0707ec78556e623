// Bases and tools typed into the explorer: the tip is at the product of the poses.

import assert from "node:assert/strict";
import { test } from "node:test";
import { makeTypedArm } from "../../judge/geometry/arm.js";
import { frameMatrix, linkFrames } from "../../judge/geometry/kinematics.js";
import { makePoseRows, readPose } from "../../page/src/mounting.js";
import { PANDA } from "./arms.mjs";

const multiply = (A, B) => A.map((row) => [0, 1, 2, 3].map((k) => row.reduce((sum, v, i) => sum + v * B[i][k], 0)));
const tipOf = (rows, q) => frameMatrix(linkFrames({ rows }, q).at(-1));
const POSES = ["0 0 0 0 0 0", "0.1, -0.2, 0.3, 0, 0, 40", "0 0 0.4 180 0 0", "-0.3 0.2 0.1 180° 0 0.5rad", "0 0 0.2 0 pi/2 0", "0.3 -0.1 0.2 20 -50 140"];

test("fixed rows make the typed pose", () => {
  for (const text of POSES) {
    const { pose } = readPose(text, "deg");
    const T = frameMatrix(pose);
    const q = [0.1, -0.4, 0.3, 1.6, 0.2, 1.9, 0.4];
    const pairs = [
      [tipOf(makePoseRows(pose), []), T],
      [tipOf([...makePoseRows(pose), ...PANDA.rows], q), multiply(T, tipOf(PANDA.rows, q))],
      [tipOf([...PANDA.rows, ...makePoseRows(pose)], q), multiply(tipOf(PANDA.rows, q), T)],
    ];
    for (const [mine, wanted] of pairs)
      mine.flat().forEach((v, i) => assert.ok(Math.abs(v - wanted.flat()[i]) < 1e-12, text));
  }
});

test("a 4x4 pose is read row by row, others are refused", () => {
  const { pose } = readPose("[[0, -1, 0, 0.1], [1, 0, 0, 0.2], [0, 0, 1, 0.3], [0, 0, 0, 1]]", "rad");
  assert.deepEqual([pose.x, pose.o], [[0, 1, 0], [0.1, 0.2, 0.3]]);
  assert.match(readPose("1 2 3", "rad").error, /3 numbers; expected x, y, z, roll, pitch, yaw/);
  assert.match(readPose("1 0 0 0 0 1 0 0 0 0 -1 0 0 0 0 1", "rad").error, /no rigid pose/);
});

test("a base and a tool leave the joints their limits", () => {
  const { pose } = readPose("0 0 0.5 0 30 0", "deg");
  const { rows } = makeTypedArm([...makePoseRows(pose), ...PANDA.rows, ...makePoseRows(pose)], PANDA);
  const limits = rows.filter(({ kind }) => kind !== "fixed").map(({ lower }) => lower);
  assert.deepEqual(limits, PANDA.rows.map(({ lower }) => lower));
  assert.equal(rows[0].lower, null);
});
