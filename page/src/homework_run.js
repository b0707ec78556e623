// Simulate the homework's circle on the wall: by Euler's rule or a better one, with the inverse
// Jacobian or a substitute, with or without feedback, and with a chosen mistake.
// tests/test_explorer.py compares it with helpers.motion.

import { makeChain, flatJacobian, joinHalves } from "../../judge/geometry/chains.js";
import {
  computeHoldingTorques,
  computeWrenchTorques,
  cross,
  dot,
  jacobianColumns,
  movingRows,
  linkFrames,
  minus,
  norm,
} from "../../judge/geometry/kinematics.js";
import { decomposeSingular } from "../../judge/geometry/linear.js";
import { dotProduct, getCirclePoint, getPoseError, solvePoseFromSingular } from "./motion.js";
import { pick, taskRows } from "../../judge/geometry/task_rows.js";

/** @typedef {import("../../judge/geometry/arm.js").Arm} Arm */
/**
 * @typedef {object} Run settings of one simulation
 * @property {"euler" | "rk4" | "exact"} method
 * @property {"inverse" | "pseudo" | "damped"} rates how joint rates are solved for
 * @property {number} steps
 * @property {number} seconds
 * @property {number} radius m
 * @property {"x" | "y"} normal of the wall
 * @property {number} gain of the feedback, 1/s
 * @property {number} cutoff the pseudo-inverse ignores singular values below this share of the
 *   largest
 * @property {number} damping
 * @property {number} locked index in q of the joint that stays still; -1 for none
 * @property {"" | "angular" | "z_i" | "o_i" | "sign" | "next"} mistake the mistake to make
 */

/** @type {Run} */
export const DEFAULT_RUN = {
  method: "euler",
  rates: "inverse",
  steps: 1000,
  seconds: 5,
  radius: 0.1,
  normal: "x",
  gain: 0,
  cutoff: 1e-9,
  damping: 0.02,
  locked: -1,
  mistake: "",
};

// Return the Jacobian's columns with the chosen mistake in them.
function getMistakenColumns(arm, q, frames, mistake) {
  const c = makeChain(arm, q);
  const after = c.at.map((row) => row + 1);
  const withChange = (options) => flatJacobian(c, frames, options);
  const mistaken = {
    angular: () => joinHalves(withChange({}), withChange({ axis: after })),
    z_i: () => withChange({ axis: after, origin: after }),
    o_i: () => withChange({ origin: after }),
  };
  const J = mistaken[mistake]?.() ?? withChange({});
  return q.map((_, k) => [0, 1, 2, 3, 4, 5].map((i) => J[i * c.dof + k]));
}

class SingularError extends Error {}

const getFreeJoints = (J, locked) => J.map((_, k) => k).filter((k) => k !== locked);
const hasNoInverse = (values) => values[Math.min(5, values.length - 1)] <= 1e-9 * values[0];

// Return whether the arm itself is singular at q, without the mistake.
function isArmSingular(arm, q, locked) {
  const J = jacobianColumns(arm, linkFrames(arm, q));
  return hasNoInverse(decomposeSingular(getFreeJoints(J, locked).map((k) => J[k])).values);
}

function solveJointRates(J, twist, { rates, cutoff, damping, locked }) {
  const free = getFreeJoints(J, locked);
  const { values, vectors } = decomposeSingular(free.map((k) => J[k]));
  const smallest = rates === "pseudo" ? cutoff * values[0] : 0;
  if (rates === "inverse" && hasNoInverse(values)) throw new SingularError();
  const solution = J.map(() => 0);
  values.forEach((value, i) => {
    if (value <= smallest || value < 1e-14) return;
    const square = value ** 2 + (rates === "damped" ? damping ** 2 : 0);
    const weight = dotProduct(vectors[i], twist) / square;
    for (const k of free) solution[k] += weight * dotProduct(J[k], vectors[i]);
  });
  return { solution, smallestSigma: values[Math.min(5, free.length - 1)] };
}

const MAX_KEPT_CONFIGURATIONS = 181; // configurations that are stored and drawn
const REACH_TOLERANCE = 1e-3; // m or rad; a pose that is missed by more is out of reach

/** One simulated run around the circle: its current joint values and its largest errors so far. */
class CircleSimulation {
  /** @param {Arm} arm @param {number[]} start @param {Run} run */
  constructor(arm, start, run) {
    this.arm = arm;
    this.run = run;
    this.q = [...start];
    this.first = linkFrames(arm, start).at(-1);
    this.every = Math.max(1, Math.ceil(run.steps / (MAX_KEPT_CONFIGURATIONS - 1)));
    this.kept = { path: [start], errors: [0], at: [0] };
    this.worst = { smallestSigma: Infinity, largestError: 0, fastestRate: 0, largestTilt: 0 };
  }

  // Return the joint rates at a share of the circle.
  computeRates(share, q) {
    const { arm, run, first, worst } = this;
    const frames = linkFrames(arm, q);
    const { o, v } = getCirclePoint(first.o, run, share);
    const error = run.gain ? getPoseError(frames.at(-1), { ...first, o }) : [0, 0, 0, 0, 0, 0];
    const twist = [...v, 0, 0, 0].map((x, i) => x + run.gain * error[i]);
    const { solution, smallestSigma } = solveJointRates(
      getMistakenColumns(arm, q, frames, run.mistake),
      twist,
      run,
    );
    worst.smallestSigma = Math.min(worst.smallestSigma, smallestSigma);
    return run.mistake === "sign" ? solution.map((x) => -x) : solution;
  }

  // Return the joint values after the next step. Throws SingularError if the Jacobian has no
  // inverse.
  computeNextJoints(share, next) {
    const { arm, run, first, q, worst } = this;
    const k1 = this.computeRates(run.mistake === "next" ? next : share, q);
    worst.fastestRate = Math.max(worst.fastestRate, ...k1.map(Math.abs));
    if (run.method === "exact") {
      const wanted = { ...first, o: getCirclePoint(first.o, run, next).o };
      return solvePoseFromSingular(arm, q, wanted, { lockedJoint: run.locked }).q;
    }
    const h = run.seconds / run.steps;
    const moved = (k, by) => q.map((x, i) => x + by * k[i]);
    if (run.method === "euler") return moved(k1, h);
    const middle = share + 0.5 / run.steps;
    const k2 = this.computeRates(middle, moved(k1, h / 2));
    const k3 = this.computeRates(middle, moved(k2, h / 2));
    const k4 = this.computeRates(next, moved(k3, h));
    return q.map((x, i) => x + (h / 6) * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]));
  }

  // Make step n. Returns false if the run ends there.
  makeStep(n) {
    const { arm, run, first, worst, kept } = this;
    const next = (n + 1) / run.steps;
    try {
      this.q = this.computeNextJoints(n / run.steps, next);
    } catch (error) {
      if (error instanceof SingularError) return false;
      throw error;
    }
    const tip = linkFrames(arm, this.q).at(-1);
    const wanted = { ...first, o: getCirclePoint(first.o, run, next).o };
    const distance = norm(minus(tip.o, wanted.o));
    const tilt = Math.atan2(norm(cross(tip.z, first.z)), dot(tip.z, first.z));
    worst.largestTilt = Math.max(worst.largestTilt, tilt);
    worst.largestError = Math.max(worst.largestError, distance);
    const missed = norm(pick(getPoseError(tip, wanted), taskRows(arm)));
    // Beyond this configuration the joints would jump.
    if (run.method === "exact" && missed > REACH_TOLERANCE) return false;
    if ((n + 1) % this.every === 0 || n + 1 === run.steps) {
      kept.path.push(this.q);
      kept.errors.push(distance);
      kept.at.push(next);
    }
    return Number.isFinite(distance);
  }
}

/**
 * Simulate a run around the circle.
 * @param {Arm} arm
 * @param {number[]} start
 * @param {Partial<Run>} options fields that differ from DEFAULT_RUN
 * @returns joint values along the run (at most 181), the tip's errors, whole turns of the joints,
 *   the smallest singular value, the step at which the run ended (null if it closed), and whether
 *   the arm is singular there
 */
export function simulateCircle(arm, start, options = {}) {
  const run = { ...DEFAULT_RUN, ...options };
  // the exact method inverts nothing; the pseudo-inverse only supplies the singular values
  if (run.method === "exact") run.rates = "pseudo";
  const simulation = new CircleSimulation(arm, start, run);
  let n = 0;
  while (n < run.steps && simulation.makeStep(n)) n++;
  const turns = movingRows(arm).map((row) => (arm.rows[row].kind === "revolute" ? 2 * Math.PI : 0));
  const windings = simulation.q.map((x, i) => (turns[i] ? (x - start[i]) / turns[i] : 0));
  const failedStep = n < run.steps ? n : null;
  const isSingular = failedStep !== null && isArmSingular(arm, simulation.q, run.locked);
  return { ...simulation.kept, run, ...simulation.worst, failedStep, isSingular, windings };
}

// Trace a circle below the tip as far as the arm reaches, with all joints free and the tool's
// orientation kept. Returns joint values and the whole wanted circle.
export function traceCircle(arm, start, circle = {}) {
  const { o } = linkFrames(arm, start).at(-1);
  const { path } = simulateCircle(arm, start, {
    method: "exact",
    steps: 180,
    ...circle,
  });
  if (path.length === 1) path.push(start); // a path needs two points
  return {
    path,
    wantedPath: Array.from({ length: 181 }, (_, k) => getCirclePoint(o, circle, k / 180).o),
  };
}

// Compute the static torques along a path.
export const computeTorquesAlong = (arm, path, wrench) =>
  path.map((q) => {
    const frames = linkFrames(arm, q);
    const push = computeWrenchTorques(jacobianColumns(arm, frames), wrench);
    return computeHoldingTorques(arm, frames).map((g, i) => g - push[i]);
  });

const CHOICES = {
  method: ["euler", "rk4", "exact"],
  rates: ["inverse", "pseudo", "damped"],
  normal: ["x", "y"],
  mistake: ["", "angular", "z_i", "o_i", "sign", "next"],
};
export const BOUNDS = {
  steps: [10, 10000],
  seconds: [1, 60],
  radius: [0.01, 0.1],
  gain: [0, 20],
  cutoff: [1e-9, 0.1],
  damping: [1e-3, 0.2],
  locked: [-1, 15],
};
const INTEGER_FIELDS = ["steps", "locked"];
const RUN_FIELDS = Object.keys(DEFAULT_RUN);

// Format a run for a link.
export const formatRun = (run) => RUN_FIELDS.map((key) => run[key]).join("_");

/**
 * Parse a run from a link; null if the text is not a run.
 * @returns {Run | null}
 */
export function parseRun(text) {
  const parts = text.replace(/_([zo])_i$/, "_$1-i").split("_");
  if (parts.length !== RUN_FIELDS.length) return null;
  const entries = RUN_FIELDS.map((key, i) => [
    key,
    parseRunField(key, parts[i].replace("-i", "_i")),
  ]);
  return entries.some(([, value]) => value === null) ? null : Object.fromEntries(entries);
}

// Parse one field of a run; null if its value is not allowed.
function parseRunField(key, text) {
  const choices = CHOICES[key];
  if (choices) return choices.includes(text) ? text : null;
  const [low, high] = BOUNDS[key];
  const value = text.trim() ? Number(text) : NaN;
  if (INTEGER_FIELDS.includes(key) && !Number.isInteger(value)) return null;
  return value >= low && value <= high ? value : null;
}
