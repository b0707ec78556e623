// The panel: labels of axes, ticks of plots, keys, spoken values and directions of motion.

import assert from "node:assert/strict";
import { test } from "node:test";
import { getStepOfKey } from "../../page/src/panel/head.js";
import { findBranches } from "../../page/src/motion.js";
import { findLabelSpot } from "../../page/src/labels.js";
import { describeMotion, formatSpokenValue } from "../../page/src/text.js";
import { formatTimeTicks } from "../../page/src/views/plots.js";
import { ELBOW, PANDA, STANFORD } from "./arms.mjs";

const LINK = { from: [100, 0], to: [100, 200] }; // vertical, 20 px wide

test("a free label stays at its axis end", () => {
  assert.deepEqual(findLabelSpot([40, 50], 22, [], [LINK], 10), [40, 50]);
});

test("a label on a link moves off it", () => {
  const [x, y] = findLabelSpot([100, 100], 22, [], [LINK], 10);
  assert.ok(Math.abs(x - 100) > 19 && Math.hypot(x - 100, y - 100) <= 30);
});

test("neighbouring labels do not overlap", () => {
  const labels = [{ spot: [40, 50], width: 22 }];
  const [x, y] = findLabelSpot([40, 50], 22, labels, [LINK], 10);
  assert.ok(Math.abs(x - 40) > 22 || Math.abs(y - 50) > 15);
});

test("a label without a free spot is left out", () => {
  assert.equal(findLabelSpot([40, 50], 22, [{ spot: [40, 50], width: 500 }, { spot: [40, 80], width: 500 }, { spot: [40, 20], width: 500 }, { spot: [40, 65], width: 500 }, { spot: [40, 35], width: 500 }], [], 10), null);
});

test("branches have the names of the closed form", () => {
  const names = (arm, q) => findBranches(arm, q).list.map(({ label }) => label).sort();
  const shoulders = ["back", "front"].flatMap((side) => ["down", "up"].map((bend) => `${side}, elbow ${bend}`));
  assert.deepEqual(names(ELBOW, [0.2, 0.9, -1.1]), shoulders);
  assert.ok(names(STANFORD, [0.1, 0.7, 0.5, 0.2, 0.6, 0.3]).every((name) => /^(front|back), rod (out|through), q_5 [<>] 0$/.test(name)));
});

test("a joint of a branch is turned by whole turns into its limits", () => {
  const q = [0.2, 0.3, 0.1, 1.2, 0.2, 3.5, 0.4]; // the range of joint 6 is -0.02 to 3.75
  const [first] = findBranches({ ...PANDA, rows: PANDA.rows.map((row, i) => (i === 2 ? { ...row, kind: "fixed" } : row)) }, q.filter((_, i) => i !== 2)).list;
  assert.ok(Math.abs(first.q[4] - 3.5) < 1e-6, `${first.q}`);
});

test("the time axis has numbers with their unit", () => {
  assert.deepEqual(formatTimeTicks(5), ["0", "t = 2.5 s", "5 s"]);
});

test("keys trigger undo and redo", () => {
  const press = (key, keys = {}) => getStepOfKey({ key, ctrlKey: true, metaKey: false, shiftKey: false, ...keys });
  assert.deepEqual([press("z"), press("Z", { shiftKey: true }), press("y"), press("a")], ["undo", "redo", "redo", null]);
  assert.equal(press("y", { ctrlKey: false, metaKey: true }), "redo");
  assert.equal(press("z", { ctrlKey: false }), null);
});

test("a spoken value has its sign and unit in words", () => {
  const [turning, sliding] = [STANFORD.rows[0], STANFORD.rows[2]];
  assert.equal(formatSpokenValue(turning, -Math.PI / 4, "deg"), "minus 45.0 degrees");
  assert.equal(formatSpokenValue(turning, -0.5, "rad"), "minus 0.500 radians");
  assert.equal(formatSpokenValue(sliding, 0.5, "deg"), "0.500 metres");
});

test("a direction names each share above two percent", () => {
  assert.equal(describeMotion([0, 0.999, 0, 0.01, 0, 0]), "move along y");
  assert.equal(describeMotion([0, 0.999, 0, 0.03, 0, 0]), "1.00 along y, 0.03 about x");
});
