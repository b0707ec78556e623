// Finds unread text in a table whose entries have names. It may be a misspelt name, as in
// {'a': 0, 'alhpa': 90}, or a whole row.

import { listLines } from "./spans.js";

/** @typedef {import("./spans.js").Span} Span */
/** @typedef {import("./table_named_entries.js").Bracket} Bracket */
/**
 * A row. `part` is its span, and `body` the span inside its brackets. `uses` are the spans of its
 * names and entries. `isWhole` is true if it has all four entries.
 * @typedef {{ part: Span, body: Span, uses: Span[], isWhole: boolean }} NamedRow
 */

const FEWEST_NUMBERS = 3; // with fewer numbers, text beside the rows is no row
const PREFIX = 2; // two lines of rows begin with the same two characters

// Names in calls and dictionaries that are no entries, as in Link(d=0.3, qlim=[-2, 2]).
const OTHER_NAME =
  "name|type|kind|joint(?:_?type)?|link|i|index|id|qlim|limits?|mdh|flip|m|mass|r|I|G|B|Jm|Tc";
const OTHER_PAIR = new RegExp(
  String.raw`(?<![\p{L}\p{N}_])(['"]?)(?:${OTHER_NAME})\1\s*[:=,]\s*` +
    String.raw`(?:\[[^\]]*\]|[^,;\n]*)`,
  "gu",
);
const KIND = /(['"])(?:revolute|prismatic|standard|modified)\1/gi;

/**
 * Find the first unused text that may be an entry within a row, or a row beside the other rows.
 * @param {string} text
 * @param {NamedRow[]} rows
 * @param {Bracket[]} brackets of the text
 * @returns {Span | null}
 */
export function findUnusedText(text, rows, brackets) {
  for (const row of rows) {
    const piece = row.isWhole ? null : findUnusedPiece(text, row);
    if (piece) return piece;
  }
  return rows.length ? findUnusedRow(text, rows, brackets) : null;
}

// Find the first text between commas within a row that no entry used.
/** @param {string} text @param {NamedRow} row @returns {Span | null} */
function findUnusedPiece(text, { body, uses }) {
  const characters = [...text.slice(body.from, body.to).split("")];
  for (const { from, to } of uses) characters.fill(" ", from - body.from, to - body.from);
  const blank = (other) => " ".repeat(other.length);
  const rest = characters.join("").replace(KIND, blank).replace(OTHER_PAIR, blank);
  for (const { 0: piece, index } of rest.matchAll(/[^,;\n]+/g)) {
    const trimmed = piece.trim();
    const from = body.from + index + piece.indexOf(trimmed);
    if (/[\p{L}\d]/u.test(trimmed)) return { from, to: from + trimmed.length };
  }
  return null;
}

// Find text between the rows or beside them that may be a row. It stands on a line of the rows, or
// on the next line if that begins like the first row or closes a bracket.
/** @param {string} text @param {NamedRow[]} rows @param {Bracket[]} brackets */
function findUnusedRow(text, rows, brackets) {
  const parts = rows.map(({ part }) => part).sort((one, other) => one.from - other.from);
  const [first, last] = [parts[0], parts.at(-1)];
  const lines = listLines(text);
  const [start, end] = [first.from, last.to].map((at) => lines.findIndex(({ to }) => at <= to));
  const readPrefix = ({ text: line }) => line.replace(/[\d\s]/g, "").slice(0, PREFIX);
  const isBeside = (line) => line && readPrefix(line) === readPrefix(lines[start]);
  const [above, below] = [lines[start - 1], lines[end + 1]];
  const between = parts.slice(1).map((part, k) => ({ from: parts[k].to, to: part.from }));
  const before = { from: lines[start].from, to: first.from };
  const behind = { from: last.to, to: lines[end].to };
  const read = ({ from, to }) => text.slice(from, to);
  const holdsBracket = (gap) => hasBracket(text, gap, brackets);
  const isRow = (gap) => holdsBracket(gap) || countNumbers(read(gap)) >= FEWEST_NUMBERS;
  const gap =
    [...between, above, below].find(
      (one) => (between.includes(one) || isBeside(one)) && isRow(one),
    ) ??
    between.find((one) => WORD_BETWEEN.test(read(one))) ??
    [before, behind].find(holdsBracket) ??
    [behind].find((one) => WORD_BEHIND.test(read(one))) ??
    [above, below].find((one) => one && UNOPENED.test(one.text));
  return gap ? trimSpan(text, gap) : null;
}

const WORD_BETWEEN = /^\s*,[^\n]*[\p{L}\d][^\n]*,\s*$/u;
const WORD_BEHIND = /^\s*,\s*[\p{L}\d][^\n=]*$/u;
const UNOPENED = /^[\s[(]*[^[\](){}]*[:=][^(){}]*\}/; // the end of a dictionary, a: 0}
const FEWEST_BRACKETED = 2; // with fewer numbers, a bracket holds no entries

// Return whether a span holds a bracket with entries, or a bracket without its counterpart.
/** @param {string} text @param {Span} gap @param {Bracket[]} brackets */
function hasBracket(text, { from, to }, brackets) {
  const hasEntries = ({ body }) => /[=:]/.test(body) || countNumbers(body) >= FEWEST_BRACKETED;
  const inside = brackets.filter((bracket) => bracket.from >= from && bracket.to <= to);
  if (inside.some(hasEntries)) return true;
  const openings = new Set(brackets.map((bracket) => bracket.from));
  const closings = new Set(brackets.map((bracket) => bracket.to - 1));
  for (let at = from; at < to; at++) {
    if ("({".includes(text[at]) && !openings.has(at)) return true;
    if (")}".includes(text[at]) && !closings.has(at) && /[=:,]/.test(text.slice(from, at)))
      return true;
  }
  return false;
}

const NUMBER = /(?<![\p{L}\p{N}_.])\.?\d/gu; // its first digit
const countNumbers = (text) => [...text.matchAll(NUMBER)].length;

/** @param {string} text @param {Span} gap @returns {Span} */
function trimSpan(text, { from, to }) {
  const trimmed = text.slice(from, to).replace(/^[\s,;)]+|[\s,;([]+$/g, "");
  const start = text.indexOf(trimmed, from);
  return { from: start, to: start + trimmed.length };
}

/**
 * Find an unused line between the lists of a table, or next to them, that is as long as a list.
 * @param {string} text
 * @param {Span[]} parts the lists of the table with their names
 * @param {number} count of the entries in each list
 * @returns {Span | null}
 */
export function findUnusedList(text, parts, count) {
  const lines = listLines(text);
  const isUsed = ({ from, to }) => parts.some((part) => part.from < to && part.to > from);
  const first = Math.max(0, lines.findIndex(isUsed) - 1);
  const candidates = lines.slice(first, lines.findLastIndex(isUsed) + 2);
  const countEntries = (line) => line.trim().split(/[,;]\s*(?=.)/).length;
  const isList = (line) => !isUsed(line) && countEntries(line.text) === count;
  const list = candidates.find(isList);
  return list ? trimSpan(text, list) : null;
}
