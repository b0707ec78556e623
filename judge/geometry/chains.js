// Jacobians and gravity torques with mistakes in the table or in the recipe. Here a Jacobian is a
// flat list of 6 x dof numbers, row by row, as people write it.

import {
  cross,
  dot,
  movingRows,
  linkFrames,
  minus,
  plus,
  scaled,
  revoluteFlags,
} from "./kinematics.js";

const ZERO = [0, 0, 0];

/** @typedef {import("./arm.js").Row} Row */
/** @typedef {import("./kinematics.js").Frame} Frame */
/**
 * An arm at a pose. A mistake changes its table or its joint values.
 * @typedef {object} Chain
 * @property {Row[]} rows
 * @property {number[]} q joint values (rad or m)
 * @property {number[]} at index of each joint's row
 * @property {boolean[]} turns whether each joint is revolute
 * @property {number} dof
 */
/**
 * Deviations from the Jacobian's recipe; a step that is absent is done right.
 * @typedef {object} RecipeOptions
 * @property {number[]} [axis] index of the frame whose z serves each joint
 * @property {number[]} [origin] index of the frame whose o serves each joint
 * @property {number} [point] index of the frame whose origin's velocity is taken
 * @property {boolean} [subtracted] whether o is subtracted from the point
 * @property {boolean} [slides] whether prismatic joints are treated as such
 * @property {boolean} [crossed] whether z is crossed with the lever arm
 */

/** @param {import("./arm.js").Rows} arm @param {number[]} q @returns {Chain} */
export const makeChain = (arm, q) => ({
  rows: arm.rows,
  q,
  at: movingRows(arm),
  turns: revoluteFlags(arm),
  dof: q.length,
});

/** @param {Chain} c */
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
 * Return frames whose axes are the rows of T, not its columns. The last row (0, 0, 0, 1) serves as
 * the origin.
 * @param {Frame[]} T
 */
export const swapRowsForColumns = (T) =>
  T.map(({ x, y, z }) => {
    const row = (i) => [x[i], y[i], z[i]];
    return { x: row(0), y: row(1), z: row(2), o: ZERO };
  });

const inAxes = ({ x, y, z }, u) => [dot(x, u), dot(y, u), dot(z, u)];
const fromAxes = ({ x, y, z }, u) => [
  u[0] * x[0] + u[1] * y[0] + u[2] * z[0],
  u[0] * x[1] + u[1] * y[1] + u[2] * z[1],
  u[0] * x[2] + u[1] * y[2] + u[2] * z[2],
];
const addScaled = (u, k, v) => [u[0] + k * v[0], u[1] + k * v[1], u[2] + k * v[2]];

/**
 * Rotate a Jacobian's rows from the base's axes into those of a frame (R^T J).
 * @param {number[]} J
 * @param {Frame} frame
 * @param {number[]} [halves] to rotate: 0 linear, 1 angular
 */
export const rotateIntoFrame = (J, frame, halves = [0, 1]) =>
  rotateHalves(J, (u) => inAxes(frame, u), halves);
/** Rotate a Jacobian's rows from a frame's axes into the base's (R J). */
export const rotateFromFrame = (J, frame) => rotateHalves(J, (u) => fromAxes(frame, u), [0, 1]);

function rotateHalves(J, rotate, halves) {
  const dof = J.length / 6;
  const made = J.slice();
  for (const half of halves) {
    for (let i = 3 * half * dof; i < (3 * half + 1) * dof; i++) {
      const u = rotate([J[i], J[i + dof], J[i + 2 * dof]]);
      for (let k = 0; k < 3; k++) made[i + k * dof] = u[k];
    }
  }
  return made;
}

/**
 * Transpose a matrix of this shape, held row by row.
 * @template T @param {T[]} flat @param {number[]} shape @returns {T[]}
 */
export const transpose = (flat, [rows, width]) =>
  flat.map((_, i) => flat[(i % rows) * width + Math.floor(i / rows)]);

/** Join the linear rows of one Jacobian with the angular rows of another. */
export const joinHalves = (v, w) => [...v.slice(0, v.length / 2), ...w.slice(w.length / 2)];

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
    const centre = plus(fromAxes(T[row + 1], centres[row]), T[row + 1].o);
    moment = addScaled(moment, masses[row], centre);
    if (c.at[k] !== row) continue;
    const { z, o } = T[row];
    const torque = -dot(z, cross(minus(moment, scaled(mass, o)), gravity));
    torques[k] = c.turns[k] ? torque : -dot(z, gravity) * mass;
    k--;
  }
  return torques;
}

/** Return the coordinates in frame `to` of a point given in frame `from`. */
export const changeFrame = (from, to, point) =>
  inAxes(to, minus(plus(fromAxes(from, point), from.o), to.o));

/** Return a wrench of the base's axes in those of a frame (R^T F). */
export const wrenchIntoFrame = (frame, F) => [
  ...inAxes(frame, F.slice(0, 3)),
  ...inAxes(frame, F.slice(3)),
];
/** Return a wrench of a frame's axes in those of the base (R F). */
export const wrenchFromFrame = (frame, F) => [
  ...fromAxes(frame, F.slice(0, 3)),
  ...fromAxes(frame, F.slice(3)),
];

/** Return J^T F. @param {number[]} J @param {number[]} F */
export const multiplyByTranspose = (J, F) =>
  Array.from({ length: J.length / 6 }, (_, k) =>
    F.reduce((sum, f, i) => sum + J[(i * J.length) / 6 + k] * f, 0),
  );
