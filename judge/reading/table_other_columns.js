// Cuts out columns that do not belong to the Denavit-Hartenberg table, such as masses in a maker's
// data sheet.

import { isNumber } from "./formula.js";
import { Tokens } from "./owners.js";
import { listLines, SpannedText } from "./spans.js";
import { findEntry } from "./table_columns.js";
import { ENTRIES } from "./table_rows.js";

/** @typedef {import("./owners.js").Token} Token */
/** @typedef {import("./spans.js").Span} Span */
/**
 * A column that does not belong to the table. The first of its cells is the header.
 * @typedef {{ header: string, cells: (Span & { text: string })[] }} OtherColumn
 */

const SEPARATORS = ["\t", "|", "&", ";"];
const KEPT = /offset/i; // the header of a further column of the table
const VECTOR = /^[([{]\s*[-+−.\d]/; // the centre of mass, (0, 0.1, 0)

/**
 * Cut other columns out of a table whose headers name all four entries.
 * @param {string} text
 * @returns {{ rest: SpannedText, others: OtherColumn[] }} the text without the columns, and the
 *   columns with numbers that were cut out
 */
export function dropOtherColumns(text) {
  const lines = listLines(text);
  for (const separator of SEPARATORS)
    for (const line of lines) {
      const headers = line.text.split(separator).map((cell) => cell.trim());
      if (headers.length < ENTRIES.length) continue;
      const words = headers.map(findEntry);
      if (!ENTRIES.every((entry) => words.includes(entry))) continue;
      const isKept = (i) => words[i] !== undefined || !headers[i] || KEPT.test(headers[i]);
      const cells = lines.map((each) => splitLine(each, separator));
      const isRow = (j) => cells[j].length === headers.length;
      const parts = lines.flatMap((each, j) => [
        ...(isRow(j)
          ? joinSpans(
              cells[j].filter((_, i) => isKept(i)),
              separator,
            )
          : [each]),
        "\n",
      ]);
      const columns = headers.flatMap((header, i) =>
        isKept(i) ? [] : [{ header, cells: cells.flatMap((row, j) => (isRow(j) ? row[i] : [])) }],
      );
      const texts = columns.map((column) =>
        column.cells.slice(1).map(({ text: cell }) => cell.trim()),
      );
      if (texts.some(hasStrayNumber)) break;
      const others = columns.filter((_, i) => texts[i].some(isNumberOrVector));
      return { rest: new SpannedText(text).assemble(parts), others };
    }
  return { rest: new SpannedText(text), others: [] };
}

// Return whether the cells of a column have different counts of numbers, as "2.2" and "3.1 99".
/** @param {string[]} cells */
const hasStrayNumber = (cells) => new Set(cells.map(countNumbers).filter(Boolean)).size > 1;

const countNumbers = (cell) =>
  cell.split(VECTOR.test(cell) ? /[\s,;]+/ : /\s+/).filter((word) => /\d/.test(word)).length;

// Split a line into its cells with their positions in the text.
function splitLine({ from, text }, separator) {
  let start = from;
  return text.split(separator).map((cell) => {
    const span = { from: start, to: start + cell.length, text: cell };
    start = span.to + separator.length;
    return span;
  });
}

const joinSpans = (spans, separator) =>
  spans.flatMap((span, i) => (i ? [separator, span] : [span]));

/**
 * Add the numbers of the columns that were cut out to the tokens of the remaining text.
 * @param {Token[]} tokens of the text without the columns
 * @param {{ rest: SpannedText, others: OtherColumn[] }} dropped from `dropOtherColumns`
 * @param {string} text as it was pasted
 * @returns {Token[]}
 */
export function addOtherNumbers(tokens, { rest, others }, text) {
  const kept = tokens.map((token) => ({ ...token, ...rest.span(token.from, token.to) }));
  const all = new Tokens(text);
  for (const { header, cells } of others)
    for (const cell of cells) all.claim(cell, "context", { reason: `column ${header}` });
  const owned = new Set(kept.map(({ from }) => from));
  const added = all.list.filter(({ from }) => !owned.has(from));
  for (const token of added) token.owner ||= "context";
  return [...kept, ...added].sort((p, q) => p.from - q.from);
}

const isNumberOrVector = (cell) => isNumber(cell) || VECTOR.test(cell);
