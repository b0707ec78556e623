// What a column of a Jacobian claims, beside what the arm does.

import assert from "node:assert/strict";
import { test } from "node:test";
import { jacobianColumns, linkFrames } from "../../judge/geometry/kinematics.js";
import { pictureOf } from "../../page/src/check/extras/picture.js";
import { carried, claimWords, moved } from "../../page/src/more/claim.js";

const right = { kind: "revolute", a: 0, d: 0, alpha: 0, theta: 0 };
const ARM = {
  name: "Arm",
  home: [0, 0, 0],
  rows: [
    { ...right, alpha: Math.PI / 2, d: 0.5 },
    { ...right, a: 0.4 },
    { ...right, kind: "prismatic", alpha: 0.3, a: 0.1, theta: 0.2 },
  ],
};
const Q = [0.5, 0.7, 0.2];
const near = (one, other) => one.forEach((v, i) => assert.ok(Math.abs(v - other[i]) < 1e-12, `${one} ${other}`));

test("a true column takes the tip where its joint takes it, however far", () => {
  const frames = linkFrames(ARM, Q);
  jacobianColumns(ARM, frames).forEach((twist, k) => {
    for (const by of [0.5, -1.9, 1e-12]) {
      const wanted = linkFrames(ARM, Q.map((v, i) => (i === k ? v + by : v))).at(-1);
      const found = carried(frames.at(-1), twist, by);
      for (const axis of ["x", "y", "z", "o"]) near(found[axis], wanted[axis]);
    }
  });
});

test("the counterexample says where both go", () => {
  const made = moved(ARM, Q, { k: 2, twist: [0, 0, -1, 0, 0, 0] }, 1);
  near(made.claimed.o, [made.tip.o[0], made.tip.o[1], made.tip.o[2] - 0.15]);
  const words = claimWords(made, 3);
  assert.match(words, /^Joint 3 slid by 150 mm: your column takes the tip 150 mm, mostly along −z; the arm takes it/);
  const same = moved(ARM, Q, { k: 0, twist: jacobianColumns(ARM, linkFrames(ARM, Q))[0] }, 1);
  assert.equal(claimWords(same, 1), "Joint 1 turned by 29°: your column takes the tip where the arm takes it.");
});

test("wrong columns are in red, in the base's axes whatever they were written in", () => {
  const frames = linkFrames(ARM, Q);
  const columns = jacobianColumns(ARM, frames);
  const { x, y, z } = frames[2];
  const seen = (u) => [x, y, z].map((axis) => axis.reduce((sum, v, i) => sum + v * u[i], 0));
  const written = columns.map((c) => [...seen(c.slice(3)), ...seen(c.slice(0, 3))]);
  const values = [0, 1, 2, 3, 4, 5].flatMap((i) => written.map((c) => c[i]));
  const wrong = values.map((_, i) => i % 3 === 1);
  const report = { grade: "wrong", typed: { values, shape: [6, 3], units: values }, wrong, findings: [] };
  const question = { ask: "jacobian", frame: "2", first: "omega" };
  const { axes, claims, words } = pictureOf(question, { arm: ARM, q: Q, report });
  assert.deepEqual(axes, [1]);
  near(claims[0].twist, columns[1]);
  assert.match(words, /In red: the axis of joint 2, whose column is wrong\.$/);
});

test("a wrong table, wrong angles and a wrong run are seen as ghosts and ways", () => {
  const wrong = { grade: "wrong", findings: [{ where: "row 2, a" }, { where: "row 9, d" }] };
  const rows = ARM.rows.map((row, i) => (i === 1 ? { ...row, a: 0.9 } : row));
  const table = pictureOf({ ask: "table" }, { arm: ARM, report: { ...wrong, table: { rows } } });
  assert.deepEqual(table.links, [1]);
  near(linkFrames(table.ghosts[0].arm, table.ghosts[0].q).at(-1).o, linkFrames({ rows }, ARM.home).at(-1).o);

  const typed = { values: [90, 0, 0.1, 10, 20, 0.2], shape: [2, 3] };
  const asked = { ask: "branches", unit: "deg", target: "0.1, 0.2, 0.3" };
  const marks = [true, true, true, false, false, false];
  const ways = pictureOf(asked, { arm: ARM, report: { ...wrong, typed, wrong: marks } });
  near(ways.q, [Math.PI / 2, 0, 0.1]);
  assert.deepEqual([ways.ghosts.length, ways.points], [0, [[0.1, 0.2, 0.3]]]);

  const run = { ask: "trace", unit: "rad", answer: "0 0 0\n0.1 0 0\n0.2 0 0" };
  const { path } = pictureOf(run, { arm: ARM, q: [0, 0, 0], report: wrong });
  assert.equal(path.length, 3);
  near(path[1], linkFrames(ARM, [0.1, 0, 0]).at(-1).o);
});
