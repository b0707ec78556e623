// An arm as plain data: what makes one, where it may stand, and what a typed one is called.

import { movingRows } from "./kinematics.js";

/**
 * A row of a standard Denavit-Hartenberg table, in rad and m; null where a limit is not known.
 * @typedef {object} Row
 * @property {"revolute" | "prismatic" | "fixed"} kind
 * @property {number} a
 * @property {number} alpha
 * @property {number} d
 * @property {number} theta
 * @property {number | null} [lower]
 * @property {number | null} [upper]
 * @property {number | null} [speed]
 * @property {number | null} [effort]
 * @property {number[]} [body] mass and centre of mass in the row's frame
 */
/** @typedef {{ name: string, home: number[], rows: Row[] }} Arm */

export const ROW_KINDS = ["revolute", "prismatic", "fixed"];
export const MAX_ROWS = 16;
export const MAX_LENGTH = 100; // m, of a length in a table
export const MAX_ANGLE = 1000; // rad, of an angle in a table: a larger one is a typing error
export const TYPED_ARM_NAME = "Your arm";

/** @type {[string, number][]} */
const ENTRIES = [
  ["a", MAX_LENGTH],
  ["alpha", MAX_ANGLE],
  ["d", MAX_LENGTH],
  ["theta", MAX_ANGLE],
];

// What is wrong with rows that came from elsewhere, in words, or null where nothing is.
export function findRowsFault(rows) {
  if (!Array.isArray(rows) || !rows.length) return "the table has no rows";
  if (rows.length > MAX_ROWS) return `the table has ${rows.length} rows; ${MAX_ROWS} are the most`;
  for (const [i, row] of rows.entries()) {
    if (!ROW_KINDS.includes(row?.kind)) return `row ${i + 1} neither turns, slides nor is fixed`;
    for (const [key, most] of ENTRIES) {
      if (!Number.isFinite(row[key])) return `row ${i + 1} has no number for ${key}`;
      if (Math.abs(row[key]) > most)
        return `row ${i + 1} has ${row[key]} for ${key}; ${most} is the most`;
    }
  }
  return null;
}

// A row with nothing but what a table says: a typed arm has no limits and no masses.
const bare = ({ kind, a, alpha, d, theta }) => ({
  kind,
  a,
  alpha,
  d,
  theta,
  lower: null,
  upper: null,
  speed: null,
  effort: null,
});

export const isSameRow = (p, q) =>
  p.kind === q.kind && ENTRIES.every(([key]) => Math.abs(p[key] - q[key]) < 1e-12);

// The arm that a typed table describes: the arm it began as while every entry is that arm's, else
// one of its own.
export function makeTypedArm(rows, base) {
  if (rows.length === base.rows.length && rows.every((row, i) => isSameRow(row, base.rows[i])))
    return base;
  const typed = { name: TYPED_ARM_NAME, home: [], rows: rows.map(bare) };
  return { ...typed, home: carryOverJoints(base, base.home, typed, (row) => row) };
}

// The joint vector for an arm whose rows were changed: joints keep their values by row, new ones
// start at 0.
export function carryOverJoints(from, q, to, rowBefore) {
  const byRow = new Map(movingRows(from).map((row, i) => [row, [from.rows[row].kind, q[i] ?? 0]]));
  return movingRows(to).map((row) => {
    const [kind, value] = byRow.get(rowBefore(row)) ?? [];
    return kind === to.rows[row].kind ? value : 0;
  });
}

export const homePose = (arm) =>
  isJointVector(arm, arm.home) ? [...arm.home] : movingRows(arm).map(() => 0);

// Whether q is a joint vector of the arm.
export const isJointVector = (arm, q) =>
  Array.isArray(q) && q.length === movingRows(arm).length && q.every(Number.isFinite);

// Where a joint may be put: its limits, or half a turn or a metre either way where none are known.
export function jointRange(row) {
  const reach = row.kind === "revolute" ? Math.PI : 1;
  return [row.lower ?? -reach, row.upper ?? reach];
}

// Whether a joint is past one of its limits.
export const isOutsideLimits = (row, value) =>
  value < (row.lower ?? -Infinity) - 1e-9 || value > (row.upper ?? Infinity) + 1e-9;

export const hasLimits = (arm) =>
  movingRows(arm).some((row) => arm.rows[row].lower !== null || arm.rows[row].upper !== null);

// How far the stretched-out arm reaches, as a scale for what is drawn.
export const estimateReach = (arm) =>
  arm.rows.reduce(
    (sum, row) =>
      sum +
      Math.abs(row.a) +
      Math.abs(row.d) +
      (row.kind === "prismatic" ? Math.abs(row.upper ?? 0.3) : 0),
    0,
  ) || 0.3;
