// Why a run misses its path: by the path that it does draw, or by the loop that made it.

import { DEG } from "../geometry/angles.js";
import { minus, norm, scaled } from "../geometry/kinematics.js";
import { subtractEach, nullSpace } from "../geometry/linear.js";
import { makeChain, flatJacobian, chainFrames } from "../geometry/chains.js";
import { jacobianRecipes } from "./jacobian.js";
import { tableMistakes } from "./chain.js";
import { makeCause } from "./ranking.js";
import {
  displacedPaths,
  isPathKnown,
  pathsWithOneMistake,
  pathsWithTwoMistakes,
} from "./trace_paths.js";

// What a right run may be off by its program's method: Euler's on the homework's circle stays well
// below, and a tool that leans or spins no more counts as held.
export const [METHOD_ERROR, METHOD_TILT] = [2e-3, 1 / DEG]; // m, rad
const FINE = 1e-5; // of what the joints turn: numbers in a program have digits too, as pi = 3.1416

/** @typedef {import("./ranking.js").Cause} Cause */
/** @typedef {import("../geometry/path.js").Path} Path */
/**
 * A rule of the student's loop: K(q_k) (q_{k+1} - q_k) = (v(t_k) dt, 0 ...), with the rows of K one
 * after another; in the right one K is the Jacobian and v the path's velocity.
 * @typedef {object} Rule
 * @property {Cause} [one] the slip in it
 * @property {(c: any, T: any[]) => number[]} [K] of an arm at a pose
 * @property {(t: number, dt: number) => number[]} [v]
 */
/**
 * Joints, the units of their last places, and the arm at row k, or half way to the next one.
 * @typedef {{ q: number[][], units: number[][], arm: any, path: Path,
 *   at: (k: number) => [any, any[]] }} Run
 */

/** @returns {Run} */
export function makeTrace(q, units, arm, path) {
  const made = new Map();
  const at = (k) => {
    if (!made.has(k)) {
      const next = q[Math.ceil(k)];
      const pose = q[Math.floor(k)].map((x, i) => (x + next[i]) / 2);
      const c = makeChain(arm, pose);
      made.set(k, [c, chainFrames(c)]);
    }
    return made.get(k);
  };
  return { q, units, arm, path, at };
}

/**
 * Why a run is wrong: it begins elsewhere; where the tip is `off`, the path that it does draw; the
 * rule that made it, to its digits, or, where anything wrong is `shown`, as nearly as a right run
 * is right; or two slips in the path. Null where it is none of these.
 * @param {Run} run @param {number[][]} tip @param {number[]} allowed
 * @param {{ off: boolean, shown: boolean }} seen
 */
export function findTraceCause(run, tip, allowed, { off, shown }) {
  const { path } = run;
  if (off && !isPathKnown(path)) return null;
  const [moved, others] = off
    ? [displacedPaths(path, tip[0], allowed[0]), pathsWithOneMistake(path)]
    : [[], []];
  if (right(run)) return moved[0]?.one ?? null;
  return (
    wrongPathCause(run, [...others, ...moved], tip, allowed, off) ??
    loopCause(run, [...speeds(path), ...others.map(ledBy), ...matrices(run)]) ??
    (shown ? loopCause(run, matrices(run), [METHOD_ERROR, METHOD_TILT]) : null) ??
    (off ? pathCause(pathsWithTwoMistakes(path), path, tip, allowed) : null)
  );
}

// A table mistake or another path that explains where the tip is; null where it is not off.
function wrongPathCause(run, others, tip, allowed, off) {
  if (!off) return null;
  return tableCause(run, allowed) ?? pathCause(others, run.path, tip, allowed);
}

// A table mistake with which the tip would follow the path: the pen forgotten, for instance.
function tableCause({ q, arm, path }, allowed) {
  const isNear = (change) => (row, k) => {
    const tip = chainFrames(change(makeChain(arm, row))).at(-1).o;
    return norm(minus(tip, path.position(path.times[k]))) <= allowed[k];
  };
  return tableMistakes(arm).find(([, change]) => q.every(isNear(change)))?.[0] ?? null;
}

// The first of other paths to which the tip is as near as it should be to its own.
function pathCause(others, { times }, tip, allowed) {
  for (const { one, path } of others) {
    const near = (p, k) => norm(minus(p, path.position(times[k]))) <= allowed[k];
    if (tip.every(near)) return one;
  }
  return null;
}

/** Whether the right rule holds, to the digits, by Euler's method. @param {Run} run */
export const followsPathByEuler = (run) => fails(run, {}) <= 1;

// Or by a method so good that only the sums here are off.
const right = (run) => followsPathByEuler(run) || fails(run, {}, [0, 0]) <= 1;

/**
 * The rule by which each step's joints follow from the one before: to the digits, by Euler's
 * method; or, by any other, `near` it. Null where none leaves half of what the right one leaves.
 * @param {Run} run @param {Iterable<Rule>} rules @param {number[] | null} near
 */
function loopCause(run, rules, near = null) {
  let [best, least] = [/** @type {Cause | null} */ (null), Math.min(1, fails(run, {}, near) / 2)];
  for (const rule of rules) {
    const left = fails(run, rule, near);
    if (left < least) [best, least] = [rule.one, left];
  }
  return best;
}

/** @param {Path} path @returns {Rule[]} */
const speeds = (path) => [
  { one: makeCause("trace.millimetres"), v: (t) => scaled(1e3, path.velocity(t)) }, // slip 5
  { one: makeCause("trace.next velocity"), v: (t, dt) => path.velocity(t + dt) }, // slip 21
];

const ledBy = ({ one, path }) => ({ one, v: path.velocity });

/** @param {Run} run @returns {Generator<Rule>} */
function* matrices({ q, arm, at }) {
  const [here, T] = at(0);
  const millimetres = (c, frames) =>
    flatJacobian(c, frames).map((x, i) => (i < 3 * c.dof ? 1e3 * x : x));
  yield { one: makeCause("J.millimetres"), K: millimetres }; // slip 26
  const first = flatJacobian(here, T);
  yield { one: makeCause("trace.jacobian held"), K: () => first }; // handed in
  for (const [one, K] of jacobianRecipes(here)) yield { one, K };
  for (const [one, change] of tableMistakes(arm))
    yield { one, K: (c) => flatJacobian(change(c), chainFrames(change(c))) };
  // handed in
  if (q[0].length >= 6) yield { one: makeCause("trace.position only"), K: linearAlone };
}

// The linear rows; and that no joint moves but to move the tip, as by their pseudo-inverse.
function linearAlone(c, T) {
  const J = flatJacobian(c, T).slice(0, 3 * c.dof);
  const each = Array.from({ length: c.dof }, (_, k) => [0, 1, 2].map((i) => J[i * c.dof + k]));
  const still = nullSpace(each);
  const idle = each.flatMap((_, i) =>
    each.map((_, j) => still.reduce((sum, n) => sum + n[i] * n[j], 0)),
  );
  return [...J, ...idle];
}

/**
 * By how much a rule fails, as a share of what it may; infinite where it does. What the joints make
 * from the start to each row, the sum of K(q_k) (q_{k+1} - q_k), is to be the sum of v(t_k) dt, as
 * by Euler's method; or, where `near` is given, both are to be the integrals that other methods
 * come near to, by sums over the middles of the steps.
 *
 * What it may: joints typed to units u are off by e <= u / 2. The sum of K_k (e_{k+1} - e_k) is
 * K_m e_m - K_0 e_0 less that of (K_k - K_{k-1}) e_k; K's own change by e in each step sums up to
 * as much as this last once more. Besides, the digits of the program's own numbers; and from the
 * middles what is `near`, and what the trapezoids' sums differ from theirs.
 * @param {Run} run @param {Rule} rule @param {number[] | null} near (m, rad)
 */
function fails({ q, units, path, at }, { K = flatJacobian, v = path.velocity }, near = null) {
  const first = K(...at(0));
  const rows = q[0].length < 6 ? 3 : first.length / q[0].length;
  const sum = new Array(rows).fill(0);
  const may = sum.map((_, i) => (near ? near[i < 3 ? 0 : 1] : 0));
  let [here, worst] = [first, 0];
  for (let k = 0; k + 1 < q.length; k++) {
    const [t, dt] = [path.times[k], path.times[k + 1] - path.times[k]];
    const step = subtractEach(q[k + 1], q[k]);
    const off = (M, time) => offOf(M, step, v(time, dt), dt, rows);
    const next = K(...at(k + 1));
    const change = subtractEach(next, here);
    const start = off(here, t);
    const used = near ? off(K(...at(k + 0.5)), t + 0.5 * dt) : start;
    const end = near ? off(next, t + dt) : start;
    const gone = FINE * norm(step);
    for (let i = 0; i < rows; i++) {
      sum[i] += used[i];
      may[i] += gone + reach(change, i, units[k]) + Math.abs((start[i] + end[i]) / 2 - used[i]);
      const ends = (reach(first, i, units[0]) + reach(next, i, units[k + 1])) / 2;
      worst = Math.max(worst, Math.abs(sum[i]) / (may[i] + ends));
    }
    if (!(worst <= 1)) return Infinity;
    here = next;
  }
  return worst;
}

// The first rows of M step - (v dt, 0 ...).
function offOf(M, step, v, dt, rows) {
  const off = new Array(rows);
  for (let i = 0, n = 0; i < rows; i++) {
    off[i] = i < 3 ? -v[i] * dt : 0;
    for (const x of step) off[i] += M[n++] * x;
  }
  return off;
}

// What errors in each joint make of row i of M, at most.
const reach = (M, i, errors) =>
  errors.reduce((sum, e, j) => sum + Math.abs(M[i * errors.length + j]) * e, 0);
