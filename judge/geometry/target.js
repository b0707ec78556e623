// Targets of inverse kinematics as they are typed: a point, or the rows of a pose.

import { findClosedForm, needsPose, solveInverse } from "./inverse.js";
import { cross, dot } from "./kinematics.js";

/** @typedef {import("./arm.js").Arm} Arm */
/** @typedef {import("./inverse.js").Branch} Branch */

// Error of axis lengths and cosines in a pose typed with two decimals.
const POSE_ROUNDING = 0.02;

/**
 * Solve for all branches by the arm's closed form; none if it has no closed form.
 * @param {Arm} arm
 * @param {any[]} target three coordinates (m), or three or four rows of a pose
 * @returns {Branch[]}
 */
export function solveTarget(arm, target) {
  const form = findClosedForm(arm);
  if (!form) return [];
  if (needsPose(form)) return solveInverse(arm, form, frameOf(target));
  const point = Array.isArray(target[0]) ? target.slice(0, 3).map((row) => row[3]) : target;
  return solveInverse(arm, form, point);
}

const frameOf = (rows) => {
  const [x, y, z, o] = [0, 1, 2, 3].map((k) => rows.slice(0, 3).map((row) => row[k]));
  return { x, y, z, o };
};

/**
 * Return the three rows of a pose with axes that are perpendicular and of unit length: the nearest
 * rotation, by Newton's steps R <- (R + R^-T) / 2. A pose that is farther off than rounding is
 * returned unchanged.
 * @param {number[][]} rows
 */
export function orthonormalize(rows) {
  const off = (u, v, wanted) => Math.abs(dot(u, v) - wanted);
  let R = rows.map((row) => row.slice(0, 3));
  if (R.some((u, i) => R.some((v, j) => off(u, v, Number(i === j)) > POSE_ROUNDING))) return rows;
  for (let step = 0; step < 6; step++) {
    const [a, b, c] = R;
    const size = dot(a, cross(b, c));
    const back = [cross(b, c), cross(c, a), cross(a, b)];
    R = R.map((row, i) => row.map((x, k) => (x + back[i][k] / size) / 2));
  }
  return rows.map((row, i) => [...R[i], row[3]]);
}
