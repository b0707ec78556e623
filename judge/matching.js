// Compares a joint vector with the solution branches of a target, to its typed digits.

import { agreement, isRight } from "./digits.js";
import { DEG } from "./geometry/angles.js";
import { makeChain, chainFrames } from "./geometry/chains.js";
import {
  jacobianColumns,
  linkFrames,
  norm,
  rotationBetween,
  revoluteFlags,
} from "./geometry/kinematics.js";
import { decomposeSingular } from "./geometry/linear.js";
import { roundHalfToEven } from "./geometry/planar.js";
import { formatMessage, formatNumber } from "./sentences.js";

/** @typedef {import("./reading/joint_vectors.js").Answer} Answer */
/** @typedef {import("./geometry/arm.js").Arm} Arm */

/**
 * The solution branches of a target; `count` includes branches that coincide.
 * @typedef {{ arm: Arm, branches: import("./geometry/inverse.js").Branch[], count: number }}
 *   Solutions
 */

const TARGET = 1e-4; // rad or m: effect on the joints of a target typed with four decimals
const REACHED = 1e-6; // m and rad: a pose this close reaches the target whatever the digits of q
export const NEARLY_ZERO = 1e-3; // a singular value or a sine below it counts as 0
const COUNTED = 1e6; // rad: round-off of larger angles hides fractions of a turn

// Return how joint values agree with a branch, ignoring whole turns.
function agreementWith(arm, { values, units }, branch, tolerance) {
  const turns = revoluteFlags(arm);
  const truth = branch.map((x, k) => values[k] + signedGap(turns[k], x, values[k]));
  const slack = branch.map(() => tolerance ?? TARGET);
  const places = tolerance === null ? units : units.map(() => 0);
  return agreement({ values, units: places }, truth, slack);
}

// Return the index of the first branch equal to an answer to its digits, or -1.
/** @param {Solutions} right @param {Answer} answer */
export const findBranch = ({ arm, branches }, answer, tolerance) =>
  branches.findIndex(({ q }) => isRight(agreementWith(arm, answer, q, tolerance)));

// For each branch, flag the joints that agree with an answer.
/** @param {Solutions} right @param {Answer} answer */
export function matchJointsByBranch({ arm, branches }, { values, units }, tolerance) {
  const turns = revoluteFlags(arm);
  return branches.map(({ q }) =>
    values.map((x, k) => {
      const truth = x + signedGap(turns[k], q[k], x);
      const slack = [tolerance ?? TARGET];
      return isRight(agreement({ values: [x], units: [units[k]] }, [truth], slack));
    }),
  );
}

// Match answers with branches: `hits` maps a branch to the first answer (from 1) that gives it,
// `astray` lists answers that give none, `sharp` is true if all others are right to their digits.
export function matchAnswers(right, given, tolerance) {
  const hits = new Map();
  const astray = [];
  let sharp = true;
  given.forEach((answer, at) => {
    const found = listEqualBranches(right, answer, tolerance);
    for (const { branch } of found) if (!hits.has(branch)) hits.set(branch, at + 1);
    if (!found.length) astray.push(at + 1);
    else if (!found.some(({ how }) => isRight(how))) sharp = false;
  });
  return { hits, astray, sharp };
}

// List the branches that an answer equals, each with its agreement. If a branch has a free joint,
// any solution of its family counts.
/** @param {Solutions} right @param {Answer} answer */
function listEqualBranches(right, answer, tolerance) {
  const { arm, branches } = right;
  const found = branches.flatMap(({ q }, branch) => {
    const how = agreementWith(arm, answer, q, tolerance);
    return how ? [{ branch, how }] : [];
  });
  const families = branches.some(({ free }) => free.includes(true));
  if (found.length || !families || !reachesTarget(right, answer.values, answer.units)) return found;
  const own = matchJointsByBranch(right, answer, tolerance);
  return branches.flatMap(({ q, free }, branch) => {
    if (!free.includes(true)) return [];
    const loose = flagFreeJoints(arm, q);
    return own[branch].every((is, k) => is || loose[k]) ? [{ branch, how: "rounded" }] : [];
  });
}

// Flag the joints that can move without moving the tip: the null space of the Jacobian.
function flagFreeJoints(arm, q) {
  const dof = q.length;
  const columns = jacobianColumns(arm, linkFrames(arm, q));
  const rows = Array.from({ length: dof >= 6 ? 6 : 3 }, (_, i) =>
    columns.map((column) => column[i]),
  );
  const { values, vectors } = decomposeSingular(rows, dof);
  return q.map((_, k) =>
    vectors.some((v, i) => values[i] < NEARLY_ZERO && Math.abs(v[k]) > NEARLY_ZERO),
  );
}

// Return the distance (m) and angle (rad) from the tip at q to the target.
/** @returns {[number, number]} */
export const measureMiss = (right, q) => measureGap(linkFrames(right.arm, q).at(-1), right);

/** @returns {[number, number]} */
function measureGap(here, { arm, branches }) {
  const target = linkFrames(arm, branches[0].q).at(-1);
  return [norm(target.o.map((x, i) => x - here.o[i])), rotationBetween(here, target)];
}

// Format a length (m) in mm with some significant digits, at most three decimals.
export const formatMillimetres = (metres, digits = 3) =>
  formatNumber(Number((1e3 * metres).toFixed(3)), digits);

// Describe how far the target is missed; `turned` (rad) is 0 if the target is a point.
export function describeMiss(away, turned) {
  const degrees = formatNumber(Number((turned * DEG).toFixed(3)));
  const turn = turned ? formatMessage("ik turn", { degrees }) : "";
  return formatMessage("ik off", { millimetres: formatMillimetres(away), turn });
}

// Return whether q reaches the target to its digits; `change` may alter the arm's table first.
export function reachesTarget(right, q, units = q.map(() => 0), change = (c) => c) {
  const frames = chainFrames(change(makeChain(right.arm, q)));
  const columns = jacobianColumns(right.arm, frames);
  const spread = (i) => columns.reduce((sum, column, k) => sum + Math.abs(column[i]) * units[k], 0);
  const most = (half) => Math.max(REACHED, norm(half.map(spread)));
  const [away, turned] = measureGap(frames.at(-1), right);
  return away <= most([0, 1, 2]) && (q.length < 6 || turned <= most([3, 4, 5]));
}

// Return x - y, for a revolute joint without whole turns.
function signedGap(turns, x, y) {
  const gap = x - y;
  return turns && Math.abs(gap) < COUNTED
    ? gap - 2 * Math.PI * roundHalfToEven(gap / (2 * Math.PI))
    : gap;
}

/** @param {Answer} one @param {Answer} other */
export const isSameAnswer = (arm, one, other) =>
  agreementWith(arm, { ...one, units: one.units.map(() => 0) }, other.values, null) !== "";
