// The rows of an arm's Jacobian that count. A planar arm moves its tip along two axes of the base
// and turns it about the third: its rows are (x, y, φ), and the other three are always 0.

import { jacobianColumns, linkFrames, movingRows } from "./kinematics.js";

/** @typedef {import("./arm.js").Rows} Rows */

const ROUND_OFF = 1e-12; // m or rad; rows up to this at a generic pose are 0 at every pose
// Joint values (rad or m) without any symmetry, for up to 16 joints.
const GENERIC_POSES = [0.37, 0.81].map((first) =>
  Array.from({ length: 16 }, (_, k) => first + Math.sin(1 + 2.3 * k)),
);

/** @type {WeakMap<object, number[]>} */
const knownRows = new WeakMap();

/**
 * Return the indices, among (vx, vy, vz, wx, wy, wz), of the rows that are not always 0.
 * @param {Rows} arm
 * @returns {number[]}
 */
export function movableRows(arm) {
  if (!knownRows.has(arm.rows)) {
    const columns = GENERIC_POSES.flatMap((q) => jacobianColumns(arm, linkFrames(arm, q)));
    const isMovable = (i) => columns.some((column) => Math.abs(column[i]) > ROUND_OFF);
    knownRows.set(arm.rows, [0, 1, 2, 3, 4, 5].filter(isMovable));
  }
  return knownRows.get(arm.rows);
}

/** Return the rows of `movableRows` that belong to the tip's velocity. @param {Rows} arm */
export const movableLinearRows = (arm) => movableRows(arm).filter((i) => i < 3);

// Planes of the base by their movable rows, with the axis across each, turned a little so that a
// camera on it still has its upright direction.
const PLANE_VIEWS = { "0,1,5": [0, -0.05, 1], "0,2,4": [0, -1, 0.05], "1,2,3": [1, 0, 0.05] };

/** Return the direction from which a planar arm is seen in its plane; null for other arms. */
export const getPlaneView = (/** @type {Rows} */ arm) =>
  PLANE_VIEWS[movableRows(arm).join()] ?? null;

/** Return whether the arm moves its tip in one plane of the base. @param {Rows} arm */
export const isPlanar = (arm) => getPlaneView(arm) !== null;

/**
 * Return the indices of the rows for which an arm is solved: all that its joints can move if there
 * are enough joints, else the position alone.
 * @param {Rows} arm
 * @returns {number[]}
 */
export function taskRows(arm) {
  const rows = movableRows(arm);
  if (rows.length <= movingRows(arm).length) return rows;
  const linear = movableLinearRows(arm);
  return linear.length < 3 && linear.length <= movingRows(arm).length ? linear : [0, 1, 2];
}

/** Return whether the rows for which an arm is solved hold its orientation. @param {Rows} arm */
export const hasTaskOrientation = (arm) => taskRows(arm).some((i) => i >= 3);

/** Return the entries of a list at some indices. @param {any[]} list @param {number[]} indices */
export const pick = (list, indices) => indices.map((i) => list[i]);
