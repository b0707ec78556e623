// Finds the rows of an arm's Jacobian that are not always 0. A planar arm moves its tip along two
// axes of the base and turns it about the third, so its rows are (x, y, φ).

import { jacobianColumns, linkFrames, movingRows } from "./kinematics.js";

/** @typedef {import("./arm.js").Rows} Rows */

const LARGEST_ZERO = 1e-12; // m or 1: a row up to this at the generic configurations is always 0
// Joint values (rad or m) without any symmetry, for up to 16 joints.
const GENERIC_CONFIGURATIONS = [0.37, 0.81].map((first) =>
  Array.from({ length: 16 }, (_, k) => first + Math.sin(1 + 2.3 * k)),
);

/** @type {WeakMap<object, number[]>} */
const rowsByTable = new WeakMap();

/**
 * Return the indices, among (vx, vy, vz, wx, wy, wz), of the rows that are not always 0.
 * @param {Rows} arm
 * @returns {number[]}
 */
export function movableRows(arm) {
  if (!rowsByTable.has(arm.rows)) {
    const columns = GENERIC_CONFIGURATIONS.flatMap((q) => jacobianColumns(arm, linkFrames(arm, q)));
    const isMovable = (i) => columns.some((column) => Math.abs(column[i]) > LARGEST_ZERO);
    rowsByTable.set(arm.rows, [0, 1, 2, 3, 4, 5].filter(isMovable));
  }
  return rowsByTable.get(arm.rows);
}

/** Return the rows of `movableRows` that belong to the tip's velocity. @param {Rows} arm */
export const movableLinearRows = (arm) => movableRows(arm).filter((i) => i < 3);

// The directions of view on the planes of the base, by the planes' movable rows. Each is turned a
// little from the plane's normal so that a camera on it still has an upright direction.
const PLANE_VIEWS = { "0,1,5": [0, -0.05, 1], "0,2,4": [0, -1, 0.05], "1,2,3": [1, 0, 0.05] };

/** Return the direction of view on a planar arm's plane, or null if the arm is not planar. */
export const getPlaneView = (/** @type {Rows} */ arm) =>
  PLANE_VIEWS[movableRows(arm).join()] ?? null;

/** Return whether the arm moves its tip in one plane of the base. @param {Rows} arm */
export const isPlanar = (arm) => getPlaneView(arm) !== null;

/**
 * Return the indices of the rows for which an arm is solved. These are all movable rows if the arm
 * has as many joints, else those of the position alone.
 * @param {Rows} arm
 * @returns {number[]}
 */
export function taskRows(arm) {
  const rows = movableRows(arm);
  if (rows.length <= movingRows(arm).length) return rows;
  const linear = movableLinearRows(arm);
  return linear.length < 3 && linear.length <= movingRows(arm).length ? linear : [0, 1, 2];
}

/** Return whether the rows for which an arm is solved include its orientation. @param {Rows} arm */
export const hasTaskOrientation = (arm) => taskRows(arm).some((i) => i >= 3);

/** Return the entries of a list at some indices. @param {any[]} list @param {number[]} indices */
export const pick = (list, indices) => indices.map((i) => list[i]);
