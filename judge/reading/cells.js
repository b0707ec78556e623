// Splits a line of text into cells, and turns units into factors: "5 mm" becomes "5*1e-3".

import { isFunction } from "./formula.js";
import { findFactor, isDegree } from "./units.js";

/** @typedef {import("./spans.js").Span} Span */
/**
 * A cell in plain characters, with its unit as a factor. A word also has its line, and a header may
 * have its label.
 * @typedef {Span & { text: string, line?: number,
 *   label?: import("./labels.js").Label, stretches?: Span[] }} Cell
 */
/**
 * The rules for splitting a text. `wrapped` makes a single row of each innermost list, even over
 * several lines. `decimal` makes commas between digits decimal commas. `gaps` separates entries at
 * two or more blanks only.
 * @typedef {{ wrapped: boolean, decimal: boolean, gaps: boolean }} Splitting
 */

export const OPEN = "[({";
export const CLOSE = "])}";

/**
 * Split a part of a text at the separators outside brackets. An assignment mark, such as = or :,
 * becomes a piece of its own.
 * @param {string} text @param {number} from @param {number} to
 * @param {(at: number) => string} separatorAt returns the separator at a position or ""
 * @returns {Span[]}
 */
export function splitOutsideBrackets(text, from, to, separatorAt) {
  const parts = [];
  let [depth, start] = [0, from];
  for (let at = from; at < to; at++) {
    if (OPEN.includes(text[at])) depth++;
    else if (CLOSE.includes(text[at])) depth = Math.max(0, depth - 1);
    const separator = depth ? "" : separatorAt(at);
    if (!separator) continue;
    parts.push({ from: start, to: at });
    if (isMark(separator)) parts.push({ from: at, to: at + separator.length });
    at += separator.length - 1;
    start = at + 1;
  }
  parts.push({ from: start, to });
  return parts;
}

const TIME_STAMPS = [/^\d{9,}\.\d+$/, /^\d{4}-\d\d-\d\d/, /^\d{1,2}[/.]\d{1,2}[/.]\d{2,4}$/];
export const isTimeStamp = (text) => TIME_STAMPS.some((pattern) => pattern.test(text));

// Write a unit as a factor to SI, or as " deg". Return undefined if the word is no unit.
function convertUnit(word) {
  const unit = word.replace(/[-·*. ]/g, "");
  if (isDegree(unit)) return " deg";
  const factor = findFactor(unit);
  return factor === 1 ? "" : factor && `*1e${Math.round(Math.log10(factor))}`;
}

/**
 * Return whether a word is a unit of a length, an angle, a force or a moment.
 * @param {string} word
 */
export const isUnit = (word) => convertUnit(word) !== undefined;
const MEASURED =
  /^([-+]? ?[\d.,]+(?:e[-+]?\d+)?(?: ?(?:π|pi\b))?)\s*([A-Za-z°][-A-Za-z°·*⋅. ]{0,12})$/;

// Remove quotes and punctuation around a cell, and write its unit as a factor.
function cleanCell(text, { decimal }) {
  let cell = text.trim().replace(/^"|"$|"?[.,;]$/g, "");
  if (decimal) cell = cell.replace(/(?<=\d|^[-+]?),(?=\d)/g, ".");
  if (cell.includes("[")) cell = cell.replaceAll("[", "(").replaceAll("]", ")");
  const [, number, word = ""] = MEASURED.exec(cell) ?? [];
  const unit = convertUnit(word);
  return unit === undefined ? cell : `${number}${unit}`;
}

/**
 * Make a cell of a span of a text.
 * @param {Span} span @param {Splitting} splitting
 * @param {import("./spans.js").SpannedText} plain @returns {Cell}
 */
export function makeCell({ from, to }, splitting, plain) {
  const raw = plain.text.slice(from, to);
  const [start, end] = [from + raw.length - raw.trimStart().length, from + raw.trimEnd().length];
  const text = cleanCell(raw.replace(/\s+/g, " "), splitting);
  const span = plain.span(start, Math.max(start, end));
  return { text, ...span, stretches: plain.stretches(start, end) };
}

/**
 * Split a span of a text at blanks and commas into cells.
 * @param {Span} span @param {Splitting} splitting
 * @param {import("./spans.js").SpannedText} plain
 */
export function splitCells({ from, to }, splitting, plain) {
  const pieces = splitting.gaps
    ? splitAtGaps(plain.text, from, to)
    : joinPieces(splitPieces(plain.text, from, to, splitting), plain.text);
  return pieces.map((piece) => makeCell(piece, splitting, plain)).filter(({ text }) => text);
}

function splitAtGaps(text, from, to) {
  const pieces = [];
  let start = from;
  for (const gap of text.slice(from, to).matchAll(/, +|[ \t\v]{2,}/g)) {
    pieces.push({ from: start, to: from + gap.index });
    start = from + gap.index + gap[0].length;
  }
  return [...pieces, { from: start, to }].flatMap((piece) => splitOffMark(piece, text));
}

// Split "tau =" into the name and the assignment mark.
function splitOffMark(piece, text) {
  const [mark] = /(?<=\S\s*)=(?=\s*$)/.exec(text.slice(piece.from, piece.to)) ?? [];
  if (!mark) return [piece];
  const at = text.lastIndexOf(mark, piece.to - 1);
  return [
    { from: piece.from, to: at },
    { from: at, to: at + 1 },
  ];
}

const MARKS = [":=", "<<", "->", ":", "="]; // assignment marks
export const isMark = (text) => MARKS.includes(text);

// Split a text at blanks, commas and assignment marks outside brackets. A piece is `closed` if it
// ends at a comma.
function splitPieces(text, from, to, { decimal }) {
  const separatorAt = (at) => {
    if (/\s/.test(text[at]) || (text[at] === "," && !decimal)) return text[at];
    return markAt(text, at);
  };
  return splitOutsideBrackets(text, from, to, separatorAt)
    .filter((part) => part.to > part.from)
    .map((part) => ({ ...part, closed: text[part.to] === "," && !decimal }));
}

// Return the assignment mark at a position, or "". The colon of a clock time, 12:30, is no mark.
function markAt(text, at) {
  if (!"=:<-".includes(text[at])) return "";
  const mark = MARKS.find((each) => text.startsWith(each, at)) ?? "";
  return mark === ":" && CLOCK.test(text.slice(Math.max(0, at - 3), at + 4)) ? "" : mark;
}

const CLOCK = /(?:^|[^\p{L}\d_])\d{1,2}:\d\d(?![.\d])|:\d\d:\d/u;

// Join the pieces of an entry with blanks, such as "0.1 + 0.2" and "5 mm".
function joinPieces(pieces, text) {
  const joined = [];
  for (const piece of pieces) {
    const last = joined.at(-1);
    if (last && areOneEntry(last, piece, text))
      joined[joined.length - 1] = { ...piece, from: last.from };
    else joined.push(piece);
  }
  return joined;
}

const ENDS_WITH_OPERATOR = /[*/^]$|(?:^|\s)[-+±~]$/;
const BEGINS_WITH_OPERATOR = /^[*/^]|^[-+±]$/;
const FACTOR_END = /^ *(?:rad|[\t\n|&;,]|$)/; // behind the factor π of "0.5 π" no entry follows

const LONGEST_END = 40; // characters at the end of a piece that show whether the entry continues

// Return whether a piece continues the entry of the piece before it.
function areOneEntry(last, piece, text) {
  const before = text.slice(Math.max(last.from, last.to - LONGEST_END), last.to);
  const word = text.slice(piece.from, piece.to);
  if (last.closed || isMark(before) || isMark(word)) return false;
  if (ENDS_WITH_OPERATOR.test(before) || BEGINS_WITH_OPERATOR.test(word)) return true;
  if (isFunction(before.replace(/^[-+]+/, ""))) return true;
  if (/^(?:π|pi)$/.test(word) && piece.from === last.to + 1)
    return /\d[.,]\d+$/.test(before) && FACTOR_END.test(text.slice(piece.to));
  return isUnit(word) && /[\d.)](?: [km]?N)?$/.test(before);
}
