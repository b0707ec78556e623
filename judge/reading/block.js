// Defines a block. A block is a rectangle of entries with the words beside it.

import { readRowLabels } from "./labels.js";

/** @typedef {import("./lines.js").Cell} Cell */
/** @typedef {import("./lines.js").Row} Row */
/**
 * A rectangle of entries. `labels` are the words before each row, and `headers` the words above the
 * first row. `name` is the name before "=" or ":". `firstLine` and `lastLine` count from 0.
 * `sources` are the rows of the text in the block, and `lines` are all rows and words of the text.
 * @typedef {object} Block
 * @property {Cell[][]} rows
 * @property {Cell[][]} labels
 * @property {Cell[]} headers
 * @property {string} name
 * @property {number} firstLine
 * @property {number} lastLine
 * @property {Row[]} sources
 * @property {Lines} [lines]
 * @property {boolean} [splitsCommas] whether its entries were split at commas that may be decimal
 *   commas
 * @property {boolean} [isTransposed] whether its rows and columns were exchanged
 */
/**
 * All rows and words of a text. The rows in `given` repeat numbers of the question.
 * @typedef {{ all: Row[], given: Set<Row>, words: Cell[] }} Lines
 */

/**
 * Write the factor of MATLAB's heading, as "1.0e+03 *", behind each entry of a row.
 * @param {Row} row @returns {Cell[]}
 */
export const applyFactor = ({ cells, scale }) =>
  scale ? cells.map((cell) => ({ ...cell, text: `${cell.text}${scale}` })) : cells;

/**
 * Make a block of rows.
 * @param {Row[]} rows @returns {Block}
 */
export function makeBlock(rows) {
  return {
    rows: rows.map(applyFactor),
    ...readRowLabels(rows),
    name: rows[0].name || rows[0].words.at(-1)?.text || "",
    firstLine: rows[0].line,
    lastLine: rows.at(-1).last,
    sources: rows,
  };
}
