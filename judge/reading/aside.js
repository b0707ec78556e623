// What people write around their numbers: greetings, questions, captions, units, signatures and
// prompts. It is set aside where the rest stands by itself, and shown back.

import { ArmError, say, shown } from "../sentences.js";
import { plain } from "./formula.js";
import { headOf } from "./heads.js";
import { PROMPT } from "./surroundings.js";
import { lines } from "./text.js";

// Words that stand in answers themselves, in heads and labels, formulas and programs.
const OWN = new Set(
  (
    "alpha theta phi beta gamma psi joint joints link links row rows column columns through " +
    "to pi sin cos tan sind cosd asin acos atan arcsin arccos arctan sqrt abs deg rad degree " +
    "degrees radians mm cm np array matrix int offset type kind revolute prismatic fixed twist " +
    "length angle common normal inf nan nm dh variable var vx vy vz wx wy wz omega tau"
  ).split(" "),
);
const COMMENT = /^\s*(?:%|#(?![A-Z]+[/!?])|\/\/)/;
// Prompts and rules, and what pandas, R and Julia print around a matrix.
const EMPTY = new RegExp(
  String.raw`^\s*(?:${PROMPT}|--|[-–—_=*]{1,80}|(?:Name: \w+, )?dtype: \w+` +
    String.raw`|(?:\[,\d+\]\s*)+|\d+[×x]\d+ (?:Matrix|Array)\{.*\}:)?\s*$`,
);
const UNIT = String.raw`(?:N\s*[·*⋅.]?\s*mm?|mm?|cm|rad(?:ians?)?|deg(?:rees?)?|°|SI(?: units?)?)`;
const UNITS_ALONE = new RegExp(
  String.raw`^\s*[([]?\s*(?:in\s+|units?:?\s*)?${UNIT}` +
    String.raw`(?:\s*(?:,|and|/|;)\s*${UNIT})*\s*[)\]]?[.:]?\s*$`,
  "i",
);
const DATE =
  String.raw`(?:\d{1,2}\.\d{1,2}\.(?:\d{2}){1,2}|\d{1,2}/\d{1,2}/\d{4}|\d{4}-\d{2}-\d{2})` +
  String.raw`(?!\d)(?:,?\s+\d{1,2}:\d{2}(?!\d))?`;
const DATED = new RegExp(String.raw`^\s*${DATE}\s*$`);
const MARKUP = /[[\]{}\\&|│\t;]|=(?!.*[?!.]\s*$)/;
const WORDS = /\p{L}[\p{L}’'-]+/gu;
const NUMBERS = /(?<![\p{L}\p{N}_.])\d[\p{N}.,]*(?:e[-+]?\d+)?/giu;
// Numbers that only count, as in "Exercise 2 b" and "Table 1", and in the labels "Answer 2:".
const COUNTS = new RegExp(
  String.raw`(?:exercise|problem|tab(?:le)?|fig(?:ure)?|task|question|part|homework|hw|step` +
    String.raw`|solution|lösung|aufgabe|tabelle|eq|equation|joint|link` +
    String.raw`|axis|row|no|nr)\.?\s*#?\d{1,2}(?:\.\d)?(?![\d.]*\d)|(?:In|Out) ?\[\d*\]:` +
    String.raw`|\bround\(\d+\)|(?:answer|branch|case|set)\s*\d+(?=\s*[:.)])` +
    String.raw`|(?<![\d.])\d+[- ]?(?:joints?|axes|dof|links?|digits|decimals|element)(?!\p{L})` +
    String.raw`|(?<![\d.])${DATE}`,
  "giu",
);
// Numbers that programs and LaTeX set beside a matrix: its size, its columns, a common factor; and
// a_{i-1} in a table's heads.
const SET = new RegExp(
  String.raw`Columns?\s+\d+(?:\s+(?:through|to|and)\s+\d+)?|\[\d{1,2},\]|\[,\d{1,2}\]` +
    String.raw`|\d+[×x]\d+(?!\d)|\bi\s*-\s*1\b|^[ \t]*1(?:\.0+)?e[+-]?\d+[ \t]*\*[ \t]*$` +
    String.raw`|\\\\\s*\[[^\]]*\]` +
    String.raw`|\\(?:c(?:line|midrule)(?:\([^()]*\))?|label|tag)\{[^{}]*\}`,
  "gimu",
);
const SIGNED = /(?:(?<![\p{L}\p{N}.)\]}])[-−])?[\d.]*\d/gu; // with the sign that is its own
const DECIMALS = /(\bround\(.*),\s*\d+\s*\)+\s*[;.,]?\s*$/s; // that round() is given
// Runs of digits, and names, which hold digits too.
const TOKENS = /\d+|\p{L}[\p{L}\p{N}_]*(?:(?<=_)\{[\w+-]*\})?/giu;

const numbersIn = (text) => text.replace(COUNTS, " ").match(NUMBERS) ?? [];

// Whether a line is no row of an answer: prose, a comment, units, or an empty prompt.
function isAside(line) {
  if (isHeading(line)) return false;
  if ([EMPTY, COMMENT, UNITS_ALONE, DATED].some((is) => is.test(line))) return true;
  if (MARKUP.test(line)) return false;
  const words = (line.match(WORDS) ?? []).filter((word) => !OWN.has(word.toLowerCase()));
  const said = words.filter((word) => headOf(word) === undefined);
  return said.length > 0 && numbersIn(line).length < 3;
}

const isHeading = (line) =>
  new Set(
    line
      .split(/[\s,#]+/)
      .map(headOf)
      .filter(Boolean),
  ).size >= 4;

/**
 * A text without the lines around its numbers, and those that say something.
 * @param {string} text
 * @returns {{ text: string, left: string[] }}
 */
function setAside(text) {
  const { text: within, left } = withoutAsides(text);
  const told = left.map((line) => line.trim());
  return { text: within, left: told.filter((line) => !EMPTY.test(line)) };
}

// A text without the lines around its numbers, and those lines.
function withoutAsides(text) {
  const all = lines(text);
  const kept = all.map((line) => !isAside(line));
  const [first, last] = [kept.indexOf(true), kept.lastIndexOf(true)];
  if (first < 0) return { text, left: [] };
  const between = all.slice(first, last).filter((line, k) => !kept[first + k] && line.trim());
  const parting = between.find((line) => !EMPTY.test(line) && !COMMENT.test(line));
  if (parting) throw new ArmError(say("two grids", { between: shown(parting.trim()) }));
  const left = [...all.slice(0, first), ...between, ...all.slice(last + 1)];
  const within = all.slice(first, last + 1).filter((line, k) => kept[first + k] || !line.trim());
  return { text: within.join("\n"), left };
}

/**
 * The numbers of a text that stand in none of the entries that were read, and do not count its rows
 * or columns: whatever lost them, they are not lost unsaid.
 * @param {string} text
 * @param {string[]} entries as typed
 * @param {number[]} sizes how many rows and columns were read
 */
function unread(text, entries, sizes) {
  const held = entries.join(" & ");
  if (text.replace(/\D/g, "") === held.replace(/\D/g, "")) return [];
  const bare = text.replace(DECIMALS, "$1").replace(COUNTS, " ").replace(SET, " ");
  // as runs of digits, for commas may be decimal ones; shown are the numbers that hold them
  const lost = sizes
    .flatMap((size) => [size, size])
    .sort((p, q) => q - p)
    .reduce(uncounted, without(tokensOf(bare), tokensOf(held)));
  const isOf = (run) => (number) => !held.includes(number) && number.split(/\D/).includes(run);
  const numbers = bare.match(SIGNED) ?? [];
  return [...new Set(lost.map((run) => numbers.find(isOf(run)) ?? run))];
}

const tokensOf = (text) =>
  ((/[^\x20-\x7e\s]|[\\{]/.test(text) ? plain(text) : text).match(TOKENS) ?? []).filter((token) =>
    /\d/.test(token[0]),
  );

// What of a list is not in another, each taken once.
export function without(list, other) {
  const left = new Map();
  for (const one of other) left.set(one, (left.get(one) ?? 0) + 1);
  return list.filter((one) => {
    const count = left.get(one) ?? 0;
    left.set(one, count - 1);
    return count <= 0;
  });
}

// A list without the labels 0 to `size` - 1, or 1 to size, where all of them stand in it.
function uncounted(list, size) {
  const labels = [0, 1]
    .map((from) => Array.from({ length: size }, (_, k) => `${k + from}`))
    .find((all) => !without(all, list).length);
  return labels ? without(list, labels) : list;
}

/**
 * A judge of tables whose text may have words around it.
 * @param {(mine: any, reference: any, options?: any) => any} judge
 */
export const alone =
  (judge) =>
  (mine, reference, options = {}) => {
    if (typeof mine !== "string") return judge(mine, reference, options);
    const { text, left } = setAside(mine);
    const report = judge(text, reference, options);
    const lost = unread(text, report.table.entries, [report.table.rows.length]);
    return { ...report, left: [...left, ...lost] };
  };
