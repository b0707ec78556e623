// Finds the crossings of two joints' curves in the plane of the two invariants, as structure.js
// describes them: A (x, y) + b.

import { solveCosineSine, solveQuadratic } from "./joint_equations.js";
import { subtractEach } from "./linear.js";

/** @param {number[]} n @param {number[]} v */
const dotInPlane = (n, v) => n[0] * v[0] + n[1] * v[1];

// Solve n . A (x, y) = c for the joint value of a curve.
function solveAlong(n, { A, turns }, c, size, chosen) {
  const [a, b] = [0, 1].map((j) => dotInPlane(n, [A[0][j], A[1][j]]));
  return turns ? solveCosineSine(a, b, c, size, chosen) : solveQuadratic(a, b, c, size);
}

// Find the joint values at which a conic crosses the line of a segment.
export const crossLine = ({ across }, segment, conic, size, chosen) =>
  solveAlong(across, conic, dotInPlane(across, subtractEach(segment.b, conic.b)), size, chosen);

// Find the joint values of the segment at the conic's point for the joint value q.
export function findOnSegment({ along }, [segment, conic], q, size, chosen) {
  const [x, y] = conic.turns ? [Math.cos(q), Math.sin(q)] : [q, q * q];
  const point = conic.A.map((row) => row[0] * x + row[1] * y);
  const offset = point.map((u, i) => u + conic.b[i] - segment.b[i]);
  return solveAlong(along, segment, dotInPlane(along, offset), size, chosen);
}

// Find the points where two circles, or two parabolas, cross. The difference of their equations is
// that of a line.
export function crossAlike(curve1, curve3, chosen) {
  const [[a, b], [c, d]] = curve3.A;
  const det = a * d - b * c;
  const solve = (/** @type {number[]} */ [x, y]) => [(d * x - b * y) / det, (a * y - c * x) / det];
  const [X, Y] = [0, 1].map((j) => solve([curve1.A[0][j], curve1.A[1][j]]));
  const e = solve(subtractEach(curve1.b, curve3.b));
  const point = (q) => {
    const [x, y] = curve1.turns ? [Math.cos(q), Math.sin(q)] : [q, q * q];
    return [X[0] * x + Y[0] * y + e[0], X[1] * x + Y[1] * y + e[1]];
  };
  if (!curve1.turns) {
    const roots = solveQuadratic(2 * X[0] * e[0] - X[1], X[0] ** 2 - Y[1], e[1] - e[0] ** 2, 1);
    return { roots, getThird: (q) => point(q)[0] };
  }
  const rightSide = 1 - dotInPlane(e, e) - dotInPlane(X, X);
  const roots = solveCosineSine(2 * dotInPlane(X, e), 2 * dotInPlane(Y, e), rightSide, 1, chosen);
  return { roots, getThird: (q) => Math.atan2(point(q)[1], point(q)[0]) };
}
