// Columns of a pasted table that are no part of it, as a maker's masses beside the four entries.

import { isNumber } from "./formula.js";
import { findEntry } from "./table_columns.js";
import { ENTRIES } from "./table_rows.js";

const SEPARATORS = ["\t", "|", "&", ";"];
const KEPT = /offset|type|kind|variable/i; // headers of columns that belong to a table
const VECTOR = /^[([{]\s*[-+−.\d]/; // a centre of mass

/**
 * Cut other columns out of a table whose headers name all four entries.
 * @param {string} text
 * @returns {{ text: string, others: string[] }} the headers of the columns with numbers that were
 *   cut out
 */
export function dropOtherColumns(text) {
  const lines = text.split("\n");
  for (const separator of SEPARATORS)
    for (const [k, line] of lines.entries()) {
      const headers = line.split(separator).map((cell) => cell.trim());
      const words = headers.map(findEntry);
      if (!ENTRIES.every((entry) => words.includes(entry))) continue;
      const isKept = (i) => words[i] !== undefined || !headers[i] || KEPT.test(headers[i]);
      const cells = lines.map((one) => one.split(separator));
      const isRow = (i) => i >= k && cells[i].length === headers.length;
      const holdsNumbers = (i) =>
        cells.some((row, j) => j > k && isRow(j) && isNumberOrVector(row[i].trim()));
      if (headers.every((_, i) => isKept(i))) return { text, others: [] };
      const kept = cells.map((row, j) =>
        isRow(j) ? row.filter((_, i) => isKept(i)).join(separator) : lines[j],
      );
      const others = headers.filter((_, i) => !isKept(i) && holdsNumbers(i));
      return { text: kept.join("\n"), others };
    }
  return { text, others: [] };
}

const isNumberOrVector = (cell) => isNumber(cell) || VECTOR.test(cell);
