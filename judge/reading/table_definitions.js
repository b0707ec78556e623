// Lists lengths that a text defines beside its table, such as l_1 = 0.5 m. If a symbol has two
// values, there is no verdict.

import { foldCharacters } from "./characters.js";
import { withoutComments } from "./decorations.js";
import { parse, plain, simple, symbols, symbolsIn, value } from "./formula.js";
import { findEntry } from "./table_columns.js";
import { IN_NAME } from "./table_owners.js";
import { isVariable } from "./table_rows.js";
import { LENGTH_UNIT, LENGTH_UNITS, toMetres } from "./units.js";
import { ArmError, formatMessage, quoteText, tryOrNull } from "../sentences.js";

/** @typedef {import("./owners.js").Token} Token */
/** @typedef {import("./spans.js").Span} Span */
/**
 * A length that a text defines.
 * @typedef {Span & { name: string, length: number, text: string, value: string,
 *   valueFrom: number }} Definition `length` is in m; `text` is the definition as typed; `value` is
 *   the formula behind "=", which begins at `valueFrom`
 */

/** The reason of a token if it is the value of a symbol. */
export const IN_DEFINITION = "value of a symbol";

const NUMERAL = String.raw`(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d+)?`;
const DECIMAL_COMMA = String.raw`\d+,\d+`;
const SYMBOL = String.raw`\p{L}(?:_?\{?\w{1,4}\}?|[₀-₉]{1,2})?`;
// A symbol with an index, d1 or d_f, is no unit. WORD_INDEX excludes digits: if two alternatives
// matched the same digits, the steps of the pattern would double with each symbol.
const WORD_INDEX = String.raw`_\{?(?!\d{1,2}(?!\w))\w{1,4}\}?`;
const NUMBERED = String.raw`\p{L}{1,3}(?:_?\{?\d{1,2}\}?|[₀-₉]{1,2}|${WORD_INDEX})`;
const WHOLE_NAME = new RegExp(`^${NUMBERED}$`, "u");
const ROOT = String.raw`\\?sqrt[ ]?[({]${NUMERAL}[)}]`;
const TERM = `(?:${ROOT}|${DECIMAL_COMMA}|${NUMERAL}|${NUMBERED})`;
const OPERATOR = String.raw`(?:[ ]?[-+*/·×∗][ ]?|\s*=\s*[-+]?)`;
const FORMULA = `[-+]?${TERM}(?:${OPERATOR}${TERM}){0,20}`; // 2 * 0.15 = 0.3
const UNIT = String.raw`[ \t]*(?:([[(])[ ]?(?:in )?)?(${LENGTH_UNIT})(?![\p{L}\p{N}])[ ]?[\])]?`;
const END =
  String.raw`(?![\p{L}\p{N}°(]|[.,]\d|[ ]?[-+*/^=·×∗⋅%]|[ ]+(?:x[ ])?[.\d]|` +
  String.raw`[ ]*\([^()\n]{0,40}\)[ ]*[-+*/^·×∗⋅])`; // 0.107 (flange) + 0.1
// Behind "d1: 0.5" and "d1 -> 0.5" the line or the clause must end.
const STRICT_END = String.raw`(?=[ \t]*(?:,(?!\d)|[;)\]}$]|\.?[ \t]*$))`;
const SIGN = String.raw`["'$]*\s*:?={1,2}\s*`;
const OTHER_SIGN = String.raw`["'$]*[ ]*(?:->|:(?!=))[ ]*`;
const START = String.raw`(?<![\p{L}\p{N}_.\\])`;
const VALUE = `(${FORMULA})(?:${UNIT})?`;
const DEFINITIONS = [
  new RegExp(`${START}(${SYMBOL})(${SIGN})${VALUE}${END}`, "gu"),
  new RegExp(`${START}(${NUMBERED})(${OTHER_SIGN})${VALUE}${STRICT_END}`, "gmu"),
];
const NAMES = String.raw`\(?${NUMBERED}(?:[ ]?,[ ]?${NUMBERED}){1,9}\)?`; // (a2, a3) = (0.4, 0.3)
const NUMERALS = String.raw`[[(]?-?${NUMERAL}(?:[ ]?,[ ]?-?${NUMERAL}){1,9}[\])]?`;
// A list of values ends without a unit, another bracket or further numbers.
const LIST_END = String.raw`(?![ ]*[\])]|[ ]*[[(]?(?:mm|cm)(?!\p{L})|[ ]*;[ ]*[.\d])`;
const SEVERAL = new RegExp(
  `(?<![=+*/-][ ]?)${START}(${NAMES})(${SIGN})(${NUMERALS})${END}${LIST_END}`,
  "gu",
);
// A name before the matched name, as d1 in "d1, d2 = 0.5". Such a line defines no length.
const NAME_BEFORE = new RegExp(
  String.raw`(?<![=+*/-][ ]?)${START}${NUMBERED}\$?[ ]?,[ ]?\$?$`,
  "u",
);

/**
 * List the lengths that a text defines. A definition in a comment counts only if no definition
 * outside comments has the same name.
 * @param {import("./spans.js").SpannedText} pasted
 * @param {Map<string, number>} known symbols that a formula may use, with their lengths
 * @returns {Definition[]}
 */
export function listDefinitions(pasted, known = new Map()) {
  const typed = matchDefinitions(foldCharacters(pasted));
  const uncommented = withoutComments(pasted);
  const kept = uncommented ? matchDefinitions(uncommented) : typed;
  const names = new Set(kept.map(({ name }) => simple(name)));
  const all = [...kept, ...typed.filter(({ name }) => !names.has(simple(name)))];
  return all.flatMap(({ unit, ...definition }) => {
    const length = evaluateLength(definition.value, unit, all, known);
    return length === null ? [] : [{ ...definition, length }];
  });
}

/**
 * A definition whose formula is not evaluated yet.
 * @typedef {Span & { name: string, text: string, valueFrom: number, value: string,
 *   unit: string | undefined }} TypedDefinition
 */

/** @param {import("./spans.js").SpannedText} pasted @returns {TypedDefinition[]} */
function matchDefinitions(pasted) {
  const { text } = pasted;
  const makeDefinition = (symbol, value, unit, valueAt, { 0: typed, index }) => {
    const { from, to } = pasted.span(index, index + typed.length);
    const valueFrom = pasted.span(valueAt, valueAt + 1).from;
    return { from, to, name: plain(symbol), text: typed.trim(), valueFrom, value, unit };
  };
  const single = DEFINITIONS.flatMap((pattern) => [...text.matchAll(pattern)]).flatMap((match) => {
    const [, symbol, sign, value, bracket, unit] = match;
    if (NAME_BEFORE.test(text.slice(Math.max(0, match.index - 12), match.index))) return [];
    const valueAt = match.index + symbol.length + sign.length;
    const lineStart = text.lastIndexOf("\n", match.index);
    const parts = value.split("=").map((part) => part.trim());
    const isName = (part) => WHOLE_NAME.test(part) && part !== parts.at(-1); // a_3 = a_6 = 0.088
    const formula = parts.filter((part) => !isName(part)).join("=");
    return [symbol, ...parts.filter(isName)].map((name) => ({
      ...makeDefinition(name, formula, unit, valueAt, match),
      lineStart,
      isBracketed: Boolean(bracket),
    }));
  });
  const several = [...text.matchAll(SEVERAL)].flatMap((match) => {
    const [, names, sign, values] = match;
    const [symbols, numerals] = [names, values].map((list) =>
      list.replace(/[()[\]]/g, "").split(","),
    );
    const valueAt = match.index + names.length + sign.length;
    if (symbols.length !== numerals.length) return [];
    return symbols.map((symbol, k) =>
      makeDefinition(symbol.trim(), numerals[k], undefined, valueAt, match),
    );
  });
  return [...spreadUnits(single), ...several];
}

// Give a unit in brackets to the bare values before it on its line: "a = 1, b = 2 [mm]".
function spreadUnits(definitions) {
  const bracketed = new Map();
  for (const definition of definitions.filter(({ isBracketed }) => isBracketed))
    bracketed.set(definition.lineStart, [
      ...(bracketed.get(definition.lineStart) ?? []),
      definition,
    ]);
  return definitions.map(({ isBracketed: _, lineStart, ...definition }) => {
    const isBehind = ({ from }) => from > definition.from;
    const unit = definition.unit ?? bracketed.get(lineStart)?.find(isBehind)?.unit;
    return { ...definition, unit };
  });
}

const MOST_USED = 50; // definitions that a formula uses, directly or through other definitions

/**
 * Evaluate a typed formula in m. Formulas joined by "=" must be equal. Return null if that fails.
 * @param {string} formula @param {string | undefined} unit
 * @param {TypedDefinition[]} definitions @param {Map<string, number>} known
 * @returns {number | null}
 */
function evaluateLength(formula, unit = "m", definitions, known, lengths = new Map()) {
  const lookUp = (name) => {
    const symbol = simple(name);
    const definition = definitions.find((candidate) => simple(candidate.name) === symbol);
    if (!definition) return known.get(symbol);
    if (lengths.size === MOST_USED || lengths.has(symbol)) return lengths.get(symbol);
    lengths.set(symbol, undefined); // the definition may refer to itself
    const { value: inner, unit: innerUnit } = definition;
    const length = evaluateLength(inner, innerUnit, definitions, known, lengths);
    lengths.set(symbol, length ?? undefined);
    return length ?? undefined;
  };
  const numbers = formula.split("=").map((part) => {
    const tree = tryOrNull(() => parse(part.replace(/(\d),(\d)/g, "$1.$2")));
    const isMixed = tree && unit !== "m" && symbols(tree).size > 0;
    return tree && !isMixed ? tryOrNull(() => value(tree, lookUp)) : null;
  });
  const last = numbers.at(-1);
  const isEqual = numbers.every((x) => x !== null && Math.abs(x - last) < ROUND_OFF);
  return isEqual ? toMetres(last, LENGTH_UNITS[unit]) : null;
}

const ROUND_OFF = 1e-9; // m

/**
 * List the defined symbols that are lengths. A joint variable is no length. The name of a column,
 * such as d, is a length only if the arm has a symbol of this name.
 * @param {Definition[]} definitions
 * @param {Set<string>} symbolsOfArm
 * @returns {[string, number][]}
 */
export function listDefinedLengths(definitions, symbolsOfArm) {
  const isLength = (name) => (findEntry(name) ? symbolsOfArm.has(simple(name)) : !isVariable(name));
  return definitions.filter(({ name }) => isLength(name)).map(({ name, length }) => [name, length]);
}

/**
 * List the definitions that the cells of a table use, directly or through other definitions. A
 * definition that holds an entry of the table is a cell itself, and is left out.
 * @param {Definition[]} definitions
 * @param {string[]} cells
 * @param {Token[]} tokens
 * @returns {Definition[]}
 */
export function listUsedDefinitions(definitions, cells, tokens) {
  const isCell = ({ from, to }) =>
    tokens.some((token) => token.owner === "entry" && token.from >= from && token.to <= to);
  const others = definitions.filter((definition) => !isCell(definition));
  const names = new Set();
  const addNames = (formulas) => {
    const added = formulas.flatMap((formula) => symbolsIn(formula) ?? []).map(simple);
    const isNew = added.some((name) => !names.has(name));
    added.forEach((name) => names.add(name));
    const used = others.filter(({ name }) => names.has(simple(name)));
    return isNew ? addNames(used.map(({ value: formula }) => formula)) : used;
  };
  return addNames(cells);
}

/**
 * Refuse a symbol that is defined with two lengths. The numbers of both definitions become unread.
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
 * Make the numbers of definitions labels.
 * @param {Definition[]} definitions
 * @param {Token[]} tokens
 */
export const claimDefinitions = (definitions, tokens) =>
  claimValues(definitions, tokens, { owner: "label", reason: IN_DEFINITION });

/**
 * @param {Definition[]} definitions
 * @param {Token[]} tokens
 * @param {{ owner: string, reason?: string }} claim the owner of the values
 * @returns {Token[]}
 */
const claimValues = (definitions, tokens, claim) =>
  tokens.map((token) => {
    const definition = definitions.find(({ from, to }) => token.from >= from && token.to <= to);
    if (!definition) return token;
    const { text, from, to, line } = token;
    const owner = from < definition.valueFrom ? { owner: "label", reason: IN_NAME } : claim;
    return { text, from, to, line, ...owner };
  });
