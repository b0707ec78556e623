// Units of the last digits of a trajectory, whose printer may have trimmed zeros.

import { followsPathByEuler, makeTrace, METHOD_ERROR } from "../causes/trace.js";
import { columnUnits } from "../digits.js";
import { chainFrames, flatJacobian, makeChain } from "../geometry/chains.js";
import { dot, linkFrames, minus, norm } from "../geometry/kinematics.js";

/** @typedef {import("../geometry/arm.js").Arm} Arm */
/** @typedef {import("../geometry/path.js").Path} Path */

const FEWEST_TRIMMED = 2; // entries of a row: a lone round one may be rounded by hand

/**
 * Return the units of a trajectory's last digits. A program that trims zeros prints 1.1 for 1.1000.
 * A row with such entries that is right to its column's digits shows that it does; then they are
 * exact, but for a lone entry whose rounding explains its row.
 * @param {{ q: number[][], units: number[][] }} run @param {Arm} arm @param {Path} path
 */
export function unitsWithoutTrimming({ q, units }, arm, path) {
  const fine = columnUnits(q, units);
  const isTrimmed = units.map((row, k) => row.map((unit, i) => unit > 1.5 * fine[k][i]));
  const errors = q.map((row, k) =>
    minus(path.position(path.times[k]), linkFrames(arm, row).at(-1).o),
  );
  const isRight = (k, error = norm(errors[k])) =>
    error <= METHOD_ERROR + blurOf(q[k], fine[k], arm);
  const count = (k) => isTrimmed[k].filter(Boolean).length;
  if (!q.some((_, k) => count(k) >= FEWEST_TRIMMED && isRight(k))) return units;
  const isExplained = (k) => {
    const i = isTrimmed[k].indexOf(true);
    const column = positionColumn(q[k], i, arm);
    const change = dot(column, errors[k]) / dot(column, column);
    const rest = norm(errors[k].map((x, j) => x - change * column[j]));
    return Math.abs(change) <= 0.51 * units[k][i] && isRight(k, rest);
  };
  return units.map((row, k) => (!isRight(k) && count(k) === 1 && isExplained(k) ? row : fine[k]));
}

/**
 * Return whether a trajectory begins right and follows Euler's method, to the finest digits of each
 * column: a start that was typed in a few digits would let any motion pass.
 * @param {{ q: number[][], units: number[][] }} run @param {Arm} arm @param {Path} path
 * @param {number} startError distance of the first point from the path (m)
 */
export function isDriftOfEuler({ q, units }, arm, path, startError) {
  const fine = columnUnits(q, units);
  if (startError > METHOD_ERROR + blurOf(q[0], fine[0], arm)) return false;
  return followsPathByEuler(makeTrace(q, fine, arm, path));
}

// Return how the tip moves (m) when joint i does, by 1 rad or 1 m.
function positionColumn(row, i, arm) {
  return positionRows(row, arm).map((entries) => entries[i]);
}

// Return the three position rows of the Jacobian at a row of joint values.
function positionRows(row, arm) {
  const at = makeChain(arm, row);
  const J = flatJacobian(at, chainFrames(at));
  return [0, 1, 2].map((k) => J.slice(k * row.length, (k + 1) * row.length));
}

// Bound the error (m) of the tip's position from the typed digits of a row of joints.
export function blurOf(row, units, arm) {
  const bound = (entries) =>
    units.reduce((sum, unit, k) => sum + Math.abs(entries[k]) * 0.51 * unit, 0);
  return norm(positionRows(row, arm).map(bound));
}
