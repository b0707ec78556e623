// Defines an arm as plain data, and makes arms of the tables that a reader types.

import { movingRows } from "./kinematics.js";

/** @typedef {"revolute" | "prismatic" | "fixed"} Kind */
/**
 * The part of a row that a table gives. Its Denavit-Hartenberg entries are in rad and m.
 * @typedef {object} TableRow
 * @property {Kind} kind
 * @property {number} a
 * @property {number} alpha
 * @property {number} d
 * @property {number} theta
 */
/**
 * The part of a row that no table gives. A limit is null if none is known.
 * @typedef {object} Limits
 * @property {number | null} [lower] rad or m
 * @property {number | null} [upper] rad or m
 * @property {number | null} [speed] rad/s or m/s
 * @property {number | null} [effort] N m or N
 * @property {number[]} [body] mass (kg) and centre of mass (m) in the row's frame
 */
/** @typedef {TableRow & Limits} Row */
/**
 * An object with the rows of a table, such as an arm.
 * @typedef {{ rows: Row[] }} Rows
 */
/**
 * An arm. The page and helpers/checks/arms.py fill in the optional fields, which the judge needs to
 * know usual mistakes: other tables that the student may have used by mistake.
 * @typedef {object} Arm
 * @property {string} name
 * @property {number[]} home the joint values where the homework starts (rad or m)
 * @property {Row[]} rows
 * @property {string} [lengths] the arm's lengths in mm, for messages
 * @property {[string, number][]} [values] numbers of the symbols in its table
 * @property {{ rows: Row[] }} [penless] the arm without its pen
 * @property {{ name: string, other: string, rows: Row[] }[]} [alike] one length taken for another
 * @property {{ name: string, rows: Row[], penless?: Row[], masses?: number[] }[]} [robots] arms of
 *   nearly the same name
 * @property {number[][]} [paper] centres of mass as published, in the frames of the publication
 * @property {number[]} [makerSigns] for each joint -1 if the maker counts it the other way
 * @property {{ report: string, links: number[], bodies: number[][], gravity: number }} [lumped] a
 *   report's model with some links lumped: [mass, x, y, z] of each row
 * @property {Arm[]} [family] other arms of the same name in the catalogue
 * @property {Partial<import("../../page/src/homework_run.js").Run>} [circle] the homework's circle,
 *   where it differs from the default run; only on the explorer's page
 */

export const ROW_KINDS = ["revolute", "prismatic", "fixed"];
export const MAX_ROWS = 16;
export const MAX_LENGTH = 100; // m, of a length in a table
const MAX_ANGLE = 1000; // rad, of an angle in a table; a larger angle is a typing error
export const TYPED_ARM_NAME = "Your arm";

// The entries of a row with their largest sizes.
/** @type {[string, number][]} */
const ENTRIES = [
  ["a", MAX_LENGTH],
  ["alpha", MAX_ANGLE],
  ["d", MAX_LENGTH],
  ["theta", MAX_ANGLE],
];

/**
 * Return the first fault of rows from a link or a file, or null if they make an arm.
 * @param {any} rows
 * @returns {string | null}
 */
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

export const NO_LIMITS = { lower: null, upper: null, speed: null, effort: null };

// Return the entries of a row with the limits of a second row. A typed row has no masses.
const withLimits = (
  { kind, a, alpha, d, theta },
  /** @type {Limits} */ { lower, upper, speed, effort },
) => ({
  kind,
  a,
  alpha,
  d,
  theta,
  lower,
  upper,
  speed,
  effort,
});

/** Return whether two rows have the same kind and entries. @param {Row} p @param {Row} q */
export const isSameRow = (p, q) =>
  p.kind === q.kind && ENTRIES.every(([key]) => Math.abs(p[key] - q[key]) < 1e-12);

// Return whether two rows differ in lengths only, so that the joint keeps its zero and its sign.
// The d of a prismatic joint must not differ, since it shifts the joint's zero.
const differsInLengthsOnly = (row, other) =>
  other && isSameRow({ ...row, a: other.a, d: row.kind === "prismatic" ? row.d : other.d }, other);

// Return how many fixed rows, such as a base, a table has before the rows of `base`. The result is
// -1 if the table differs from `base` in more than lengths and fixed rows at its ends.
function countRowsBefore(rows, base) {
  for (let before = 0; before <= rows.length - base.length; before++) {
    const isKept = (row, i) =>
      differsInLengthsOnly(row, base[i - before]) || (!base[i - before] && row.kind === "fixed");
    if (rows.every(isKept)) return before;
  }
  return -1;
}

/**
 * Return the arm that a typed table describes. This is `base` itself if no entry was changed. The
 * arm keeps the limits of `base` if only lengths were changed and fixed rows added at the ends.
 * @param {Row[]} rows
 * @param {Arm} base the arm whose table the reader began with
 * @returns {Arm}
 */
export function makeTypedArm(rows, base) {
  if (rows.length === base.rows.length && rows.every((row, i) => isSameRow(row, base.rows[i])))
    return base;
  const before = countRowsBefore(rows, base.rows);
  const limitsOf = (i) => (before < 0 ? NO_LIMITS : (base.rows[i - before] ?? NO_LIMITS));
  const typedRows = rows.map((row, i) => withLimits(row, limitsOf(i)));
  const typed = { name: TYPED_ARM_NAME, home: [], rows: typedRows };
  return {
    ...typed,
    home: carryOverJoints(base, base.home, typed, (row) => row - Math.max(0, before)),
  };
}

/**
 * Return the joint vector for an arm whose rows were changed. Joints keep their values by row, and
 * new joints start at 0.
 * @param {Arm} from
 * @param {number[]} q joint values of `from`
 * @param {Arm} to
 * @param {(row: number) => number} rowBefore index in `from` of a row of `to`
 */
export function carryOverJoints(from, q, to, rowBefore) {
  /** @type {Map<number, [Kind, number]>} */
  const valueByRow = new Map(
    movingRows(from).map((row, i) => [row, [from.rows[row].kind, q[i] ?? 0]]),
  );
  return movingRows(to).map((row) => {
    const [kind, value] = valueByRow.get(rowBefore(row)) ?? [];
    return kind === to.rows[row].kind ? value : 0;
  });
}

/** Return the arm's home, or zeros if it has none. @param {Arm} arm */
export const homeConfiguration = (arm) =>
  isJointVector(arm, arm.home) ? [...arm.home] : movingRows(arm).map(() => 0);

/** Return whether q is a joint vector of the arm. @param {Arm} arm @param {any} q */
export const isJointVector = (arm, q) =>
  Array.isArray(q) && q.length === movingRows(arm).length && q.every(Number.isFinite);

/**
 * Return a joint's limits. An unknown limit is half a turn or a metre from zero.
 * @param {Row} row
 */
export function jointRange(row) {
  const fallback = row.kind === "revolute" ? Math.PI : 1;
  return [row.lower ?? -fallback, row.upper ?? fallback];
}

/** Return whether a joint value is past a limit of its row by more than round-off. */
export const isOutsideLimits = (row, value) =>
  value < (row.lower ?? -Infinity) - 1e-9 || value > (row.upper ?? Infinity) + 1e-9;

/** Return whether some joint has a limit. @param {Arm} arm */
export const hasLimits = (arm) =>
  movingRows(arm).some((row) => arm.rows[row].lower !== null || arm.rows[row].upper !== null);

/**
 * Return about how far the stretched arm reaches (m), as a scale for drawings.
 * @param {Rows} arm
 */
export const estimateReach = (arm) =>
  arm.rows.reduce(
    (sum, row) =>
      sum +
      Math.abs(row.a) +
      Math.abs(row.d) +
      (row.kind === "prismatic" ? Math.abs(row.upper ?? 0.3) : 0),
    0,
  ) || 0.3;
