// Walks along an arm's axes from the base to the tip and lists the gaps between them.

import { cross, dot, movingRows, linkFrames, minus, norm, plus, scaled } from "./kinematics.js";
import { decomposeSingular } from "./linear.js";

/** @typedef {import("./axes.js").Gap} Gap */

// m, or the sine of an angle: below it axes meet or are parallel. 1e4 x round-off of a long chain
export const TINY = 1e-9;

export const NORMAL_INDEX = -1; // stands for the common normal in a list of joint indices

/**
 * List the gaps from base to tip. Prismatic joints are moved to where the lengths are least, since
 * their zeros are arbitrary.
 * @param {import("./arm.js").Rows} arm
 * @returns {Gap[]}
 */
export function listGaps(arm) {
  const moving = movingRows(arm);
  const slides = moving.flatMap((row, k) => (arm.rows[row].kind === "prismatic" ? [k] : []));
  const q = moving.map(() => 0);
  if (!slides.length) return walk(arm, q);
  const start = listLengths(walk(arm, q));
  const rates = slides.map((k) => {
    const pushed = moving.map((_, j) => Number(j === k));
    const moved = listLengths(walk(arm, pushed));
    return moved.map((x, i) => (Math.abs(x - start[i]) < TINY ? 0 : x - start[i]));
  });
  solveLeastSquares(rates, start).forEach((x, i) => (q[slides[i]] = -x));
  return walk(arm, q);
}

// The shortest x for which the columns times x come closest to b.
function solveLeastSquares(columns, b) {
  const rows = b.map((_, i) => columns.map((column) => column[i]));
  const { values, vectors } = decomposeSingular(rows, columns.length);
  const along = columns.map((column) => column.reduce((sum, x, i) => sum + x * b[i], 0));
  const x = columns.map(() => 0);
  values.forEach((value, k) => {
    if (value <= TINY * values[0]) return;
    const part = vectors[k].reduce((sum, u, i) => sum + u * along[i], 0) / (value * value);
    vectors[k].forEach((u, i) => (x[i] += part * u));
  });
  return x;
}

const listLengths = (gaps) => [
  ...gaps.flatMap(({ normal }) => normal),
  ...gaps.flatMap(({ offset, fromBase }) => (offset === null || fromBase ? [] : [offset])),
];

function walk(arm, q) {
  const frames = linkFrames(arm, q);
  const moving = movingRows(arm);
  const dof = moving.length;
  const axes = moving.map((row) => frames[row].z);
  const points = moving.map((row) => frames[row].o);
  const turning = moving.flatMap((row, k) => (arm.rows[row].kind === "revolute" ? [k] : []));
  const stops = [...turning, dof];
  const upTo = (from, to) =>
    Array.from({ length: Math.max(0, Math.min(to + 1, dof) - from) }, (_, k) => from + k);
  const atBase = { offset: null, bunch: [], fromBase: true, toTip: false };
  const gaps = [makeGap(axes, upTo(0, stops[0]), [0, 0, 0], atBase)];
  let foot = turning.length
    ? findCommonNormal([0, 0, 0], [0, 0, 1], points[stops[0]], axes[stops[0]])[1]
    : [0, 0, 0];
  let bunch = [];
  turning.forEach((i, n) => {
    const j = stops[n + 1];
    const toTip = j === dof;
    if (!bunch.length) foot = projectOnto(points[i], axes[i], foot);
    const [next, along] = toTip ? [frames.at(-1).o, null] : [points[j], axes[j]];
    const [leave, arrive] = findCommonNormal(foot, axes[i], next, along);
    bunch = [...bunch, i];
    const isNextParallel = !toTip && isParallel(axes[i], axes[j]);
    const offset = isNextParallel ? null : dot(axes[i], minus(leave, foot));
    const fromBase = bunch[0] === turning[0];
    gaps.push(makeGap(axes, upTo(i, j), minus(arrive, leave), { offset, bunch, fromBase, toTip }));
    foot = arrive;
    if (!isNextParallel) bunch = [];
  });
  return gaps;
}

/** List all choices of `count` items, in order. @template T @param {T[]} list */
export function combinations(list, count) {
  if (!count) return [[]];
  return list.flatMap((one, k) =>
    combinations(list.slice(k + 1), count - 1).map((more) => [one, ...more]),
  );
}

/** @returns {Gap} */
function makeGap(axes, between, normal, rest) {
  const length = norm(normal);
  const directions = new Map(between.map((k) => [k, axes[k]]));
  if (length > TINY) directions.set(NORMAL_INDEX, scaled(1 / length, normal));
  const shape = new Map();
  for (const [i, j] of combinations(between, 2)) shape.set(`${[i, j]}`, dot(axes[i], axes[j]));
  for (const three of combinations([...directions.keys()], 3)) {
    const [u, v, w] = three.map((k) => directions.get(k));
    shape.set(`${three}`, dot(cross(u, v), w));
  }
  return { joints: between, normal, length, shape, ...rest };
}

// The foot of a point on the line (p, u).
const projectOnto = (p, u, point) => plus(p, scaled(dot(u, minus(point, p)), u));

/**
 * Return the feet of the common normal from the line (p, u) to the line (q, v), or to the point q.
 * Between parallel lines it starts at p.
 */
export function findCommonNormal(p, u, q, v) {
  if (!v) return [projectOnto(p, u, q), q];
  if (isParallel(u, v)) return [p, projectOnto(q, v, p)];
  const w = minus(q, p);
  const uv = dot(u, v);
  const below = 1 - uv * uv;
  const s = (dot(u, w) - uv * dot(v, w)) / below;
  const t = (uv * dot(u, w) - dot(v, w)) / below;
  return [plus(p, scaled(s, u)), plus(q, scaled(t, v))];
}

/** Return whether two unit vectors are parallel. */
export const isParallel = (u, v) => norm(cross(u, v)) < TINY;
