// What is said of one wrong entry of a table, and of one difference of the axes.

import { cause, nameOf } from "../causes/ranking.js";
import { DEG } from "../geometry/angles.js";
import { say, size } from "../sentences.js";
import { angleBetween } from "../geometry/axes.js";
import { ANGLE, angular } from "../geometry/rows.js";

export const DECIMAL = /\d*\.\d+(?:[eE][+-]?\d+)?/g;

/** @typedef {import("./table.js").Table} Table */
/** @typedef {import("../geometry/axes.js").Difference} Difference */
/** @typedef {import("../report.js").Finding} Finding */

// One wrong entry in the student's numbers, in a row of theirs.
/** @param {Table} table @returns {Finding} */
export function entry(table, t, [k, column], length) {
  const [mine, wanted] = [t.rows[k][column], t.reference[k][column]];
  const row = typedRow(table, k + 1, column);
  const why = kindOfError(column, row, mine, wanted, length);
  const typed = t.cause ? size(mine, 6) : typedAs(table, k + 1, column);
  const words = say("table entry", { typed, words: say(why.keys[0], why.fields[0]) });
  return { what: nameOf(why), where: `row ${row}, ${column}`, words };
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
export function geometry(table, d) {
  const toBase = d.key === "table lean" || d.key === "table foot";
  const row = toBase ? d.row : typedRow(table, d.row, d.entry);
  const where = `row ${row}, ${d.entry}`;
  if (d.key === "table count") {
    const { mine, reference } = d;
    return { what: "row", where, words: say("table count words", { mine, reference }) };
  }
  const [i, j] = d.ends.map((end) => end && typedRow(table, end, "d"));
  const toTip = (d.key === "table distance" || d.key === "table side") && !j;
  const end = toTip ? say("the tip") : say("axis", { i: j });
  const along = i === j ? say("axis", { i }) : say("parallel axes", { i, j });
  const what = say(WHAT[d.key], { start: i, end, along, j });
  const words = say("table at", { row, entry: d.entry, words: amount(d, what) });
  return { what: "row", where, words };
}

/** @param {Difference} d @param {string} what */
function amount({ key, mine, reference }, what) {
  if (key === "table kind") return say("table other", { what, mine, reference });
  if (key === "table side") return say("table side", { what });
  if (["table between", "table held", "table lean"].includes(key)) {
    const signed = key === "table held" || mine >= 0; // held as theta is, about the student's axis
    const [x, y] = signed ? [mine, reference] : [-mine, -reference];
    const spelt = [x, y, angleBetween(x, y)].map((angle) => size(rounded(angle * DEG, 4), 6));
    return say("table angle", { what, mine: spelt[0], reference: spelt[1], off: spelt[2] });
  }
  // To a micrometre: where axes are nearly parallel, rounding leaves no more of a distance. First
  // to a nanometre, so that half a micrometre is one for the checkers too.
  const [x, y] = [mine, reference].map((length) => rounded(rounded(length, 9), 6));
  if (x * y < 0) return say("table other way", { what, mine: size(x, 6), reference: size(y, 6) });
  const way = Math.abs(x) > Math.abs(y) ? say("long") : say("short");
  const off = size(rounded(1000 * Math.abs(mine - reference), 6), 4);
  const [ours, theirs] = [x, y].map((length) => size(Math.abs(length), 6));
  return say("table length", { what, mine: ours, reference: theirs, off, way });
}

export const rounded = (x, decimals) => Number(x.toFixed(decimals));

// The typed row, from 1, that holds an entry of a row of the table.
export const typedRow = ({ added, modified }, row, column) =>
  row - added + Number(modified && (column === "a" || column === "alpha"));

// What was typed as an entry of a row; undefined where no row holds it.
const typedText = (table, row, column) => table.texts[typedRow(table, row, column) - 1]?.[column];

export const typedAs = (table, row, column) =>
  typedText(table, row, column) ?? size(table.rows[row - 1][column], 6);

// The unit of the last decimal in one angle, where it has two or more.
export function ownUnit(table, row, column) {
  const last = (typedText(table, row, column) ?? "").match(DECIMAL)?.at(-1) ?? "";
  const places = last.slice(last.indexOf(".") + 1).length;
  return places >= 2 ? table.angleScale * 10 ** -places : 0;
}

/** @returns {import("../causes/ranking.js").Cause} */
function kindOfError(column, row, mine, wanted, length) {
  const negative = angular(column)
    ? angleBetween(mine, -wanted) < ANGLE
    : Math.abs(mine + wanted) <= length;
  const twist = column === "alpha";
  if (negative) return twist ? cause("table.twist", { row }) : cause("table.sign", { column, row });
  if (!mine)
    return twist ? cause("table.no twist", { row }) : cause("table.missing", { column, row });
  if (!wanted) return cause("table.too much", { column, row });
  if (angular(column)) {
    const off = size(rounded(angleBetween(mine, wanted) * DEG, 6), 4);
    return cause("table.angle", { column, row, _off: off });
  }
  const _way = say(
    mine * wanted < 0 ? "off" : Math.abs(mine) > Math.abs(wanted) ? "long" : "short",
  );
  const _off = size(rounded(1000 * Math.abs(mine - wanted), 6), 4);
  return cause("table.number", { column, row, _off, _way });
}
