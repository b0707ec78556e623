// Makes the arms between two tables, for a slider that goes from one arm to the other.

import { makeTypedArm } from "../../judge/geometry/arm.js";

/** @typedef {import("../../judge/geometry/arm.js").Arm} Arm */
/** @typedef {import("../../judge/geometry/arm.js").TableRow} TableRow */

/** Return whether two arms have the same kinds of rows, so that there are arms between them. */
export const haveSameKinds = (arm, other) =>
  arm.rows.length === other.rows.length &&
  arm.rows.every(({ kind }, i) => kind === other.rows[i].kind);

/**
 * Return the fields of the state for the arm at a share of the way from the reference to a table.
 * @param {{ base: Arm, reference: Arm }} state
 * @param {TableRow[]} rows of the table
 * @param {number} share
 */
export function blendTables({ base, reference }, rows, share) {
  const between = rows.map((row, i) => blendRows(reference.rows[i], row, share));
  return { arm: makeTypedArm(between, base), blended: share < 1 ? { rows, share } : null };
}

// Return the row that is a share of the way from one row to another; an angle goes the short way.
function blendRows(from, to, share) {
  if (share === 1) return to;
  const mix = (key, turns = 0) => from[key] + share * (to[key] - from[key] - 2 * Math.PI * turns);
  const mixAngles = (key) => mix(key, Math.round((to[key] - from[key]) / (2 * Math.PI)));
  return { ...to, a: mix("a"), alpha: mixAngles("alpha"), d: mix("d"), theta: mixAngles("theta") };
}
