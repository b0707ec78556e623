// Refuses a table that the text beside it changes, for example by a joint offset, a second value of
// an entry, or a tool. The judge does not apply such a change, so there is no verdict.

import { plain } from "./formula.js";
import { refuseLine } from "./table_symbols.js";
import { LENGTH_UNIT } from "./units.js";

/** @typedef {import("./spans.js").Span} Span */
/** @typedef {import("./table.js").TypedTable} TypedTable */

const VARIABLE = String.raw`\b(?:th(?:eta)?|q|phi)_?\{?(\d{1,2})\}?'?\*?`;
const VALUE = String.raw`(?:\.?\d|pi\b)`;
// theta_2 = q_2 - 90 and theta_2 = 90 - q_2
const SHIFTED = new RegExp(
  `${VARIABLE} ?= ?(?:-? ?${VARIABLE} ?[-+] ?${VALUE}|-? ?${VALUE}[^,;=]*[-+] ?${VARIABLE})`,
);
const SHIFTED_IN_ROW = new RegExp(`${VARIABLE} ?[-+] ?${VALUE}`);
const OFFSET = new RegExp(
  String.raw`${VARIABLE}.*\boffset\b.*${VALUE}|\boffset\b.*${VARIABLE}`,
  "i",
);
const OFFSET_IN_ROW = /\b(?:offset|plus|minus)\b[^,;|&]*?[1-9]/i;
// L(2).offset = pi/6, L3.a = 0.35, r.tool = transl(0, 0, 0.1) and a(2) = 0.45
const FIELD = /\.(?:a|d|alpha|theta|offset|tool|base) ?=(?!=)/;
const LIST_ENTRY = /(?<![\w.])(?:a|r|d|alpha|theta|offset) ?[[(]\d{1,2}[\])] ?=(?!=)/;
const TOOL = /(?<![\p{L}\p{N}])(?:tool|base)['"]?[ \t]*[:=│|,](.*)/iu;
const TRANSFORM = /\.\d{0,20}[1-9]|(?=[^.]{0,80}[1-9])(?:-?\d{1,20}[ ,]{1,9}){2}-?\d/;
// "the base stands 30 cm above the floor", "a_2 is doubled"
const MOVED = new RegExp(
  String.raw`\b(?:base|floor|ground|world|tool|tcp)\b[^\n]{0,60}[1-9][\d.]{0,9} ?` +
    String.raw`(?:${LENGTH_UNIT})\b|\b(?:doubled|halved|not to scale)\b`,
  "i",
);
const DOUBT_IN_ROW = /\b(?:or|oder|should)\b|^\W*(?:sum|total|summe|gesamt)\b/i;
const FLIP = /\bflip ?= ?(?:True|true|1)\b/;
const COMMENT = /^\s*(?:%|#(?!\d)|\/\/)/;

/**
 * Refuse a table that text beside it changes.
 * @param {TypedTable} table
 * @param {string} masked the text with blanks over the table's cells and over used definitions
 * @param {string} text as it was pasted
 */
export function refuseChanges(table, masked, text) {
  const typedLines = text.split("\n");
  for (const [k, line] of masked.split("\n").entries()) {
    if (COMMENT.test(line)) continue;
    const isRow = line.trim() !== typedLines[k].trim();
    if (isChange(line, isRow, table)) refuseLine("changed", {}, k, table.tokens ?? [], text);
  }
}

/** @param {string} line @param {boolean} isRow @param {TypedTable} table */
function isChange(line, isRow, { rows }) {
  if ([FLIP, MOVED].some((pattern) => pattern.test(line))) return true;
  if (assignsField(line)) return true;
  const [, behindTool = ""] = TOOL.exec(line) ?? [];
  if (TRANSFORM.test(behindTool)) return true;
  if (isRow) return changesRow(line);
  const text = plain(line);
  const match = SHIFTED.exec(text) ?? OFFSET.exec(text);
  if (!match) return false;
  const numbers = match.slice(1).filter(Boolean).map(Number);
  return numbers.some((number) => rows[number - 1] && !hasOffset(rows, number));
}

/**
 * Return whether text beside the entries of a row changes the row, as "q2 + 90" does, or says that
 * it is no row, as "sum" does.
 * @param {string} text
 */
export const changesRow = (text) =>
  DOUBT_IN_ROW.test(text) || OFFSET_IN_ROW.test(text) || SHIFTED_IN_ROW.test(plain(text));

// Return whether a line assigns a number other than 0 to an entry or a field.
const assignsField = (line) =>
  [FIELD, LIST_ENTRY].some((pattern) => {
    const match = pattern.exec(line);
    return match !== null && /[1-9]|pi|π/.test(line.slice(match.index + match[0].length));
  });

// Return whether the row of a joint has an offset in the table.
/** @param {TypedTable["rows"]} rows @param {number} number */
const hasOffset = (rows, number) =>
  rows.some(({ joint, numbers }, k) => (joint?.number ?? k + 1) === number && numbers.theta !== 0);
