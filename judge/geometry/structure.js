// Finds which joint axes of an arm meet in a point or are parallel, which gives its inverse
// kinematics a closed form. helpers/inverse/structure.py does the same and names the sources; a
// test compares the two.

import { cross, dot, linkFrames, minus, movingRows, norm, plus, scaled } from "./kinematics.js";
import { decomposeSingular, solveLinear } from "./linear.js";

/** @typedef {import("./arm.js").Arm} Arm */
/** @typedef {import("./kinematics.js").Frame} Frame */
/** @typedef {import("./kinematics.js").Vector} Vector */
/** @typedef {{ direction: Vector, point: Vector, turns: boolean }} Axis a joint's axis as a line */
/**
 * @typedef {object} Structure
 * @property {"wrist" | "first three meet" | "parallel" | "planar" | "position" | "two links"} kind
 * @property {Axis[]} axes one for each joint, at the configuration `reference`
 * @property {number} size length of the arm from axis to axis (m)
 * @property {number[]} reference the generic configuration
 * @property {Frame} tip the tip's frame at that configuration
 * @property {Vector} [centre] the point where three axes meet
 * @property {number} [first] the index of the first of three parallel axes
 * @property {number} gap largest deviation of the axes from the structure (rad, or lengths divided
 *   by the size)
 */

// rad, or lengths divided by the arm's size. Files round angles to four digits, and calibrated arms
// deviate from their design by about as much.
const STRUCTURE_TOLERANCE = 1e-4;
// The largest gap that round-off leaves; the closed form then needs no steps of Newton's method.
export const EXACT = 1e-10;
// Joint values (rad or m) at which no two axes coincide by chance.
const GENERIC_CONFIGURATION = [0.86, 1.11, 0.99, 0.5, 0.57, 1.08];

/** @type {WeakMap<Arm, Structure | null>} */
const structures = new WeakMap();

/** Return the structure of an arm, or null if it has none. @param {Arm} arm */
export function findStructure(arm) {
  if (!structures.has(arm)) structures.set(arm, classifyAxes(axesAtGenericConfiguration(arm)));
  return structures.get(arm) ?? null;
}

/** @returns {Structure | null} */
function classifyAxes(configuration) {
  const { axes, size } = configuration;
  const turns = axes.map((axis) => axis.turns);
  const isParallel = axes.length > 1 && parallelGap(axes) < STRUCTURE_TOLERANCE;
  if (axes.length === 6) return classifySix(configuration);
  if (turns.filter(Boolean).length === 3 && axes.length < 5 && isParallel)
    return { kind: "planar", ...configuration, gap: parallelGap(axes) };
  if (axes.length === 3) {
    const gap = crossingGap(axes, size);
    return gap < STRUCTURE_TOLERANCE ? { kind: "position", ...configuration, gap } : null;
  }
  if (axes.length === 2 && turns.every(Boolean) && isParallel)
    return { kind: "two links", ...configuration, gap: parallelGap(axes) };
  return null;
}

/** @returns {Structure | null} */
function classifySix(configuration) {
  const { axes, size } = configuration;
  const sphericalKinds = [
    { kind: /** @type {const} */ ("wrist"), three: axes.slice(3), placing: axes.slice(0, 3) },
    {
      kind: /** @type {const} */ ("first three meet"),
      three: axes.slice(0, 3),
      placing: axes.slice(3).reverse(),
    },
  ];
  for (const { kind, three, placing } of sphericalKinds) {
    const centre = meetingPoint(three, size);
    const gap = crossingGap(placing, size);
    if (centre && gap < STRUCTURE_TOLERANCE)
      return { kind, ...configuration, centre: centre.point, gap: Math.max(centre.gap, gap) };
  }
  if (!axes.every((axis) => axis.turns)) return null;
  for (let first = 0; first < 4; first++) {
    const gap = parallelGap(axes.slice(first, first + 3));
    const others = [0, 1, 2].map((i) => (first + 3 + i) % 6);
    const gaps = [0, 1].flatMap((i) => {
      if (others[i + 1] !== others[i] + 1) return [];
      return meetingPoint([axes[others[i]], axes[others[i + 1]]], size)?.gap ?? [];
    });
    if (gap < STRUCTURE_TOLERANCE && gaps.length)
      return { kind: "parallel", ...configuration, first, gap: Math.max(gap, Math.min(...gaps)) };
  }
  return null;
}

/**
 * Return the joint axes as lines, the arm's size and its tip at the generic configuration.
 * @param {Arm} arm
 */
function axesAtGenericConfiguration(arm) {
  const moving = movingRows(arm);
  const reference = moving.map((_, k) => GENERIC_CONFIGURATION[k % 6]);
  const frames = linkFrames(arm, reference);
  let [last, size] = [frames[0].o, 0];
  // Each axis gets the point nearest to the previous axis's point, since common normals of nearly
  // parallel axes may lie far away.
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
 * Return the point where revolute axes meet, or null if they do not meet.
 * @param {Axis[]} axes
 * @param {number} size of the arm (m)
 * @returns {{ point: Vector, gap: number } | null} gap: the axes' largest distance from the point,
 *   divided by the size
 */
export function meetingPoint(axes, size) {
  if (!axes.every((axis) => axis.turns)) return null;
  for (let k = 1; k < axes.length; k++)
    if (norm(cross(axes[k - 1].direction, axes[k].direction)) < STRUCTURE_TOLERANCE) return null;
  const normals = axes.map(({ direction: h }) =>
    h.map((x, i) => h.map((y, j) => Number(i === j) - x * y)),
  );
  const sum = [0, 1, 2].map((i) => [0, 1, 2].map((j) => addUp(normals.map((P) => P[i][j]))));
  const rightSide = [0, 1, 2].map((i) =>
    addUp(axes.map(({ point }, k) => dot(normals[k][i], point))),
  );
  const point = solveLinear(sum, rightSide);
  const distances = axes.map((axis) => norm(cross(axis.direction, minus(point, axis.point))));
  const gap = Math.max(...distances) / size;
  return gap < STRUCTURE_TOLERANCE ? { point, gap } : null;
}

const addUp = (numbers) => numbers.reduce((sum, x) => sum + x, 0);

// Return the largest sine of the angle between neighbouring axes.
/** @param {Axis[]} axes */
const parallelGap = (axes) =>
  Math.max(...axes.slice(1).map((axis, k) => norm(cross(axes[k].direction, axis.direction))));

// Measure how far the curves of joints 1 and 3 are from two curves whose crossings have a closed
// form. It is 0 if either curve is a segment, or if both are parabolas or both are circles.
function crossingGap([first, second, third], size) {
  if (!first.turns && !third.turns) return 0;
  const widths = [first, third].map((axis) => findFlatness(axis, second, size).width);
  if (!second.turns && first.turns && third.turns) widths.push(parallelGap([first, third]));
  return Math.min(...widths);
}

/**
 * Return the curve on which a joint moves a point. A revolute joint moves it along
 * centre + X cos q + Y sin q, a prismatic joint along centre + X q.
 * @param {Axis} axis
 * @param {Vector} point (m)
 */
export function jointCurve(axis, point) {
  if (!axis.turns) return { centre: point, X: axis.direction, Y: [0, 0, 0], turns: false };
  const offset = minus(point, axis.point);
  const X = minus(offset, scaled(dot(axis.direction, offset), axis.direction));
  return { centre: minus(point, X), X, Y: cross(axis.direction, X), turns: true };
}

/**
 * Return the two numbers of a point on a curve that joint 2 does not change. Along the curve they
 * are A (x, y) + b, where (x, y) = (cos q, sin q) for a revolute joint and (q, q^2) for a slide. If
 * joint 2 is revolute, they are the height along its axis and the squared distance from it, divided
 * by twice the arm's size. If it is a slide, they are the two coordinates across its axis.
 * @param {Axis} second axis of joint 2
 * @param {ReturnType<typeof jointCurve>} curve
 * @param {number} size of the arm (m)
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

/** Return a unit vector at a right angle to a direction. @param {Vector} direction */
export function unitAcross(direction) {
  const least = direction.map(Math.abs).indexOf(Math.min(...direction.map(Math.abs)));
  const e = cross(
    direction,
    [0, 1, 2].map((i) => Number(i === least)),
  );
  return scaled(1 / norm(e), e);
}

/**
 * Return how flat a joint's curve is in the plane of the two invariants. This depends on the axes
 * of the joint and of joint 2, not on the point that the joint moves.
 * @param {Axis} axis of the joint
 * @param {Axis} second axis of joint 2
 * @param {number} size of the arm (m)
 * @returns {{ along: number[], across: number[], width: number }} the directions of the curve's
 *   length and width, and the width divided by the length: 0 for a segment
 */
export function findFlatness(axis, second, size) {
  const point = plus(axis.point, scaled(size, [0.3, -0.7, 0.5]));
  const { A } = invariants(second, jointCurve(axis, point), size);
  const columns = [0, 1].map((j) => [A[0][j], A[1][j]]);
  const { values, vectors } = decomposeSingular(columns, 2);
  // Solutions are named by the sign of a root, so the sign of a direction must not depend on the
  // library that computed it.
  const [along, across] = [0, 1].map((k) => {
    const [x, y] = vectors[k];
    return (Math.abs(x) > 1e-6 ? x : y) < 0 ? [-x, -y] : [x, y];
  });
  return { along, across, width: values[0] > 0 ? values[1] / values[0] : 0 };
}

/** Return whether a curve counts as a segment. */
export const isFlat = ({ width }) => width < STRUCTURE_TOLERANCE;
