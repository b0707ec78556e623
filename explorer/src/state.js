// What the explorer shows now, what follows from it, and who wants to know.

import { gravityTorque, jacobianColumns, joints, linkFrames, wrenchTorque } from "./kinematics.js";
import { determinant, plainBasis, singular } from "./linear.js";

const RANK = 1e-6; // singular values below this share of the largest count as zero

// Everything that is computed once for each joint vector and wrench.
export function derive(arm, q, wrench) {
  const frames = linkFrames(arm, q);
  const columns = jacobianColumns(arm, frames);
  const { values, vectors } = singular(columns);
  const rank = values.filter((value) => value > RANK * values[0]).length;
  const linear = singular(columns.map((column) => column.slice(0, 3)), 3);
  const six = columns.length >= 6;
  const gravity = gravityTorque(arm, frames);
  const push = wrenchTorque(columns, wrench);
  return {
    frames, columns, rank, values, linear, gravity, push,
    lost: six ? plainBasis(vectors.slice(rank)) : [],
    determinant: columns.length === 3 ? determinant(columns.map((c) => c.slice(0, 3))) : determinant(columns),
    manipulability: (six ? values : linear.values.slice(0, columns.length)).reduce((p, v) => p * v, 1),
    torque: gravity.map((g, i) => g - push[i]),
  };
}

export class Store {
  #listeners = [];

  constructor(state) {
    this.state = { ...state };
    this.derived = derive(state.arm, state.q, state.wrench);
  }

  // Change some fields, compute what follows, and tell everyone which fields changed and who asked.
  set(patch, by = "reader") {
    const changed = Object.keys(patch).filter((key) => this.state[key] !== patch[key]);
    if (!changed.length) return;
    Object.assign(this.state, patch);
    if (changed.some((key) => ["arm", "q", "wrench"].includes(key))) {
      this.derived = derive(this.state.arm, this.state.q, this.state.wrench);
    }
    for (const listener of this.#listeners) listener(new Set(changed), by);
  }

  listen(listener) {
    this.#listeners.push(listener);
  }
}

// The joint vector for an arm whose rows were changed: joints keep their values by row, new ones start at 0.
export function carriedOver(from, q, to, rowBefore) {
  const byRow = new Map(joints(from).map((row, i) => [row, [from.rows[row].kind, q[i]]]));
  return joints(to).map((row) => {
    const [kind, value] = byRow.get(rowBefore(row)) ?? [];
    return kind === to.rows[row].kind ? value : 0;
  });
}
