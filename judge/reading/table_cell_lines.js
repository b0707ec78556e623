// Joins the cells of a table to rows if each cell stands on a line of its own, column headers
// first. Word and PDF viewers copy tables like this.

import { listLines } from "./spans.js";
import { findEntry } from "./table_columns.js";
import { ENTRIES } from "./table_rows.js";
import { ArmError, formatMessage, quoteText } from "../sentences.js";

/** @typedef {import("./spans.js").Span & { text: string }} Line */

const UNIT = /^[([]\D+[)\]]$/; // (mm) on the line below its header
const ROW_NAME = /^(?:[\p{L}#]+[ _]?)?\d{1,2}(?: ?[-–→] ?\d{1,2})?$/u; // Link 1, 0-1

/**
 * Join the cells of such a table to rows. Other texts are returned unchanged. No character moves:
 * the line end between two cells of a row becomes "|", and blank lines become blanks.
 * @param {string} text
 * @param {(cell: string) => boolean} isEntry whether a cell may be an entry of a table
 */
export function joinCellLines(text, isEntry) {
  const lines = listLines(text).filter((line) => line.text.trim());
  const start = lines.findIndex((_, k) => countHeaderLines(lines.slice(k, k + 20)));
  if (start < 0) return text;
  const behind = start + countHeaderLines(lines.slice(start, start + 20));
  const headerLines = lines.slice(start, behind);
  const cells = takeCells(lines.slice(behind), isEntry);
  const headers = headerLines.filter((line) => !UNIT.test(line.text.trim()));
  const width = findWidth(headers, cells, lines[behind + cells.length]);
  const lastCells = cells.filter((_, k) => (k + 1) % width === 0);
  const rowEnds = new Set([headerLines.at(-1), ...lastCells]);
  const characters = text.split("");
  lines.slice(start, behind + cells.length - 1).forEach((line, k) => {
    const end = line.from + line.text.trimEnd().length;
    characters.fill(" ", end, lines[start + k + 1].from);
    characters[line.to] = rowEnds.has(line) ? "\n" : "|";
  });
  return characters.join("");
}

// Count the lines of column headers at the start of the lines. Return 0 unless they name all of a,
// alpha, d and theta.
/** @param {Line[]} lines */
function countHeaderLines(lines) {
  const names = new Set();
  let count = 0;
  for (const { text } of lines) {
    const header = text.trim();
    const name = findEntry(header);
    const isOffset = /offset/i.test(header); // a joint offset beside theta and d
    if (!UNIT.test(header)) {
      if (name === undefined || /[=:]/.test(header)) break;
      if (names.has(name) && !isOffset) break;
      names.add(name);
    }
    count++;
  }
  return ENTRIES.every((entry) => names.has(entry)) ? count : 0;
}

// Take the lines up to the first line that is not a single cell.
/** @param {Line[]} lines @param {(cell: string) => boolean} isEntry */
function takeCells(lines, isEntry) {
  const isCell = ({ text }) => isEntry(text.trim()) || ROW_NAME.test(text.trim());
  const end = lines.findIndex((line) => !isCell(line));
  return end < 0 ? lines : lines.slice(0, end);
}

/**
 * Find the number of columns. A column of row numbers may have no header.
 * @param {Line[]} headers @param {Line[]} cells
 * @param {Line | undefined} next the line behind the cells
 */
function findWidth(headers, cells, next) {
  const { length } = headers;
  const namesCount = headers.some((line) => findEntry(line.text.trim()) === "i");
  const isCounted = cells.every(
    ({ text }, k) => k % (length + 1) > 0 || Number(/\d+/.exec(text)) === k / (length + 1) + 1,
  );
  const width = isCounted && !namesCount ? length + 1 : length;
  if (cells.length % width === 0) return width;
  const fields = { columns: length, count: cells.length };
  const behind = next ? ` before ${quoteText(next.text.trim())}` : "";
  throw new ArmError(formatMessage("cell lines", { ...fields, behind }));
}
