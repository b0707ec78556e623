// Jacobians and weights of mistaken tables and recipes. A Jacobian is a list of 6 x dof numbers,
// row by row, as people write it.

import {
  cosSin,
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

export { cosSin };

/**
 * An arm at a pose; mistakes give it another table or another pose.
 * @typedef {{ rows: import("./arm.js").Row[], q: number[], at: number[], turns: boolean[], dof:
 *   number }} Chain
 */

/** @returns {Chain} */
export const makeChain = (arm, q) => ({
  rows: arm.rows,
  q,
  at: movingRows(arm),
  turns: revoluteFlags(arm),
  dof: q.length,
});

export const chainFrames = (c) => linkFrames(c, c.q);

/**
 * A Jacobian built column by column, with a step of the recipe done otherwise: `axis` and `origin`
 * are the frames whose z and o serve each joint, `point` the frame whose origin moves, as far as o
 * is `subtracted` from it and z `crossed` with it.
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
    const arm = subtracted ? minus(tip, o) : tip;
    const linear = turns ? (crossed ? cross(z, arm) : arm) : z;
    for (let i = 0; i < 3; i++) {
      J[i * c.dof + k] = linear[i];
      J[(i + 3) * c.dof + k] = turns ? z[i] : 0;
    }
  });
  return J;
}

// Frames whose axes and origins are read along the rows of T, its last row (0, 0, 0, 1) for the
// origin.
export const swapRowsForColumns = (T) =>
  T.map(({ x, y, z }) => {
    const row = (i) => [x[i], y[i], z[i]];
    return { x: row(0), y: row(1), z: row(2), o: ZERO };
  });

const inAxes = ({ x, y, z }, u) => [dot(x, u), dot(y, u), dot(z, u)];
const fromAxes = ({ x, y, z }, u) => plus(plus(scaled(u[0], x), scaled(u[1], y)), scaled(u[2], z));

// Both halves, or one of them (0 linear, 1 angular), of a Jacobian in the axes of a frame (R^T J),
// or back (R J).
export const rotateIntoFrame = (J, frame, halves = [0, 1]) =>
  turned(J, (u) => inAxes(frame, u), halves);
export const rotateFromFrame = (J, frame) => turned(J, (u) => fromAxes(frame, u), [0, 1]);

function turned(J, turn, halves) {
  const dof = J.length / 6;
  const made = J.slice();
  for (const half of halves) {
    for (let i = 3 * half * dof; i < (3 * half + 1) * dof; i++) {
      const u = turn([J[i], J[i + dof], J[i + 2 * dof]]);
      for (let k = 0; k < 3; k++) made[i + k * dof] = u[k];
    }
  }
  return made;
}

// Rows as columns of a matrix of this shape.
/** @template T @param {T[]} flat @param {number[]} shape @returns {T[]} */
export const transpose = (flat, [rows, width]) =>
  flat.map((_, i) => flat[(i % rows) * width + Math.floor(i / rows)]);

export const joinHalves = (v, w) => [...v.slice(0, v.length / 2), ...w.slice(w.length / 2)];

// g(q) for a mass and a centre, in its row's frame, of each row.
export function gravityTorques(c, T, masses, centres, gravity) {
  const found = new Array(c.dof);
  let [mass, moment, k] = [0, ZERO, c.dof - 1];
  for (let row = c.rows.length - 1; row >= 0; row--) {
    mass += masses[row];
    moment = plus(
      moment,
      scaled(masses[row], plus(fromAxes(T[row + 1], centres[row]), T[row + 1].o)),
    );
    if (c.at[k] !== row) continue;
    const { z, o } = T[row];
    const turning = -dot(z, cross(minus(moment, scaled(mass, o)), gravity));
    found[k] = c.turns[k] ? turning : -dot(z, gravity) * mass;
    k--;
  }
  return found;
}

// A wrench as it reads in the axes of a frame (R^T F), or its numbers meant in them (R F).
export const wrenchIntoFrame = (frame, F) => [
  ...inAxes(frame, F.slice(0, 3)),
  ...inAxes(frame, F.slice(3)),
];
export const wrenchFromFrame = (frame, F) => [
  ...fromAxes(frame, F.slice(0, 3)),
  ...fromAxes(frame, F.slice(3)),
];

// J^T F.
export const wrenchTorques = (J, F) =>
  Array.from({ length: J.length / 6 }, (_, k) =>
    F.reduce((sum, f, i) => sum + J[(i * J.length) / 6 + k] * f, 0),
  );
