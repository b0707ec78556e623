// Finds what is computed or compared beside the numbers of an answer, such as "-[1, 2]",
// "[1, 2]*pi", "cos q1 = 0.5" and "q1 < 0.5". Only the name of the answer may stand before its
// numbers. The judge does not compute the result, but asks for the final numbers.

import { parse, symbols } from "./formula.js";
import { TRANSPOSED as TRANSPOSE_MARK } from "./ordering.js";
import { tryOrNull } from "../sentences.js";

/** @typedef {import("./lines.js").Row} Row */

const MATRIX_BEGIN = String.raw`\\begin\{[^{}\n]*\}(?:\{[lcr|\s]*\}|\[[a-z]\])?`;
const ARRAY = String.raw`(?:[a-z]{1,5}\.)?(?:as)?(?:array|matrix|tensor|vector)\b`;
const OPENING = new RegExp(
  String.raw`(?:\s|[[({&]|\\left|\\[bB]ig+l?|\\[ ,;:!]|${MATRIX_BEGIN}|${ARRAY})+$`,
  "i",
);
const CLOSING = /^(?:\s*(?:[\])}]|\\right\b|\\[bB]ig+r?|\\end\{[^{}\n]*\})|[ \t]|\\[ ,;:!])+/;
const countBrackets = (text) => text.match(/[[\](){}]/g)?.length ?? 0;

// A sign, a factor or a function before a bracket.
const BEFORE = [
  /[=:][ \t]*([-\u2212\u2013])[ \t]*$/,
  /([\w.^{}+⁻⁰¹²³⁴-⁹-]*[\w)\]}⁰¹²³⁴-⁹]\s*(?:[*·×/^]|\\cdot|\\times))\s*$/,
  new RegExp(
    String.raw`((?:π|\\pi|(?<![\p{L}_])pi|\\[dt]?frac(?:\{[^{}]*\}\{[^{}]*\}|\d\d)|` +
      String.raw`10\^\{?-?\d+\}?|10⁻?[⁰¹²³⁴-⁹]+))\s*$`,
    "u",
  ),
  /=[ \t]*(\d+(?:[.,]\d+)?(?:e[-+]?\d+)?(?:\/\d+)?)[ \t]*$/i,
  /\b(p?inv|transpose|(?:np\.)?(?:rad2deg|degrees)|(?:a|arc)?(?:sin|cos|tan)|sqrt|abs)\s*$/,
];
// A factor before numbers without brackets, as in "J = 1.0e+03 *".
const FACTOR = /[=:][ \t]*(\d+(?:\.\d+)?(?:e[-+]?\d+)?[ \t]*[*·×])\s*$/i;
// A sign or a number directly before a bracket. With a blank between, it is a bullet or the number
// of a row.
const SIGN = /(?:^|[\s(])([-\u2212\u2013])$/;
const NUMBER = /(?<![\p{L}\d_.])(\d+(?:\.\d+)?)$/u;
// A factor or an inverse behind a bracket, and a transpose behind a matrix. A list may be
// transposed.
const BEHIND = [
  /^(\.?[*/][ \t]*[\d\p{L}\\][\w./]*)/u,
  /^([×·]|\\cdot|\\times|π|\\pi|pi\b)/,
  /^(\^[ \t]*[({]?[ \t]*-)/,
];
const TRANSPOSED = new RegExp(
  String.raw`^(\.?'(?!\w)|\.T\b|\.transpose|ᵀ|` +
    String.raw`\^[ \t]*[({]?[ \t]*(?:\\[a-z]+[ \t{]*)?T\b|\^\{?\\top)`,
  "i",
);
const DEGREES_BEHIND = /^\.?[*][ \t]*(?:\w+\.)?pi[ \t]*\/[ \t]*180/;

// A relation other than "=" before a number. The < of a tag has no blank behind it.
const RELATION = /(≠|!=|\\n?eq?(?!\p{L})|(?<=[\p{L}\d}] ?)[<≤≥]|(?<=[\p{L}\d}] )>)\s*$/u;

const NEAR = 80; // characters beside a row that hold its brackets, factors and name

/**
 * Find what is computed or compared beside the numbers of an answer.
 * @param {string} text as it was pasted
 * @param {{ sources: Row[], isTransposed?: boolean }} block of the answer
 * @returns {string | null} the words of the text
 */
export function findComputation(text, { sources: rows, isTransposed = false }) {
  const isList = rows.length === 1 || rows.every(({ cells }) => cells.length === 1);
  for (const { cells } of rows) {
    const [first, last] = [cells[0], cells.at(-1)];
    const before = text.slice(Math.max(0, first.from - NEAR), first.from);
    const outside = before.replace(OPENING, "");
    const opened = countBrackets(before.slice(outside.length));
    const name = findNameBefore(outside);
    if (isComputed(name, isTransposed)) return name;
    const behind = text.slice(last.to, last.to + NEAR);
    const rest = behind.replace(CLOSING, "");
    const closed = countBrackets(behind.slice(0, behind.length - rest.length));
    // A row of a matrix in its own brackets may be transposed, because it is a column.
    const isMatrix = !isList && closed > opened;
    const change =
      firstMatch([RELATION], outside) ||
      (opened ? findBefore(before, outside) : firstMatch([FACTOR], before)) ||
      (closed && findBehind(rest, isMatrix));
    if (change) return change;
  }
  return null;
}

function findBefore(before, outside) {
  const opening = before.slice(outside.length);
  const touching = [/^\\begin/.test(opening) && NUMBER, /^\S/.test(opening) && SIGN];
  return firstMatch([...BEFORE, ...touching.filter(Boolean)], outside);
}

const findBehind = (rest, isMatrix) =>
  DEGREES_BEHIND.test(rest) ? null : firstMatch(isMatrix ? [...BEHIND, TRANSPOSED] : BEHIND, rest);

const firstMatch = (patterns, text) =>
  patterns.map((pattern) => pattern.exec(text)?.[1]).find(Boolean) ?? null;

// Return the text before the "=" or ":" of a row: "tau" of "case 1, tau = g - JTF =".
function findNameBefore(outside) {
  const line = outside.slice(outside.lastIndexOf("\n") + 1);
  if (!/[=:]\s*$/.test(line)) return "";
  const piece = line.replace(/[=:]\s*$/, "").split(/[,;|&]/);
  return piece.at(-1).split("=")[0].trim();
}

// Parts of a name beside its letters: a bullet, the number of a solution in q^{(1)}, a unit, and
// the argument of J(q).
const BESIDE_NAME = /^- +|\^\{?\(\d\)\}?|\/ ?(?:rad|deg|N?m)$|(?<=\S)\([^()]*\)$/g;
const TRANSPOSE = new RegExp(`(?:${TRANSPOSE_MARK}|')$`);
const SYMBOL = /^(?:q|th(?:eta)?|tau|[tjvw])(?:_?\{?\w{1,4}\}?)?$/i;
// The name of an inverse, a rate or a limit
const OTHER_NAME = new RegExp(
  String.raw`(?<!\p{L})(?:p?inv|d?dot)(?!\p{L})|[_ ](?:max|min|limits?|d?dot)(?!\p{L})|` +
    String.raw`[qθ](?:\u0307|\d?d?dot)`,
  "u",
);

/**
 * Return whether the name before "=" is a formula of the asked quantity, such as "q1+q2", or names
 * its inverse, its rate or its limit.
 * @param {string} name @param {boolean} isTransposed whether the answer was transposed as named
 */
function isComputed(name, isTransposed) {
  const whole = name.replace(BESIDE_NAME, "");
  const bare = isTransposed ? whole.replace(TRANSPOSE, "") : whole;
  if (OTHER_NAME.test(bare)) return true;
  const tree = tryOrNull(() => parse(bare));
  if (!tree || tree[0] === "name" || !/[-+*/^'ᵀ]|(?:sin|cos|tan|sqrt)/.test(bare)) return false;
  const names = [...symbols(tree)];
  return names.length > 0 && names.every((symbol) => SYMBOL.test(symbol));
}
