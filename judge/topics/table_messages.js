// Formats the messages about a wrong entry of a table and about a difference of the axes.

import { causeMessage, causeName } from "../causes/ranking.js";
import { makeEntryCause } from "../causes/table.js";
import { DEG } from "../geometry/angles.js";
import { formatMessage, formatNumber } from "../sentences.js";
import { angleDistance } from "../geometry/axes.js";
import { isAngleColumn } from "../geometry/rows.js";

export const DECIMAL = /\d*\.\d+(?:[eE][+-]?\d+)?/g;

/** @typedef {import("./table.js").Table} Table */
/** @typedef {import("../causes/ranking.js").Cause} Cause */
/** @typedef {import("../geometry/arm.js").TableRow} TableRow */
/** @typedef {import("../geometry/axes.js").Difference} Difference */
/** @typedef {import("../verdict.js").Finding} Finding */

/**
 * Describe a wrong entry by the row and the text of the student's table.
 * @param {Table} table
 * @param {{ cause: Cause | null, rows: TableRow[], reference: TableRow[] }} comparison rows with
 *   the correction of `cause`, and the rows with which they are compared
 * @param {[number, string]} entry index of the row, and column
 * @param {number} length tolerance (m)
 * @returns {Finding}
 */
export function describeEntry(table, { cause, rows, reference }, [k, column], length) {
  const [actual, expected] = [rows[k][column], reference[k][column]];
  const row = typedRowNumber(table, k + 1, column);
  const entryCause = makeEntryCause(column, row, actual, expected, length);
  const what = entryCause ? causeName(entryCause) : "entry";
  const message = entryCause
    ? causeMessage(entryCause)
    : describeWrongNumber(column, row, actual, expected);
  const typed = cause ? formatNumber(actual, 6) : entryText(table, k + 1, column);
  const words = formatMessage("table entry", { typed, words: message });
  return { what, where: `row ${row}, ${column}`, words };
}

// The message that names the quantity of each difference of the axes.
const QUANTITY_KEYS = {
  "table slide": "table slide",
  "table distance": "table distance what",
  "table between": "table between what",
  "table lean": "table lean what",
  "table foot": "table foot what",
  "table along": "table along what",
  "table kind": "table kind what",
};

/**
 * Describe a difference of the axes by the rows of the student's table.
 * @param {Table} table @param {Difference} difference @returns {Finding}
 */
export function describeDifference(table, difference) {
  const { key, entry, ends } = difference;
  const isToBase = key === "table lean" || key === "table foot";
  const row = isToBase ? difference.row : typedRowNumber(table, difference.row, entry);
  const where = `row ${row}, ${entry}`;
  if (key === "table count") {
    const { mine, reference } = difference;
    return { what: "row", where, words: formatMessage("table count words", { mine, reference }) };
  }
  const [i, j] = ends.map((end) => end && typedRowNumber(table, end, "d"));
  const end = j ? formatMessage("axis", { i: j }) : formatMessage("the tip");
  const along = i === j ? formatMessage("axis", { i }) : formatMessage("parallel axes", { i, j });
  const quantity = formatMessage(QUANTITY_KEYS[key], { start: i, end, along, j });
  const words = formatMessage("table at", {
    row,
    entry,
    words: describeAmount(difference, quantity),
  });
  return { what: "row", where, words };
}

/** Compare a quantity with the reference's in words. @param {Difference} difference */
function describeAmount({ key, mine, reference }, /** @type {string} */ what) {
  if (key === "table slide") return what;
  if (key === "table kind") return formatMessage("table other", { what, mine, reference });
  if (key === "table between" || key === "table lean")
    return describeAngle(what, mine < 0 ? [-mine, -reference] : [mine, reference]);
  return describeLength(what, mine, reference);
}

/** @param {string} what @param {number[]} angles of the table and of the reference (rad) */
function describeAngle(what, [actual, expected]) {
  const [mine, reference, off] = [actual, expected, angleDistance(actual, expected)].map((angle) =>
    formatNumber(roundTo(angle * DEG, 4), 6),
  );
  return formatMessage("table angle", { what, mine, reference, off });
}

// Describe a length in m. It is rounded to a micrometre, since between nearly parallel axes
// round-off leaves no more digits, and to a nanometre first, so that half a micrometre always
// rounds up.
/** @param {string} what @param {number} actual @param {number} expected */
function describeLength(what, actual, expected) {
  const [x, y] = [actual, expected].map((length) => roundTo(roundTo(length, 9), 6));
  if (x * y < 0) {
    const fields = { what, mine: formatNumber(x, 6), reference: formatNumber(y, 6) };
    return formatMessage("table other way", fields);
  }
  const way = formatMessage(Math.abs(x) > Math.abs(y) ? "long" : "short");
  const off = formatNumber(roundTo(1000 * Math.abs(actual - expected), 6), 4);
  const [mine, reference] = [x, y].map((length) => formatNumber(Math.abs(length), 6));
  return formatMessage("table length", { what, mine, reference, off, way });
}

export const roundTo = (x, decimals) => Number(x.toFixed(decimals));

// Return the number of the typed row that has an entry of a row of the table.
export const typedRowNumber = ({ added, modified }, row, column) =>
  row - added + Number(modified && (column === "a" || column === "alpha"));

// Return the text that was typed as an entry of a row, or undefined if no typed row has it.
const typedText = (table, row, column) =>
  table.texts[typedRowNumber(table, row, column) - 1]?.[column];

/** The names of multiples of a right angle. @type {Record<number, string>} */
export const RIGHT_ANGLES = { "-2": "-pi", "-1": "-pi/2", 0: "0", 1: "pi/2", 2: "pi" };

/** Return the text of an entry, or its number if the text is LaTeX or missing. */
export function entryText(table, row, column) {
  const text = typedText(table, row, column);
  if (text !== undefined && !text.includes("\\")) return text;
  const value = table.rows[row - 1][column];
  const turns = value / (Math.PI / 2);
  const isRight = isAngleColumn(column) && Math.abs(turns - Math.round(turns)) < 1e-9;
  return (isRight && RIGHT_ANGLES[Math.round(turns)]) || formatNumber(value, 6);
}

// Return the unit of an angle's last decimal, or 0 if it has fewer than two decimals.
export function entryUnit(table, row, column) {
  const last = (typedText(table, row, column) ?? "").match(DECIMAL)?.at(-1) ?? "";
  const decimals = last.slice(last.indexOf(".") + 1).length;
  return decimals >= 2 ? table.angleScale * 10 ** -decimals : 0;
}

// Describe how far a wrong entry is off.
function describeWrongNumber(column, row, actual, expected) {
  if (!expected) return formatMessage("table too much", { column, row });
  if (isAngleColumn(column)) {
    const off = formatNumber(roundTo(angleDistance(actual, expected) * DEG, 6), 4);
    return formatMessage("table entry angle", { column, row, off });
  }
  const way = formatMessage(
    actual * expected < 0 ? "off" : Math.abs(actual) > Math.abs(expected) ? "long" : "short",
  );
  const off = formatNumber(roundTo(1000 * Math.abs(actual - expected), 6), 4);
  return formatMessage("table number", { column, row, off, way });
}
