// A matrix or table of LaTeX, and what is set beside it.

import { decimal } from "./commas.js";
import { alone } from "./surroundings.js";

// One row of cells for each row of the matrix.

const ENVIRONMENT =
  /\\begin\{(?:[a-zA-Z]*matrix\*?|array|tabular|aligned)\}(?:\[[^\]]*\])?(?:\{[^{}]*\})?/g;

// What closes an environment, and the rules of a table.
const LATEX_REST = new RegExp(
  String.raw`\\end\{[^{}]*\}(?:_\{[^{}]*\})?(?:\s*\\right\s*[\]).|])?` +
    String.raw`|\\c(?:line|midrule)(?:\([^()]*\))?\{[^{}]*\}` +
    String.raw`|\\(?:hline|(?:top|mid|bottom)rule|nonumber)(?![A-Za-z])`,
  "g",
);

export function latexRows(text) {
  const inner = matrixAlone(text)
    .replace(/\\left\s*[[(.|]\s*(?=\\begin)/g, " ")
    .replace(ENVIRONMENT, " ")
    .replace(LATEX_REST, " ")
    .replace(/^\s*[A-Za-z_][\p{L}\p{N}_]*(?:\([^()]*\))?\s*=/u, "")
    .replace(/\\\\\s*\[[^\]]*\]/g, "\\\\")
    .replaceAll("$", " ")
    .replaceAll("\\[", " ")
    .replaceAll("\\]", " ");
  return inner.split(/\\\\|\\cr(?![A-Za-z])/).map((row) => row.split("&").map(decimal));
}

// Beside the matrix: sizes, brackets, labels and ends of sentences, and the name before it, J = or
// dx/dq = J =.
const INNER = String.raw`\{(?:[A-Za-z]*matrix\*?|array|tabular)\}`;
const [BEGIN, END] = ["begin", "end"].map((word) => new RegExp(String.raw`\\${word}${INNER}`, "g"));
const SET_BEFORE = new RegExp(
  String.raw`\\begin\{[a-z]+\*?\}|\\label\{[^{}]*\}` +
    String.raw`|\\(?:displaystyle|scriptsize|footnotesize|small|tiny|boxed)` +
    String.raw`|\\(?:(?:left|[bB]igg?l?)[ \t]*[\[(|.]|\[|\()` +
    String.raw`|[$&{ \t\r\n]`,
  "g",
);
const SET_AFTER = new RegExp(
  String.raw`\\end\{[a-z]+\*?\}|\\(?:label|tag)\{[^{}]*\}|\\(?:q?quad|nonumber|notag)(?![A-Za-z])` +
    String.raw`|\\(?:(?:right|[bB]igg?r?)[ \t]*[\])|.]|\]|\))|[$}.,; \t\r\n]`,
  "g",
);
// J =, or dx/dq = J =
const NAME = String.raw`(?:(?!\\[dt]?frac[0-9])[^-=0-9](?:(?!\\approx)[^=])*(?:=|\\approx))+`;
const [NAMES, NAMED] = [new RegExp(NAME, "g"), new RegExp(`^${NAME}$`)];
/** @type {[RegExp, string][]} */
const LATEX = [
  [/\\[hv]?phantom\{[^{}]*\}/g, " "],
  [/\\num\{([^{}]*)\}/g, "$1"],
  [/\{([-+])\}/g, "$1"],
  [/(?<=[0-9])\{,\}(?=[0-9])/g, "."],
];

// The text of the one matrix in it, without its name and what else is set beside it; an error for a
// factor.
function matrixAlone(text) {
  const [begins, ends] = [BEGIN, END].map((pattern) => [...text.matchAll(pattern)]);
  const single = begins.length === 1 && ends.length === 1;
  const matrix = single ? between(text, begins[0].index, ends[0].index + ends[0][0].length) : text;
  return LATEX.reduce((rest, [pattern, instead]) => rest.replace(pattern, instead), matrix);
}

function between(text, start, end) {
  let before = text.slice(0, start).replace(SET_BEFORE, "");
  let after = text.slice(end).replace(SET_AFTER, "");
  if (["()", "[]"].includes(before.slice(-1) + after.slice(0, 1)))
    [before, after] = [before.slice(0, -1), after.slice(1)];
  alone(text.slice(0, start), before.replace(NAMES, ""));
  alone(text.slice(end), after);
  const named = NAMED.test(before) || !/\d/.test(before); // "J =", or words above
  return text.slice(named ? start : 0, after ? text.length : end);
}
