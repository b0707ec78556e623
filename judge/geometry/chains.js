// Computes Jacobians and gravity torques with mistakes in the table or in the recipe. Here a
// Jacobian is a flat list of 6 x dof numbers, row by row, as people write it.

import {
  cross,
  dot,
  movingRows,
  linkFrames,
  minus,
  scaled,
  revoluteFlags,
  pointInBase,
  vectorInBase,
  vectorInFrame,
} from "./kinematics.js";

const ZERO = [0, 0, 0];

/** @typedef {import("./arm.js").Row} Row */
/** @typedef {import("./kinematics.js").Frame} Frame */
/**
 * An arm at a configuration. A mistake changes the arm's table or its joint values.
 * @typedef {object} Chain
 * @property {Row[]} rows
 * @property {number[]} q joint values (rad or m)
 * @property {number[]} at index of each joint's row
 * @property {boolean[]} turns whether each joint is revolute
 * @property {number} dof
 */
/**
 * Deviations from the Jacobian's recipe. A step that is absent is done right.
 * @typedef {object} RecipeOptions
 * @property {number[]} [axis] index of the frame whose z serves each joint
 * @property {number[]} [origin] index of the frame whose o serves each joint
 * @property {number} [point] index of the frame whose origin's velocity is taken
 * @property {boolean} [subtracted] whether o is subtracted from the point
 * @property {boolean} [slides] whether prismatic joints are treated as such
 * @property {boolean} [crossed] whether z is crossed with the lever arm
 */

/**
 * Return an arm at a configuration.
 * @param {import("./arm.js").Rows} arm
 * @param {number[]} q
 * @returns {Chain}
 */
export const makeChain = (arm, q) => ({
  rows: arm.rows,
  q,
  at: movingRows(arm),
  turns: revoluteFlags(arm),
  dof: q.length,
});

/** Return the link frames of an arm at its configuration. @param {Chain} c */
export const chainFrames = (c) => linkFrames(c, c.q);

/**
 * Build a Jacobian column by column, with some step of the recipe done otherwise.
 * @param {Chain} c
 * @param {Frame[]} T link frames
 * @param {RecipeOptions} [options]
 * @returns {number[]} 6 x dof numbers, row by row
 */
export function flatJacobian(c, T, options = {}) {
  const {
    axis = c.at,
    origin = c.at,
    subtracted = true,
    point = T.length - 1,
    slides = true,
    crossed = true,
  } = options;
  const tip = T[point].o;
  const J = new Array(6 * c.dof);
  c.at.forEach((_, k) => {
    const [z, o] = [T[axis[k]].z, T[origin[k]].o];
    const turns = c.turns[k] || !slides;
    const lever = subtracted ? minus(tip, o) : tip;
    const linear = turns ? (crossed ? cross(z, lever) : lever) : z;
    for (let i = 0; i < 3; i++) {
      J[i * c.dof + k] = linear[i];
      J[(i + 3) * c.dof + k] = turns ? z[i] : 0;
    }
  });
  return J;
}

/**
 * Return frames whose axes are the rows of T, as for somebody who takes rows for columns. The last
 * row (0, 0, 0, 1) serves as the origin.
 * @param {Frame[]} T
 */
export const swapRowsForColumns = (T) =>
  T.map(({ x, y, z }) => {
    const row = (i) => [x[i], y[i], z[i]];
    return { x: row(0), y: row(1), z: row(2), o: ZERO };
  });

const addScaled = (u, k, v) => [u[0] + k * v[0], u[1] + k * v[1], u[2] + k * v[2]];

/** Rotate a Jacobian's rows from the base's axes into those of a frame (R^T J). */
export const rotateIntoFrame = (J, frame) => mapVectors(J, (v) => vectorInFrame(frame, v));
/** Rotate a Jacobian's rows from a frame's axes into the base's (R J). */
export const rotateFromFrame = (J, frame) => mapVectors(J, (v) => vectorInBase(frame, v));

// Convert the linear and the angular vectors of a Jacobian's columns.
function mapVectors(J, convert) {
  const dof = J.length / 6;
  const converted = J.slice();
  for (const first of [0, 3 * dof])
    for (let i = first; i < first + dof; i++) {
      const v = convert([J[i], J[i + dof], J[i + 2 * dof]]);
      for (let k = 0; k < 3; k++) converted[i + k * dof] = v[k];
    }
  return converted;
}

/**
 * Transpose a matrix that is given row by row.
 * @template T @param {T[]} flat @param {number[]} shape @returns {T[]}
 */
export const transpose = (flat, [rows, width]) =>
  flat.map((_, i) => flat[(i % rows) * width + Math.floor(i / rows)]);

/** Return column k of a matrix that is given row by row. @template T @param {T[]} flat */
export const selectColumn = (flat, k, width) => flat.filter((_, i) => i % width === k);

/** Join the linear rows of a Jacobian with the angular rows of a second one. */
export const joinHalves = (linear, angular) => [
  ...linear.slice(0, linear.length / 2),
  ...angular.slice(angular.length / 2),
];

/**
 * Return g(q), the torques (N m) and forces (N) that hold the arm up.
 * @param {Chain} c
 * @param {Frame[]} T link frames
 * @param {number[]} masses of each row (kg)
 * @param {number[][]} centres of mass in the frame of each row (m)
 * @param {number[]} gravity vector (m/s²)
 * @returns {number[]}
 */
export function computeTorquesOfMasses(c, T, masses, centres, gravity) {
  const torques = new Array(c.dof);
  let [mass, moment, k] = [0, ZERO, c.dof - 1];
  for (let row = c.rows.length - 1; row >= 0; row--) {
    mass += masses[row];
    moment = addScaled(moment, masses[row], pointInBase(T[row + 1], centres[row]));
    if (c.at[k] !== row) continue;
    const { z, o } = T[row];
    const torque = -dot(z, cross(minus(moment, scaled(mass, o)), gravity));
    torques[k] = c.turns[k] ? torque : -dot(z, gravity) * mass;
    k--;
  }
  return torques;
}

/** Rotate a wrench from a frame's axes into the base's (R F). */
export const wrenchFromFrame = (frame, F) => [
  ...vectorInBase(frame, F.slice(0, 3)),
  ...vectorInBase(frame, F.slice(3)),
];

/** Return the joint torques J^T F. @param {number[]} J @param {number[]} F */
export function multiplyByTranspose(J, F) {
  const torques = new Array(J.length / 6).fill(0);
  for (let i = 0, n = 0; i < 6; i++)
    for (let k = 0; k < torques.length; k++) torques[k] += J[n++] * F[i];
  return torques;
}
