// Lists the gaps between an arm's neighbouring axes, from the base to the tip.

import { cross, dot, movingRows, linkFrames, minus, norm, plus, scaled } from "./kinematics.js";
import { decomposeSingular } from "./linear.js";

/** @typedef {import("./axes.js").Gap} Gap */

// m, or the sine of an angle: axes this close meet or are parallel. 1e4 x round-off of a long
// chain.
export const AXIS_ROUND_OFF = 1e-9;

export const NORMAL_INDEX = -1; // stands for the common normal in a list of joint indices

/**
 * List the gaps from base to tip. Prismatic joints are moved to where the lengths are smallest,
 * since their zeros are arbitrary.
 * @param {import("./arm.js").Rows} arm
 * @returns {Gap[]}
 */
export function listGaps(arm) {
  const moving = movingRows(arm);
  const slides = moving.flatMap((row, k) => (arm.rows[row].kind === "prismatic" ? [k] : []));
  const q = moving.map(() => 0);
  if (!slides.length) return listGapsAt(arm, q);
  const start = listLengths(listGapsAt(arm, q));
  const rates = slides.map((k) => {
    const pushed = moving.map((_, j) => Number(j === k));
    const moved = listLengths(listGapsAt(arm, pushed));
    return moved.map((x, i) => (Math.abs(x - start[i]) < AXIS_ROUND_OFF ? 0 : x - start[i]));
  });
  solveLeastSquares(rates, start).forEach((x, i) => (q[slides[i]] = -x));
  return listGapsAt(arm, q);
}

// Return the shortest x for which the columns times x come closest to b.
function solveLeastSquares(columns, b) {
  const rows = b.map((_, i) => columns.map((column) => column[i]));
  const { values, vectors } = decomposeSingular(rows, columns.length);
  const products = columns.map((column) => column.reduce((sum, x, i) => sum + x * b[i], 0));
  const x = columns.map(() => 0);
  values.forEach((value, k) => {
    if (value <= AXIS_ROUND_OFF * values[0]) return;
    const component = vectors[k].reduce((sum, u, i) => sum + u * products[i], 0) / (value * value);
    vectors[k].forEach((u, i) => (x[i] += component * u));
  });
  return x;
}

// List the lengths that the slides of an arm may change.
const listLengths = (gaps) => [
  ...gaps.flatMap(({ normal }) => normal),
  ...gaps.flatMap(({ offset, fromBase }) => (offset === null || fromBase ? [] : [offset])),
];

// List the gaps at one configuration. The common normals of revolute axes follow one after the
// other: `foot` is where the last one ends.
function listGapsAt(arm, q) {
  const frames = linkFrames(arm, q);
  const moving = movingRows(arm);
  const dof = moving.length;
  const axes = moving.map((row) => frames[row].z);
  const points = moving.map((row) => frames[row].o);
  const revolute = moving.flatMap((row, k) => (arm.rows[row].kind === "revolute" ? [k] : []));
  const ends = [...revolute, dof];
  const listJoints = (from, to) =>
    Array.from({ length: Math.max(0, Math.min(to + 1, dof) - from) }, (_, k) => from + k);
  const baseGap = { offset: null, parallelJoints: [], fromBase: true, toTip: false };
  const gaps = [makeGap(axes, listJoints(0, ends[0]), [0, 0, 0], baseGap)];
  const origin = [0, 0, 0];
  let foot = revolute.length
    ? findCommonNormal(origin, [0, 0, 1], points[ends[0]], axes[ends[0]])[1]
    : origin;
  let parallelJoints = [];
  revolute.forEach((i, n) => {
    const j = ends[n + 1];
    const toTip = j === dof;
    if (!parallelJoints.length) foot = projectOnto(points[i], axes[i], foot);
    const [nextPoint, nextAxis] = toTip ? [frames.at(-1).o, null] : [points[j], axes[j]];
    const [start, end] = findCommonNormal(foot, axes[i], nextPoint, nextAxis);
    parallelJoints = [...parallelJoints, i];
    const isNextParallel = !toTip && isParallel(axes[i], axes[j]);
    const offset = isNextParallel ? null : dot(axes[i], minus(start, foot));
    const fromBase = parallelJoints[0] === revolute[0];
    gaps.push(
      makeGap(axes, listJoints(i, j), minus(end, start), {
        offset,
        parallelJoints,
        fromBase,
        toTip,
      }),
    );
    foot = end;
    if (!isNextParallel) parallelJoints = [];
  });
  return gaps;
}

/**
 * List all choices of `count` items, in order.
 * @template T
 * @param {T[]} list
 * @param {number} count
 */
export function combinations(list, count) {
  if (!count) return [[]];
  return list.flatMap((item, k) =>
    combinations(list.slice(k + 1), count - 1).map((later) => [item, ...later]),
  );
}

/** @returns {Gap} */
function makeGap(axes, joints, normal, offsetFields) {
  const length = norm(normal);
  const directions = new Map(joints.map((k) => [k, axes[k]]));
  if (length > AXIS_ROUND_OFF) directions.set(NORMAL_INDEX, scaled(1 / length, normal));
  const shape = new Map();
  for (const [i, j] of combinations(joints, 2)) shape.set(`${[i, j]}`, dot(axes[i], axes[j]));
  for (const three of combinations([...directions.keys()], 3)) {
    const [u, v, w] = three.map((k) => directions.get(k));
    shape.set(`${three}`, dot(cross(u, v), w));
  }
  return { joints, normal, length, shape, ...offsetFields };
}

// Return the foot of a point on the line through p along u.
const projectOnto = (p, u, point) => plus(p, scaled(dot(u, minus(point, p)), u));

/**
 * Return both ends of the common normal of two lines, or of a line and a point. Between parallel
 * lines it starts at p.
 * @param {number[]} p a point of the first line (m)
 * @param {number[]} u its direction
 * @param {number[]} q a point of the second line, or the point (m)
 * @param {number[] | null} v its direction; null for a point
 */
function findCommonNormal(p, u, q, v) {
  if (!v) return [projectOnto(p, u, q), q];
  if (isParallel(u, v)) return [p, projectOnto(q, v, p)];
  const w = minus(q, p);
  const uv = dot(u, v);
  const denominator = 1 - uv * uv;
  const s = (dot(u, w) - uv * dot(v, w)) / denominator;
  const t = (uv * dot(u, w) - dot(v, w)) / denominator;
  return [plus(p, scaled(s, u)), plus(q, scaled(t, v))];
}

/** Return whether two unit vectors are parallel. */
export const isParallel = (u, v) => norm(cross(u, v)) < AXIS_ROUND_OFF;
