// Finds the mistake that explains a wrong trajectory. It is in the path or in the loop that
// computed the trajectory.

import { DEG } from "../geometry/angles.js";
import { jacobianColumns, minus, norm, rotationBetween, scaled } from "../geometry/kinematics.js";
import { subtractEach, nullSpace } from "../geometry/linear.js";
import { makeChain, flatJacobian, chainFrames } from "../geometry/chains.js";
import { listJacobianRecipes } from "./jacobian.js";
import { listJointMistakes } from "./joints.js";
import { listTableMistakes } from "./chain.js";
import { combineCauses, keep, makeCause } from "./ranking.js";
import {
  listAngleSteps,
  listDisplacedPaths,
  listPathsWithOneMistake,
  listPathsWithTwoMistakes,
} from "./trace_paths.js";

// Error that the method of a right program may leave. Euler's method on the homework's circle stays
// well below it. A tool that turns by less counts as keeping its orientation.
export const [METHOD_ERROR, METHOD_TILT] = [2e-3, 1 / DEG]; // m, rad
// Share of the joint motion: the error of a program's rounded constants, such as pi = 3.1416.
const CONSTANT_ERROR = 1e-5;

/** @typedef {import("./ranking.js").Cause} Cause */
/** @typedef {import("../geometry/path.js").Path} Path */
/**
 * The equation K(q_k) (q_{k+1} - q_k) = (v(t_k) dt, 0 ...) that the student's loop solves. In the
 * right equation K is the Jacobian, as a list row by row, and v the path's velocity.
 * @typedef {object} Rule
 * @property {Cause} [cause] the mistake in the equation
 * @property {(c: any, T: any[]) => number[]} [recipe] makes K of an arm at a configuration
 * @property {(t: number, dt: number) => number[]} [v]
 */
/**
 * A joint trajectory with the path that it should follow.
 * @typedef {object} Trace
 * @property {number[][]} q joint values without jumps by whole turns (rad or m)
 * @property {number[][]} typedRows joint values as they were typed
 * @property {number[][]} units of the last typed digits
 * @property {any} arm
 * @property {Path} path
 * @property {(k: number) => [any, any[]]} at returns the chain and the frames at row k, which may
 *   be half way between two rows
 */

/** @returns {Trace} */
export function makeTrace(q, units, arm, path, typedRows = q) {
  const statesByRow = new Map();
  const at = (k) => {
    if (!statesByRow.has(k)) {
      const next = q[Math.ceil(k)];
      const configuration = q[Math.floor(k)].map((x, i) => (x + next[i]) / 2);
      const c = makeChain(arm, configuration);
      statesByRow.set(k, [c, chainFrames(c)]);
    }
    return statesByRow.get(k);
  };
  return { q, typedRows, units, arm, path, at };
}

/**
 * Explain a wrong trajectory, or return null.
 *
 * Causes in this order: coordinates of the centre left out; if the tip is off the path, a mistake
 * in the table or the path; the rule of the loop, to the digits; with symptoms, a mistake in the
 * joint values; two mistakes in the loop; any other shift; with symptoms, the rule to the error of
 * a right program; two mistakes in the path.
 * @param {Trace} trace
 * @param {number[][]} tip its points
 * @param {number[]} allowed largest error of the tip at each step (m)
 * @param {{ isOff: boolean, hasSymptoms: boolean }} state whether the tip leaves the path, and
 *   whether anything in the motion is wrong
 */
export function findTraceCause(trace, tip, allowed, { isOff, hasSymptoms }) {
  const { arm, path } = trace;
  const find = (mistakes) => findMotionCause(trace, mistakes, allowed);
  const [tableMistakes, jointMistakes] = [listTableMistakes(arm), listJointMistakes(arm)];
  const [shifts, wrongPaths] = isOff
    ? [listDisplacedPaths(path, tip[0], allowed[0]), listPathsWithOneMistake(path)]
    : [[], []];
  const [shift] = shifts;
  if (followsPath(trace)) {
    const findOther = () => find([...tableMistakes, ...jointMistakes]);
    return shift ? chooseShiftCause(shift, findOther) : null;
  }
  const pathRules = wrongPaths.map((wrong) => ({ cause: wrong.cause, v: wrong.path.velocity }));
  const rules = [...listVelocityRules(path), ...pathRules, ...listMatrixRules(trace)];
  return (
    find(isOff ? [...tableMistakes, ...wrongPaths, ...shifts.filter(isCentreless)] : []) ??
    findLoopCause(trace, rules) ??
    find(hasSymptoms ? jointMistakes : []) ??
    findLoopCause(trace, listPairsOfRules(trace)) ??
    find(shifts) ??
    findLoopCause(trace, hasSymptoms ? listMatrixRules(trace) : [], [METHOD_ERROR, METHOD_TILT]) ??
    find(isOff ? listPathsWithTwoMistakes(path) : [])
  );
}

const isCentreless = ({ cause }) => cause.keys[0] === "trace.centre";

// Choose the cause of a trajectory that follows the right rule from a wrong start.
const chooseShiftCause = (shift, findOther) =>
  isCentreless(shift) ? shift.cause : (findOther() ?? shift.cause);

// Find the first mistake with which the tip would follow the path, and the tool keep its
// orientation. It is made in the table (`change`) or in the path, or undone in the joint values
// (`correct`).
function findMotionCause({ typedRows, arm, path: rightPath }, mistakes, allowed) {
  const keepsTool = typedRows[0].length >= 6;
  for (const { cause, change = keep, correct = keep, path = rightPath } of mistakes) {
    const toolAt = (row) => chainFrames(change(makeChain(arm, correct(row)))).at(-1);
    const first = toolAt(typedRows[0]);
    const isRight = (row, k) => {
      const tool = toolAt(row);
      const isNear = norm(minus(tool.o, path.position(path.times[k]))) <= allowed[k];
      return isNear && (!keepsTool || rotationBetween(first, tool) <= METHOD_TILT);
    };
    if (typedRows.every(isRight)) return cause;
  }
  return null;
}

/** Return whether the right rule holds to the digits, by Euler's method. @param {Trace} trace */
export const followsPathByEuler = (trace) => measureRuleError(trace, {}) <= 1;

// Return whether a trajectory obeys the right rule, up to the error of Euler's method or round-off.
const followsPath = (trace) =>
  followsPathByEuler(trace) || measureRuleError(trace, {}, [0, 0]) <= 1;

/**
 * Find the rule that gives each step from the previous step. It must hold by Euler's method to the
 * digits, or by any method within the errors `near`. Null if no rule has less than half of the
 * right rule's error.
 * @param {Trace} trace @param {Iterable<Rule>} rules @param {number[] | null} near
 */
function findLoopCause(trace, rules, near = null) {
  let [best, least] = [
    /** @type {Cause | null} */ (null),
    Math.min(1, measureRuleError(trace, {}, near) / 2),
  ];
  for (const rule of rules) {
    const error = measureRuleError(trace, rule, near);
    if (error < least) [best, least] = [rule.cause, error];
  }
  return best;
}

// List mistakes in the velocities. With a wrong angle step the velocity has the right size, and the
// direction that it should have at another time.
/** @param {Path} path @returns {Rule[]} */
const listVelocityRules = (path) => [
  { cause: makeCause("trace.millimetres"), v: (t) => scaled(1e3, path.velocity(t)) }, // slip 5
  { cause: makeCause("trace.next velocity"), v: (t, dt) => path.velocity(t + dt) }, // slip 21
  ...listAngleSteps(path).map(({ cause, rate, from }) => ({
    cause,
    v: (t) => path.velocity(from + rate * t), // handed in
  })),
];

/** List a wrong velocity with a wrong Jacobian. @returns {Generator<Rule>} */
function* listPairsOfRules({ path, at }) {
  for (const { cause: first, v } of listVelocityRules(path))
    for (const { cause: second, recipe } of listJacobianRecipes(at(0)[0]))
      yield { cause: combineCauses(first, second), v, recipe };
}

/** @param {Trace} trace @returns {Generator<Rule>} */
function* listMatrixRules({ q, arm, at }) {
  const [here, T] = at(0);
  const millimetres = (c, frames) =>
    flatJacobian(c, frames).map((x, i) => (i < 3 * c.dof ? 1e3 * x : x));
  yield { cause: makeCause("J.millimetres"), recipe: millimetres }; // slip 26
  const first = flatJacobian(here, T);
  yield { cause: makeCause("trace.jacobian held"), recipe: () => first }; // handed in
  yield* listJacobianRecipes(here);
  for (const { cause, change } of listTableMistakes(arm))
    yield { cause, recipe: (c) => flatJacobian(change(c), chainFrames(change(c))) };
  // handed in
  if (q[0].length >= 6) yield { cause: makeCause("trace.position only"), recipe: keepPositionOnly };
}

// Use the linear rows only, and require the motion that their pseudo-inverse gives.
function keepPositionOnly(c, T) {
  const columns = jacobianColumns(c, T).map((column) => column.slice(0, 3));
  const directions = nullSpace(columns);
  const projection = columns.flatMap((_, i) =>
    columns.map((_, j) => directions.reduce((sum, n) => sum + n[i] * n[j], 0)),
  );
  return [...flatJacobian(c, T).slice(0, 3 * c.dof), ...projection];
}

/**
 * Return the error of a rule divided by its error bound, or Infinity once it exceeds 1.
 *
 * For Euler's method the sum of K(q_k) (q_{k+1} - q_k) up to each row must equal the sum of
 * v(t_k) dt. If `near` is given, both are integrals, summed at the middles of the steps, which any
 * method approximates.
 *
 * The bound: joints typed to units u are off by e <= u / 2. By partial summation the sum of
 * K_k (e_{k+1} - e_k) is K_m e_m - K_0 e_0 minus the sum of (K_k - K_{k-1}) e_k. The change of K by
 * e adds the last sum once more. Added are the round-off of the program and, for integrals, `near`
 * and the difference between trapezoidal and midpoint sums.
 * @param {Trace} trace @param {Rule} rule @param {number[] | null} near (m, rad)
 */
function measureRuleError(
  { q, units, path, at },
  { recipe = flatJacobian, v = path.velocity },
  near = null,
) {
  const first = recipe(...at(0));
  const rows = q[0].length < 6 ? 3 : first.length / q[0].length;
  const sum = new Array(rows).fill(0);
  const bound = sum.map((_, i) => (near ? near[i < 3 ? 0 : 1] : 0));
  let [here, largestShare] = [first, 0];
  for (let k = 0; k + 1 < q.length; k++) {
    const [t, dt] = [path.times[k], path.times[k + 1] - path.times[k]];
    const step = subtractEach(q[k + 1], q[k]);
    const measureError = (M, time) => computeStepError(M, step, v(time, dt), dt, rows);
    const next = recipe(...at(k + 1));
    const change = subtractEach(next, here);
    const start = measureError(here, t);
    const used = near ? measureError(recipe(...at(k + 0.5)), t + 0.5 * dt) : start;
    const end = near ? measureError(next, t + dt) : start;
    const roundOff = CONSTANT_ERROR * norm(step);
    for (let i = 0; i < rows; i++) {
      sum[i] += used[i];
      bound[i] +=
        roundOff + boundEffect(change, i, units[k]) + Math.abs((start[i] + end[i]) / 2 - used[i]);
      const ends = (boundEffect(first, i, units[0]) + boundEffect(next, i, units[k + 1])) / 2;
      largestShare = Math.max(largestShare, Math.abs(sum[i]) / (bound[i] + ends));
    }
    if (!(largestShare <= 1)) return Infinity;
    here = next;
  }
  return largestShare;
}

// Return the first rows of M step - (v dt, 0 ...).
function computeStepError(M, step, v, dt, rows) {
  const error = new Array(rows);
  for (let i = 0, n = 0; i < rows; i++) {
    error[i] = i < 3 ? -v[i] * dt : 0;
    for (const x of step) error[i] += M[n++] * x;
  }
  return error;
}

// Bound the effect of errors in each joint on row i of M.
const boundEffect = (M, i, errors) =>
  errors.reduce((sum, e, j) => sum + Math.abs(M[i * errors.length + j]) * e, 0);
