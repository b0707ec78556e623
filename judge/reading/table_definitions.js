// Lengths that a text defines beside its table, such as l_1 = 0.5 m. A symbol with two values stops
// the verdict.

import { withoutComments } from "./decorations.js";
import { number, plain, simple, symbolsIn } from "./formula.js";
import { findEntry } from "./table_columns.js";
import { IN_NAME } from "./table_owners.js";
import { isVariable, toMetres, UNITS } from "./table_rows.js";
import { ArmError, formatMessage, quoteText } from "../sentences.js";

/** @typedef {import("./owners.js").Token} Token */
/** @typedef {import("./spans.js").Span} Span */
/**
 * A length that a text defines.
 * @typedef {Span & { name: string, length: number, text: string, valueFrom: number }} Definition
 *   `length` is in m; `text` is the definition as typed; its value begins at `valueFrom`
 */

/** The reason of a number that is the value of a symbol. */
export const IN_DEFINITION = "value of a symbol";

const PRODUCT = String.raw`-?\d+(?:\.\d+)?(?:[ ]?[*/][ ]?\d+(?:\.\d+)?)*`; // L1 = 2 * 0.15
const DEFINITION = new RegExp(
  String.raw`(?<![\p{L}\p{N}_.])([A-Za-z](?:_?\{?\w{1,4}\}?)?)(\s*:?=\s*)` +
    String.raw`(${PRODUCT})\s*(mm|cm|m)?(?![\w.*/+^°]| ?[*/+^])`,
  "gu",
);

/**
 * List the lengths that a text defines. One in a comment counts if no other line defines its name.
 * @param {import("./spans.js").SpannedText} pasted
 * @returns {Definition[]}
 */
export function listDefinitions(pasted) {
  const definitions = matchDefinitions(pasted);
  const uncommented = withoutComments(pasted);
  if (!uncommented) return definitions;
  const kept = matchDefinitions(uncommented);
  const names = new Set(kept.map(({ name }) => name));
  return [...kept, ...definitions.filter(({ name }) => !names.has(name))];
}

function matchDefinitions(pasted) {
  return [...pasted.text.matchAll(DEFINITION)].flatMap(
    ({ 0: text, 1: symbol, 2: sign, ...rest }) => {
      const { 3: product, 4: unit = "m", index } = rest;
      const length = toMetres(number(product), UNITS[unit]);
      const valueAt = index + symbol.length + sign.length;
      const { from } = pasted.span(valueAt, index + text.length);
      const span = pasted.span(index, index + text.length);
      const definition = {
        ...span,
        name: plain(symbol),
        length,
        text: text.trim(),
        valueFrom: from,
      };
      return Number.isFinite(length) ? [definition] : [];
    },
  );
}

/**
 * List the symbols of a table that a text defines, with their lengths. A joint's variable is no
 * length. A column's name is one if it is a symbol of the arm and the text gives it one length.
 * @param {Definition[]} definitions
 * @param {Set<string>} symbols of the asked arm
 * @returns {[string, number][]}
 */
export function listDefinedLengths(definitions, symbols) {
  const countLengths = (symbol) =>
    new Set(definitions.filter(({ name }) => name === symbol).map(({ length }) => length)).size;
  const isLength = (name) =>
    findEntry(name) ? symbols.has(simple(name)) && countLengths(name) === 1 : !isVariable(name);
  return definitions.filter(({ name }) => isLength(name)).map(({ name, length }) => [name, length]);
}

/**
 * List the definitions of symbols in cells. A definition with an entry of the table is a cell.
 * @param {Definition[]} definitions
 * @param {string[]} cells
 * @param {Token[]} tokens
 * @returns {Definition[]}
 */
export function listUsedDefinitions(definitions, cells, tokens) {
  const used = new Set(cells.flatMap((cell) => symbolsIn(cell) ?? []).map(simple));
  const isCell = ({ from, to }) =>
    tokens.some((token) => token.owner === "entry" && token.from >= from && token.to <= to);
  return definitions.filter(
    (definition) => used.has(simple(definition.name)) && !isCell(definition),
  );
}

/**
 * Refuse a symbol that is defined with two lengths; the numbers of both become unread.
 * @param {Definition[]} definitions
 * @param {Token[]} tokens
 * @param {string} text as it was pasted
 */
export function refuseTwoLengths(definitions, tokens, text) {
  for (const first of definitions) {
    const second = definitions.find(
      ({ name, length }) => simple(name) === simple(first.name) && length !== first.length,
    );
    if (!second) continue;
    const marked = claimValues([first, second], tokens, { owner: "unread" });
    const describe = ({ text: typed, from }) => ({
      quoted: quoteText(typed),
      line: text.slice(0, from).split("\n").length,
    });
    const [one, other] = [first, second].map(describe);
    const fields = { name: first.name, one: one.quoted, line: one.line };
    const more = { other: other.quoted, otherLine: other.line, what: formatMessage("your table") };
    throw new ArmError(formatMessage("two lengths", { ...fields, ...more }), [], marked, text);
  }
}

/**
 * Give the numbers of definitions their owner: they are labels, or parts of a name.
 * @param {Definition[]} definitions
 * @param {Token[]} tokens
 */
export const claimDefinitions = (definitions, tokens) =>
  claimValues(definitions, tokens, { owner: "label", reason: IN_DEFINITION });

/**
 * @param {Definition[]} definitions
 * @param {Token[]} tokens
 * @param {{ owner: string, reason?: string }} claim of the values
 * @returns {Token[]}
 */
const claimValues = (definitions, tokens, claim) =>
  tokens.map((token) => {
    const own = definitions.find(({ from, to }) => token.from >= from && token.to <= to);
    if (!own) return token;
    const { text, from, to, line } = token;
    const owner = from < own.valueFrom ? { owner: "label", reason: IN_NAME } : claim;
    return { text, from, to, line, ...owner };
  });

/**
 * Take definitions out of the lines that were not used.
 * @param {string[]} lines @param {Definition[]} definitions
 */
export const dropDefinitions = (lines, definitions) =>
  lines.flatMap((line) => {
    const parts = line.split(/[,;]/);
    const unused = parts.filter((part) => !definitions.some(({ text }) => part.includes(text)));
    if (unused.length === parts.length) return [line];
    const rest = unused.join(",").trim();
    return /\d/.test(rest) ? [rest] : [];
  });
