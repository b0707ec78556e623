// Compares joint vectors with the solution branches of a target, to their typed digits.

import { compareDigits, isRight } from "./digits.js";
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
export const NEARLY_ZERO = 1e-3; // singular values and sines below this count as 0
const LARGEST_ANGLE = 1e6; // rad: the round-off of larger angles hides fractions of a turn

// Compare joint values with a branch, ignoring whole turns.
function compareWithBranch(arm, { values, units }, branch, tolerance) {
  const isRevolute = revoluteFlags(arm);
  const expected = branch.map((x, k) => values[k] + signedGap(isRevolute[k], x, values[k]));
  const slack = branch.map(() => tolerance ?? TARGET_ROUNDING);
  const typedUnits = tolerance === null ? units : units.map(() => 0);
  return compareDigits({ values, units: typedUnits }, expected, slack);
}

/** Return the index of the first branch that equals an answer to its digits, or -1. */
export const findBranch = (
  /** @type {Solutions} */ { arm, branches },
  /** @type {JointVector} */ answer,
  tolerance,
) => branches.findIndex(({ q }) => isRight(compareWithBranch(arm, answer, q, tolerance)));

/**
 * Return for each branch whether each joint of an answer agrees with it.
 * @param {Solutions} solutions
 * @param {JointVector} answer
 * @param {number | null} tolerance used instead of the typed digits (rad or m)
 */
export function matchJointsByBranch({ arm, branches }, { values, units }, tolerance) {
  const isRevolute = revoluteFlags(arm);
  return branches.map(({ q }) =>
    values.map((x, k) => {
      const expected = x + signedGap(isRevolute[k], q[k], x);
      const slack = [tolerance ?? TARGET_ROUNDING];
      return isRight(compareDigits({ values: [x], units: [units[k]] }, [expected], slack));
    }),
  );
}

/**
 * Match answers with branches.
 * @param {Solutions} solutions
 * @param {JointVector[]} answers
 * @param {number | null} tolerance used instead of the typed digits (rad or m)
 * @returns {{ answerByBranch: Map<number, number>, wrongNumbers: number[], isExact: boolean }}
 *   `answerByBranch` maps a branch's index to the number (from 1) of the first answer that equals
 *   it; `wrongNumbers` are the numbers of the answers that equal no branch; `isExact` is true if
 *   all other answers are right to their digits
 */
export function matchAnswers(solutions, answers, tolerance) {
  const answerByBranch = new Map();
  const wrongNumbers = [];
  let isExact = true;
  answers.forEach((answer, index) => {
    const matches = listEqualBranches(solutions, answer, tolerance);
    for (const { branch } of matches)
      if (!answerByBranch.has(branch)) answerByBranch.set(branch, index + 1);
    if (!matches.length) wrongNumbers.push(index + 1);
    else if (!matches.some(({ agreement }) => isRight(agreement))) isExact = false;
  });
  return { answerByBranch, wrongNumbers, isExact };
}

// List the branches that an answer equals, each with its agreement. If a branch has a free joint,
// any solution of its family counts.
/** @param {Solutions} solutions @param {JointVector} answer */
function listEqualBranches(solutions, answer, tolerance) {
  const { arm, branches } = solutions;
  const matches = branches.flatMap(({ q }, branch) => {
    const agreement = compareWithBranch(arm, answer, q, tolerance);
    return agreement ? [{ branch, agreement }] : [];
  });
  const hasFamily = branches.some(({ free }) => free.includes(true));
  if (matches.length || !hasFamily || !reachesTarget(solutions, answer.values, answer.units))
    return matches;
  const matchesByBranch = matchJointsByBranch(solutions, answer, tolerance);
  return branches.flatMap(({ q, free }, branch) => {
    if (!free.includes(true)) return [];
    const freeJoints = flagFreeJoints(arm, q);
    const isInFamily = matchesByBranch[branch].every((isEqual, k) => isEqual || freeJoints[k]);
    return isInFamily ? [{ branch, agreement: "rounded" }] : [];
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
export const measureMiss = (solutions, q) =>
  measureTipError(linkFrames(solutions.arm, q).at(-1), solutions);

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
 * @param {Solutions} solutions
 * @param {number[]} q joint values (rad or m)
 * @param {number[]} [units] of the last typed digit of each joint value
 * @param {(chain: any) => any} [change] changes the arm's table or joint values first
 */
export function reachesTarget(solutions, q, units = q.map(() => 0), change = (chain) => chain) {
  const frames = chainFrames(change(makeChain(solutions.arm, q)));
  const columns = jacobianColumns(solutions.arm, frames);
  const boundRow = (i) =>
    columns.reduce((sum, column, k) => sum + Math.abs(column[i]) * units[k], 0);
  const bound = (rows) => Math.max(REACHED, norm(rows.map(boundRow)));
  const [distance, angle] = measureTipError(frames.at(-1), solutions);
  return distance <= bound([0, 1, 2]) && (q.length < 6 || angle <= bound([3, 4, 5]));
}

// Return x - y, without whole turns for a revolute joint.
function signedGap(isRevolute, x, y) {
  const gap = x - y;
  return isRevolute && Math.abs(gap) < LARGEST_ANGLE
    ? gap - 2 * Math.PI * roundHalfToEven(gap / (2 * Math.PI))
    : gap;
}

/**
 * Return whether two answers are equal up to the rounding of a target.
 * @param {Arm} arm @param {JointVector} first @param {JointVector} second
 */
export const isSameAnswer = (arm, first, second) =>
  compareWithBranch(arm, { ...first, units: first.units.map(() => 0) }, second.values, null) !== "";
