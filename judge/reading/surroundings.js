// What stands around the numbers of a paste and says nothing about them: prompts, comments, fences, names,
// and what LaTeX sets beside a matrix.

import { ArmError, shown } from "../sentences.js";

const FENCE = /(?<![^\n])[ \t]*```[^\n\r]*/g;
const PROMPT = String.raw`(?<![^\n])[ \t]*(?:>>>?|(?:In|Out) ?\[[0-9]*\]:)[ \t]*`;
const ASKED = new RegExp(
  PROMPT +
    String.raw`(?:[A-Za-z_][A-Za-z0-9_]*|(?:print|disp|display)\([A-Za-z0-9_]*\))[ \t]*(?![^\n\r])`,
  "g",
);
const PROMPTED = new RegExp(PROMPT, "g");
const COMMENT = /((?<![^\n])|[;,\]]|\.\.\.|\\\\)[ \t]*(?:%|#(?![A-Z]+[/!?]))[^\n\r]*/g;
const REMARK = /(?<=[0-9.)])[ \t]+[#%][ \t]*[A-Za-z][^\n\r]*/g; // 50 % 20 % is none
const LABEL = /^[ \t\r\n]*[A-Za-z_][A-Za-z0-9_]*[ \t]*:[ \t\r\n]*(?=[[({])/;
const SIGN = /^[ \t\r\n]*=[ \t]*(?=[[({])/;

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
const NAME = String.raw`(?:(?!\\[dt]?frac[0-9])[^-=0-9](?:(?!\\approx)[^=])*(?:=|\\approx))+`; // J =, or dx/dq = J =
const [NAMES, NAMED] = [new RegExp(NAME, "g"), new RegExp(`^${NAME}$`)];
const FACTOR = new RegExp(
  String.raw`^(?:\\(?:[dt]?frac|cdot|times|ast|sqrt|pi|circ|degree)|[-+*/^0-9.,(){}°]` +
    String.raw`|(?<![A-Za-z])[A-Za-z](?:_[0-9A-Za-z])?(?![A-Za-z]))+$`,
);
/** @type {[RegExp, string][]} */
const LATEX = [
  [/\\[hv]?phantom\{[^{}]*\}/g, " "],
  [/\\num\{([^{}]*)\}/g, "$1"],
  [/\{([-+])\}/g, "$1"],
  [/(?<=[0-9])\{,\}(?=[0-9])/g, "."],
];

// A paste without what only stands around it.
export const bare = (text) =>
  straight(text)
    .replace(FENCE, "")
    .replace(COMMENT, "$1")
    .replace(REMARK, "")
    .replace(ASKED, "")
    .replace(PROMPTED, "")
    .replace(LABEL, "")
    .replace(SIGN, "");

// A text with the quotes that programs know, and without byte order marks.
export const straight = (text) =>
  text
    .replace(/[“”„‟]/g, '"')
    .replaceAll("\ufeff", "")
    .replace(/‘([^‘’\n]*)’/g, "'$1'");

// LaTeX without a name and what else is set beside its one matrix, and with its numbers as they are elsewhere; an error
// for a factor beside it.
export function bareLatex(text) {
  const [begins, ends] = [BEGIN, END].map((pattern) => [...text.matchAll(pattern)]);
  if (begins.length === 1 && ends.length === 1) {
    const [start, end] = [begins[0].index, ends[0].index + ends[0][0].length];
    let before = text.slice(0, start).replace(SET_BEFORE, "");
    let after = text.slice(end).replace(SET_AFTER, "");
    if (["()", "[]"].includes(before.slice(-1) + after.slice(0, 1)))
      [before, after] = [before.slice(0, -1), after.slice(1)];
    alone(text.slice(0, start), before.replace(NAMES, ""));
    alone(text.slice(end), after);
    const named = !before || NAMED.test(before);
    text = text.slice(named ? start : 0, after ? text.length : end);
  }
  for (const [pattern, instead] of LATEX) text = text.replace(pattern, instead);
  return text;
}

// An error where a factor stands beside a matrix: it is meant for every entry.
export function alone(stands, factor) {
  if (FACTOR.test(factor)) throw beside(stands);
}

// What is said where something that matters stands beside a matrix.
export const beside = (stands) =>
  new ArmError(`beside the matrix stands ${shown(stands.trim())}; expected entries that hold it`);
