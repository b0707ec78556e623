// Which branch a typed joint vector is, within its digits.

import { agreement, isRight } from "../digits.js";
import { chain, framesOf, transposed } from "../geometry/chains.js";
import { rint } from "../geometry/planar.js";
import { jacobianColumns, joints, linkFrames, matrix, turning } from "../geometry/kinematics.js";
import { singular } from "../geometry/linear.js";
import {
  eachJoint,
  inRadians,
  jointShapes,
  notPerJoint,
  numbers,
  rowsOf,
  setAside,
  unnamed,
} from "../reading/numbers.js";
import { say } from "../sentences.js";

/** @typedef {import("./branches.js").Answer} Answer */
/** @typedef {import("./branches.js").Right} Right */

const NAMES = /^(?:q|th|θ|sol|ans$|s\d*$)/i;
const TARGET = 1e-4; // rad or m: what a target given with four decimals moves the joints
const REACHED = 1e-6; // m and rad: a pose this close is the target's, whatever the digits
export const NEAR = 1e-3; // a singular value, or a sine, this small counts as 0
const COUNTED = 1e6; // rad: in a larger angle rounding has eaten the turn's parts

/**
 * Joint vectors with their units, however they were held, and how they were read; a square is read
 * by rows unless told. Where each row of a locked arm has a value, those of its locked joints are
 * set aside.
 * @param {any} mine @param {any} arm @param {string} angles @param {any} asked
 * @returns {{ answers: Answer[], taken: string[], typed: import("../reading/numbers.js").Typed }}
 */
export function answers(mine, arm, angles, { byColumns = false, ...asked } = {}) {
  const moving = joints(arm);
  const dof = moving.length;
  const what = `${arm.name}: your answer`;
  const wants = { wants: jointShapes(arm), names: NAMES, ...asked };
  const typed = numbers(unnamed(mine), what, undefined, eachJoint(arm), wants);
  if (!typed.values.length) return { answers: [], taken: [], typed };
  const shape = shapeOf(typed, dof);
  const width = !shape.includes(dof) && shape.includes(arm.rows.length) ? arm.rows.length : dof;
  const lies = shape[0] === width && (byColumns || shape[1] !== width);
  if (shape.length !== 2 || shape[lies ? 0 : 1] !== width)
    throw notPerJoint(what, arm, typed.shape);
  const upright = (list) => (lies ? transposed(list, shape) : list);
  const kept = (list) =>
    upright(list).filter((_, i) => width === dof || moving.includes(i % width));
  const [values, units, entries] = [typed.values, typed.units, typed.entries].map(kept);
  const flat = inRadians({ ...typed, values, units, entries }, arm, angles);
  const [each, places] = [rowsOf(flat.values, dof), rowsOf(flat.units, dof)];
  const locked = width > dof ? [setAside(arm, upright(typed.values))] : [];
  const taken = [...typed.said, ...inUnit(typed, angles), ...perColumn(lies, each), ...locked];
  return { answers: each.map((one, i) => ({ values: one, units: places[i] })), taken, typed };
}

// What is told where the text names another unit than the question.
/** @param {import("../reading/numbers.js").Typed} typed @param {string} angles */
const inUnit = ({ says }, angles) =>
  says?.angles && says.angles !== angles
    ? [say(says.angles === "deg" ? "taken: degrees" : "taken: radians")]
    : [];

const perColumn = (lies, { length }) =>
  lies && length > 1 ? [say("taken: answer per column")] : [];

// Rows and columns: a list is one row, and a single one however deep it lies.
function shapeOf({ shape, values }, dof) {
  if (shape[1] === 1 && shape[0] > dof && shape[0] % dof === 0) return [shape[0] / dof, dof];
  const flat = shape.length > 2 ? shape.filter((n) => n !== 1) : shape;
  return flat.length < 2 ? [1, values.length] : flat;
}

// How joints agree with a branch's, whole turns aside.
function agreementWith(arm, { values, units }, branch, tolerance) {
  const turns = turning(arm);
  const truth = branch.map((x, k) => values[k] + signedGap(turns[k], x, values[k]));
  const slack = branch.map(() => tolerance ?? TARGET);
  const places = tolerance === null ? units : units.map(() => 0);
  return agreement({ values, units: places }, truth, slack);
}

// The first branch that an answer is to its digits; -1 where it is none.
/** @param {Right} right @param {Answer} answer */
export const isBranch = ({ arm, branches }, answer, tolerance) =>
  branches.findIndex(({ q }) => isRight(agreementWith(arm, answer, q, tolerance)));

// Of each branch, which joints an answer has of it.
/** @param {Right} right @param {Answer} answer */
export function jointsOf({ arm, branches }, { values, units }, tolerance) {
  const turns = turning(arm);
  return branches.map(({ q }) =>
    values.map((x, k) => {
      const truth = x + signedGap(turns[k], q[k], x);
      const slack = [tolerance ?? TARGET];
      return isRight(agreement({ values: [x], units: [units[k]] }, [truth], slack));
    }),
  );
}

// The answer that gives each branch, the answers that give none, and whether all are right to their
// digits.
export function hitsOf(right, given, tolerance) {
  const hits = new Map();
  const astray = [];
  let sharp = true;
  given.forEach((answer, at) => {
    const found = matches(right, answer, tolerance);
    for (const { branch } of found) if (!hits.has(branch)) hits.set(branch, at + 1);
    if (!found.length) astray.push(at + 1);
    else if (!found.some(({ how }) => isRight(how))) sharp = false;
  });
  return { hits, astray, sharp };
}

// The branches that an answer is, and how: the same joints, or, where a joint is free, another
// member of the branch's family.
/** @param {Right} right @param {Answer} answer */
export function matches(right, answer, tolerance) {
  const { arm, branches } = right;
  const found = branches.flatMap(({ q }, branch) => {
    const how = agreementWith(arm, answer, q, tolerance);
    return how ? [{ branch, how }] : [];
  });
  const families = branches.some(({ free }) => free.includes(true));
  if (found.length || !families || !reaches(right, answer.values, answer.units)) return found;
  const own = jointsOf(right, answer, tolerance);
  return branches.flatMap(({ q, free }, branch) => {
    if (!free.includes(true)) return [];
    const loose = movingInPlace(arm, q);
    return own[branch].every((is, k) => is || loose[k]) ? [{ branch, how: "rounded" }] : [];
  });
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

// How far q's tip is from the target, [m, rad].
/** @returns {[number, number]} */
export const missOf = (right, q) => between(linkFrames(right.arm, q).at(-1), right);

/** @returns {[number, number]} */
function between(here, { arm, branches }) {
  const target = linkFrames(arm, branches[0].q).at(-1);
  return [length(target.o.map((x, i) => x - here.o[i])), turnBetween(here, target)];
}

// Whether q takes the tip to the target, to the digits of q; of an arm whose table is changed too.
export function reaches(right, q, units = q.map(() => 0), change = (c) => c) {
  const frames = framesOf(change(chain(right.arm, q)));
  const columns = jacobianColumns(right.arm, frames);
  const spread = (i) => columns.reduce((sum, column, k) => sum + Math.abs(column[i]) * units[k], 0);
  const most = (half) => Math.max(REACHED, length(half.map(spread)));
  const [away, turned] = between(frames.at(-1), right);
  return away <= most([0, 1, 2]) && (q.length < 6 || turned <= most([3, 4, 5]));
}

const length = (v) => Math.sqrt(v.reduce((sum, x) => sum + x * x, 0));

// The angle (rad) of the turn from one frame to another.
export function turnBetween(here, there) {
  const [A, B] = [matrix(here), matrix(there)];
  const entry = (i, j) => A[0][i] * B[0][j] + A[1][i] * B[1][j] + A[2][i] * B[2][j];
  const R = [0, 1, 2].map((i) => [0, 1, 2].map((j) => entry(i, j)));
  const off = length([R[2][1] - R[1][2], R[0][2] - R[2][0], R[1][0] - R[0][1]]);
  return Math.atan2(off, R[0][0] + R[1][1] + R[2][2] - 1);
}

// How far x is ahead of y, whole turns aside where a joint turns.
function signedGap(turns, x, y) {
  const gap = x - y;
  return turns && Math.abs(gap) < COUNTED ? gap - 2 * Math.PI * rint(gap / (2 * Math.PI)) : gap;
}

/** @param {Answer} one @param {Answer} other */
export const sameAnswer = (arm, one, other) =>
  agreementWith(arm, { ...one, units: one.units.map(() => 0) }, other.values, null) !== "";
