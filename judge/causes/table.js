// Finds the mistakes in a table that does not describe the reference. It compares each correction
// of the rows with each arm that the student may have described, and keeps the corrections that
// leave the fewest mistakes.

import {
  angleDistance,
  compareAxes,
  describeAxes,
  listDifferentEntries,
} from "../geometry/axes.js";
import { ANGLE_TOLERANCE, isAngleColumn, snapRows, jointColumn } from "../geometry/rows.js";
import { combinations } from "../geometry/axis_gaps.js";
import { convertFromCraig } from "../reading/table_conversion.js";
import { listExchangedLengths, listOtherLengths, lowerLinkColumns } from "./chain.js";
import { combineCauses, makeCause } from "./ranking.js";

/** @typedef {import("../geometry/arm.js").TableRow} TableRow */
/** @typedef {import("./ranking.js").Cause} Cause */

/** @typedef {import("../geometry/axes.js").Difference} Difference */

/**
 * A supposed mistake. It has a cause, the corrected rows, the arm with which they are compared, and
 * the remaining differences of entries, as row and column, or of axes.
 * @typedef {{ cause: Cause | null, rows: TableRow[], reference: TableRow[],
 *   differences: ([number, string] | Difference)[] }} Hypothesis
 */
/**
 * A cause and the function that corrects the rows. The third entry says that a correction counts
 * only if no difference remains.
 * @typedef {[Cause | null, (rows: TableRow[]) => TableRow[], boolean?]} Correction
 */

const MAX_ENTRIES = 3; // a table with more wrong entries is compared by its axes

/**
 * Find the hypotheses with the fewest mistakes. A remaining difference counts as a mistake. Of
 * several hypotheses that leave differences only the first is returned, preferably with entries.
 * @param {TableRow[]} rows as typed
 * @param {import("../geometry/arm.js").Arm} reference
 * @param {TableRow[]} expected rows of the reference, with snapped angles
 * @param {boolean} modified whether the rows were read in Craig's convention
 * @param {number} tolerance of a length (m)
 * @returns {Hypothesis[]}
 */
export function findFewestMistakes(rows, reference, expected, modified, tolerance) {
  const hypotheses = listHypotheses(rows, reference, expected, modified, tolerance);
  const fewest = Math.min(...hypotheses.map(countMistakes));
  const best = hypotheses.filter((hypothesis) => countMistakes(hypothesis) === fewest);
  const complete = best.filter(({ differences }) => !differences.length);
  if (complete.length) return complete;
  return [best.find(({ differences }) => Array.isArray(differences[0])) ?? best[0]];
}

/** @param {Hypothesis} hypothesis */
const countMistakes = ({ cause, differences }) => (cause?.keys.length ?? 0) + differences.length;

// Compare the corrected rows with each arm that has other lengths, and the typed rows with each arm
// that has two lengths exchanged.
/** @returns {Hypothesis[]} */
function listHypotheses(rows, reference, expected, modified, tolerance) {
  const changeReference = (mistakes) =>
    Array.from(mistakes, ({ cause, change }) => [
      cause,
      snapRows(change({ rows: reference.rows }).rows),
    ]);
  const others = [[null, expected], ...changeReference(listOtherLengths(reference))];
  const exchanged = changeReference(listExchangedLengths(reference));
  const corrections = listCorrections(rows, modified);
  /** @type {Correction} */
  const exactly = [null, (same) => same, true];
  return [
    ...others.flatMap((other) => corrections.map((correction) => [...other, ...correction])),
    ...exchanged.map((other) => [...other, ...exactly]),
  ].flatMap(([otherArm, arm, mistake, correct, isWhole]) => {
    const cause = otherArm && mistake ? combineCauses(otherArm, mistake) : (otherArm ?? mistake);
    const corrected = snapRows(correct(rows));
    const entries = listWrongEntries(corrected, arm, tolerance);
    const differences = isWhole
      ? entries
      : chooseDifferences(entries, listWrongAxes(corrected, arm, tolerance), cause);
    if (!differences || cause?.keys.length > 2 || (isWhole && differences.length)) return [];
    return [{ cause, rows: corrected, reference: arm, differences }];
  });
}

// Return the wrong entries if they are few and no more than the wrong axes; else the wrong axes.
// Null if a cause leaves many of both.
function chooseDifferences(entries, axes, cause) {
  const isFew = entries && entries.length <= MAX_ENTRIES;
  if (isFew && axes.length && entries.length <= axes.length) return entries;
  if (!cause || axes.length < 2) return axes;
  return isFew ? entries : null;
}

// List the axes that differ. The frames of the rows do not matter.
const listWrongAxes = (rows, expected, tolerance) =>
  compareAxes(describeAxes(rows), describeAxes(expected), tolerance, ANGLE_TOLERANCE).differences;

/** @returns {[number, string][] | null} null if the rows do not correspond */
function listWrongEntries(rows, expected, tolerance) {
  if (rows.some(({ kind }, k) => kind !== expected[k]?.kind)) return null;
  const entries = listDifferentEntries(rows, expected, tolerance);
  return entries && entries.filter(([k, column]) => column !== jointColumn(rows[k].kind));
}

/**
 * List corrections of usual mistakes in the arrangement of a table, all handed in.
 * @param {TableRow[]} typedRows
 * @param {boolean} modified
 * @returns {Correction[]}
 */
function listCorrections(typedRows, modified) {
  const indices = [...typedRows.keys()];
  const pairs = combinations(indices, 2);
  return [
    [null, (rows) => rows],
    [makeCause("table.alpha and theta"), exchangeColumns("alpha", "theta")],
    [makeCause("table.a and d"), exchangeColumns("a", "d")],
    ...(modified ? [] : [/** @type {Correction} */ ([makeCause("table.craig"), convertFromCraig])]),
    [makeCause("table.into craig"), lowerLinkColumns],
    ...indices.map(exchangeLengthsInRow),
    ...pairs.map(([i, j]) => exchangeRows(i, j)),
  ];
}

const exchangeInRow = (row, first, second) => ({
  ...row,
  [first]: row[second],
  [second]: row[first],
});
const exchangeColumns = (first, second) => (rows) =>
  rows.map((row) => exchangeInRow(row, first, second));

// Exchange a and d of row k.
/** @returns {Correction} */
const exchangeLengthsInRow = (k) => [
  makeCause("table.a and d in row", { row: k + 1 }),
  (rows) =>
    rows.map((row, i) =>
      i === k && row.kind !== "prismatic" ? exchangeInRow(row, "a", "d") : row,
    ),
  true,
];

/** @returns {Correction} */
const exchangeRows = (i, j) => [
  makeCause("table.rows exchanged", { i: i + 1, j: j + 1 }),
  (rows) => rows.map((row, k) => (k === i ? rows[j] : k === j ? rows[i] : row)),
  true,
];

/**
 * Make the cause for an entry with the wrong sign or without a number.
 * @param {string} column @param {number} row @param {number} actual @param {number} expected
 * @param {number} length tolerance (m)
 * @returns {Cause | null} null for any other entry
 */
export function makeEntryCause(column, row, actual, expected, length) {
  const isNegated = isAngleColumn(column)
    ? angleDistance(actual, -expected) < ANGLE_TOLERANCE
    : Math.abs(actual + expected) <= length;
  if (!isNegated && actual) return null;
  if (column === "alpha") return makeCause(isNegated ? "table.twist" : "table.no twist", { row });
  return makeCause(isNegated ? "table.sign" : "table.missing", { column, row });
}
