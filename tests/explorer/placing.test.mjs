// The frames trainer: the book's own choices give the book's tables, any valid ones the same arm.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { linkFrames } from "../../judge/geometry/kinematics.js";
import { bareArm, choices, directions, frameOf, randomArm, tableOf, violation } from "../../page/src/more/placing.js";
import { sameArm } from "../../page/src/same_arm.js";

const ARMS = JSON.parse(readFileSync(new URL("../../page/src/more/arms.json", import.meta.url), "utf8"));

// Every way to place the frames of an arm, cut off after `most` tables.
function tables(arm, most = 60) {
  const bare = bareArm(arm);
  const found = [];
  const walk = (placed) => {
    if (found.length >= most) return;
    if (placed.length > bare.axes.length) return void found.push(tableOf(arm, bare, placed));
    const before = placed.at(-1);
    const { zs, points } = choices(bare, placed);
    for (const z of zs) for (const o of points) for (const x of directions(before, z, o)) {
      const frame = frameOf(z, x, o);
      if (!violation(before, frame, placed.length)) walk([...placed, frame]);
    }
  };
  walk([bare.base]);
  return found;
}

for (const arm of ARMS) {
  test(`${arm.name}: every valid choice is a table of the arm`, () => {
    const found = tables(arm);
    assert.ok(found.length > 7, `${found.length} tables`);
    for (const rows of found) assert.ok(sameArm({ name: "mine", home: [], rows }, arm), JSON.stringify(rows));
  });
  test(`${arm.name}: the book's frames are valid and give the book's numbers`, () => {
    const bare = bareArm(arm);
    const frames = linkFrames(arm, bare.q);
    for (let i = 1; i < frames.length; i++) assert.equal(violation(frames[i - 1], frames[i], i), null);
    tableOf(arm, bare, frames).forEach((row, k) => {
      for (const key of ["a", "d"]) assert.ok(Math.abs(row[key] - arm.rows[k][key]) < 1e-9, `${key}_${k + 1}`);
      for (const key of ["alpha", "theta"]) {
        assert.ok(Math.abs(Math.sin((row[key] - arm.rows[k][key]) / 2)) < 1e-9, `${key}_${k + 1}`);
      }
    });
  });
}

test("what is violated is named", () => {
  const arm = ARMS.find(({ name }) => name === "Elbow arm");
  const bare = bareArm(arm);
  const [base, first] = linkFrames(arm, bare.q);
  assert.match(violation(base, { ...first, x: base.z, z: base.x }, 1), /x_1 is not at a right angle to z_0/);
  assert.match(violation(base, { ...first, o: [first.o[0], first.o[1] + 0.2, first.o[2]] }, 1), /does not meet the axis z_0/);
});

test("arms of their own can be placed", () => {
  let seed = 5;
  const roll = () => (seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0) / 2 ** 32;
  for (let n = 0; n < 12; n++) {
    const arm = randomArm(roll);
    const found = tables(arm, 8);
    assert.ok(found.length > 0, JSON.stringify(arm.rows));
    for (const rows of found) assert.ok(sameArm({ name: "mine", home: [], rows }, arm));
  }
});
