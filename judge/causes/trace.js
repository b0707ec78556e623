// Why a run misses its path: by the shape that the tip drew, by the loop that made it.

import { minus, norm, plus, scaled } from "../geometry/kinematics.js";
import { minusEach, singular } from "../geometry/linear.js";
import { chain, columns, framesOf } from "../geometry/chains.js";
import { rint } from "../geometry/planar.js";
import { recipes } from "./jacobian.js";
import { wrongTables } from "./tables.js";
import { cause } from "./ranking.js";
import { listed, size } from "../sentences.js";

const ALIKE = 1e-9; // m: misses nearer to each other than this are the same
const SAMPLE = 100;
const STRIDE = 50;
// windows in a run: few enough for many steps each, enough to see a circle's turns
const ALONG = 40;
const PLAIN = 0.1; // of the miss: what another path without a free number may leave
const PLAIN_PATHS = ["trace.backwards", "trace.other side"];
const HOLDS = 1.5; // times the noise: what a rule that holds may leave
const LOOSE = 4; // times the noise: what one may leave that is ten times better than the right one
const NICE = [2, 3, 4, 5, 8, 10, 20, 40, 50, 100].map((n) => 1 / n);
const PAIRS = [
  [0, 1],
  [0, 2],
  [1, 2],
];
const FINE = 3e-4; // of the speed: below, the digits show a thousandth of it
const CLEARLY = 0.7; // of what the right loop leaves: what another must stay below to be named
const SHARE = 0.02; // of the speed: what a rule that holds may leave, however fine the digits
const AS_WELL = 1.05; // times what the best rule leaves: a likelier one that leaves it is as good

/** @typedef {import("./ranking.js").Cause} Cause */
/** @typedef {import("../geometry/path.js").Path} Path */

// How far each point is from where the path has it.
export const offs = (wanted, points) => points.map((p, k) => norm(minus(p, wanted[k])));
const farthest = (points, wanted) =>
  points.reduce((top, p, k) => Math.max(top, norm(minus(p, wanted[k]))), -Infinity);
const mean = (points) =>
  scaled(
    1 / points.length,
    points.reduce((sum, p) => plus(sum, p), [0, 0, 0]),
  );
const shifted = (points, by) => points.map((p) => minus(p, by));
const size2 = (points) =>
  Math.sqrt(points.reduce((sum, p) => sum + p[0] * p[0] + p[1] * p[1] + p[2] * p[2], 0));
const drawn = (points) => points.slice(1).reduce((sum, p, k) => sum + norm(minus(p, points[k])), 0);

// By the shape

/**
 * What would explain every point; of those that leave as little, the likelier; null where nothing
 * does. `blur` is what the digits of the joints leave of each point (m).
 * @param {Path} path @param {number[][]} tip @returns {Cause | null}
 */
export function pathCause(path, tip, allowed, blur = 0) {
  const miss = farthest(tip, path.times.map(path.position));
  const usual = near(path, miss, allowed);
  const plain = Math.max(usual, PLAIN * miss);
  const most = ({ keys }) => (PLAIN_PATHS.includes(keys[0]) ? plain : usual);
  const found = [...shapes(path, tip, blur)].filter(([one, left]) => left <= most(one));
  const least = Math.min(...found.map(([, left]) => left));
  return found.find(([, left]) => left <= 1.5 * least + 0.1 * allowed)?.[0] ?? null;
}

// How much a cause may leave of a miss (m): two of the path's steps, a quarter of the miss.
export function near(path, miss, allowed) {
  const wanted = path.times.map(path.position);
  const step = wanted.slice(1).reduce((top, p, k) => Math.max(top, norm(minus(p, wanted[k]))), 0);
  return Math.min(Math.max(allowed, 2 * step), miss / 4);
}

// Other paths than the one asked for, the likelier first, each with what it leaves (m).
/** @returns {Generator<[Cause, number]>} */
function* shapes(path, tip, blur) {
  const wanted = path.times.map(path.position);
  const left = (points) => farthest(points, wanted);
  yield [cause("trace.backwards"), left([...tip].reverse())];
  const shift = mean(tip.map((p, k) => minus(p, wanted[k])));
  const missing = leftOut(wanted, shift, near(path, left(tip), blur));
  if (missing) yield [cause("trace.centre", { axes: missing }), left(shifted(tip, shift))];
  yield [cause("trace.displaced", { _by: vector(shift) }), left(shifted(tip, shift))];
  const fraction = fractionOf(path, wanted, tip, blur);
  if (fraction) {
    const [part, rest] = fraction;
    yield [cause("trace.fraction", { _share: size(100 * part), _over: size(1 / part) }), rest];
  }
  const [middle, centre] = [mean(tip), mean(wanted)];
  const scale = size2(shifted(tip, middle)) / Math.max(size2(shifted(wanted, centre)), 1e-12);
  if (Math.abs(scale - 1) > 0.02 && scale > 1e-3) {
    const shape = shifted(wanted, centre).map((p) => scaled(scale, p));
    const rest = farthest(shifted(tip, middle), shape);
    const words = { _scale: size(Number(scale.toFixed(6)), 4) };
    yield [cause("trace.scaled", words), shareOf(rest, scale, blur)];
  }
  yield [cause("trace.other side"), left(tip.map((p) => minus(scaled(2, wanted[0]), p)))];
  for (const [i, j] of PAIRS) {
    const order = [0, 1, 2].map((k) => (k === i ? j : k === j ? i : k));
    const exchanged = (p) =>
      plus(
        centre,
        order.map((k) => p[k] - middle[k]),
      );
    const words = { first: "xyz"[i], second: "xyz"[j] };
    yield [cause("trace.axes exchanged", words), left(tip.map(exchanged))];
  }
}

// The coordinates of the path's centre that are left out, where a path's displacement is just
// theirs; none where it is another.
function leftOut(wanted, shift, much) {
  const centre = mean(wanted);
  const kept = shift.map((x) => Math.abs(x) <= much);
  const gone = shift.map((x, i) => Math.abs(x + centre[i]) <= much);
  const out = ["x", "y", "z"].filter((_, i) => !kept[i]);
  return out.length && kept.every((is, i) => is || gone[i]) ? listed(out) : "";
}

// What a path drawn smaller leaves, as if it had its size.
const shareOf = (rest, scale, blur) => Math.max(0, rest - blur) / Math.min(1, scale);

// The share of the path that was drawn at even pace, and what it leaves: half speed, a quarter, dt
// against T.
/** @returns {[number, number] | null} */
function fractionOf(path, wanted, tip, blur) {
  const share = drawn(tip) / Math.max(drawn(wanted), 1e-12);
  if (!(share > 1e-3 && share < 50) || Math.abs(share - 1) < 0.02) return null;
  const shares = [...NICE, share, rint(share)].filter((f) => f && Math.abs(f - 1) > 0.02);
  const start = path.times[0];
  const most = farthest(tip, wanted) / 2; // a run astray is as long as many a share
  /** @type {[number, number][]} */
  const found = shares.flatMap((f) => {
    const points = path.times.map((t) => path.position(start + f * (t - start)));
    const left = farthest(tip, points);
    return left <= most ? [[f, shareOf(left / Math.max(1, 2 * f), f, blur)]] : [];
  });
  return found.reduce(
    (best, one) =>
      !best || one[1] < best[1] || (one[1] === best[1] && one[0] < best[0]) ? one : best,
    /** @type {[number, number] | null} */ (null),
  );
}

// A vector in mm, to three digits of its largest coordinate at most.
function vector(metres) {
  const far = 1e3 * Math.max(...metres.map(Math.abs));
  const unit = 10 ** [100, 10, 1].filter((least) => far < least).length;
  return `(${metres.map((x) => size(rint(1e3 * x * unit) / unit + 0)).join(", ")})`;
}

// By the table

/**
 * The wrong table by which these joints do follow the path, as joints from inverse kinematics do;
 * null where it leaves more than a quarter of the miss.
 * @param {Path} path @returns {Cause | null}
 */
export function tableCause(q, arm, path, allowed) {
  const wanted = path.times.map(path.position);
  const here = chain(arm, q[0]);
  // Points far from each other first, so that a table that does not fit is soon dropped.
  const order = [...q.keys()].sort((a, b) => (a % STRIDE) - (b % STRIDE) || a - b);
  const left = (table, enough) => {
    let top = 0;
    for (const k of order) {
      top = Math.max(top, norm(minus(framesOf({ ...table, q: q[k] }).at(-1).o, wanted[k])));
      if (top > enough) return Infinity;
    }
    return top;
  };
  const most = Math.min(allowed, left(here, Infinity) / 4);
  /** @type {[Cause, number][]} */
  const found = wrongTables(arm).map(([one, change]) => [one, left(change(here), most + ALIKE)]);
  const least = Math.min(...found.map(([, rest]) => rest));
  if (!(least <= most)) return null;
  return found.find(([, rest]) => rest <= least + ALIKE)?.[0] ?? null;
}

// By the loop

/**
 * The rule by which each step's joints follow from the one before: another Jacobian, or another
 * step's velocity; null where the right one explains them, or none clearly. For a step of Euler's
 * method J(q_k) (q_{k+1} - q_k) / dt is the velocity of step k, for Runge's and Kutta's the one in
 * the middle.
 * @param {number[][]} q @param {number[]} units the largest unit of each joint's last places @param
 *   {Path} path
 * @returns {Cause | null}
 */
export function loopCause(q, units, arm, path) {
  if (q.length < 4) return null;
  const both = [0, 0.5].map((share) => stepsOf(q, units, arm, path, share));
  const right = Math.min(...both.map((steps) => steps.right));
  if (right < HOLDS) return null;
  const rules = both.flatMap((steps) => [...rulesOf(steps)]);
  const least = Math.min(...rules.map(({ left }) => left));
  const best = rules.find(({ left }) => left <= AS_WELL * least);
  if (!best) return null;
  const fits = best.fits || best.left < Math.min(LOOSE, 0.1 * right);
  return fits && right > 1.8 && best.left < CLEARLY * right ? best.one : null;
}

// Whether each step is clearly right by Euler's method.
export function holds(q, units, arm, path) {
  const steps = stepsOf(q, units, arm, path, 0);
  return steps.clear && steps.right < HOLDS;
}

/**
 * @typedef {object} Steps a sample of a run's steps, in windows of neighbours over which what a
 *   rule leaves is averaged, for there the roundings cancel; each looked at from a share of the way
 *   on
 * @property {any} arm
 * @property {{ at: any, J: number[], rate: number[], now: number[], later: number[],
 *   made?: [Cause, number[]][] }[]} samples
 * @property {number[]} noise what the digits leave of the tip's six velocities
 * @property {number[]} own what they leave of the joints' own
 * @property {number} speed
 * @property {number} window
 * @property {number} rows
 * @property {number} right by how much the right rule fails
 * @property {boolean} clear whether the digits show the velocities at all
 */

/** @returns {Steps} */
function stepsOf(q, units, arm, path, share) {
  const dt = path.times.slice(1).map((t, k) => t - path.times[k]);
  const window = Math.max(1, Math.floor((q.length - 2) / ALONG));
  const samples = samplesOf(q, arm, path, dt, { window, share });
  const speed = path.times.reduce((top, t) => Math.max(top, ...path.velocity(t).map(Math.abs)), 0);
  const digits = units.map((unit) => unit / Math.min(...dt) / Math.sqrt(6) / window);
  const rest = 1e-4 + (share ? 0.5 * bendOf(samples, speed) ** 2 : 0);
  const noise = noiseOf(samples, digits, rest * speed);
  const pace = Math.sqrt(average(samples.map(({ rate }) => average(rate.map((x) => x * x)))));
  const own = digits.map((digit) => digit + rest * pace + 1e-12);
  const rows = units.length >= 6 ? 6 : 3;
  const steps = { arm, samples, noise, own, speed, window, rows, right: 0, clear: true };
  steps.right = fails(
    steps,
    ({ J }) => J,
    ({ now }) => now,
  );
  steps.clear = Math.max(...noise) < 0.1 * speed;
  return steps;
}

// What is looked at of some steps: the Jacobian a share of the step on, and the rates.
function samplesOf(q, arm, path, dt, { window, share }) {
  return picked(Math.max(0, q.length - 2 - window), Math.max(12, Math.floor(SAMPLE / window)))
    .flatMap((first) => Array.from({ length: window }, (_, i) => first + i))
    .map((k) => {
      const step = q[k].map((x, i) => q[k + 1][i] - x);
      const at = chain(
        arm,
        q[k].map((x, i) => x + share * step[i]),
      );
      const t = path.times[k] + share * dt[k];
      const [now, later] = [path.velocity(t), path.velocity(t + dt[k])];
      return { at, J: columns(at, framesOf(at)), rate: step.map((x) => x / dt[k]), now, later };
    });
}

// By how much of itself the velocity turns in a step, which a step's middle leaves out.
function bendOf(samples, speed) {
  const turns = samples.map(({ later, now }) => Math.max(...minus(later, now).map(Math.abs)));
  return Math.max(0, ...turns) / Math.max(speed, 1e-12);
}

// Two roundings, each even within a unit, through each row of J, and the rest.
const noiseOf = (samples, digits, rest) =>
  [0, 1, 2, 3, 4, 5].map((row) => {
    const squares = samples.map(({ J }) =>
      digits.reduce((sum, digit, k) => sum + (J[row * digits.length + k] * digit) ** 2, 0),
    );
    return Math.sqrt(average(squares)) + rest;
  });

const average = (list) => list.reduce((sum, x) => sum + x, 0) / list.length;

// So many whole numbers at most, evenly spread from 0 to the last.
function picked(last, count) {
  const step = last / (count - 1);
  const found = Array.from({ length: count }, (_, i) =>
    i === count - 1 ? last : Math.trunc(i * step),
  );
  return [...new Set(found)];
}

// Each wrong rule, by how much it fails on the whole in units of the noise, and whether that is
// little.
/** @param {Steps} steps @returns {Generator<{ one: Cause, left: number, fits: boolean }>} */
function* rulesOf(steps) {
  const { samples, arm } = steps;
  const now = (sample) => sample.now;
  const own = (sample) => sample.J;
  yield held(steps, cause("trace.other side"), own, (sample) => scaled(-1, sample.now));
  yield held(steps, cause("trace.millimetres"), own, (sample) => scaled(1e3, sample.now));
  if (Math.max(...steps.noise) < FINE * steps.speed) {
    const left = fails(steps, own, (sample) => scaled(1e-3, sample.now));
    yield { one: cause("J.millimetres"), left, fits: left < HOLDS };
  }
  yield held(steps, cause("trace.next velocity"), own, (sample) => sample.later);
  yield held(steps, cause("trace.jacobian held"), () => samples[0].J, now); // handed in
  const each = (at) => Array.from(recipes(at), ([one, made]) => [one, made(at, framesOf(at))]);
  const wrong = (sample) => (sample.made ??= each(sample.at)); // where it is looked at
  for (const [k, [one]] of wrong(samples[0]).entries()) {
    yield held(steps, /** @type {Cause} */ (one), (sample) => wrong(sample)[k][1], now);
  }
  for (const [one, change] of wrongTables(arm)) {
    const by = ({ at }) => columns(change(at), framesOf(change(at)));
    yield held(steps, /** @type {Cause} */ (one), by, now);
  }
  if (steps.rows < 6) return;
  const dof = steps.own.length;
  yield moves(steps, cause("trace.position only"), ({ J, now: v }) => leastRates(J, dof, v));
}

function fails(steps, J, linear, most = Infinity) {
  const { noise, rows } = steps;
  const off = (sample) => failed(J(sample), sample.rate, linear(sample), rows);
  return leaves(steps, off, noise.slice(0, rows), most);
}

// The first rows of K u - (v, 0), with the rows of K one after another.
function failed(K, u, v, rows) {
  const off = new Array(rows);
  for (let row = 0; row < rows; row++) {
    let sum = row < 3 ? -v[row] : 0;
    for (let k = 0; k < u.length; k++) sum += K[row * u.length + k] * u[k];
    off[row] = sum;
  }
  return off;
}

// The root mean square over the windows' averages of what is off, each number in its own unit, and
// of these the largest; infinite as soon as it must be more than `most`.
function leaves({ samples, window }, off, units, most = Infinity) {
  const squares = units.map(() => 0);
  let left = 0;
  for (let from = 0; from < samples.length && left <= most; from += window) {
    const sum = units.map(() => 0);
    for (const sample of samples.slice(from, from + window))
      off(sample).forEach((x, k) => (sum[k] += x));
    sum.forEach((x, k) => (squares[k] += (x / window) ** 2 * (window / samples.length)));
    left = Math.max(...squares.map((x, k) => Math.sqrt(x) / units[k]));
  }
  return left <= most ? left : Infinity;
}

/** @param {Steps} steps @param {Cause} one */
function held(steps, one, J, linear) {
  const little = (SHARE * steps.speed) / Math.max(...steps.noise);
  const left = fails(steps, J, linear, AS_WELL * Math.max(LOOSE, little));
  return { one, left, fits: left < HOLDS || left < little };
}

// How far the joints' rates are from those of another rule.
/** @param {Steps} steps @param {Cause} one */
function moves(steps, one, wanted) {
  const { own } = steps;
  const every = own.map(() => 1);
  const little = SHARE * leaves(steps, ({ rate }) => rate, every);
  const off = (sample) => minusEach(sample.rate, wanted(sample));
  const left = leaves(steps, off, own, AS_WELL * Math.max(LOOSE, little / Math.min(...own)));
  return { one, left, fits: left < HOLDS || leaves(steps, off, every, little) < little };
}

// J^T v with the first three rows of J.
const upwards = (J, dof, v) =>
  Array.from({ length: dof }, (_, k) => v[0] * J[k] + v[1] * J[dof + k] + v[2] * J[2 * dof + k]);

// The least rates that move the tip by v, by the pseudo-inverse of the linear rows.
function leastRates(J, dof, v) {
  const each = Array.from({ length: dof }, (_, k) => [J[k], J[dof + k], J[2 * dof + k]]);
  const { values, vectors } = singular(each, 3);
  const sum = vectors.reduce(
    (total, u, i) => {
      if (!(values[i] > 1e-15 * values[0])) return total;
      return plus(total, scaled((u[0] * v[0] + u[1] * v[1] + u[2] * v[2]) / values[i] ** 2, u));
    },
    [0, 0, 0],
  );
  return upwards(J, dof, sum);
}
