// Gives each number of a pasted text its owner, which is what the number was taken for. A number on
// the answer's lines or beside them that no step claims is unread, and then nothing is graded.

import { RAD } from "../geometry/angles.js";
import { isUnit } from "./cells.js";
import { isJointCount } from "./counts.js";
import { hasDecimals } from "./formula.js";
import { findLabel } from "./labels.js";
import { namesOtherQuantity } from "./row_names.js";
import { ArmError, formatMessage, quoteText } from "../sentences.js";

/**
 * A number of the pasted text: its digits, its place, and what it was taken for: "entry", "label"
 * (a joint's number, a row's name, an index, a time), "header" of a column, "given" by the
 * question itself, "context" with its `reason`, or "unread". An entry has its `row` and `column`,
 * from 0, and its `index` among all entries, row by row. `matrix`, of a link matrix A_row, is its
 * row and column there; `column` is then the entry that it gives.
 * @typedef {{ text: string, from: number, to: number, line: number, owner: string, row?: number,
 *   column?: number, index?: number, matrix?: number[], reason?: string }} Token
 */
/** @typedef {import("./blocks.js").Block} Block */
/** The reason of a number that stands in another list. */
export const OTHER_LIST = "another list";

/** @typedef {import("./lines.js").Row} Row */

const DIGITS = /[0-9０-９٠-٩]+(?:[.．٫][0-9０-９٠-٩]*)?(?:[eE][-+−]?\d+)?|\.\d+(?:[eE][-+−]?\d+)?/g;
const LINE_END = /\r\n?|[\n\v\f]/g;

/** The numbers of a text. Each is claimed once. */
export class Tokens {
  /** @param {string} text */
  constructor(text) {
    const ends = [...text.matchAll(LINE_END)].map((end) => end.index + end[0].length);
    let line = 0;
    /** @type {Token[]} */
    this.list = [...text.matchAll(DIGITS)].map(({ 0: digits, index }) => {
      while (ends[line] <= index) line++;
      return { text: digits, from: index, to: index + digits.length, line, owner: "" };
    });
  }

  // The tokens that begin within a span.
  within({ from, to }) {
    let [low, high] = [0, this.list.length];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.list[middle].from < from) low = middle + 1;
      else high = middle;
    }
    let end = low;
    while (end < this.list.length && this.list[end].from < to) end++;
    return this.list.slice(low, end);
  }

  /**
   * Give the numbers of a span their owner, unless they have one.
   * @param {import("./spans.js").Span} span @param {string} owner @param {object} [more]
   */
  claim(span, owner, more = {}) {
    for (const token of this.within(span))
      if (!token.owner) Object.assign(token, { owner, ...more });
  }
}

/**
 * List the numbers of a text with their owners, once a block was taken as the answer.
 * @param {string} text @param {Block} block @returns {Token[]}
 */
export function tokensOf(text, block) {
  const tokens = new Tokens(text);
  const strayRows = findUnlabelledRows(block);
  block.rows.forEach((cells, row) =>
    cells.forEach((cell, column) => {
      const owner = strayRows.has(row) ? "unread" : "entry";
      const index = row * cells.length + column;
      for (const stretch of cell.stretches ?? [cell])
        tokens.claim(stretch, owner, { row, column, index });
    }),
  );
  for (const word of listOddLabels(block.labels)) tokens.claim(word, "unread");
  for (const cell of [...block.labels.flat(), ...block.headers]) claimWord(tokens, cell, "label");
  for (const { cells } of block.sources)
    for (const cell of cells) tokens.claim(cell, "label", { reason: "another column" });
  for (const { cells } of block.lines.given) for (const cell of cells) tokens.claim(cell, "given");
  claimOtherRows(tokens, block, findLinesBeside(text, block));
  for (const token of tokens.list)
    if (!token.owner)
      Object.assign(
        token,
        isLineNumber(text, token)
          ? { owner: "label" }
          : { owner: "context", reason: "markup or comment" },
      );
  markUnclear(text, tokens.list);
  return tokens.list;
}

// List the words with decimals before rows, unless one stands before each row, as a time does.
const listOddLabels = (labels) => {
  const found = labels.map((words) => words.filter(({ text }) => hasDecimals(text)));
  return found.every(({ length }) => length > 0) ? [] : found.flat();
};

// Mark numbers as unread that a comma may join to an entry or that "or" offers in its place.
/** @param {string} text @param {Token[]} tokens */
function markUnclear(text, tokens) {
  for (const token of listAlternatives(text, tokens)) token.owner = "unread";
  for (const halves of listSplitNumbers(text, tokens)) {
    const entries = halves.filter(({ owner }) => owner === "entry");
    if (entries.length === 1) for (const half of halves) half.owner = "unread";
  }
}

const OR = /^[^#%\n]{0,20}(?<!\p{L})(?:or|oder|ou|bzw\.?|oppure|или|或) {0,2}[-+\u2212]?$/iu;

// List the numbers that "or" offers in place of an entry, outside comments, unless they repeat it
// in another unit.
/** @param {string} text @param {Token[]} tokens */
const listAlternatives = (text, tokens) =>
  tokens.filter((token, k) => {
    const entry = tokens[k - 1];
    if (entry?.owner !== "entry") return false;
    if (!OR.test(text.slice(entry.to, token.from))) return false;
    const [value, before] = [token, entry].map((each) => signedValue(text, each));
    const ratio = value / before;
    return ![1, RAD, 1 / RAD].some((unit) => Math.abs(ratio / unit - 1) < 0.02);
  });

const signedValue = (text, { text: digits, from }) =>
  Number(digits.replace(",", ".")) *
  (/[-\u2212\u2013] ?$/.test(text.slice(Math.max(0, from - 2), from)) ? -1 : 1);

// Return whether only blanks stand before a number on its line.
/** @param {string} text @param {Token} token */
const leadsLine = (text, { from }) =>
  /(?:^|\n)[ \t]*$/.test(text.slice(Math.max(0, from - 20), from));

// List the numbers that a comma may join, 115,2111, as their two halves. In "1,0,-1" it separates
// entries, and at the start of a line the first half may be the number of the row.
/** @param {string} text @param {Token[]} tokens */
function listSplitNumbers(text, tokens) {
  return tokens.flatMap((half, k) => {
    const rest = tokens[k + 1];
    if (text[half.to] !== "," || rest?.from !== half.to + 1) return [];
    const isListed = /,[-+−]?$/.test(text.slice(0, half.from).slice(-2));
    if (isListed || /^,\S/.test(text.slice(rest.to, rest.to + 2))) return [];
    if (leadsLine(text, half)) return [];
    return /^\d+$/.test(half.text) && /^\d+$/.test(rest.text) ? [[half, rest]] : [];
  });
}

// Return whether a number leads its line and is set off, as in "2: 0.5" or "2 | 0.5".
/** @param {string} text @param {Token} token */
const isLineNumber = (text, token) =>
  leadsLine(text, token) && /^[ \t]*[|:.)\t]/.test(text.slice(token.to, token.to + 4));

// Find the rows without a label in a block whose other rows are named after those of a Jacobian.
function findUnlabelledRows({ labels }) {
  const isNamed = labels.map((words) => findLabel(words)?.kind === "row");
  const unlabelled = isNamed.flatMap((named, row) => (named ? [] : [row]));
  return new Set(isNamed.includes(true) ? unlabelled : []);
}

// Claim the numbers of a label or a column's header, unless it may be a misspelt entry.
const claimWord = (tokens, cell, owner) => {
  if (!isMisspelt(cell.text)) tokens.claim(cell, owner);
};

// Times, dates as 28.11.2026 and versions; the seconds since 1970; the time that a program took;
// -2.9..2.9
const DATES = [
  /\d:\d\d|(?<![\d.])\d{1,3}\.\d{1,3}\.\d{1,4}(?![\d.])/,
  /^\[?\d{9,}\.\d|^(?:\d+m)?[\d.]+ ?m?s$|\d\.{2,3}[-+−]?[\d.]/,
];
export const isDate = (word) => DATES.some((pattern) => pattern.test(word));
// Digits with a letter among them, as 7l2 and O.5, or with a mark behind them, as 0!
const ODD_NUMBER = /^[-+]?\d+[lIOo]\d*$|^[-+]?[OoIl][.,]\d|^[-+]?\d+[!?*~†‡§]/;

// Return whether a word holds a number with decimals that was no entry, or an odd number.
export const isMisspelt = (word) =>
  (hasDecimals(word) && !isDate(word) && !/^[\p{L}·\\_]/u.test(word)) || ODD_NUMBER.test(word);

const beginsAsNumber = (word) => /^[-+]?[.,]?\d|^[-+]?[OoIl][.,]/.test(word) && !isDate(word);

/**
 * Return the lines next to a block, over empty ones, that may be rows.
 * @param {string} text @param {Block} block @returns {Set<number>}
 */
function findLinesBeside(text, { from, to }) {
  const lines = text.split(LINE_END);
  const hasText = (line) => /[\p{L}\d]/u.test(line);
  const above = lines.findLastIndex((line, k) => k < from && hasText(line));
  const below = lines.findIndex((line, k) => k > to && hasText(line));
  return new Set([above, below].filter((k) => k >= 0 && mayBeRow(lines[k])));
}

// Return whether a line has neither a name nor a sentence.
function mayBeRow(line) {
  if (/^[^\d=:]*\p{L}[^=:\n]{0,30}[=:]/u.test(line)) return false;
  const words = (line.match(/\p{L}[\p{L}-]{2,}/gu) ?? []).filter((word) => !isUnit(word));
  return words.length < 2;
}

// The words and rows that are no part of the block.
function claimOtherRows(tokens, block, beside) {
  const { from, to, sources, lines } = block;
  const starts = new Map(
    sources.flatMap(({ line, last, cells: [cell] }) => [line, last].map((k) => [k, cell.from])),
  );
  const isNear = (line) => line >= from && line <= to;
  claimWords(tokens, block, beside);
  const isLeading = ({ line, cells }) => cells[0].from < starts.get(line);
  const perRow = lines.all.filter(isLeading).length % sources.length === 0;
  for (const row of lines.all) {
    const owner = isNear(row.line)
      ? chooseOwnerInside(row, perRow && isLeading(row))
      : chooseOwnerOutside(row, block, beside);
    for (const cell of row.cells) tokens.claim(cell, owner, { reason: OTHER_LIST });
  }
}

// Claim the numbers in words. In the block, beside it or in a row of its length a misspelt number
// is unread; all others are parts of names and sentences.
function claimWords(tokens, block, beside) {
  const { from, to, lines } = block;
  const isBrokenRow = findBrokenRows(block, tokens);
  for (const word of lines.words) {
    const [token] = tokens.within(word);
    if (!token) continue;
    const { line } = token;
    const isNear = (line >= from && line <= to) || beside.has(line);
    const unread =
      (isNear && isMisspelt(word.text)) || (isBrokenRow(line) && beginsAsNumber(word.text));
    tokens.claim(word, unread ? "unread" : "context", { reason: "a name or a sentence" });
  }
}

// Return a function that tests whether a line apart from the block holds as many numbers, read or
// not, as a row of the block.
function findBrokenRows({ rows, lines }, tokens) {
  const width = rows[0].length;
  if (width < LEAST_ROW) return () => false;
  const counts = new Map();
  const add = (line, count) => counts.set(line, (counts.get(line) ?? 0) + count);
  for (const row of lines.all) add(row.line, row.cells.length);
  for (const word of lines.words)
    if (beginsAsNumber(word.text)) add(tokens.within(word)[0]?.line, 1);
  return (line) => counts.get(line) === width;
}

const hasWord = ({ words }) => words.some(({ text }) => /\p{L}{2}/u.test(text));
const hasDecimalCell = ({ cells }) => cells.some(({ text }) => hasDecimals(text));

// Return the owner of numbers on the block's lines. They are context below a name of their own, a
// label if they are a time or an index for each row, or else unread if they may be entries.
function chooseOwnerInside(row, mayBeLabel) {
  if (row.name || hasWord(row)) return "context";
  if (mayBeLabel && row.cells.length === 1) return "label";
  return hasDecimalCell(row) ? "unread" : "context";
}

// Return whether a row holds two numbers or more that do not count joints, as 1, 2, 3 do.
function hasValues({ cells }) {
  const numbers = cells.filter(({ text }) => Number.isFinite(Number(text)));
  return numbers.length > 1 && !isJointCount(numbers);
}

// Return the owner of numbers apart from the block. They are unread if they may be a row that was
// torn off the block, else context.
function chooseOwnerOutside(row, block, beside) {
  const isRow = hasValues(row) || (hasDecimalCell(row) && widthOf(block) < 3);
  const torn = beside.has(row.line) && isRow && !row.name;
  return torn || mayBePart(row, block) ? "unread" : "context";
}

const widthOf = ({ sources }) => Math.max(...sources.map(({ cells }) => cells.length));

// Return whether a row anywhere in the text may be a row of the block. It is as long as the block's
// rows, holds values, repeats none of the rows, and has no name.
function mayBePart(row, { rows, sources }) {
  const { length } = row.cells;
  if (rows.length < 2 || length < LEAST_ROW || length !== widthOf({ sources })) return false;
  if (!hasValues(row)) return false;
  if (rows.some((cells) => textsOf(cells) === textsOf(row.cells))) return false;
  return !/\p{L}/u.test(row.name) && !namesOtherQuantity(row);
}

const textsOf = (cells) => cells.map(({ text }) => text).join();

const LEAST_ROW = 3; // numbers of a row that its length distinguishes from other numbers

/**
 * Raise an error that quotes the first number that was not read.
 * @param {string} text @param {Token[]} tokens @param {string} what
 */
export function refuseUnread(text, tokens, what) {
  const token = tokens.find(({ owner }) => owner === "unread");
  if (!token) return;
  const rest = tokens[tokens.indexOf(token) + 1];
  const isHalf = text[token.to] === "," && rest?.from === token.to + 1;
  const word = findWordAround(text, { from: token.from, to: isHalf ? rest.to : token.to });
  const where = describeLabel(text, token);
  const fields = {
    what: dropArmName(what),
    word: quoteText(word),
    line: token.line + 1,
    where,
  };
  const key = PLAIN_NUMBER.test(word) ? "unclaimed" : "unread";
  throw new ArmError(formatMessage(key, fields), [], tokens, text);
}

/**
 * Raise an error that quotes a cell that was not read; its numbers become unread.
 * @param {string} text @param {Token[]} tokens
 * @param {import("./spans.js").Span} cell @param {string} what
 */
export function refuseUnreadCell(text, tokens, { from, to }, what) {
  for (const token of tokens) if (token.from >= from && token.to <= to) token.owner = "unread";
  const line = text.slice(0, from).split(LINE_END).length;
  const word = quoteText(text.slice(from, to).trim());
  const fields = { what: dropArmName(what), word, line, where: "" };
  throw new ArmError(formatMessage("unread", fields), [], tokens, text);
}

// Drop the name of the arm from a phrase such as "UR10e: your torques".
const dropArmName = (what) => what.slice(what.lastIndexOf(": ") + 1).trim();

const PLAIN_NUMBER = /^[-+−–]?\d*(?:[.,]\d*)?(?:e[-+−–]?\d+)?$/i;

// Return the word around a number, up to blanks and separators of cells.
function findWordAround(text, { from, to }) {
  const before = /[^\s|&;[\],]*$/.exec(text.slice(Math.max(0, from - 20), from))[0];
  const behind = /^[^\s|&;[\],]*/.exec(text.slice(to, to + 20))[0];
  return before + text.slice(from, to) + behind;
}

// Return the joint or the row that the line's label names, in brackets.
function describeLabel(text, { from }) {
  const start = Math.max(text.lastIndexOf("\n", from), from - 60) + 1;
  const words = text
    .slice(start, from)
    .split(/[\s|&,;:=]+/)
    .filter(Boolean);
  const label = findLabel(words.map((word) => ({ text: word })));
  if (!label || label.kind === "row") return "";
  const key = label.kind === "joint" ? "joint" : "row";
  return ` (${formatMessage(key, { [key]: label.number })})`;
}
