// Finds a sign, a factor or a function that touches the numbers of an answer, such as "-[1, 2]" and
// "[1, 2]*pi". The judge does not compute the result, but asks for the final numbers.

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

const NEAR = 80; // characters beside a row that hold its brackets, factors and name

/**
 * Find a sign, a factor or a function that touches the numbers of an answer.
 * @param {string} text as it was pasted @param {Row[]} rows the rows of the answer
 * @returns {string | null} the words of the text
 */
export function findComputation(text, rows) {
  const isList = rows.length === 1 || rows.every(({ cells }) => cells.length === 1);
  for (const { cells } of rows) {
    const [first, last] = [cells[0], cells.at(-1)];
    const before = text.slice(Math.max(0, first.from - NEAR), first.from);
    const outside = before.replace(OPENING, "");
    const opened = countBrackets(before.slice(outside.length));
    const behind = text.slice(last.to, last.to + NEAR);
    const rest = behind.replace(CLOSING, "");
    const closed = countBrackets(behind.slice(0, behind.length - rest.length));
    // A row of a matrix in its own brackets may be transposed, because it is a column.
    const isMatrix = !isList && closed > opened;
    const change =
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
