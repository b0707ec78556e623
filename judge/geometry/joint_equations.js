// Move points and directions by joints, and solve the three equations that inverse kinematics by
// structure needs; as helpers/inverse/equations.py.

import { cross, dot, minus, norm, plus, scaled } from "./kinematics.js";

/** @typedef {import("./structure.js").Axis} Axis */
/** @typedef {{ values: number[], equal: boolean, free: boolean }} Roots one value where equal */

const BOUNDARY = 1e-12; // relative to the size: a target this close to a boundary is on it
const ON_AXIS = 1e-11; // relative to the size: a point this close to an axis is on it

export function rotate(h, q, v) {
  const [c, s] = [Math.cos(q), Math.sin(q)];
  return plus(plus(scaled(c, v), scaled(s, cross(h, v))), scaled((1 - c) * dot(h, v), h));
}

/** @param {Axis} axis */
export const movePoint = (axis, q, v) =>
  axis.turns
    ? plus(axis.point, rotate(axis.direction, q, minus(v, axis.point)))
    : plus(v, scaled(q, axis.direction));

/** @param {Axis} axis */
export const moveDirection = (axis, q, v) => (axis.turns ? rotate(axis.direction, q, v) : v);

export const partAcross = (h, v) => minus(v, scaled(dot(h, v), h));

// The three equations.

/** Solve a cos q + b sin q = c. @returns {Roots} */
export function solveCosineSine(a, b, c, size, chosen) {
  const amplitude = Math.hypot(a, b);
  let gap = amplitude - Math.abs(c);
  if (Math.abs(gap) < BOUNDARY * size) gap = 0;
  if (amplitude < ON_AXIS * size) return { values: [chosen], equal: true, free: true };
  const half = Math.atan2(Math.sqrt(Math.max(gap, 0)), Math.sqrt(amplitude + Math.abs(c)));
  const [middle, off] = [Math.atan2(b, a), 2 * (c < 0 ? Math.PI / 2 - half : half)];
  return rootsOf(middle + off, middle - off, gap <= 0);
}

/** Solve a q + b q^2 = c. @returns {Roots} */
export function solveQuadratic(a, b, c, size) {
  if (Math.abs(b) < BOUNDARY / size)
    return { values: [Math.abs(a) < ON_AXIS ? NaN : c / a], equal: true, free: false };
  let square = a * a + 4 * b * c;
  if (Math.abs(square) < 4 * Math.abs(b) * BOUNDARY * size) square = 0;
  const root = Math.sqrt(Math.max(square, 0));
  return rootsOf((-a + root) / (2 * b), (-a - root) / (2 * b), square <= 0);
}

/** @returns {Roots} */
const rootsOf = (first, second, equal) => ({
  values: equal ? [first] : [first, second],
  equal,
  free: false,
});

// Return the angle about a direction h from u to v; free if u or v is along h.
export function angleBetween(h, u, v, size, chosen) {
  const [x, y] = [partAcross(h, u), partAcross(h, v)];
  if (Math.min(norm(x), norm(y)) < ON_AXIS * size) return { value: chosen, free: true };
  return { value: Math.atan2(dot(h, cross(x, y)), dot(x, y)), free: false };
}

/** Find the two angles about h that give u the angle to v that `target` has. @returns {Roots} */
export function turnsToAngle(h, u, v, target) {
  const between = (p, q) => Math.atan2(norm(cross(p, q)), dot(p, q));
  const [sideV, sideU, opposite] = [between(h, v), between(h, u), between(v, target)];
  const half = (sideV + sideU + opposite) / 2;
  const above = sine(half - sideV) * sine(half - sideU);
  const below = sine(half) * sine(half - opposite);
  const corner = 2 * Math.atan2(Math.sqrt(Math.max(above, 0)), Math.sqrt(Math.max(below, 0)));
  const { value } = angleBetween(h, u, v, 1, 0);
  return rootsOf(value + corner, value - corner, above <= 0 || below <= 0);
}

// Return 0 at the workspace boundary, where both angles coincide.
const sine = (angle) =>
  Math.abs(angle) > BOUNDARY && Math.abs(Math.PI - angle) > BOUNDARY ? Math.sin(angle) : 0;
