// Moves points and directions by joints, and solves the three equations that inverse kinematics by
// structure needs. helpers/inverse/equations.py does the same.

import { cross, dot, minus, norm, plus, scaled } from "./kinematics.js";

/** @typedef {import("./structure.js").Axis} Axis */
/** @typedef {import("./kinematics.js").Vector} Vector */
/**
 * The roots of one equation: two values, or one if they are equal; any value solves a free joint.
 * @typedef {{ values: number[], equal: boolean, free: boolean }} Roots
 */

// Relative to the arm's size, or in rad: a target this close to the boundary of what a joint
// reaches counts as on it. 1000 x round-off of a pose.
const RELATIVE_BOUNDARY = 1e-12;
// Relative to the arm's size: a point this close to an axis counts as on it. Turning about the axis
// moves it by less than the round-off of a pose.
const ON_AXIS = 1e-11;

/** Rotate a vector about a unit direction through the origin, by an angle in rad. */
export function rotate(direction, angle, v) {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const turned = plus(scaled(c, v), scaled(s, cross(direction, v)));
  return plus(turned, scaled((1 - c) * dot(direction, v), direction));
}

/**
 * Move a point by a joint's motion q.
 * @param {Axis} axis
 * @param {number} q
 * @param {Vector} point
 */
export const movePoint = (axis, q, point) =>
  axis.turns
    ? plus(axis.point, rotate(axis.direction, q, minus(point, axis.point)))
    : plus(point, scaled(q, axis.direction));

/**
 * Turn a direction by a joint's motion q.
 * @param {Axis} axis
 * @param {number} q
 * @param {Vector} v
 */
export const moveDirection = (axis, q, v) => (axis.turns ? rotate(axis.direction, q, v) : v);

/** Return the part of a vector at a right angle to a unit direction. */
export const partAcross = (direction, v) => minus(v, scaled(dot(direction, v), direction));

/**
 * Solve a cos q + b sin q = c.
 * @param {number} a @param {number} b @param {number} c
 * @param {number} size of the coefficients, to measure round-off by
 * @param {number} chosen root if every q is one
 * @returns {Roots}
 */
export function solveCosineSine(a, b, c, size, chosen) {
  const amplitude = Math.hypot(a, b);
  let gap = amplitude - Math.abs(c);
  if (Math.abs(gap) < RELATIVE_BOUNDARY * size) gap = 0;
  if (amplitude < ON_AXIS * size) return { values: [chosen], equal: true, free: true };
  const half = Math.atan2(Math.sqrt(Math.max(gap, 0)), Math.sqrt(amplitude + Math.abs(c)));
  const middle = Math.atan2(b, a);
  const deviation = 2 * (c < 0 ? Math.PI / 2 - half : half);
  return makeRoots(middle + deviation, middle - deviation, gap <= 0);
}

/** Solve a q + b q^2 = c. @returns {Roots} */
export function solveQuadratic(a, b, c, size) {
  if (Math.abs(b) < RELATIVE_BOUNDARY / size)
    return { values: [Math.abs(a) < ON_AXIS ? NaN : c / a], equal: true, free: false };
  let discriminant = a * a + 4 * b * c;
  if (Math.abs(discriminant) < 4 * Math.abs(b) * RELATIVE_BOUNDARY * size) discriminant = 0;
  const root = Math.sqrt(Math.max(discriminant, 0));
  return makeRoots((-a + root) / (2 * b), (-a - root) / (2 * b), discriminant <= 0);
}

/** @returns {Roots} */
const makeRoots = (first, second, equal) => ({
  values: equal ? [first] : [first, second],
  equal,
  free: false,
});

/**
 * Return the angle about a direction from u to v (rad). It is free if u or v is along the
 * direction.
 * @param {Vector} direction unit vector
 * @param {Vector} u @param {Vector} v
 * @param {number} size of u and v, to measure round-off by
 * @param {number} chosen angle if it is free (rad)
 */
export function angleBetween(direction, u, v, size, chosen) {
  const [x, y] = [partAcross(direction, u), partAcross(direction, v)];
  if (Math.min(norm(x), norm(y)) < ON_AXIS * size) return { value: chosen, free: true };
  return { value: Math.atan2(dot(direction, cross(x, y)), dot(x, y)), free: false };
}

/**
 * Find the two turns about a direction after which u is as far from v as `target` is. The
 * directions are corners of a spherical triangle, and the half-angle formula gives the angle at
 * `direction`.
 * @returns {Roots}
 */
export function turnsToAngle(direction, u, v, target) {
  const between = (p, q) => Math.atan2(norm(cross(p, q)), dot(p, q));
  const [sideV, sideU] = [between(direction, v), between(direction, u)];
  const opposite = between(v, target);
  const half = (sideV + sideU + opposite) / 2;
  const above = sineInsideReach(half - sideV) * sineInsideReach(half - sideU);
  const below = sineInsideReach(half) * sineInsideReach(half - opposite);
  const corner = 2 * Math.atan2(Math.sqrt(Math.max(above, 0)), Math.sqrt(Math.max(below, 0)));
  const { value } = angleBetween(direction, u, v, 1, 0);
  return makeRoots(value + corner, value - corner, above <= 0 || below <= 0);
}

// Return the sine of an angle, 0 at the workspace boundary, where both turns coincide.
const sineInsideReach = (angle) =>
  Math.abs(angle) > RELATIVE_BOUNDARY && Math.abs(Math.PI - angle) > RELATIVE_BOUNDARY
    ? Math.sin(angle)
    : 0;
