// Refuses an answer whose text gives a symbol another value than the question, or a value that no
// step read.

import { parse, simple, symbols, symbolsIn, value } from "./formula.js";
import { refuseUnreadCell } from "./owners.js";
import { LENGTH_UNIT, LENGTH_UNITS } from "./units.js";
import { ArmError, formatMessage, quoteText, tryOrNull } from "../sentences.js";

// A symbol with its value, such as c23 = cos(q2 + q3) and a2 = 0.4.
const VALUE = /(?<![\p{L}\d_.])(\p{L}_?\{?\d{1,4}\}?) *:?= *([^\s=,;][^\n=,;]{0,40})/gu;
// A line of several names and their values: a2, a3 = 0.4, 0.3.
const SEVERAL = /^[ \t]*(\p{L}\w*(?: *, *\p{L}\w*){1,20}) *= *([^\n=;]{1,400})$/gmu;

// Write "a2, a3 = 0.4, 0.3" as "a2 = 0.4; a3 = 0.3", unless the counts differ.
const splitAssignments = (text) =>
  text.replace(SEVERAL, (line, typedNames, typedValues) => {
    const [names, values] = [typedNames, typedValues].map((list) => list.split(","));
    if (names.length !== values.length) return line;
    return names.map((name, k) => `${name.trim()} = ${values[k].trim()}`).join("; ");
  });

/**
 * Raise an error if the text gives a symbol of the answer a value that differs from its value in
 * the question. A value that is no formula of known symbols is skipped.
 * @param {string} text @param {Map<string, number>} meanings of the symbols in the answer
 * @param {(names: Set<string>) => Map<string, number>} known looks symbols up
 */
export function refuseOtherValues(text, meanings, known) {
  const expected = new Map([...meanings].map(([name, x]) => [simple(name), x]));
  for (const { 1: name, 2: words } of splitAssignments(text).matchAll(VALUE)) {
    const formula = cutAtBracket(words);
    const x = expected.get(simple(name));
    const stated = x === undefined ? null : tryOrNull(() => evaluateKnown(formula, known));
    if (stated === null || Math.abs(stated - x) < ROUND_OFF) continue;
    const fields = { quoted: quoteText(`${name} = ${formula}`), name };
    throw new ArmError(formatMessage("contrary value", fields));
  }
}

const ROUND_OFF = 1e-9;

const MEASURED = new RegExp(String.raw`^(.*\d) ?(${LENGTH_UNIT})$`);

function evaluateKnown(typed, known) {
  const [, formula = typed, unit = "m"] = MEASURED.exec(typed) ?? [];
  const tree = parse(formula);
  const meanings = known(symbols(tree));
  return value(tree, (name) => meanings.get(name)) * LENGTH_UNITS[unit];
}

// Cut a formula at a closing bracket that it did not open, and drop the full stop at its end.
const cutAtBracket = (formula) =>
  /^(?:\([^()]*\)|[^()\]])*/.exec(formula)[0].replace(/[.\s]+$/, "");

const NAME = String.raw`\p{L}+_?\{?\d{1,2}\}?`;
// One name or several, and their values: "a2 (upper arm) = 0.45", "a2, a3 = 0.45".
const ASSIGNED = new RegExp(
  String.raw`(?<![\p{L}\d_.\\])(${NAME}(?: *, *${NAME})*)(?: *\([^()\n=]{0,30}\))? *:?= *` +
    String.raw`([^\s=][^\n=,;]{0,40})`,
  "gu",
);

/**
 * Refuse a table if its text assigns one of its symbols a value that was not read, or shifts one of
 * its joint variables, as "theta_2 = q_2 + 90" does.
 * @param {string} text as it was pasted
 * @param {{ typedCells?: string[], tokens?: import("./owners.js").Token[] }} table
 * @param {import("./spans.js").Span[]} readSpans of the definitions that were read
 */
export function refuseUnreadValues(text, { typedCells = [], tokens = [] }, readSpans) {
  const used = new Set(typedCells.flatMap((cell) => symbolsIn(cell) ?? []).map(simple));
  for (const { 0: quoted, 1: names, 2: formula, index } of text.matchAll(ASSIGNED)) {
    const span = { from: index, to: index + quoted.trimEnd().length };
    const isInside = ({ from, to }) => from < span.to && to > span.from;
    const isEntry = (token) => token.owner === "entry" && isInside(token);
    if (!names.split(",").some((name) => used.has(simple(name.trim())))) continue;
    if (readSpans.some(isInside) || tokens.some(isEntry)) continue;
    if (isValue(formula, JOINT.test(simple(names))))
      refuseUnreadCell(text, tokens, span, formatMessage("your table"));
  }
}

const JOINT = /^(?:q|th|theta|phi)\d+$/;

// Return whether words behind "=" are a value. A joint variable may have a value for a picture, but
// no formula of another variable.
function isValue(words, isJoint) {
  const formula = cutAtBracket(words);
  const names = symbolsIn(formula);
  if (isJoint) return names !== null && names.length > 0 && /[-+*/]/.test(formula);
  return /^[-+(]?\s*[.\d]/.test(formula) || Boolean(names?.every((name) => /\d$/.test(name)));
}
