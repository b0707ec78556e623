// The messages about one wrong entry of a table, and about one difference of the axes.

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
 * List the entries, as index of the row and column, that differ from the reference's; null where
 * the rows do not correspond.
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

// One wrong entry in the student's numbers, in a row of theirs.
/** @param {Table} table @returns {Finding} */
export function describeEntry(table, t, [k, column], length) {
  const [mine, wanted] = [t.rows[k][column], t.reference[k][column]];
  const row = typedRowNumber(table, k + 1, column);
  const why = kindOfError(column, row, mine, wanted, length);
  const typed = t.cause ? formatNumber(mine, 6) : entryText(table, k + 1, column);
  const words = formatMessage("table entry", {
    typed,
    words: formatMessage(why.keys[0], why.fields[0]),
  });
  return { what: causeName(why), where: `row ${row}, ${column}`, words };
}

const WHAT = {
  "table distance": "table distance what",
  "table between": "table between what",
  "table held": "table held what",
  "table side": "table side what",
  "table lean": "table lean what",
  "table foot": "table foot what",
  "table along": "table along what",
  "table kind": "table kind what",
};

// One difference, in the rows and axes of the table as typed.
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
  const what = formatMessage(WHAT[d.key], { start: i, end, along, j });
  const words = formatMessage("table at", { row, entry: d.entry, words: amount(d, what) });
  return { what: "row", where, words };
}

/** @param {Difference} d @param {string} what */
function amount({ key, mine, reference }, what) {
  if (key === "table kind") return formatMessage("table other", { what, mine, reference });
  if (key === "table side") return formatMessage("table side", { what });
  if (["table between", "table held", "table lean"].includes(key)) {
    const signed = key === "table held" || mine >= 0; // held as theta is, about the student's axis
    const [x, y] = signed ? [mine, reference] : [-mine, -reference];
    const spelt = [x, y, angleDistance(x, y)].map((angle) =>
      formatNumber(roundTo(angle * DEG, 4), 6),
    );
    return formatMessage("table angle", {
      what,
      mine: spelt[0],
      reference: spelt[1],
      off: spelt[2],
    });
  }
  // To a micrometre: where axes are nearly parallel, rounding leaves no more of a distance. First
  // to a nanometre, so that half a micrometre is one for the checkers too.
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

// The typed row, from 1, that holds an entry of a row of the table.
export const typedRowNumber = ({ added, modified }, row, column) =>
  row - added + Number(modified && (column === "a" || column === "alpha"));

// Return the text that was typed as an entry of a row; undefined where no row holds it.
const typedText = (table, row, column) =>
  table.texts[typedRowNumber(table, row, column) - 1]?.[column];

export const entryText = (table, row, column) =>
  typedText(table, row, column) ?? formatNumber(table.rows[row - 1][column], 6);

// The unit of the last decimal in one angle, where it has two or more.
export function entryUnit(table, row, column) {
  const last = (typedText(table, row, column) ?? "").match(DECIMAL)?.at(-1) ?? "";
  const places = last.slice(last.indexOf(".") + 1).length;
  return places >= 2 ? table.angleScale * 10 ** -places : 0;
}

/** @returns {import("../causes/ranking.js").Cause} */
function kindOfError(column, row, mine, wanted, length) {
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
