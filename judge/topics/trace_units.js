// Finds the units of a trajectory's last digits, from which a program may have trimmed zeros.

import { followsPathByEuler, makeTrace, METHOD_ERROR } from "../causes/trace.js";
import { findColumnUnits } from "../digits.js";
import { dot, jacobianColumns, linkFrames, minus, norm } from "../geometry/kinematics.js";

/** @typedef {import("../geometry/arm.js").Arm} Arm */
/** @typedef {import("../geometry/path.js").Path} Path */

const FEWEST_TRIMMED = 2; // entries of a row; a single short entry may be rounded by hand

/**
 * Return the units of a trajectory's last digits. A program that trims zeros prints 1.1 for 1.1000.
 * If a row with such entries is right to the digits of its columns, the zeros were trimmed. All
 * short entries are then exact, except for a single entry in a row whose rounding explains its
 * error.
 * @param {{ q: number[][], units: number[][] }} trajectory @param {Arm} arm @param {Path} path
 */
export function findUntrimmedUnits({ q, units }, arm, path) {
  const fineUnits = findColumnUnits(q, units);
  const isTrimmed = units.map((row, k) => row.map((unit, i) => unit > 1.5 * fineUnits[k][i]));
  const errors = q.map((row, k) =>
    minus(path.position(path.times[k]), linkFrames(arm, row).at(-1).o),
  );
  const isRight = (k, error = norm(errors[k])) =>
    error <= METHOD_ERROR + boundTipError(q[k], fineUnits[k], arm);
  const count = (k) => isTrimmed[k].filter(Boolean).length;
  if (!q.some((_, k) => count(k) >= FEWEST_TRIMMED && isRight(k))) return units;
  const isExplained = (k) => {
    const i = isTrimmed[k].indexOf(true);
    const column = computePositionColumns(q[k], arm)[i];
    const change = dot(column, errors[k]) / dot(column, column);
    const rest = norm(errors[k].map((x, j) => x - change * column[j]));
    return Math.abs(change) <= 0.51 * units[k][i] && isRight(k, rest);
  };
  return units.map((row, k) =>
    !isRight(k) && count(k) === 1 && isExplained(k) ? row : fineUnits[k],
  );
}

/**
 * Return whether a trajectory begins right and follows Euler's method. Each column counts with its
 * finest digits, since a start that was typed with few digits would let any motion pass.
 * @param {{ q: number[][], units: number[][] }} trajectory @param {Arm} arm @param {Path} path
 * @param {number} startError distance of the first point from the path (m)
 */
export function isDriftOfEuler({ q, units }, arm, path, startError) {
  const fineUnits = findColumnUnits(q, units);
  if (startError > METHOD_ERROR + boundTipError(q[0], fineUnits[0], arm)) return false;
  return followsPathByEuler(makeTrace(q, fineUnits, arm, path));
}

// Return the linear half of each column of the Jacobian at a row of joint values.
const computePositionColumns = (row, arm) =>
  jacobianColumns(arm, linkFrames(arm, row)).map((column) => column.slice(0, 3));

/** Bound the error of the tip's position (m) that the typed digits of a row of joints allow. */
export function boundTipError(row, units, arm) {
  const columns = computePositionColumns(row, arm);
  const bound = (i) =>
    units.reduce((sum, unit, k) => sum + Math.abs(columns[k][i]) * 0.51 * unit, 0);
  return norm([0, 1, 2].map(bound));
}
