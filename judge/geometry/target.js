// Solves inverse kinematics for a typed target, which is a point or the rows of a pose.

import { findClosedForm, needsPose, solveInverse } from "./inverse.js";
import { cross, dot } from "./kinematics.js";

/** @typedef {import("./arm.js").Arm} Arm */
/** @typedef {import("./inverse.js").Branch} Branch */

// Largest error of the axes' lengths and cosines in a pose that was typed with two decimals.
const POSE_ROUNDING = 0.02;

/**
 * Find all branches by the arm's closed form. An arm without a closed form has none.
 * @param {Arm} arm
 * @param {any[]} target three coordinates (m), or three or four rows of a pose
 * @returns {Branch[]}
 */
export function solveTarget(arm, target) {
  const form = findClosedForm(arm);
  if (!form) return [];
  if (needsPose(form)) return solveInverse(arm, form, makeFrame(target));
  const point = Array.isArray(target[0]) ? target.slice(0, 3).map((row) => row[3]) : target;
  return solveInverse(arm, form, point);
}

const makeFrame = (rows) => {
  const [x, y, z, o] = [0, 1, 2, 3].map((k) => rows.slice(0, 3).map((row) => row[k]));
  return { x, y, z, o };
};

/**
 * Replace the rotation in a pose by the nearest exact rotation. Newton's steps R <- (R + R^-T) / 2
 * find it. A pose with a larger error than rounding causes is returned unchanged.
 * @param {number[][]} rows three rows of four entries
 */
export function orthonormalize(rows) {
  const isWrong = (u, v, expected) => Math.abs(dot(u, v) - expected) > POSE_ROUNDING;
  let R = rows.map((row) => row.slice(0, 3));
  if (R.some((u, i) => R.some((v, j) => isWrong(u, v, Number(i === j))))) return rows;
  for (let step = 0; step < 6; step++) {
    const [a, b, c] = R;
    const determinant = dot(a, cross(b, c));
    const cofactors = [cross(b, c), cross(c, a), cross(a, b)];
    R = R.map((row, i) => row.map((x, k) => (x + cofactors[i][k] / determinant) / 2));
  }
  return rows.map((row, i) => [...R[i], row[3]]);
}
