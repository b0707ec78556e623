// The explorer compares one column of a typed Jacobian, and a message names it.

import assert from "node:assert/strict";
import { test } from "node:test";
import { compareColumn, describeComparedColumn } from "../../page/src/compared_column.js";
import { ELBOW } from "./arms.mjs";

const RIGHT = [[0, 0.7, 0, 0, 0, 1], [0, 0, 0.7, 0, -1, 0], [0, 0, 0.3, 0, -1, 0]]; // of the stretched arm, by hand
const compare = (change, highlightedRow = null) => {
  const answer = [0, 1, 2, 3, 4, 5].flatMap((i) => RIGHT.map((column) => column[i]));
  for (const [i, k, value] of change) answer[3 * i + k] = value;
  return compareColumn({ arm: ELBOW, answer, highlightedRow }, RIGHT);
};

test("the column that differs most is compared", () => {
  const compared = compare([[2, 1, 0.8], [2, 2, 0.5]]);
  assert.equal(
    describeComparedColumn(compared),
    "When joint 3 moves alone, the tip has the velocity (0.000, 0.000, 0.300); the typed column says (0.000, 0.000, 0.500), the red arrow.",
  );
});

test("angular parts are compared if the linear ones are equal", () => {
  const { joint, right, typed } = compare([[4, 1, 1]]);
  assert.deepEqual([joint, right, typed], [2, [0, -1, 0], [0, 1, 0]]);
});

test("the column under the pointer is compared", () => {
  const words = describeComparedColumn(compare([[2, 2, 0.5]], 0));
  assert.match(words, /^When joint 1 moves alone.*; the typed column says the same\.$/);
});

test("without a typed Jacobian nothing is compared", () => {
  assert.equal(compareColumn({ arm: ELBOW, answer: null, highlightedRow: 1 }, RIGHT), null);
  assert.equal(compareColumn({ arm: ELBOW, answer: [1, 2, 3], highlightedRow: 1 }, RIGHT), null);
});
