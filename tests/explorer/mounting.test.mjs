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

test("only a 4x4 pose is read row by row", () => {
  const { pose } = readPose("[[0, -1, 0, 0.1], [1, 0, 0, 0.2], [0, 0, 1, 0.3], [0, 0, 0, 1]]", "rad");
  assert.deepEqual([pose.x, pose.o], [[0, 1, 0], [0.1, 0.2, 0.3]]);
  assert.match(readPose("1 2 3", "rad").error, /3 numbers; expected x, y, z, roll, pitch, yaw/);
  assert.match(readPose("1 0 0 0 0 1 0 0 0 0 -1 0 0 0 0 1", "rad").error, /no rigid pose/);
});

// Rot_x(30°) by hand: its cosine is 0.866025, its sine 1/2.
const turned = (cosine) => `1 0 0 0 0 ${cosine} -0.5 0 0 0.5 ${cosine} 0.2 0 0 0 1`;

test("a pose with few decimals becomes the nearest rotation", () => {
  for (const cosine of ["0.866", "0.8660", "0.86603"]) {
    const { pose, note } = readPose(turned(cosine), "rad");
    assert.match(note, /only [35] decimals; the nearest rotation was taken/);
    assert.ok(Math.abs(pose.y[1] - Math.cos(Math.PI / 6)) < 1e-3);
    assert.ok(Math.abs(pose.y[1] ** 2 + pose.y[2] ** 2 - 1) < 1e-12);
    assert.deepEqual(pose.o, [0, 0, 0.2]);
  }
  assert.equal(readPose(turned("0.8660254"), "rad").note, undefined);
  for (const cosine of ["0.87", "0.868"]) assert.match(readPose(turned(cosine), "rad").error, /no rigid pose/);
});

test("base and tool leave the joint limits unchanged", () => {
  const { pose } = readPose("0 0 0.5 0 30 0", "deg");
  const { rows } = makeTypedArm([...makePoseRows(pose), ...PANDA.rows, ...makePoseRows(pose)], PANDA);
  const limits = rows.filter(({ kind }) => kind !== "fixed").map(({ lower }) => lower);
  assert.deepEqual(limits, PANDA.rows.map(({ lower }) => lower));
  assert.equal(rows[0].lower, null);
});
