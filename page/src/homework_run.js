// The homework's circle on the wall, run as it is run there: by Euler's rule or a better one, by
// the inverse or one of its stand-ins, with or without feedback, and with a mistake where one is
// asked for. tests/test_explorer.py holds it against helpers.motion.

import { makeChain, flatJacobian, joinHalves } from "../../judge/geometry/chains.js";
import {
  cross,
  dot,
  jacobianColumns,
  movingRows,
  linkFrames,
  minus,
  norm,
} from "../../judge/geometry/kinematics.js";
import { gravityTorque, wrenchTorque } from "../../judge/geometry/kinematics.js";
import { decomposeSingular } from "../../judge/geometry/linear.js";
import { inner, onCircle, poseError, reachFrom } from "./motion.js";
import { asked } from "./verdicts.js";

/** @typedef {import("../../judge/geometry/arm.js").Arm} Arm */
/**
 * @typedef {object} Run
 * @property {"euler" | "rk4" | "exact"} method
 * @property {"inverse" | "pseudo" | "damped"} rates
 * @property {number} steps
 * @property {number} seconds
 * @property {number} radius m
 * @property {"x" | "y"} normal of the wall
 * @property {number} gain 1/s, of the feedback
 * @property {number} cutoff share of the largest singular value below which the pseudo-inverse
 *   gives up
 * @property {number} damping
 * @property {number} locked the joint, as its index in q, that stays; -1 for none
 * @property {"" | "angular" | "z_i" | "o_i" | "sign" | "next"} slip
 */

/** @type {Run} */
export const HOMEWORK = {
  method: "euler",
  rates: "inverse",
  steps: 1000,
  seconds: 5,
  radius: 0.1,
  normal: "x",
  gain: 0,
  cutoff: 1e-9,
  damping: 0.02,
  locked: 2,
  slip: "",
};

// The Jacobian's columns as a mistake makes them.
function columnsOf(arm, q, frames, slip) {
  const c = makeChain(arm, q);
  const after = c.at.map((row) => row + 1);
  const made = (options) => flatJacobian(c, frames, options);
  const mistaken = {
    angular: () => joinHalves(made({}), made({ axis: after })),
    z_i: () => made({ axis: after, origin: after }),
    o_i: () => made({ origin: after }),
  };
  const J = mistaken[slip]?.() ?? made({});
  return q.map((_, k) => [0, 1, 2, 3, 4, 5].map((i) => J[i * c.dof + k]));
}

class Singular extends Error {}

const freeOf = (J, locked) => J.map((_, k) => k).filter((k) => k !== locked);
const noInverse = (values) => values[Math.min(5, values.length - 1)] <= 1e-9 * values[0];

// Whether the arm itself is singular there, whatever a mistake makes of its Jacobian.
function isSingular(arm, q, locked) {
  const J = jacobianColumns(arm, linkFrames(arm, q));
  return noInverse(decomposeSingular(freeOf(J, locked).map((k) => J[k])).values);
}

function jointRates(J, twist, { rates, cutoff, damping, locked }) {
  const free = freeOf(J, locked);
  const { values, vectors } = decomposeSingular(free.map((k) => J[k]));
  const least = rates === "pseudo" ? cutoff * values[0] : 0;
  if (rates === "inverse" && noInverse(values)) throw new Singular();
  const found = J.map(() => 0);
  values.forEach((value, i) => {
    if (value <= least || value < 1e-14) return;
    const square = value ** 2 + (rates === "damped" ? damping ** 2 : 0);
    const weight = inner(vectors[i], twist) / square;
    for (const k of free) found[k] += weight * inner(J[k], vectors[i]);
  });
  return { found, least: values[Math.min(5, free.length - 1)] };
}

const KEPT = 181; // poses that are shown
const OFF = 1e-3; // m or rad from what is wanted, which then is out of reach

/** One run around the circle: where it has come to, and the worst on its way. */
class Walk {
  /** @param {Arm} arm @param {number[]} start @param {Run} run */
  constructor(arm, start, run) {
    this.arm = arm;
    this.run = run;
    this.q = [...start];
    this.first = linkFrames(arm, start).at(-1);
    this.every = Math.max(1, Math.ceil(run.steps / (KEPT - 1)));
    this.kept = { path: [start], errors: [0], at: [0] };
    this.worst = { least: Infinity, largest: 0, fastest: 0, tilt: 0 };
  }

  // Joint rates at a share of the way, as the run finds them.
  rates(share, q) {
    const { arm, run, first, worst } = this;
    const frames = linkFrames(arm, q);
    const { o, v } = onCircle(first.o, run, share);
    const error = run.gain ? poseError(frames.at(-1), { ...first, o }) : [0, 0, 0, 0, 0, 0];
    const twist = [...v, 0, 0, 0].map((x, i) => x + run.gain * error[i]);
    const { found, least } = jointRates(columnsOf(arm, q, frames, run.slip), twist, run);
    worst.least = Math.min(worst.least, least);
    return run.slip === "sign" ? found.map((x) => -x) : found;
  }

  // The joints a step on; throws where the Jacobian has no inverse.
  stepped(share, next) {
    const { arm, run, first, q, worst } = this;
    const k1 = this.rates(run.slip === "next" ? next : share, q);
    worst.fastest = Math.max(worst.fastest, ...k1.map(Math.abs));
    if (run.method === "exact") {
      const wanted = { ...first, o: onCircle(first.o, run, next).o };
      return reachFrom(arm, q, wanted, { held: run.locked }).q;
    }
    const h = run.seconds / run.steps;
    const moved = (k, by) => q.map((x, i) => x + by * k[i]);
    if (run.method === "euler") return moved(k1, h);
    const middle = share + 0.5 / run.steps;
    const k2 = this.rates(middle, moved(k1, h / 2));
    const k3 = this.rates(middle, moved(k2, h / 2));
    const k4 = this.rates(next, moved(k3, h));
    return q.map((x, i) => x + (h / 6) * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]));
  }

  // Go step n; false where the run breaks there.
  go(n) {
    const { arm, run, first, worst, kept } = this;
    const next = (n + 1) / run.steps;
    try {
      this.q = this.stepped(n / run.steps, next);
    } catch (fault) {
      if (fault instanceof Singular) return false;
      throw fault;
    }
    const there = linkFrames(arm, this.q).at(-1);
    const wanted = { ...first, o: onCircle(first.o, run, next).o };
    const off = norm(minus(there.o, wanted.o));
    const tilt = Math.atan2(norm(cross(there.z, first.z)), dot(there.z, first.z));
    worst.tilt = Math.max(worst.tilt, tilt);
    worst.largest = Math.max(worst.largest, off);
    const missed = norm(poseError(there, wanted).slice(0, asked(arm)));
    if (run.method === "exact" && missed > OFF) return false; // beyond, joints would jump
    if ((n + 1) % this.every === 0 || n + 1 === run.steps) {
      kept.path.push(this.q);
      kept.errors.push(off);
      kept.at.push(next);
    }
    return Number.isFinite(off);
  }
}

/**
 * What comes of a run: joint values along it (at most 181 of them), how far the tip is off, turns
 * of the joints, the smallest singular value, the step at which the inverse did not exist, and
 * whether the arm is singular there.
 * @param {Arm} arm
 * @param {number[]} start
 * @param {Partial<Run>} given
 */
export function runCircle(arm, start, given = {}) {
  const run = { ...HOMEWORK, ...given };
  // nothing is inverted: only singular values are asked for
  if (run.method === "exact") run.rates = "pseudo";
  const walk = new Walk(arm, start, run);
  let n = 0;
  while (n < run.steps && walk.go(n)) n++;
  const turns = movingRows(arm).map((row) => (arm.rows[row].kind === "revolute" ? 2 * Math.PI : 0));
  const wound = walk.q.map((x, i) => (turns[i] ? (x - start[i]) / turns[i] : 0));
  const failed = n < run.steps ? n : null;
  const stuck = failed !== null && isSingular(arm, walk.q, run.locked);
  return { ...walk.kept, run, ...walk.worst, failed, stuck, wound };
}

// Joint vectors along a circle below the tip, with all joints free and the tool's orientation held,
// as far as the arm reaches, and where the tip should be all the way round.
export function traceCircle(arm, start, circle = {}) {
  const { o } = linkFrames(arm, start).at(-1);
  const { path } = runCircle(arm, start, { method: "exact", steps: 180, locked: -1, ...circle });
  if (path.length === 1) path.push(start); // a path has two ends
  return { path, wanted: Array.from({ length: 181 }, (_, k) => onCircle(o, circle, k / 180).o) };
}

// Static torques along a path.
export const torquesAlong = (arm, path, wrench) =>
  path.map((q) => {
    const frames = linkFrames(arm, q);
    const push = wrenchTorque(jacobianColumns(arm, frames), wrench);
    return gravityTorque(arm, frames).map((g, i) => g - push[i]);
  });

const CHOICES = {
  method: ["euler", "rk4", "exact"],
  rates: ["inverse", "pseudo", "damped"],
  normal: ["x", "y"],
  slip: ["", "angular", "z_i", "o_i", "sign", "next"],
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
const WHOLE = ["steps", "locked"];
const KEYS = Object.keys(HOMEWORK);

// A run in a link, and back; null where the text is none.
export const runText = (run) => KEYS.map((key) => run[key]).join("_");

/** @returns {Run | null} */
export function runFrom(text) {
  const parts = text.replace(/_([zo])_i$/, "_$1-i").split("_");
  if (parts.length !== KEYS.length) return null;
  const entries = KEYS.map((key, i) => [key, fieldOf(key, parts[i].replace("-i", "_i"))]);
  return entries.some(([, value]) => value === null) ? null : Object.fromEntries(entries);
}

// A field of a run from a link's text, or null where it is none.
function fieldOf(key, text) {
  const choices = CHOICES[key];
  if (choices) return choices.includes(text) ? text : null;
  const [low, high] = BOUNDS[key];
  const value = text.trim() ? Number(text) : NaN;
  if (WHOLE.includes(key) && !Number.isInteger(value)) return null;
  return value >= low && value <= high ? value : null;
}
