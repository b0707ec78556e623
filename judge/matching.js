// The one judge of joint vectors: which branch one is, within its digits, and how far it misses.

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
 * All joint vectors that reach a target, and how many there are if those that coincide are counted
 * each.
 * @typedef {{ arm: Arm, branches: import("./geometry/inverse.js").Branch[], count: number }}
 *   Solutions
 */

const TARGET = 1e-4; // rad or m: what a target given with four decimals moves the joints
const REACHED = 1e-6; // m and rad: a pose this close is the target's, whatever the digits
export const NEARLY_ZERO = 1e-3; // a singular value, or a sine, this small counts as 0
const COUNTED = 1e6; // rad: in a larger angle rounding has eaten the turn's parts

// How joints agree with a branch's, whole turns aside.
function agreementWith(arm, { values, units }, branch, tolerance) {
  const turns = revoluteFlags(arm);
  const truth = branch.map((x, k) => values[k] + signedGap(turns[k], x, values[k]));
  const slack = branch.map(() => tolerance ?? TARGET);
  const places = tolerance === null ? units : units.map(() => 0);
  return agreement({ values, units: places }, truth, slack);
}

// The first branch that an answer is to its digits; -1 where it is none.
/** @param {Solutions} right @param {Answer} answer */
export const findBranch = ({ arm, branches }, answer, tolerance) =>
  branches.findIndex(({ q }) => isRight(agreementWith(arm, answer, q, tolerance)));

// Of each branch, which joints an answer has of it.
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

// The answer that gives each branch, the answers that give none, and whether all are right to their
// digits.
export function matchAnswers(right, given, tolerance) {
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
/** @param {Solutions} right @param {Answer} answer */
function matches(right, answer, tolerance) {
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
  const { values, vectors } = decomposeSingular(rows, dof);
  return q.map((_, k) =>
    vectors.some((v, i) => values[i] < NEARLY_ZERO && Math.abs(v[k]) > NEARLY_ZERO),
  );
}

// How far q's tip is from the target, [m, rad].
/** @returns {[number, number]} */
export const measureMiss = (right, q) => between(linkFrames(right.arm, q).at(-1), right);

/** @returns {[number, number]} */
function between(here, { arm, branches }) {
  const target = linkFrames(arm, branches[0].q).at(-1);
  return [norm(target.o.map((x, i) => x - here.o[i])), rotationBetween(here, target)];
}

// A length in m as so many digits of mm, not below a thousandth of one.
export const formatMillimetres = (metres, digits = 3) =>
  formatNumber(Number((1e3 * metres).toFixed(3)), digits);

// How far the target is missed, in words; `turned` (rad) is 0 where only a point was asked for.
export function describeMiss(away, turned) {
  const degrees = formatNumber(Number((turned * DEG).toFixed(3)));
  const turn = turned ? formatMessage("ik turn", { degrees }) : "";
  return formatMessage("ik off", { millimetres: formatMillimetres(away), turn });
}

// Whether q takes the tip to the target, to the digits of q; of an arm whose table is changed too.
export function reachesTarget(right, q, units = q.map(() => 0), change = (c) => c) {
  const frames = chainFrames(change(makeChain(right.arm, q)));
  const columns = jacobianColumns(right.arm, frames);
  const spread = (i) => columns.reduce((sum, column, k) => sum + Math.abs(column[i]) * units[k], 0);
  const most = (half) => Math.max(REACHED, norm(half.map(spread)));
  const [away, turned] = between(frames.at(-1), right);
  return away <= most([0, 1, 2]) && (q.length < 6 || turned <= most([3, 4, 5]));
}

// How far x is ahead of y, whole turns aside where a joint turns.
function signedGap(turns, x, y) {
  const gap = x - y;
  return turns && Math.abs(gap) < COUNTED
    ? gap - 2 * Math.PI * roundHalfToEven(gap / (2 * Math.PI))
    : gap;
}

/** @param {Answer} one @param {Answer} other */
export const isSameAnswer = (arm, one, other) =>
  agreementWith(arm, { ...one, units: one.units.map(() => 0) }, other.values, null) !== "";
