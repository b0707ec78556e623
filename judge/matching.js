// Compares joint vectors with the solution branches of a target, to their typed digits.

import { agreement, isRight } from "./digits.js";
import { DEG } from "./geometry/angles.js";
import { makeChain, chainFrames } from "./geometry/chains.js";
import {
  jacobianColumns,
  linkFrames,
  minus,
  norm,
  rotationBetween,
  revoluteFlags,
} from "./geometry/kinematics.js";
import { decomposeSingular } from "./geometry/linear.js";
import { roundHalfToEven } from "./geometry/planar.js";
import { formatMessage, formatNumber } from "./sentences.js";

/** @typedef {import("./reading/joint_vectors.js").JointVector} JointVector */
/** @typedef {import("./geometry/arm.js").Arm} Arm */

/**
 * The solution branches of a target; `count` includes branches that coincide.
 * @typedef {{ arm: Arm, branches: import("./geometry/inverse.js").Branch[], count: number }}
 *   Solutions
 */

const TARGET_ROUNDING = 1e-4; // rad or m: effect on the joints of a target typed with four decimals
const REACHED = 1e-6; // m and rad: a pose this close reaches the target whatever the digits of q
export const NEARLY_ZERO = 1e-3; // a singular value or a sine below it counts as 0
const LARGEST_ANGLE = 1e6; // rad: the round-off of larger angles hides fractions of a turn

// Return how joint values agree with a branch, ignoring whole turns.
function compareWithBranch(arm, { values, units }, branch, tolerance) {
  const turns = revoluteFlags(arm);
  const expected = branch.map((x, k) => values[k] + signedGap(turns[k], x, values[k]));
  const slack = branch.map(() => tolerance ?? TARGET_ROUNDING);
  const typedUnits = tolerance === null ? units : units.map(() => 0);
  return agreement({ values, units: typedUnits }, expected, slack);
}

/** Return the index of the first branch that equals an answer to its digits, or -1. */
export const findBranch = (
  /** @type {Solutions} */ { arm, branches },
  /** @type {JointVector} */ answer,
  tolerance,
) => branches.findIndex(({ q }) => isRight(compareWithBranch(arm, answer, q, tolerance)));

/**
 * Return for each branch whether each joint of an answer agrees with it.
 * @param {Solutions} right
 * @param {JointVector} answer
 * @param {number | null} tolerance used instead of the typed digits (rad or m)
 */
export function matchJointsByBranch({ arm, branches }, { values, units }, tolerance) {
  const turns = revoluteFlags(arm);
  return branches.map(({ q }) =>
    values.map((x, k) => {
      const expected = x + signedGap(turns[k], q[k], x);
      const slack = [tolerance ?? TARGET_ROUNDING];
      return isRight(agreement({ values: [x], units: [units[k]] }, [expected], slack));
    }),
  );
}

/**
 * Match answers with branches.
 * @param {Solutions} right
 * @param {JointVector[]} given
 * @param {number | null} tolerance used instead of the typed digits (rad or m)
 * @returns {{ hits: Map<number, number>, wrongNumbers: number[], isExact: boolean }} `hits` maps a
 *   branch to the first answer, from 1, that equals it; `wrongNumbers` are those of the answers
 *   that equal no branch; `isExact` is true if the other answers are right to their digits
 */
export function matchAnswers(right, given, tolerance) {
  const hits = new Map();
  const wrongNumbers = [];
  let isExact = true;
  given.forEach((answer, index) => {
    const matches = listEqualBranches(right, answer, tolerance);
    for (const { branch } of matches) if (!hits.has(branch)) hits.set(branch, index + 1);
    if (!matches.length) wrongNumbers.push(index + 1);
    else if (!matches.some(({ how }) => isRight(how))) isExact = false;
  });
  return { hits, wrongNumbers, isExact };
}

// List the branches that an answer equals, each with its agreement. If a branch has a free joint,
// any solution of its family counts.
/** @param {Solutions} right @param {JointVector} answer */
function listEqualBranches(right, answer, tolerance) {
  const { arm, branches } = right;
  const matches = branches.flatMap(({ q }, branch) => {
    const how = compareWithBranch(arm, answer, q, tolerance);
    return how ? [{ branch, how }] : [];
  });
  const hasFamily = branches.some(({ free }) => free.includes(true));
  if (matches.length || !hasFamily || !reachesTarget(right, answer.values, answer.units))
    return matches;
  const matchesByBranch = matchJointsByBranch(right, answer, tolerance);
  return branches.flatMap(({ q, free }, branch) => {
    if (!free.includes(true)) return [];
    const freeJoints = flagFreeJoints(arm, q);
    const isInFamily = matchesByBranch[branch].every((agrees, k) => agrees || freeJoints[k]);
    return isInFamily ? [{ branch, how: "rounded" }] : [];
  });
}

// Return for each joint whether it can move without moving the tip, by the Jacobian's null space.
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
export const measureMiss = (right, q) => measureTipError(linkFrames(right.arm, q).at(-1), right);

/** @returns {[number, number]} */
function measureTipError(tip, { arm, branches }) {
  const target = linkFrames(arm, branches[0].q).at(-1);
  return [norm(minus(target.o, tip.o)), rotationBetween(tip, target)];
}

// Format a length (m) in mm with some significant digits, at most three decimals.
export const formatMillimetres = (metres, digits = 3) =>
  formatNumber(Number((1e3 * metres).toFixed(3)), digits);

/**
 * Describe how far a tip is from its target.
 * @param {number} distance m
 * @param {number} angle rad; 0 if the target is a point
 */
export function describeMiss(distance, angle) {
  const degrees = formatNumber(Number((angle * DEG).toFixed(3)));
  const turn = angle ? formatMessage("ik turn", { degrees }) : "";
  return formatMessage("ik off", { millimetres: formatMillimetres(distance), turn });
}

/**
 * Return whether q reaches the target to its digits.
 * @param {Solutions} right
 * @param {number[]} q joint values (rad or m)
 * @param {number[]} [units] of the last typed digit of each joint value
 * @param {(chain: any) => any} [change] changes the arm's table or joint values first
 */
export function reachesTarget(right, q, units = q.map(() => 0), change = (chain) => chain) {
  const frames = chainFrames(change(makeChain(right.arm, q)));
  const columns = jacobianColumns(right.arm, frames);
  const spread = (i) => columns.reduce((sum, column, k) => sum + Math.abs(column[i]) * units[k], 0);
  const most = (rows) => Math.max(REACHED, norm(rows.map(spread)));
  const [distance, angle] = measureTipError(frames.at(-1), right);
  return distance <= most([0, 1, 2]) && (q.length < 6 || angle <= most([3, 4, 5]));
}

// Return x - y, without whole turns for a revolute joint.
function signedGap(turns, x, y) {
  const gap = x - y;
  return turns && Math.abs(gap) < LARGEST_ANGLE
    ? gap - 2 * Math.PI * roundHalfToEven(gap / (2 * Math.PI))
    : gap;
}

/**
 * Return whether two answers are equal up to the rounding of a target.
 * @param {Arm} arm @param {JointVector} first @param {JointVector} second
 */
export const isSameAnswer = (arm, first, second) =>
  compareWithBranch(arm, { ...first, units: first.units.map(() => 0) }, second.values, null) !== "";
