// Checks the lengths that the text around a table gives to its symbols. If a line seems to define a
// symbol but cannot be read, or if a unit is unclear, there is no verdict.

import { plain, simple } from "./formula.js";
import { refuseUnreadCell } from "./owners.js";
import { ENTRIES } from "./table_rows.js";
import { LENGTH_UNIT } from "./units.js";
import { ArmError, formatMessage, quoteText } from "../sentences.js";

/** @typedef {import("./owners.js").Token} Token */
/** @typedef {import("./spans.js").Span} Span */
/** @typedef {import("./table_definitions.js").Definition} Definition */

// A symbol in plain characters, a_2, and the same symbol as an entry of a list, a(2).
const NAME = /(?<![A-Za-z0-9_.])[A-Za-z][A-Za-z]*_?\{?\w*\}?'?/g;
const LIST_ENTRY = /(?<=\b[A-Za-z]{1,5}) ?[[(](\d{1,2})[\])]/g;
// A number with its unit, but not the 3 of 3R.
const NUMERAL = new RegExp(
  String.raw`(?<![\w.])\.?\d[\d.,]*(?:e[-+]?\d+)?(?=(?:${LENGTH_UNIT})?(?![A-Za-z\d]))`,
  "gi",
);
// A number that counts, as in "(1)", "2:" and "row 3".
const COUNTED = "joint|row|link|frame|fig(?:ure)?\\.?|table|part";
const COUNT = new RegExp(String.raw`^\s*[[(]?\d{1,2}[\]).:|\t]|(?:${COUNTED})s? ?\d+`, "gi");
const MATRIX_ROW = /^[01]$/; // the numbers of a link matrix's row, apart from names

/**
 * Refuse a table if a line that was not read may define a symbol of the table.
 * @param {string[]} names of the symbols whose values the text does not define
 * @param {string} masked the text with blanks over the table's cells and all definitions
 * @param {Token[]} tokens @param {string} text as it was pasted
 */
export function refuseUnreadValues(names, masked, tokens, text) {
  const searched = new Set(names.map(simple));
  for (const [k, line] of masked.split("\n").entries()) {
    const name = findValuedSymbol(line, searched);
    if (name) refuseLine("unread value", { name }, k, tokens, text);
  }
}

/**
 * Refuse a table because of a line beside it. The numbers of the line become unread.
 * @param {string} key of the message @param {object} fields
 * @param {number} line from 0
 * @param {Token[]} tokens @param {string} text as it was pasted
 * @returns {never}
 */
export function refuseLine(key, fields, line, tokens, text) {
  const quoted = quoteText(text.split("\n")[line]);
  const marked = tokens.map((token) =>
    token.line === line && token.owner !== "entry" ? { ...token, owner: "unread" } : token,
  );
  throw new ArmError(formatMessage(key, { ...fields, line: line + 1, quoted }), [], marked, text);
}

/**
 * Replace spans of a text by blanks. Line ends stay.
 * @param {string} text @param {Span[]} spans
 */
export function maskSpans(text, spans) {
  const characters = text.split("");
  for (const { from, to } of spans)
    for (let at = from; at < to; at++) if (characters[at] !== "\n") characters[at] = " ";
  return characters.join("");
}

// Find a symbol that a line may define. The line has a number apart from indices, or assigns
// something with a digit to the symbol, as in "a_2 = l1".
/** @param {string} line @param {Set<string>} searched simple names */
function findValuedSymbol(line, searched) {
  const text = plain(line).replace(LIST_ENTRY, "_$1");
  const hasValue = hasValues(text);
  const match = [...text.matchAll(NAME)].find(({ 0: typed, index }) => {
    const name = simple(typed);
    const behind = text.slice(index + typed.length);
    if (!searched.has(name)) return false;
    if (ASSIGNED.test(behind)) return !MATRIX.test(behind) && /\d/.test(behind);
    return hasValue && name.length > 1; // "a" may be the article
  });
  return match?.[0];
}

const ASSIGNED = /^['"]? ?:?={1,2}(?!=)/;
const MATRIX = /^[^=]*= ?\[/; // A_2 = [...]

// Return whether a line has numbers apart from names and counts. A row of a link matrix has none.
function hasValues(text) {
  const rest = text.replace(COUNT, "").replace(NAME, (name) => "x".repeat(name.length));
  const numerals = rest.match(NUMERAL) ?? [];
  const isMatrixRow = numerals.length > 1 && numerals.every((one) => MATRIX_ROW.test(one));
  return numerals.length > 0 && !isMatrixRow;
}

const LEAST_MILLIMETRES = 10;
const MOST_METRES = 1;

/**
 * Drop the tables in which a defined length and the typed lengths seem to be in different units.
 * Refuse the first table if no table is left.
 * @param {Definition[]} definitions that the tables use
 * @param {import("./table.js").TypedTable[]} tables one for each possible order of the columns
 * @param {string} text as it was pasted
 */
export function dropUnclearUnits(definitions, tables, text) {
  const unclear = tables.map((table) => findUnclearUnit(definitions, table));
  if (unclear.every(Boolean)) refuseUnclearUnit(unclear[0], tables[0], text);
  return tables.filter((_, k) => !unclear[k]);
}

// Find a definition whose unit is unclear, with a length that must be in mm and one in m.
/** @param {Definition[]} definitions @param {import("./table.js").TypedTable} table */
function findUnclearUnit(definitions, { rows }) {
  const lengths = rows.flatMap(({ numbers, metres }) =>
    ["a", "d"].flatMap((name) => (metres.has(name) ? [] : [Math.abs(numbers[name])])),
  );
  const isLarge = (x) => x >= LEAST_MILLIMETRES;
  const isSmall = (x) => x > 0 && x < MOST_METRES;
  const [large, small] = [lengths.find(isLarge), lengths.find(isSmall)];
  if (large === undefined || small === undefined) return null;
  const definition =
    definitions.find(({ length }) => isLarge(Math.abs(length))) ??
    definitions.find(({ length }) => isSmall(Math.abs(length)));
  return definition ? { definition, large, small } : null;
}

/**
 * @param {{ definition: Definition, large: number, small: number }} unclear
 * @param {import("./table.js").TypedTable} table @param {string} text
 */
function refuseUnclearUnit({ definition, large, small }, { tokens }, text) {
  const line = text.slice(0, definition.from).split("\n").length;
  const fields = { name: definition.name, quoted: quoteText(definition.text), line, large, small };
  throw new ArmError(formatMessage("unclear unit", fields), [], tokens, text);
}

const UNIT_BEHIND = new RegExp(String.raw`^ ?(?:(${LENGTH_UNIT})|rad|deg|°)(?![\p{L}\p{N}])`, "u");

/**
 * Refuse an angle in mm and a length in degrees.
 * @param {import("./table.js").TypedTable} table @param {string} text as it was pasted
 */
export function refuseMixedUnits({ tokens, isOrderGuessed }, text) {
  for (const token of isOrderGuessed ? [] : tokens) {
    const [unit, lengthUnit] = UNIT_BEHIND.exec(text.slice(token.to, token.to + 9)) ?? [];
    if (unit === undefined || token.owner !== "entry") continue;
    const isLength = ["a", "d"].includes(ENTRIES[token.column]);
    if (isLength === (lengthUnit !== undefined)) continue;
    const cell = { from: token.from, to: token.to + unit.length };
    refuseUnreadCell(text, tokens, cell, formatMessage("your table"));
  }
}
