// What people write around their numbers: greetings, questions, captions, units, signatures and
// prompts. It is set aside where the rest stands by itself, and shown back.

import { ArmError, say, shown } from "../sentences.js";
import { headOf } from "./table_columns.js";
import { lines } from "./text.js";

// Words that stand in answers themselves, in heads and labels, formulas and programs.
const OWN = new Set(
  (
    "alpha theta phi beta gamma psi joint joints link links row rows column columns through " +
    "to pi sin cos tan sind cosd asin acos atan arcsin arccos arctan sqrt abs deg rad degree " +
    "degrees radians mm cm np numpy sp sympy math array asarray matrix matrices tensor begin " +
    "end bmatrix pmatrix vmatrix smallmatrix tabular hline toprule midrule bottomrule left " +
    "right frac dfrac tfrac cdot text mathrm quad dtype float int offset type kind revolute " +
    "prismatic fixed twist length angle common normal inf nan nm dh variable var vx vy vz wx " +
    "wy wz omega tau dhlink revolutedh prismaticdh seriallink dict list zeros eye vpa " +
    "simplify round double sym display print disp lambda return function def"
  ).split(" "),
);
const COMMENT = /^\s*(?:%|#(?![A-Z]+[/!?])|\/\/)/;
// Prompts and rules, and what pandas, R and Julia print around a matrix.
const EMPTY = new RegExp(
  String.raw`^\s*(?:>>>?|(?:In|Out) ?\[\d*\]:|--|[-–—_=*]{1,80}|(?:Name: \w+, )?dtype: \w+` +
    String.raw`|(?:\[,\d+\]\s*)+|\d+[×x]\d+ (?:Matrix|Array)\{.*\}:)?\s*$`,
);
const UNIT = String.raw`(?:N\s*[·*⋅.]?\s*mm?|mm?|cm|rad(?:ians?)?|deg(?:rees?)?|°|SI(?: units?)?)`;
const UNITS_ALONE = new RegExp(
  String.raw`^\s*[([]?\s*(?:in\s+|units?:?\s*)?${UNIT}` +
    String.raw`(?:\s*(?:,|and|/|;)\s*${UNIT})*\s*[)\]]?[.:]?\s*$`,
  "i",
);
const MARKUP = /[[\]{}\\&|│\t;]|=(?!.*[?!.]\s*$)/;
const WORDS = /\p{L}[\p{L}’'-]+/gu;
const NUMBERS = /(?<![\p{L}\p{N}_.])\d[\p{N}.,]*(?:e[-+]?\d+)?/giu;
// Numbers that only count, as in "Exercise 2 b" and "Table 1".
const COUNTS = new RegExp(
  String.raw`(?:exercise|problem|tab(?:le)?|fig(?:ure)?|task|question|part|homework|hw|sheet|step` +
    String.raw`|solution|assignment|aufgabe|tabelle|chapter|section|eq|equation|joint|link|no|nr` +
    String.raw`|#)\.?\s*#?\d+(?:\.\d+)*|(?:In|Out) ?\[\d*\]:` +
    String.raw`|\d+[- ]?(?:joints?|axes|dof|links?|digits|decimals)(?!\p{L})`,
  "giu",
);

const numbersIn = (text) => text.replace(COUNTS, " ").match(NUMBERS) ?? [];

// Whether a line is no row of an answer: prose, a comment, units, or an empty prompt.
function isAside(line) {
  if (isHeading(line)) return false;
  if (EMPTY.test(line) || COMMENT.test(line) || UNITS_ALONE.test(line)) return true;
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
export function setAside(text) {
  const all = lines(text);
  const kept = all.map((line) => !isAside(line));
  const [first, last] = [kept.indexOf(true), kept.lastIndexOf(true)];
  if (first < 0) return { text, left: [] };
  const between = all.slice(first, last).filter((line, k) => !kept[first + k] && line.trim());
  const parting = between.find((line) => !EMPTY.test(line) && !COMMENT.test(line));
  if (parting) throw new ArmError(say("two grids", { between: shown(parting.trim()) }));
  const left = [...all.slice(0, first), ...between, ...all.slice(last + 1)];
  const within = all.slice(first, last + 1).filter((line, k) => kept[first + k] || !line.trim());
  return {
    text: within.join("\n"),
    left: left.map((line) => line.trim()).filter((line) => !EMPTY.test(line)),
  };
}

// Whether numbers stand in what was set aside.
export const holdsNumbers = (left) => left.some((line) => numbersIn(line).length > 0);
