// Why a run misses its path, the port of helpers/checks/traces_causes.py: by the shape that the tip drew, by the loop
// that made it.

import { minus, norm, plus, scaled } from "../kinematics.js";
import { singular } from "../linear.js";
import { chain, columns, framesOf } from "./chains.js";
import { rint } from "./inverse.js";
import { recipes, wrongTables } from "./jacobian_causes.js";
import { cause } from "./ranking.js";
import { size } from "./say.js";

const SAMPLE = 100;
const PAIRS = [[0, 1], [0, 2], [1, 2]]; // prettier-ignore
const CLEARLY = 0.7; // of what the right loop leaves: what another must stay below to be named

/** @typedef {import("./ranking.js").Cause} Cause */
/** @typedef {import("./path.js").Path} Path */

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
 * What would explain every point, the likelier first; null where nothing does.
 * @param {Path} path @param {number[][]} tip @returns {Cause | null}
 */
export function pathCause(path, tip, allowed) {
  const [first] = shapes(path, tip, allowed);
  return first ?? null;
}

/** @returns {Generator<Cause>} */
function* shapes(path, tip, allowed) {
  const wanted = path.times.map(path.position);
  const follows = (points) => farthest(points, wanted) <= allowed;
  if (follows([...tip].reverse())) yield cause("trace.backwards");
  const shift = mean(tip.map((p, k) => minus(p, wanted[k])));
  if (norm(shift) > allowed && follows(shifted(tip, shift))) {
    yield cause("trace.displaced", { _by: vector(shift) });
  }
  const fraction = fractionOf(path, wanted, tip, allowed);
  if (fraction) yield cause("trace.fraction", { _share: size(100 * fraction), _over: size(1 / fraction) });
  const [middle, centre] = [mean(tip), mean(wanted)];
  const scale = size2(shifted(tip, middle)) / Math.max(size2(shifted(wanted, centre)), 1e-12);
  if (Math.abs(scale - 1) > 0.02) {
    const shape = shifted(wanted, centre).map((p) => scaled(scale, p));
    const about = [
      [middle, [0, 0, 0]],
      [tip[0], shape[0]],
    ].map(([from, to]) => farthest(shifted(tip, from), shifted(shape, to)));
    if (Math.min(...about) <= allowed * Math.min(1, Math.max(scale, 0.1))) {
      yield cause("trace.scaled", { _scale: size(Number(scale.toFixed(6)), 4) });
    }
  }
  if (follows(tip.map((p) => minus(scaled(2, wanted[0]), p)))) yield cause("trace.other side");
  for (const [i, j] of PAIRS) {
    const order = [0, 1, 2].map((k) => (k === i ? j : k === j ? i : k));
    const exchanged = (p) => plus(centre, order.map((k) => p[k] - middle[k])); // prettier-ignore
    if (follows(tip.map(exchanged)))
      yield cause("trace.axes exchanged", { first: "xyz"[i], second: "xyz"[j] });
  }
  if (otherPhase(wanted, tip, allowed)) yield cause("trace.phase");
}

// The share of the path that was drawn at even pace, where that is all: half speed, a quarter, dt against T.
/** @returns {number | null} */
function fractionOf(path, wanted, tip, allowed) {
  const all = drawn(wanted);
  const share = all ? drawn(tip) / all : 1;
  if (!(share > 1e-3 && share < 50) || Math.abs(share - 1) < 0.02) return null;
  const parts = [2, 3, 4, 5, 8, 10, 20, 40, 50, 100].map((n) => 1 / n);
  const nice = parts.reduce((best, x) => (Math.abs(x - share) < Math.abs(best - share) ? x : best));
  const start = path.times[0];
  for (const f of [nice, share, rint(share) || share]) {
    const points = path.times.map((t) => path.position(start + f * (t - start)));
    if (farthest(tip, points) <= allowed * Math.max(1, 2 * f)) return f;
  }
  return null;
}

// Whether a closed path is drawn from another point on: its last point equals its first.
function otherPhase(wanted, tip, allowed) {
  const once = tip.slice(0, -1);
  const n = once.length;
  const away = once.map((p) => norm(minus(p, wanted[0])));
  if (away[0] <= 2 * allowed) return false;
  const near = away.indexOf(Math.min(...away));
  return [-2, -1, 0, 1, 2].some((step) => {
    const k = (((near + step) % n) + n) % n;
    return k !== 0 && farthest([...once.slice(k), ...once.slice(0, k)], wanted) <= allowed;
  });
}

const vector = (metres) => `(${metres.map((x) => size(rint(1e3 * x * 1e3) / 1e3 + 0)).join(", ")})`;

// By the loop

/**
 * The rule by which each step's joints follow from the one before: another Jacobian, or another step's velocity; null
 * where the right one explains them, or none clearly.
 * @param {number[][]} q @param {number} unit the largest unit of a last place @param {Path} path
 * @returns {Cause | null}
 */
export function loopCause(q, unit, arm, path) {
  if (q.length < 4) return null;
  const dt = path.times.slice(1).map((t, k) => t - path.times[k]);
  const v = path.times.map(path.velocity);
  const samples = picked(q.length).map((k) => {
    const rate = q[k].map((x, i) => (q[k + 1][i] - x) / dt[k]);
    return { at: chain(arm, q[k]), rate, now: v[k], next: v[k + 1] };
  });
  const speed = v.reduce((top, one) => Math.max(top, ...one.map(Math.abs)), 0);
  // Two roundings, each even within a unit, through each row of J.
  const digits = unit / Math.min(...dt) / Math.sqrt(6);
  const all = samples.map((sample) => left(arm, sample));
  const dof = q[0].length;
  const noise = [0, 1, 2, 3, 4, 5].map((row) => {
    const squares = all.map(({ J }) =>
      J.slice(row * dof, (row + 1) * dof).reduce((sum, x) => sum + x * x, 0),
    );
    return digits * Math.sqrt(average(squares)) + 1e-4 * speed;
  });
  const counted = all[0].rules.map(([one], k) => {
    const fails = noise.map(
      (n, row) => Math.sqrt(average(all.map(({ rules }) => rules[k][1][row] ** 2))) / n,
    );
    return { one, left: Math.max(...fails) };
  });
  const [right, ...rules] = counted;
  const best = rules.reduce((least, rule) => (rule.left < least.left ? rule : least));
  const fits = best.left < 1.5 || best.left * Math.max(...noise) < 0.02 * speed;
  return fits && right.left > 1.8 && best.left < CLEARLY * right.left ? best.one : null;
}

const average = (list) => list.reduce((sum, x) => sum + x, 0) / list.length;

// At most so many steps, evenly spread, without the last two rows.
function picked(rows) {
  const step = (rows - 3) / (SAMPLE - 1);
  const found = Array.from({ length: SAMPLE }, (_, i) =>
    i === SAMPLE - 1 ? rows - 3 : Math.trunc(i * step),
  );
  return [...new Set(found)];
}

// The six velocities by which each rule fails at one step, the right one's first.
/** @returns {{ J: number[], rules: [Cause | null, number[]][] }} */
function left(arm, { at, rate, now, next }) {
  const J = columns(at, framesOf(at));
  const fails = (K, linear) => times(K, rate).map((x, i) => (i < 3 ? x - linear[i] : x));
  const differs = (wanted) => times(J.map(Math.abs), rate.map((x, i) => Math.abs(x - wanted[i]))); // prettier-ignore
  /** @type {[Cause | null, number[]][]} */
  const rules = [[null, fails(J, now)]];
  rules.push([cause("trace.next velocity"), fails(J, next)]);
  for (const [one, K] of recipes(at)) rules.push([/** @type {Cause} */ (one), fails(K, now)]);
  for (const [one, other] of wrongTables(arm, at))
    rules.push([one, fails(columns(other, framesOf(other)), now)]);
  if (at.dof > 3) {
    rules.push([cause("trace.position only"), differs(leastRates(J, at.dof, now))]);
    rules.push([cause("trace.transpose"), differs(upwards(J, at.dof, now))]);
  }
  return { J, rules };
}

// K u, with the rows of K one after another.
const times = (K, u) =>
  [0, 1, 2, 3, 4, 5].map((row) => u.reduce((sum, x, k) => sum + K[row * u.length + k] * x, 0));

// J^T v with the first three rows of J.
const upwards = (J, dof, v) =>
  Array.from({ length: dof }, (_, k) => v[0] * J[k] + v[1] * J[dof + k] + v[2] * J[2 * dof + k]);

// The least rates that move the tip by v, by the pseudo-inverse of the linear rows.
function leastRates(J, dof, v) {
  const each = Array.from({ length: dof }, (_, k) => [J[k], J[dof + k], J[2 * dof + k]]);
  const { values, vectors } = singular(each, 3);
  const sum = vectors.reduce((total, u, i) => {
    if (!(values[i] > 1e-15 * values[0])) return total;
    return plus(total, scaled((u[0] * v[0] + u[1] * v[1] + u[2] * v[2]) / values[i] ** 2, u));
  }, [0, 0, 0]); // prettier-ignore
  return upwards(J, dof, sum);
}
