// Decorations of a number: emphasis, a box, a colour, an approximate sign, an uncertainty, the mark
// of a footnote, a comment. They are taken off; the number keeps its place in the pasted text.

import { foldBlanks } from "./characters.js";

const NUMBER = String.raw`[-+]?(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eE][-+]?\d+)?`;
const UNITS_BEHIND = String.raw`[kmM]?N ?[-·*]?m{0,2}|rad|deg|°|\$\^\\circ\$|π|pi|mm?|cm`;
const QUANTITY = String.raw`${NUMBER}(?: ?(?:${UNITS_BEHIND}))?`;
const BEFORE = String.raw`(?<=^|[\s|&,;:=[({>$])`;
const AFTER = String.raw`(?=$|[\s|&,;:.\])}<$])`;
const EMPHASIS = "\\*{1,3}|_{1,2}|`|'";

const UNIT =
  String.raw`Newton-?met(?:er|re)s?|[kmM]?N\s?[-·*.⋅]?\s?m{0,2}|rad(?:ians?)?|deg(?:rees?)?|` +
  String.raw`°|mm?|cm|m\/s|rad\/s`;
const SIUNITX = { newton: "N", metre: "m", meter: "m", radian: "rad", degree: "deg", milli: "m" };
const SUPERSCRIPTS = "⁻⁺⁰¹²³⁴⁵⁶⁷⁸⁹";
const TIMES_POWER =
  String.raw`(?<=\d)[ \t]*(?:\\times|\\cdot|[×·⋅∙*x])[ \t]*10[ \t]*` +
  String.raw`(?:\^\s*[({]?[ \t]*([-+]?\d{1,2})(?:[ \t]*[)}])?(?![\d.])|([${SUPERSCRIPTS}]{1,3}))`;

const lowerDigits = (raised) =>
  [...raised].map((digit) => "-+0123456789"[SUPERSCRIPTS.indexOf(digit)]).join("");

function shortUnit(unit) {
  const letters = unit.replace(/\\([a-z]+)/g, (all, word) => SIUNITX[word] ?? all);
  return letters.replace(/[.\s\\~]/g, "");
}

// x ± u, where u is small or a few of x's last places; another ± stands for two numbers, as in
// 0.3 ± 0.1, which may be 0.4 and 0.2.
function withoutUncertainty(all, x, unit = "", uncertainty) {
  const decimals = x.split(/[.,]/)[1]?.length ?? 0;
  const most = Math.max(SMALL, decimals > 1 ? 20 * 10 ** -decimals : 0);
  return Number(uncertainty.replace(",", ".")) <= most ? x + unit : all;
}

const SMALL = 0.001; // rad or N m: no two solutions lie as near

const FACES = "math(?:bf|it|rm)|boldsymbol|text(?:bf|it)?|boxed|underline|num";

// Text in braces, which may hold braces.
const BRACED = String.raw`\{((?:[^{}\n]|\{[^{}\n]{0,60}\}){0,80})\}`;
// The same, three braces deep.
const INNER = String.raw`((?:[^{}\n]|\{(?:[^{}\n]|\{[^{}\n]{0,60}\}){0,60}\}){0,80})`;
// (corrected), (was 2.075), but (rad)
const REMARK = String.raw`\((?!\s*(?:${UNIT}|pi)\s*\))[A-Za-z][^()\n]{0,30}\)(?![ ]?[*/^+-])`;

const UNCERTAIN =
  String.raw`((?<![\d.,])\d{1,9}(?:[.,]\d{0,20})?|(?<=,)\d{1,9}\.\d{1,20}|` +
  String.raw`(?<!\d)[.,]\d{1,20}|π|\\pi)((?:[ ]?(?:π|\\?pi))?(?:[ ]?(?:${UNIT}))?)` +
  String.raw`\s*(?:±|\\pm(?![a-z])|\+\/-)\s*(\d*[.,]\d+)`;

// Behind a value, but not behind "1", which may be a name.
const BEHIND_VALUE =
  String.raw`(?<![\p{L}_]\d{1,2}[ ]?)(?<=(?:[.,]\d{0,22}|(?<![\d.])0)` +
  String.raw`(?:e[-+]?\d{1,2})?[ ]?π?)`;
// A star, an exclamation mark or an arrow behind a value, at its cell's end or before its unit.
const MARK_BEHIND =
  String.raw`(?<=[\d\])}°mπ])(?:[*!]|[ ]*<-+)` +
  String.raw`(?=[ ]*(?:$|[,;\t|&"\]])|[ ]{2,}|[ ]and\b|\.\s|[ ]?(?:k?N|rad))`;

/** @type {any[][]} */
const DECORATIONS = [
  [/(?<=10)<sup>\s*([-+]?\d{1,2})\s*<\/sup>/gi, "^$1"],
  [/<sup>\s*[\w*†‡]\s*<\/sup>/gi, ""],
  [/<\/?(?:b|i|u|em|strong|code|span|mark|sub|p|div|pre|br)\b[^<>\n]{0,80}>/gi, ""],
  [/\\(?:phantom|cancel)\{[^{}\n]*\}/g, " "],
  [new RegExp(String.raw`\{\\color\{\w+\}\s*${INNER}\}`, "g"), "$1"],
  [/\\(?:SI|qty)\{([^{}\n]*)\}\{([^{}\n]*)\}/g, (_, x, unit) => `${x} ${shortUnit(unit)}`],
  [new RegExp(String.raw`\\(?:${FACES}|textcolor\{\w+\})${BRACED}`, "g"), "$1"],
  [new RegExp(TIMES_POWER, "g"), (_, power, raised) => `e${power ?? lowerDigits(raised)}`],
  [/(?:≈|≅|\\approx(?![a-z]))\s*(?=[-+]?[\p{L}\d.\\])/gu, " "],
  [new RegExp(UNCERTAIN, "g"), withoutUncertainty],
  [
    /(?<=[\w°π)}*])(?:(?:\\[,;:! ])?[ ]*(?:[✓✔✅☑†‡§]|\\checkmark)(?!\w)|\[\^\w{1,3}\]|\^\{\*\})/g,
    "",
  ],
  // The uncertainty of 0.3768(12), or the number of a footnote.
  [
    new RegExp(
      String.raw`(?<=\d\.\d{1,18}|(?<![A-Za-z])\d[ ]?(?:${UNIT}))\(\d{1,2}\)(?!\s*[*/^])`,
      "g",
    ),
    "",
  ],
  [/(?<=\d)\^(?:\{?\(?[a-d]\)?\}?(?!\w)|\{\(\d\)\})/g, ""],
  [/(?<=[\d)][ \t]+)-(?=[ \t]*$)/gm, ""], // an empty cell at a row's end
  [new RegExp(`${BEFORE}(${EMPHASIS}) ?(${QUANTITY}) ?\\1${AFTER}`, "gm"), "$2"],
  [/(?<=[|&][ \t]*)(\*{1,3}|_)([^*|&\n]{1,40})\1(?=[ \t]*[|&])/g, "$2"], // an emphasised cell
  [new RegExp(MARK_BEHIND, "gm"), ""],
  [new RegExp(String.raw`(?<=(?:\d|°)(?:[ ]?(?:${UNIT}|π|pi))?)[ ]*${REMARK}`, "g"), ""],
  // a corrected value
  [/(?<![\w.])[-+]?\d{1,9}[.,]\d{1,20}\s*(?:→|->)\s*(?=[-+]?(?:[\d.θ]|theta))/g, ""],
  [new RegExp(String.raw`${BEHIND_VALUE}[ \t]*\[\s*(${UNIT})\s*\]`, "gu"), " $1"], // 0.5 [rad]
  // A unit behind a name belongs to the name: it is no list.
  [
    new RegExp(String.raw`(?<=[\p{L}\p{N})\]}$])[ \t]*[[(]\s*(${UNIT})\s*[\])]`, "gu"),
    (_, unit) => `_(${unit.replace(/[-\s·*.⋅]/g, "")})`,
  ],
];

/**
 * Take decorations off.
 * @param {import("./spans.js").SpannedText} text
 */
export function withoutDecorations(text) {
  const once = (decorated) =>
    DECORATIONS.reduce((rest, [pattern, instead]) => rest.replace(pattern, instead), decorated);
  return once(once(withoutTildes(text))); // twice: one within another
}

const NEGATIVE = /(?:^|[\s|&,;:=[({~])-\s?[\d.]/m;

// ~ before numbers says that they are rounded, if others show that a minus is typed as a minus.
const withoutTildes = (text) =>
  NEGATIVE.test(text.text) ? text.replace(/~[ ]?(?=[-+]?[\d.])/g, " ") : text;

const QUOTATION = /^(?:[ \t]*>(?!>)[ \t]?)+/gm; // > before each line

/**
 * Take off what stands before each line: the marks of a quotation, line numbers.
 * @param {import("./spans.js").SpannedText} pasted
 */
export const withoutMargins = (pasted) => withoutLineNumbers(pasted.replace(QUOTATION, ""));

const LINE_NUMBER = /^[ \t]*(\d{1,3})(?:[ \t]*[|:] ?|\t| {2}|$)/;

// The numbers of lines, where all lines have one and there is other text than rows of numbers.
function withoutLineNumbers(text) {
  const lines = text.text.split("\n").filter((line) => line.trim());
  const numbers = lines.map((line) => Number(LINE_NUMBER.exec(line)?.[1]));
  if (lines.length < 3 || numbers.some((number, k) => number !== k + 1)) return text;
  return text.replace(new RegExp(LINE_NUMBER.source, "gm"), "");
}

const NUMBERED = new RegExp(
  String.raw`^([ \t]*)(?:\((\d{1,2})\)|\[(\d{1,2})\]|(\d{1,2})[).]|#(\d{1,2})[.:)]?)` +
    String.raw`[ \t]+(?=[-+(["'\d.])`,
);

/**
 * Write the numbers of numbered lines, (1) 0.5, as labels, 1: 0.5.
 * @param {import("./spans.js").SpannedText} text
 */
export function labelNumberedLines(text) {
  const numbers = text.text.split("\n").flatMap((line) => {
    const match = NUMBERED.exec(line);
    return match ? [Number(match.slice(2).find(Boolean))] : [];
  });
  if (numbers.length < 2 || numbers[0] > 1) return text;
  if (numbers.some((number, k) => number !== numbers[0] + k)) return text;
  const pattern = new RegExp(NUMBERED.source, "gm");
  return text.replace(pattern, (_, blanks, ...groups) => `${blanks}${groups.find(Boolean)}: `);
}

const STRUCK = /~~[^~\n]{1,300}~~|<s>[^<>\n]{1,300}<\/s>/g;
const COMMENTS = [
  /(?<=[\d\])°m][ ]*)#[ ]?[a-z]{2,12}(?=[ ]*(?:[\t|&;,]|$))/gm, // in a cell
  STRUCK,
  /^[ \t>]*(?:(?:page|p\.)[ \t]*\d{1,3}(?:[ \t]*of[ \t]*\d{1,3})?|- \d{1,3} -)[ \t]*$/gim,
  /^[ \t]*(?:def \w+\(|return |import \w|from \w+ import ).*$/gm, // code
  // A comment with a number; #1 numbers a line, and # q1 q2 q3 may be the column headers.
  /^[ \t]*(?:#(?!\d)|%|\/\/).*\d[.,]\d.*$/gm,
  /(?<=(?:[\d\])},;°m*π]|pi)[ \t]+)(?:#(?!\d)|%|\/\/|<-(?!-*[ ]*[,;|&\t]|[\d.])).*$/gm,
];

const blank = (comment) => comment.replace(/[^\n]/g, " ");

/**
 * Take text out that was struck through.
 * @param {import("./spans.js").SpannedText} pasted
 */
export const withoutStruckText = (pasted) => pasted.replace(STRUCK, blank);

/**
 * Take comments and struck text out; null where there are none.
 * @param {import("./spans.js").SpannedText} pasted
 */
export function withoutComments(pasted) {
  const text = foldBlanks(pasted);
  const rest = COMMENTS.reduce((kept, pattern) => kept.replace(pattern, blank), text);
  return rest === text ? null : rest;
}
