// Removes text around a number that does not change it, such as emphasis, a box, ≈, an uncertainty,
// a footnote mark and a comment. The number keeps its position in the pasted text.

import { foldCharacters, ROW_END } from "./characters.js";
import { withoutRepeatedUnits } from "./repetitions.js";
import { UNIT } from "./units.js";
import { ArmError, formatMessage, quoteText } from "../sentences.js";

const NUMBER = String.raw`[-+]?(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eE][-+]?\d+)?`;
const QUANTITY = String.raw`${NUMBER}(?: ?(?:${UNIT}|π|pi))?`;
const BEFORE = String.raw`(?<![^\s|&,;:=[({>$])`;
const AFTER = String.raw`(?![^\s|&,;:.\])}<$])`;
const EMPHASIS = `\\*{1,3}|_{1,2}|"|'`;

const SMALL = 0.001; // rad or N m: two different solutions are further apart

// Remove the uncertainty u of x ± u, if it is small or changes only the last decimal places of x.
// If u is large, as in 0.3 ± 0.1, the text may mean the two numbers 0.4 and 0.2: nothing changes.
function withoutUncertainty(all, decimals = "", unit = "", bare, bracketed) {
  const most = Math.max(SMALL, decimals.length > 1 ? 20 * 10 ** -decimals.length : 0);
  return Number((bare ?? bracketed).replace(",", ".")) <= most ? unit : all;
}

const UNCERTAINTY =
  String.raw`(?<=[.,](\d{1,20})|\d)((?: ?π)?(?: ?${UNIT})?)` +
  String.raw`\s*(?:(?:±|\+\/-)\s*(\d*[.,]\d+)(?:\2)?` +
  String.raw`|\(\s*(?:±|\+\/?-)\s*(\d*[.,]\d+)\s*\))`;

// LaTeX commands that set their argument, and the argument, which may hold braces.
const SETTING_COMMANDS = "(?:math|text)(?:bf|it|rm)?|boldsymbol|boxed|underline|num";
const SET_ARGUMENT =
  String.raw`(?:\\(?:${SETTING_COMMANDS}|textcolor\{\w+\})\{|\{\\color\{\w+\}\s*)` +
  String.raw`((?:[^{}\n]|\{[^{}\n]{0,60}\}){0,80})\}`;

// Remarks in brackets, (corrected) and (was 2.075), but neither (rad) nor (a_2 c_2 + a_3), nor one
// with two numbers, which may be entries.
const REMARK =
  String.raw`\((?!(?:${UNIT}|pi) ?\))(?![^()\n]*(?:[A-Za-z]\d|\d\s+[-+]?[\d.]))` +
  String.raw`[A-Za-z][^()\n*/+^_{}=]{0,30}\)(?! ?[*/^+-])`;

// A name directly before a bracket. The bracket is no remark, but an argument, as in atan2(y, x),
// or a factor.
const NAME = String.raw`[A-Za-z]_?\d{1,2}(?=\()`;

// A joint variable that is locked, q3 (locked at 0). This remark stays in the text.
const LOCKED = String.raw`(?<=[A-Za-zθ]_?\d) *\((?:locked|fixed)\b`;

// The end of a value with decimals. The end of "1" is left out, since 1 may be a name.
const END_OF_VALUE =
  String.raw`(?<![\p{L}_]\d{1,2} ?)(?<=(?:[.,]\d{1,22}|(?<![\d.])0)` +
  String.raw`(?:e[-+]?\d{1,2})? ?π?)`;
// A star, an exclamation mark or an arrow behind a value, at the end of its cell or before its
// unit.
const MARK_BEHIND =
  String.raw`(?<=[\d\])}°mπ])(?:[*!]|[ ]*<-+)` +
  String.raw`(?=[ ]*(?:$|[,;\t|&"\]])|[ ]{2,}|[ ]and\b|\.\s|[ ]?${UNIT}(?![\w.]))`;
const FOOTNOTE_MARK =
  String.raw`(?<=[\w°π)}*])(?:(?:\\[,;:! ])?[ ]*[✓✔✅☑†‡§](?!\w)|\[\^\w{1,3}\]|\^\{\*\}|` +
  String.raw`(?<=\d)\^(?:\{?\(?[a-d]\)?\}?(?!\w)|\{\(\d\)\})|<sup>\s*[\w*†‡]\s*<\/sup>)`;

// Other elements of a web page.
const TAG =
  /<\/?(?:tr|thead|tbody|table|b|i|u|em|strong|code|span|mark|sub|p|div|br)\b[^<>\n]{0,80}>/gi;

/** @type {any[][]} */
const DECORATIONS = [
  [/(?<=10)<sup>\s*([-+]?\d{1,2})\s*<\/sup>/gi, "^$1"],
  [new RegExp(FOOTNOTE_MARK, "g"), ""],
  [/<\/?t[dh]\b[^<>\n]{0,80}>/gi, " | "], // a cell of a web page
  [/<\/tr>/gi, ROW_END],
  [TAG, ""],
  [/\\ang\{([^{}\n;]*)\}/g, "$1 deg"],
  [/\\(?:SI|qty)\{([^{}\n]*)\}\{([^{}\n]*)\}/g, "$1 $2"],
  [new RegExp(SET_ARGUMENT, "g"), "$1"],
  [
    /(?<=\d)[ \t]*[×·*x][ \t]*10[ \t]*\^\s*[({]?[ \t]*([-+]?\d{1,2})(?:[ \t]*[)}])?(?!\.?\d)/g,
    "e$1",
  ],
  [/≈\s*(?=[-+]?(?:[\p{L}\d.\\]|,\d))/gu, " "],
  [new RegExp(UNCERTAINTY, "g"), withoutUncertainty],
  // The uncertainty of 0.3768(12), or the number of a footnote.
  [
    new RegExp(
      String.raw`(?<=\d\.\d{1,18}|(?<![A-Za-z])\d[ ]?${UNIT})\(\d{1,2}\)(?!\s*[*/^])`,
      "g",
    ),
    "",
  ],
  [/(?<=[\d)][ \t]+)-(?=[ \t]*$)/gm, ""], // an empty cell at a row's end
  [new RegExp(`${BEFORE}(${EMPHASIS}) ?(${QUANTITY}) ?\\1${AFTER}`, "g"), "$2"],
  [/(?<=[|&][ \t]*)(\*{1,3}|_)([^*|&\n]{1,40}\*?)\1(?=[ \t]*[|&])/g, "$2"], // an emphasised cell
  [new RegExp(MARK_BEHIND, "gm"), ""],
  [
    new RegExp(
      String.raw`(?<=\d(?:[ ]?[*·]?[ ]?(?:${UNIT}|π|pi))?)(?<!${NAME})(?!${LOCKED}) *${REMARK}`,
      "g",
    ),
    "",
  ],
  // a corrected value
  [/(?<![\w.])[-+]?\d{1,9}[.,]\d{1,20}\s*(?:→|->)\s*(?=[-+]?[\d.θ])/g, ""],
  [new RegExp(String.raw`${END_OF_VALUE}[ \t]*\[\s*(${UNIT})\s*\]`, "gu"), " $1"], // 0.5 [rad]
  [/(?<=\p{L})[ ][[(][-1][\])](?=[ ]*[\t|&])/gu, ""], // wx [-], without a unit
  // The unit behind a name, tau [Nm], is joined to the name: it is no list.
  [new RegExp(String.raw`(?<=[\p{L}\p{N})\]}$])[ \t]*[[(]\s*(${UNIT})\s*[\])]`, "gu"), "_($1)"],
];

/**
 * Remove decorations.
 * @param {import("./spans.js").SpannedText} text
 */
export function withoutDecorations(text) {
  const once = (decorated) =>
    DECORATIONS.reduce(
      (rest, [pattern, replacement]) => rest.replace(pattern, replacement),
      decorated,
    );
  const bare = once(withoutRepeatedUnits(withoutTildes(text)));
  return withoutRepeatedUnits(once(bare)); // again, for a decoration within a decoration
}

const NEGATIVE = /(?<![^\s|&,;:=[({~])-\s?[\d.]/;

// Remove the ~ before rounded numbers. If the text has no minus, the ~ stays: it may be the minus.
const withoutTildes = (text) =>
  NEGATIVE.test(text.text) ? text.replace(/~[ ]?(?=[-+]?[\d.])/g, " ") : text;

const QUOTATION = /^(?:[ \t]*>(?!>)[ \t]?)+/gm; // > before each line

// Lines that declare symbols in MATLAB and SymPy: syms q1 q2 and q1, q2 = symbols("q1:3").
const SYMBOLS = String.raw`[\w, \t]{1,80}=[ \t]*(?:\w+\.)?symbols\([^()\n]*\)`;
const DECLARATION = new RegExp(
  String.raw`^[ \t]*(?:syms[ \t][\w \t]{1,200}|${SYMBOLS})[ \t]*;?[ \t]*$`,
  "gm",
);

/**
 * Remove the > of quoted lines, the line numbers and declarations of symbols.
 * @param {import("./spans.js").SpannedText} pasted
 */
export const withoutMargins = (pasted) =>
  withoutLineNumbers(pasted.replace(QUOTATION, "").replace(DECLARATION, ""));

// A name for a factor, as in "dtr = pi/180".
const FACTOR = new RegExp(
  String.raw`^[ \t]*([A-Za-z]{2,9})[ \t]*=[ \t]*` +
    String.raw`((?:\w{1,9}\.)?pi ?\/ ?180(?:\.0)?|\d[\d.e-]{0,9})[ \t]*;?[ \t]*$`,
  "gm",
);

/**
 * Write factors in place of their names: 90*dtr becomes 90*(pi/180).
 * @param {import("./spans.js").SpannedText} pasted
 * @throws {ArmError} if a used name has two values
 */
export function replaceFactorNames(pasted) {
  const factors = [...pasted.text.matchAll(FACTOR)];
  return factors.reduce((text, [line, name, value]) => {
    const replaced = text.replace(
      new RegExp(String.raw`(?<=\d ?\* ?)${name}(?!\w)`, "g"),
      `(${value})`,
    );
    const other = factors.find((factor) => factor[1] === name && factor[2] !== value);
    if (replaced === text || !other) return replaced;
    const lines = [line, other[0]].map((each) => quoteText(each.trim()));
    throw new ArmError(formatMessage("two factors", { one: lines[0], other: lines[1] }));
  }, pasted);
}

const LINE_NUMBER = /^[ \t]*(\d{1,3})(?:[ \t]*[|:] ?|\t| {2}|$)/gm;

// Remove the numbers of lines if all lines have a number and the numbers count from 1.
function withoutLineNumbers(text) {
  const lines = text.text.split("\n").filter((line) => line.trim());
  const lineNumbers = listNumbers(text, LINE_NUMBER);
  const isNumbered =
    lineNumbers.length === lines.length && lineNumbers[0] === 1 && countUp(lineNumbers);
  return lines.length > 2 && isNumbered ? text.replace(LINE_NUMBER, "") : text;
}

const listNumbers = ({ text }, pattern) =>
  [...text.matchAll(pattern)].map((match) => Number(match.filter(Boolean).at(-1)));

const countUp = (numbers) => numbers.every((number, k) => number === numbers[0] + k);

// [1], (1), 1) and 1.; [1. begins a row of NumPy.
const ENUMERATOR = /^([ \t]*)(?:\[(\d{1,2})\]|\(?(\d{1,2})\)|(\d{1,2})\.)[ \t]+(?=[-+(["'\d.])/gm;

/**
 * Write the numbers of numbered lines as labels: "(1) 0.5" becomes "1: 0.5".
 * @param {import("./spans.js").SpannedText} text
 */
export function labelNumberedLines(text) {
  const lineNumbers = listNumbers(text, ENUMERATOR);
  if (lineNumbers.length < 2 || lineNumbers[0] > 1 || !countUp(lineNumbers)) return text;
  return text.replace(ENUMERATOR, "$1$2$3$4: ");
}

const STRUCK = /~~[^~\n]{1,300}~~|<s>[^<>\n]{1,300}<\/s>|\\(?:phantom|cancel)\{[^{}\n]*\}/g;
const COMMENTS = [
  /(?<=[\d)°m*][ ]*)#[ ]?[a-z]{2,12}(?=[ ]*(?:[\t|&;,]|$))/gm, // in a cell
  STRUCK,
  /^[ \t>]*(?:(?:page|p\.)[ \t]*\d{1,3}(?:[ \t]*of[ \t]*\d{1,3})?|- \d{1,3} -)[ \t]*$/gim,
  /^[ \t]*(?:def \w+\(|return ).*$/gm, // code
  // A comment with a number; #1 is the number of a line, and # q1 q2 q3 may be the column headers.
  /^[ \t]*(?:#(?!\d)|%|\/\/).*\d[.,]\d.*$/gm,
  /(?<=(?:[\d\])},;:°m*π]|rad|deg)[ \t]+)(?:#(?!\d)|%|\/\/|<-(?!-*[ ]*[,;|&\t°]|\.?\d)).*$/gm,
];

const blank = (comment) => comment.replace(/[^\n]/g, " ");

// Runs of 200 blanks or of a repeated mark, as "- - - -". Some patterns look back over the whole
// run at each character, so a long run would take very long.
const LONG_BLANK = /([^\S\r\n]{200})[^\S\r\n]+/g;
const LONG_RULE = /(([^\p{L}\p{N}\s][ \t]?)\2{199})\2+/gu;

/**
 * Replace struck-out text by blanks, and shorten long runs of blanks or of the same mark.
 * @param {import("./spans.js").SpannedText} pasted
 */
export const withoutStruckText = (pasted) =>
  pasted.replace(STRUCK, blank).replace(LONG_BLANK, "$1").replace(LONG_RULE, "$1");

/**
 * Replace comments and struck-out text by blanks. Return null if there are none.
 * @param {import("./spans.js").SpannedText} pasted
 */
export function withoutComments(pasted) {
  const text = foldCharacters(pasted);
  const rest = COMMENTS.reduce((kept, pattern) => kept.replace(pattern, blank), text);
  return rest === text ? null : rest;
}
