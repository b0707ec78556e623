// Classifies the entries of a table's row and moves angles to the right angles nearby.

// rad: angles are often typed with four decimals.
export const ANGLE_TOLERANCE = 1e-4;

/** Return whether the entries of a column are angles. @param {string} column */
export const isAngleColumn = (column) => column === "alpha" || column === "theta";

/** Return the entry that a joint of this kind changes, or undefined for a fixed row. */
export const jointColumn = (kind) => ({ revolute: "theta", prismatic: "d" })[kind];

/**
 * Return the multiple of a right angle near an angle, or the angle itself if none is near.
 * @param {number} angle rad
 * @param {number} [unit] of its last typed digit (rad)
 */
export function snapAngle(angle, unit = 0) {
  const nearest = (Math.round(angle / (Math.PI / 2)) * Math.PI) / 2;
  return Math.abs(angle - nearest) < Math.max(ANGLE_TOLERANCE, 0.51 * unit) ? nearest : angle;
}

/** Snap alpha and theta of each row. @param {import("./arm.js").TableRow[]} rows */
export const snapRows = (rows) =>
  rows.map((row) => ({ ...row, alpha: snapAngle(row.alpha), theta: snapAngle(row.theta) }));
