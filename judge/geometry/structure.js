// The structure of an arm that gives its inverse kinematics a closed form: which joint axes, as
// lines at a generic pose, meet in a point or are parallel. As helpers/inverse/structure.py, which
// gives the sources; a test holds the two equal.

import { cross, dot, linkFrames, minus, movingRows, norm, plus, scaled } from "./kinematics.js";
import { decomposeSingular, solveLinear } from "./linear.js";

/** @typedef {import("./arm.js").Arm} Arm */
/** @typedef {number[]} Vector three components */
/** @typedef {{ x: Vector, y: Vector, z: Vector, o: Vector }} Frame */
/** @typedef {{ direction: Vector, point: Vector, turns: boolean }} Axis a joint's axis as a line */
/**
 * @typedef {object} Structure
 * @property {"wrist" | "first three meet" | "parallel" | "planar" | "position" | "two links"} kind
 * @property {Axis[]} axes one for each joint, at the pose `reference`
 * @property {number} size the length of the arm from axis to axis, in m
 * @property {number[]} reference the generic pose
 * @property {Frame} tip the tip's frame there
 * @property {Vector} [centre] the point where three axes meet
 * @property {number} [first] the index of the first of three parallel axes
 * @property {number} gap by how much the axes miss the structure (rad, or lengths over the size)
 */

const NEARLY = 1e-4; // rad, or lengths over the arm's size: as in Python
export const EXACT = 1e-10; // below this the closed form needs no finishing by Newton's method
// Any pose at which no two axes coincide by chance.
const GENERIC = [0.86, 1.11, 0.99, 0.5, 0.57, 1.08];

/** @type {WeakMap<Arm, Structure | null>} */
const known = new WeakMap();

/**
 * The structure of an arm, or null where it has none.
 * @param {Arm} arm
 */
export function findStructure(arm) {
  if (!known.has(arm)) known.set(arm, classifyAxes(axesAtGenericPose(arm)));
  return known.get(arm) ?? null;
}

/** @returns {Structure | null} */
function classifyAxes(base) {
  const { axes, size } = base;
  const turns = axes.map((axis) => axis.turns);
  const isParallel = axes.length > 1 && parallelGap(axes) < NEARLY;
  if (axes.length === 6) return classifySix(base);
  if (turns.filter(Boolean).length === 3 && axes.length < 5 && isParallel)
    return { kind: "planar", ...base, gap: parallelGap(axes) };
  if (axes.length === 3) {
    const gap = crossingGap(axes, size);
    return gap < NEARLY ? { kind: "position", ...base, gap } : null;
  }
  if (axes.length === 2 && turns.every(Boolean) && isParallel)
    return { kind: "two links", ...base, gap: parallelGap(axes) };
  return null;
}

/** @returns {Structure | null} */
function classifySix(base) {
  const { axes, size } = base;
  const spherical = [
    { kind: /** @type {const} */ ("wrist"), three: axes.slice(3), placing: axes.slice(0, 3) },
    {
      kind: /** @type {const} */ ("first three meet"),
      three: axes.slice(0, 3),
      placing: axes.slice(3).reverse(),
    },
  ];
  for (const { kind, three, placing } of spherical) {
    const met = meetingPoint(three, size);
    const gap = crossingGap(placing, size);
    if (met && gap < NEARLY)
      return { kind, ...base, centre: met.point, gap: Math.max(met.gap, gap) };
  }
  if (!axes.every((axis) => axis.turns)) return null;
  for (let first = 0; first < 4; first++) {
    const gap = parallelGap(axes.slice(first, first + 3));
    const others = [0, 1, 2].map((i) => (first + 3 + i) % 6);
    const gaps = [0, 1].flatMap((i) => {
      if (others[i + 1] !== others[i] + 1) return [];
      return meetingPoint([axes[others[i]], axes[others[i + 1]]], size)?.gap ?? [];
    });
    if (gap < NEARLY && gaps.length)
      return { kind: "parallel", ...base, first, gap: Math.max(gap, Math.min(...gaps)) };
  }
  return null;
}

/** @param {Arm} arm */
function axesAtGenericPose(arm) {
  const moving = movingRows(arm);
  const reference = moving.map((_, k) => GENERIC[k % 6]);
  const frames = linkFrames(arm, reference);
  let [last, size] = [frames[0].o, 0];
  // The foot of the perpendicular from the point before: common normals of nearly parallel axes may
  // lie far away.
  const axes = moving.map((row) => {
    const { z, o } = frames[row];
    const point = plus(o, scaled(dot(z, minus(last, o)), z));
    size += norm(minus(point, last));
    last = point;
    return { direction: z, point, turns: arm.rows[row].kind === "revolute" };
  });
  const tip = frames.at(-1);
  return { axes, size: size + norm(minus(tip.o, last)), reference, tip };
}

/**
 * Return the point where revolute axes meet, and their largest distance from it relative to the
 * arm's size; null if they do not meet.
 * @param {Axis[]} axes
 */
export function meetingPoint(axes, size) {
  if (!axes.every((axis) => axis.turns)) return null;
  for (let k = 1; k < axes.length; k++)
    if (norm(cross(axes[k - 1].direction, axes[k].direction)) < NEARLY) return null;
  const normals = axes.map(({ direction: h }) =>
    h.map((x, i) => h.map((y, j) => Number(i === j) - x * y)),
  );
  const sum = [0, 1, 2].map((i) => [0, 1, 2].map((j) => total(normals.map((P) => P[i][j]))));
  const right = [0, 1, 2].map((i) => total(axes.map(({ point }, k) => dot(normals[k][i], point))));
  const point = solveLinear(sum, right);
  const misses = axes.map((axis) => norm(cross(axis.direction, minus(point, axis.point))));
  const gap = Math.max(...misses) / size;
  return gap < NEARLY ? { point, gap } : null;
}

const total = (numbers) => numbers.reduce((sum, x) => sum + x, 0);

/** @param {Axis[]} axes */
const parallelGap = (axes) =>
  Math.max(...axes.slice(1).map((axis, k) => norm(cross(axes[k].direction, axis.direction))));

// Measure how far the curves of joints 1 and 3 are from a closed form of their crossings: 0 if one
// is a segment, or if both are parabolas or circles of one kind.
function crossingGap([first, second, third], size) {
  if (!first.turns && !third.turns) return 0;
  const widths = [first, third].map((axis) => flatnessOf(axis, second, size).width);
  if (!second.turns && first.turns && third.turns) widths.push(parallelGap([first, third]));
  return Math.min(...widths);
}

/**
 * Return the curve on which a joint moves a point: centre + X cos q + Y sin q, or centre + X q.
 * @param {Axis} axis @param {Vector} point
 */
export function jointCurve(axis, point) {
  if (!axis.turns) return { centre: point, X: axis.direction, Y: [0, 0, 0], turns: false };
  const offset = minus(point, axis.point);
  const X = minus(offset, scaled(dot(axis.direction, offset), axis.direction));
  return { centre: minus(point, X), X, Y: cross(axis.direction, X), turns: true };
}

/**
 * Return the two numbers that joint 2 does not change, as A (x, y) + b along a curve, where
 * (x, y) = (cos q, sin q) or (q, q^2). For a revolute joint 2 they are the height along its axis
 * and the squared distance from it over twice the arm's size; for a slide, two coordinates across.
 * @param {Axis} second
 */
export function invariants(second, { centre, X, Y, turns }, size) {
  const h = second.direction;
  if (!second.turns) {
    const e = unitAcross(h);
    const rows = [e, cross(h, e)].map((f) => [dot(f, X), dot(f, Y), dot(f, centre)]);
    return { A: rows.map((row) => row.slice(0, 2)), b: rows.map((row) => row[2]), turns };
  }
  const r = minus(centre, second.point);
  const linear = turns ? dot(r, Y) : dot(X, X) / 2;
  const square = dot(r, r) + (turns ? dot(X, X) : 0);
  const A = [
    [dot(h, X), dot(h, Y)],
    [dot(r, X) / size, linear / size],
  ];
  return { A, b: [dot(h, r), square / (2 * size)], turns };
}

/** @param {Vector} direction */
export function unitAcross(direction) {
  const least = direction.map(Math.abs).indexOf(Math.min(...direction.map(Math.abs)));
  const e = cross(
    direction,
    [0, 1, 2].map((i) => Number(i === least)),
  );
  return scaled(1 / norm(e), e);
}

/**
 * Return the directions along and across a joint's curve in the plane of the two invariants, and
 * its width over its length, 0 for a segment. They depend on the two axes, not on the point.
 * @param {Axis} axis @param {Axis} second
 */
export function flatnessOf(axis, second, size) {
  const point = plus(axis.point, scaled(size, [0.3, -0.7, 0.5]));
  const { A } = invariants(second, jointCurve(axis, point), size);
  const columns = [0, 1].map((j) => [A[0][j], A[1][j]]);
  const { values, vectors } = decomposeSingular(columns, 2);
  // Roots are named by their sign, so a direction must not depend on the library that found it.
  const [along, across] = [0, 1].map((k) => {
    const [x, y] = vectors[k];
    return (Math.abs(x) > 1e-6 ? x : y) < 0 ? [-x, -y] : [x, y];
  });
  return { along, across, width: values[0] > 0 ? values[1] / values[0] : 0 };
}

export const isFlat = ({ width }) => width < NEARLY;
