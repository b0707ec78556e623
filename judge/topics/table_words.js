// Formats the messages about a wrong entry of a table and about a difference of the axes.

import { makeCause, causeName } from "../causes/ranking.js";
import { DEG } from "../geometry/angles.js";
import { formatMessage, formatNumber } from "../sentences.js";
import { angleDistance } from "../geometry/axes.js";
import { ANGLE_TOLERANCE, isAngleColumn } from "../geometry/rows.js";
import { ENTRIES } from "../reading/table_rows.js";

export const DECIMAL = /\d*\.\d+(?:[eE][+-]?\d+)?/g;

/** @typedef {import("./table.js").Table} Table */
/** @typedef {import("../geometry/axes.js").Difference} Difference */
/** @typedef {import("../verdict.js").Finding} Finding */

/**
 * List the entries that differ from the reference's, as the row's index and the column. The result
 * is null if the tables have different numbers of rows.
 * @param {import("../geometry/arm.js").TableRow[]} rows
 * @param {import("../geometry/arm.js").TableRow[]} wanted
 * @param {number} length tolerance (m)
 * @returns {[number, string][] | null}
 */
export function listOffEntries(rows, wanted, length) {
  if (rows.length !== wanted.length) return null;
  const isOff = (k, column) => {
    const [x, y] = [rows[k][column], wanted[k][column]];
    return isAngleColumn(column) ? angleDistance(x, y) > ANGLE_TOLERANCE : Math.abs(x - y) > length;
  };
  return ENTRIES.flatMap((column) =>
    rows.flatMap((_, k) =>
      isOff(k, column) ? [/** @type {[number, string]} */ ([k, column])] : [],
    ),
  );
}

// Describe a wrong entry by the row and the text of the student's table.
/** @param {Table} table @returns {Finding} */
export function describeEntry(table, t, [k, column], length) {
  const [mine, wanted] = [t.rows[k][column], t.reference[k][column]];
  const row = typedRowNumber(table, k + 1, column);
  const why = makeEntryCause(column, row, mine, wanted, length);
  const typed = t.cause ? formatNumber(mine, 6) : entryText(table, k + 1, column);
  const words = formatMessage("table entry", {
    typed,
    words: formatMessage(why.keys[0], why.fields[0]),
  });
  return { what: causeName(why), where: `row ${row}, ${column}`, words };
}

const NAMES = {
  "table distance": "table distance what",
  "table between": "table between what",
  "table held": "table held what",
  "table side": "table side what",
  "table lean": "table lean what",
  "table foot": "table foot what",
  "table along": "table along what",
  "table kind": "table kind what",
};

// Describe a difference of the axes by the rows of the student's table.
/** @param {Table} table @param {Difference} d @returns {Finding} */
export function describeDifference(table, d) {
  const toBase = d.key === "table lean" || d.key === "table foot";
  const row = toBase ? d.row : typedRowNumber(table, d.row, d.entry);
  const where = `row ${row}, ${d.entry}`;
  if (d.key === "table count") {
    const { mine, reference } = d;
    return { what: "row", where, words: formatMessage("table count words", { mine, reference }) };
  }
  const [i, j] = d.ends.map((end) => end && typedRowNumber(table, end, "d"));
  const toTip = (d.key === "table distance" || d.key === "table side") && !j;
  const end = toTip ? formatMessage("the tip") : formatMessage("axis", { i: j });
  const along = i === j ? formatMessage("axis", { i }) : formatMessage("parallel axes", { i, j });
  const what = formatMessage(NAMES[d.key], { start: i, end, along, j });
  const words = formatMessage("table at", { row, entry: d.entry, words: describeAmount(d, what) });
  return { what: "row", where, words };
}

/** @param {Difference} d @param {string} what */
function describeAmount({ key, mine, reference }, what) {
  if (key === "table kind") return formatMessage("table other", { what, mine, reference });
  if (key === "table side") return formatMessage("table side", { what });
  if (["table between", "table held", "table lean"].includes(key)) {
    const signed = key === "table held" || mine >= 0; // held as theta is, about the student's axis
    const [x, y] = signed ? [mine, reference] : [-mine, -reference];
    const [actual, expected, off] = [x, y, angleDistance(x, y)].map((angle) =>
      formatNumber(roundTo(angle * DEG, 4), 6),
    );
    return formatMessage("table angle", { what, mine: actual, reference: expected, off });
  }
  // Lengths are rounded to a micrometre, since between nearly parallel axes round-off leaves no
  // more digits. They are rounded to a nanometre first, so that half a micrometre always rounds up.
  const [x, y] = [mine, reference].map((length) => roundTo(roundTo(length, 9), 6));
  if (x * y < 0)
    return formatMessage("table other way", {
      what,
      mine: formatNumber(x, 6),
      reference: formatNumber(y, 6),
    });
  const way = Math.abs(x) > Math.abs(y) ? formatMessage("long") : formatMessage("short");
  const off = formatNumber(roundTo(1000 * Math.abs(mine - reference), 6), 4);
  const [ours, theirs] = [x, y].map((length) => formatNumber(Math.abs(length), 6));
  return formatMessage("table length", { what, mine: ours, reference: theirs, off, way });
}

export const roundTo = (x, decimals) => Number(x.toFixed(decimals));

// Return the number of the typed row that has an entry of a row of the table.
export const typedRowNumber = ({ added, modified }, row, column) =>
  row - added + Number(modified && (column === "a" || column === "alpha"));

// Return the text that was typed as an entry of a row, or undefined if no typed row has it.
const typedText = (table, row, column) =>
  table.texts[typedRowNumber(table, row, column) - 1]?.[column];

export const entryText = (table, row, column) =>
  typedText(table, row, column) ?? formatNumber(table.rows[row - 1][column], 6);

// Return the unit of an angle's last decimal, or 0 if it has fewer than two decimals.
export function entryUnit(table, row, column) {
  const last = (typedText(table, row, column) ?? "").match(DECIMAL)?.at(-1) ?? "";
  const decimals = last.slice(last.indexOf(".") + 1).length;
  return decimals >= 2 ? table.angleScale * 10 ** -decimals : 0;
}

/** @returns {import("../causes/ranking.js").Cause} */
function makeEntryCause(column, row, mine, wanted, length) {
  const negative = isAngleColumn(column)
    ? angleDistance(mine, -wanted) < ANGLE_TOLERANCE
    : Math.abs(mine + wanted) <= length;
  const twist = column === "alpha";
  if (negative)
    return twist ? makeCause("table.twist", { row }) : makeCause("table.sign", { column, row });
  if (!mine)
    return twist
      ? makeCause("table.no twist", { row })
      : makeCause("table.missing", { column, row });
  if (!wanted) return makeCause("table.too much", { column, row });
  if (isAngleColumn(column)) {
    const off = formatNumber(roundTo(angleDistance(mine, wanted) * DEG, 6), 4);
    return makeCause("table.angle", { column, row, _off: off });
  }
  const _way = formatMessage(
    mine * wanted < 0 ? "off" : Math.abs(mine) > Math.abs(wanted) ? "long" : "short",
  );
  const _off = formatNumber(roundTo(1000 * Math.abs(mine - wanted), 6), 4);
  return makeCause("table.number", { column, row, _off, _way });
}
