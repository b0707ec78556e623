// Defines a block, which is rows of one length and the words beside them.

import { readRowLabels } from "./labels.js";

/** @typedef {import("./lines.js").Cell} Cell */
/** @typedef {import("./lines.js").Row} Row */
/**
 * A rectangle of entries. `labels` are the words before each row, `headers` those above the first;
 * `name` is what the block is assigned to; `from` and `to` are its first and last line; `sources`
 * are the rows of the text that it is made of, `lines` all rows and words of the text.
 * @typedef {object} Block
 * @property {Cell[][]} rows
 * @property {Cell[][]} labels
 * @property {Cell[]} headers
 * @property {string} name
 * @property {number} from
 * @property {number} to
 * @property {Row[]} sources
 * @property {Lines} [lines]
 * @property {boolean} [splitsCommas] whether commas that may be decimal commas separate its entries
 */
/**
 * All rows and words of a text. The rows `given` repeat numbers of the question.
 * @typedef {{ all: Row[], given: Set<Row>, words: Cell[] }} Lines
 */

/**
 * Write the factor of a row behind its entries.
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
    from: rows[0].line,
    to: rows.at(-1).last,
    sources: rows,
  };
}
