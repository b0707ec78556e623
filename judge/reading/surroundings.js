// Finds text around the numbers of an answer that would change them, such as the sign of "-[1, 2]",
// the factor of "[1, 2]*pi", or the name "cos q1". The judge does not compute the result, but asks
// for the final numbers.

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
// Units behind a number that are those of velocities, stiffnesses or masses times lengths.
const OTHER_UNIT =
  /^[\s\])}]*((?:rad|deg|°) ?\/ ?s(?!\p{L})|N ?\/ ?m(?!\p{L})|kg ?[·*]? ?m(?![\p{L}\d^²]))/u;
// A relation before a value, "tau_1 < 3", and words behind a value, "is wrong", that reject it.
const RELATION =
  /(≠|!=|\\neq?|(?<=[\p{L}\d}] ?)[<≤≥]|(?<=[\p{L}\d}] )>|(?<!\p{L})(?:is|are) not)\s*$/u;
const REJECTION = new RegExp(
  String.raw`^(?:(?:[°%]|N ?m|rad|deg)(?!\p{L}))?[\])} \t.,]*` +
    String.raw`((?:(?:is|are|was|were) )?(?:wrong|incorrect|false|falsch|faux)(?!\p{L})|` +
    String.raw`(?:is|are) not (?:the|right|correct)(?!\p{L}))`,
  "iu",
);
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

const NAME = String.raw`\\?(?:q|θ|theta|tau|τ|J)`;
// A name that is a formula, "cos q1", or that of a velocity or a limit, "q_dot" and "q_max".
const COMPUTED_NAME = new RegExp(
  [
    String.raw`^-(?=${NAME})`,
    String.raw`^\d+(?=${NAME}(?!\p{L}))`,
    String.raw`(?<!\p{L})(?:p?inv|sin|cos|tan)(?!\p{L})`,
    String.raw`\^\s*[({]?\s*-\s*1`,
    String.raw`${NAME}_?\{?\d*\}?\s*[*/]\s*\d`,
    String.raw`${NAME}_?\{?\d*\}?\s*\+\s*${NAME}`,
    String.raw`[qθ]\u0307`,
    String.raw`\\d?dot\{?\\?(?:q|theta)|(?<!\p{L})(?:q|θ|theta)_?\d?_?dot|^d(?:q|θ|theta)\d?$`,
    String.raw`[_ ](?:max|min|limits?)(?!\p{L})`,
  ].join("|"),
  "u",
);

const NEAR = 80; // characters beside a row that hold its brackets, factors and name

/**
 * Find a relation such as < before the rows of an answer, or words that reject the rows.
 * @param {string} text as it was pasted @param {Row[]} rows the rows of the answer
 * @returns {string | null} the words of the text
 */
export function findRejection(text, rows) {
  for (const { cells } of rows) {
    const [first, last] = [cells[0], cells.at(-1)];
    const before = text.slice(Math.max(0, first.from - NEAR), first.from).replace(OPENING, "");
    const behind = text.slice(last.to, last.to + NEAR).replace(CLOSING, "");
    const rejection = RELATION.exec(before)?.[1] ?? REJECTION.exec(behind)?.[1];
    if (rejection) return rejection;
  }
  return null;
}

/**
 * Find text around the numbers of an answer that would change them, or a name that shows that they
 * are not the answer.
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
    const name = nameBefore(outside);
    if (COMPUTED_NAME.test(name)) return name;
    const behind = text.slice(last.to, last.to + NEAR);
    const rest = behind.replace(CLOSING, "");
    const closed = countBrackets(behind.slice(0, behind.length - rest.length));
    // A row of a matrix in its own brackets may be transposed, because it is a column.
    const isMatrix = !isList && closed > opened;
    const change =
      firstMatch([OTHER_UNIT], behind) ||
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

// Return the name at the end of the text before a list, tau of "case 1, tau = g - JTF =". It stands
// behind the last separator and before the first "=".
function nameBefore(text) {
  const line = text.slice(text.lastIndexOf("\n") + 1);
  if (!/[=:]\s*$/.test(line)) return "";
  const piece = line
    .replace(/[=:]\s*$/, "")
    .split(/[,;|&]/)
    .at(-1);
  return piece.split("=")[0].trim();
}
