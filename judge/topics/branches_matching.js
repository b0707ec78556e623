// Which branch a typed joint vector is, within its digits.

import { HALF, HAND } from "../digits.js";
import { transposed } from "../geometry/chains.js";
import { rint } from "../geometry/planar.js";
import { jacobianColumns, joints, linkFrames, matrix } from "../geometry/kinematics.js";
import { singular } from "../geometry/linear.js";
import {
  eachJoint,
  inRadians,
  notPerJoint,
  numbers,
  turning,
  unnamed,
} from "../reading/numbers.js";
import { say } from "../sentences.js";

/** @typedef {import("./branches.js").Answer} Answer */

export const EXACT = 1.01e-4; // rad or m: answers copied from paper with four decimals still count

export const REACHED = 1e-6; // m and rad: a pose this close is the target's, whatever the digits

export const NEAR = 1e-3; // a singular value, or a sine, this small counts as 0

const BY_HAND = 0.0301; // rad or m: the most that rounding on the way is allowed

/**
 * Joint vectors with their units, however they were held, and how they were read; a square is read
 * by rows unless told.
 * @returns {{ answers: Answer[], taken: string[], typed: import("../reading/numbers.js").Typed }}
 */
export function answers(mine, arm, angles, byColumns = false) {
  const dof = joints(arm).length;
  const what = `${arm.name}: your answer`;
  const typed = numbers(unnamed(mine), what, undefined, eachJoint(arm));
  if (!typed.values.length) return { answers: [], taken: [], typed };
  const shape = shapeOf(typed, dof);
  const lies = shape.length === 2 && shape[0] === dof && (byColumns || shape[1] !== dof);
  const [count, width] = lies ? [shape[1], shape[0]] : shape;
  if (shape.length !== 2 || width !== dof) throw notPerJoint(what, arm, typed.shape);
  const upright = (list) => (lies ? transposed(list, shape) : list);
  const [values, units, entries] = [typed.values, typed.units, typed.entries].map(upright);
  const flat = inRadians({ values, units, entries }, arm, angles);
  const part = (list, i) => list.slice(i * dof, (i + 1) * dof);
  const both = Array.from({ length: count }, (_, i) => ({
    values: part(flat.values, i),
    units: part(flat.units, i),
  }));
  const taken = lies && count > 1 ? [say("taken: answer per column")] : [];
  return { answers: both, taken, typed };
}

// Rows and columns: a list is one row, and a single one however deep it lies.
export function shapeOf({ shape, values }, dof) {
  if (shape[1] === 1 && shape[0] > dof && shape[0] % dof === 0) return [shape[0] / dof, dof];
  const flat = shape.length > 2 ? shape.filter((n) => n !== 1) : shape;
  return flat.length < 2 ? [1, values.length] : flat;
}

export function marginsOf(units, tolerance, hand = false) {
  if (tolerance !== null) return units.map(() => Math.max(tolerance, 1e-9));
  const byHand = (u) => Math.max(HALF * u, Math.min(HAND * u, BY_HAND));
  return units.map((u) => Math.max(hand ? byHand(u) : HALF * u, EXACT));
}

// The answer that gives each branch, the answers that give none, and whether all are right to their
// digits.
export function hitsOf(right, given, tolerance) {
  const hits = new Map();
  const astray = [];
  let sharp = true;
  given.forEach(({ values, units }, at) => {
    let match = matches(right, values, marginsOf(units, tolerance));
    if (!match.length) {
      match = matches(right, values, marginsOf(units, tolerance, true));
      sharp = false;
    }
    for (const k of match) if (!hits.has(k)) hits.set(k, at + 1);
    if (!match.length) astray.push(at + 1);
  });
  return { hits, astray, sharp };
}

// The branches that q is: the same joints, or, where a joint is free, another member of the
// branch's family.
export function matches(right, q, margin) {
  const { arm, branches } = right;
  const gaps = branches.map((branch) => gapOf(arm, q, branch.q));
  const near = (gap) => gap.map((x, k) => x <= margin[k]);
  const same = gaps.map((gap) => near(gap).every(Boolean));
  let family = branches.map(({ free }) => free.includes(true));
  if (family.includes(true) && missOf(right, q, margin) === null) {
    family = family.map((is, b) => {
      if (!is) return false;
      const loose = movingInPlace(arm, branches[b].q);
      return near(gaps[b]).every((fits, k) => fits || loose[k]);
    });
    const far = gaps.map((gap, b) =>
      gap.reduce((sum, x, k) => sum + (branches[b].free[k] ? 0 : x), 0),
    );
    const least = Math.min(...far.filter((_, b) => family[b])) + Math.max(...margin);
    family.forEach((is, b) => (same[b] ||= is && far[b] < least));
  }
  return same.flatMap((is, b) => (is ? [b] : []));
}

// Which joints can move while the tip stands still, by the Jacobian's null space.
function movingInPlace(arm, q) {
  const dof = q.length;
  const columns = jacobianColumns(arm, linkFrames(arm, q));
  const rows = Array.from({ length: dof >= 6 ? 6 : 3 }, (_, i) =>
    columns.map((column) => column[i]),
  );
  const { values, vectors } = singular(rows, dof);
  return q.map((_, k) => vectors.some((v, i) => values[i] < NEAR && Math.abs(v[k]) > NEAR));
}

// How far q's tip is from the target, [m, rad], or null where the digits of q explain it.
/** @returns {[number, number] | null} */
export function missOf(right, q, margin) {
  const { arm, branches } = right;
  const [frames, target] = [q, branches[0].q].map((one) => linkFrames(arm, one));
  const away = length(target.at(-1).o.map((x, i) => x - frames.at(-1).o[i]));
  const turned = q.length >= 6 ? turnBetween(frames.at(-1), target.at(-1)) : 0;
  const columns = jacobianColumns(arm, frames);
  const spread = (i) =>
    columns.reduce((sum, column, k) => sum + Math.abs(column[i]) * margin[k], 0);
  const most = (half) => Math.max(REACHED, length(half.map(spread)));
  const [far, wide] = [most([0, 1, 2]), most([3, 4, 5])];
  return away <= far && turned <= wide ? null : [away, turned];
}

export const length = (v) => Math.sqrt(v.reduce((sum, x) => sum + x * x, 0));

// The angle (rad) of the turn from one frame to another.
export function turnBetween(here, there) {
  const [A, B] = [matrix(here), matrix(there)];
  const entry = (i, j) => A[0][i] * B[0][j] + A[1][i] * B[1][j] + A[2][i] * B[2][j];
  const R = [0, 1, 2].map((i) => [0, 1, 2].map((j) => entry(i, j)));
  const off = length([R[2][1] - R[1][2], R[0][2] - R[2][0], R[1][0] - R[0][1]]);
  return Math.atan2(off, R[0][0] + R[1][1] + R[2][2] - 1);
}

export function gapOf(arm, q, other) {
  const turns = turning(arm);
  return q.map((x, k) => gapBetween(turns[k], x, other[k]));
}

// rad: in a larger angle rounding has eaten the turn's parts, and whole turns cannot be counted off
const COUNTED = 1e6;

export function gapBetween(turns, x, y) {
  const gap = Math.abs(x - y);
  return turns && gap < COUNTED ? Math.abs(gap - 2 * Math.PI * rint(gap / (2 * Math.PI))) : gap;
}
