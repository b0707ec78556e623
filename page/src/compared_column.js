// Compares a column of a typed Jacobian with the right one: the tip's velocity by each, when one
// joint moves alone.

import { minus, movingRows, norm } from "../../judge/geometry/kinematics.js";
import { formatFixed } from "./text.js";

const SAME = 1e-3; // smaller differences come from the typed digits

/** Return whether a typed number differs from the right one. */
export const isOff = (typed, value) => Math.abs(typed - value) > SAME;

/**
 * Return the column to compare: the one that the reader points at, or the one that differs most.
 * Its linear parts are compared, or its angular parts if the linear ones are equal. Null if there
 * is no typed Jacobian.
 * @param {{ arm: import("../../judge/geometry/arm.js").Arm, answer: number[] | null,
 *   highlightedRow: number | null }} state
 * @param {number[][]} columns of the right Jacobian
 */
export function compareColumn({ arm, answer, highlightedRow }, columns) {
  if (answer?.length !== 6 * columns.length) return null;
  const typedColumns = columns.map((_, k) =>
    [0, 1, 2, 3, 4, 5].map((row) => answer[row * columns.length + k]),
  );
  const parts = columns.map((column, k) =>
    [0, 3].map((from) => {
      const [right, typed] = [column, typedColumns[k]].map((c) => c.slice(from, from + 3));
      return { right, typed, size: norm(minus(right, typed)), isTurn: from === 3 };
    }),
  );
  const sizes = parts.map((pair) => Math.max(...pair.map(({ size }) => size)));
  const pointed = movingRows(arm).indexOf(highlightedRow ?? -1);
  const k = pointed < 0 ? sizes.indexOf(Math.max(...sizes)) : pointed;
  const [linear, angular] = parts[k];
  const part = linear.size > SAME || angular.size <= SAME ? linear : angular;
  return { ...part, joint: movingRows(arm)[k] + 1 };
}

const formatVector = (vector) => `(${vector.map((v) => formatFixed(v, 3)).join(", ")})`;

/** Describe a compared column in a sentence. @param {ReturnType<typeof compareColumn>} compared */
export function describeComparedColumn(compared) {
  if (!compared) return "";
  const { joint, right, typed, size, isTurn } = compared;
  const part = isTurn ? "angular velocity" : "velocity";
  const moves = `When joint ${joint} moves alone, the tip has the ${part} ${formatVector(right)}`;
  if (size <= SAME) return `${moves}; the typed column says the same.`;
  return `${moves}; the typed column says ${formatVector(typed)}, the red arrow.`;
}
