// Records how each number of a pasted text was used: as an entry of the answer, as a label, as
// context and so on. This is the owner of the number. If a number on the answer's lines or next to
// them was not used, it is unread, and nothing is graded.

import { RAD } from "../geometry/angles.js";
import { isUnit } from "./cells.js";
import { linesOf, listNextLines } from "./characters.js";
import { isJointCount } from "./counts.js";
import { hasDecimals } from "./formula.js";
import { findLabel } from "./labels.js";
import { namesOtherQuantity } from "./row_names.js";
import { ArmError, formatMessage, quoteText } from "../sentences.js";

/**
 * A number of the pasted text with its owner. The owners are "entry", "label" (a joint number, a
 * row name, an index, a time), "header" of a column, "given" by the question, "context" with a
 * `reason`, and "unread". An entry has a `row` and `column`, from 0, and an `index` among all
 * entries, row by row. In a link matrix A_row, `matrix` is the position within the matrix, and
 * `column` the entry of the table that the number gives.
 * @typedef {{ text: string, from: number, to: number, line: number, owner: string, row?: number,
 *   column?: number, index?: number, matrix?: number[], reason?: string }} Token
 */
/** @typedef {import("./blocks.js").Block} Block */
/** The reason of a number in words. */
export const BESIDE_WORDS = "a name or a sentence";
/** The reason of a number in a list that is not the answer. */
export const OTHER_LIST = "another list";

/** @typedef {import("./lines.js").Row} Row */

const DIGITS = /[0-9０-９٠-٩]+(?:[.．٫][0-9０-９٠-٩]*)?(?:[eE][-+−]?\d+)?|\.\d+(?:[eE][-+−]?\d+)?/g;
const LINE_END = /\r\n?|[\n\v\f]/g;

/** The numbers of a text. Each number gets its owner from the first step that claims it. */
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

  // List the tokens that begin within a span, by binary search.
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
   * Give an owner to the numbers of a span that have none yet.
   * @param {import("./spans.js").Span} span @param {string} owner @param {object} [more]
   */
  claim(span, owner, more = {}) {
    for (const token of this.within(span))
      if (!token.owner) Object.assign(token, { owner, ...more });
  }
}

/**
 * List the numbers of a text with their owners, given the block of the answer.
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
  if (block.rows.length === 1) markLabelInBrackets(text, tokens.list);
  return tokens.list;
}

// List the words with decimals before rows. If each row has such a word, it is a label such as a
// time, and the list is empty.
const listOddLabels = (labels) => {
  const found = labels.map((words) => words.filter(({ text }) => hasDecimals(text)));
  return found.every(({ length }) => length > 0) ? [] : found.flat();
};

// Mark a label within the brackets of a single row as unread: "[0.5 0.5, 0.7, -0.4]" has four
// numbers.
/** @param {string} text @param {Token[]} tokens */
function markLabelInBrackets(text, tokens) {
  const first = tokens.findIndex(({ owner }) => owner === "entry");
  const label = tokens[first - 1];
  if (label?.owner !== "label" || label.line !== tokens[first].line) return;
  const isOpen = /[[({][ \t]*[-+\u2212]?$/.test(text.slice(0, label.from));
  const isBeside = /^[ \t]+[-+\u2212]?$/.test(text.slice(label.to, tokens[first].from));
  if (isOpen && isBeside) label.owner = "unread";
}

// Mark numbers as unread if a comma may join them to an entry, "115,2111", or if they are an
// alternative to an entry, "0.3 or 0.5".
/** @param {string} text @param {Token[]} tokens */
function markUnclear(text, tokens) {
  for (const token of listAlternatives(text, tokens)) token.owner = "unread";
  for (const halves of listSplitNumbers(text, tokens)) {
    const entries = halves.filter(({ owner }) => owner === "entry");
    if (entries.length === 1) for (const half of halves) half.owner = "unread";
  }
}

const OR = /^[^#%\n]{0,60}(?<!\p{L})(?:or|oder|ou|bzw\.?|oppure|или|或) {0,2}[-+\u2212]?$/iu;

const THAT_IS = /(?:i\.e\.|d\. ?h\.),? {0,2}[-+\u2212]?$/i;
const TAG = /<[^<>\n]*>/g;
const COMMENT = /#|%|\/\//;
const UNITS = [1, RAD, 1 / RAD, 1e-3, 1e3];

// List the numbers behind "or" or "i.e." on a line with entries, outside comments. A number that
// repeats an entry in a different unit is left out.
/** @param {string} text @param {Token[]} tokens */
const listAlternatives = (text, tokens) =>
  tokens.filter((token, k) => {
    const before = tokens[k - 1];
    if (token.owner === "entry" || before?.line !== token.line) return false;
    const between = text.slice(before.to, token.from).replace(TAG, "");
    const isRestated = THAT_IS.test(between);
    if (!isRestated && !OR.test(between)) return false;
    const entries = tokens.filter(({ owner }) => owner === "entry");
    const beside = entries.filter(({ line, from }) => line === token.line && from < token.from);
    if (!beside.length || COMMENT.test(text.slice(beside.at(-1).to, token.from))) return false;
    const value = signedValue(text, token);
    const repeats = (other) =>
      UNITS.some((unit) => Math.abs(value / signedValue(text, other) / unit - 1) < 0.02);
    return !(isRestated ? entries : beside).some(repeats);
  });

const signedValue = (text, { text: digits, from }) =>
  Number(digits.replace(",", ".")) *
  (/[-\u2212\u2013] ?$/.test(text.slice(Math.max(0, from - 2), from)) ? -1 : 1);

// Return whether only blanks stand before a number on its line.
/** @param {string} text @param {Token} token */
const leadsLine = (text, { from }) =>
  /(?:^|\n)[ \t]*$/.test(text.slice(Math.max(0, from - 20), from));

// List pairs of whole numbers that a comma may join to a decimal number, as 115 and 2111 of
// "115,2111". In "1,0,-1" the commas separate entries. A pair at the start of a line is left out,
// since its first number may count the row.
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

// Return whether a number is the first on its line with a separator behind it: "2: 0.5", "2 | 0.5".
/** @param {string} text @param {Token} token */
const isLineNumber = (text, token) =>
  leadsLine(text, token) && /^[ \t]*[|:.)\t]/.test(text.slice(token.to, token.to + 4));

// Find the rows without a label, if any row of the block has the name of a Jacobian's row, as "vx".
function findUnlabelledRows({ labels }) {
  const isNamed = labels.map((words) => findLabel(words)?.kind === "row");
  const unlabelled = isNamed.flatMap((named, row) => (named ? [] : [row]));
  return new Set(isNamed.includes(true) ? unlabelled : []);
}

// Claim the numbers of a label or a header, unless it may be a misspelt entry.
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
// Digits with a letter among them, 7l2 and O.5, or with a mark behind them, 0!
const ODD_NUMBER = /^[-+]?\d+[lIOo]\d*$|^[-+]?[OoIl][.,]\d|^[-+]?\d+[!?*~†‡§]/;

// Return whether a word is likely a misspelt number, such as "7l2" or "0.5x".
const isMisspelt = (word) => {
  const parts = word.includes("(") ? [word] : word.split(","); // atan2(0.3,0.5) is a single word
  const isNumber = (part) => hasDecimals(part) && !isDate(part) && !/^[\p{L}·\\_]/u.test(part);
  return ODD_NUMBER.test(word) || parts.some(isNumber);
};

const beginsAsNumber = (word) => /^[-+]?[.,]?\d|^[-+]?[OoIl][.,]/.test(word) && !isDate(word);

/**
 * Return the lines above and below a block that may be rows. Empty lines are skipped.
 * @param {string} text @param {Block} block @returns {Set<number>}
 */
function findLinesBeside(text, { firstLine, lastLine }) {
  const lines = linesOf(text);
  return new Set(listNextLines(lines, firstLine, lastLine).filter((k) => mayBeRow(lines[k])));
}

// Return whether a line may be a row, because it has neither a name nor a sentence.
function mayBeRow(line) {
  if (/^[^\d=:]*\p{L}[^=:\n]{0,30}[=:]/u.test(line)) return false;
  const words = (line.match(/\p{L}[\p{L}-]{2,}/gu) ?? []).filter((word) => !isUnit(word));
  return words.length < 2;
}

// Claim the words and rows that are no part of the block.
function claimOtherRows(tokens, block, beside) {
  const { firstLine, lastLine, sources, lines } = block;
  const starts = new Map(
    sources.flatMap(({ line, last, cells: [cell] }) => [line, last].map((k) => [k, cell.from])),
  );
  const isNear = (line) => line >= firstLine && line <= lastLine;
  claimWords(tokens, block, beside);
  const isLeading = ({ line, cells }) => cells[0].from < starts.get(line);
  const perRow = lines.all.filter(isLeading).length % sources.length === 0;
  const names = new Set(sources.map(nameWithoutNumber));
  for (const row of lines.all) {
    const isTorn = row.cells.length > 1 && row.words.length && names.has(nameWithoutNumber(row));
    const owner = isNear(row.line)
      ? chooseOwnerInside(row, perRow && isLeading(row), isTorn)
      : chooseOwnerOutside(row, block, beside);
    for (const cell of row.cells) tokens.claim(cell, owner, { reason: OTHER_LIST });
  }
}

// Claim the numbers in words. A misspelt number is unread if it stands in the block, next to it, or
// in a row of the same length. All other numbers are parts of names and sentences.
function claimWords(tokens, block, beside) {
  const { firstLine, lastLine, lines } = block;
  const isBrokenRow = findBrokenRows(block, tokens);
  for (const word of lines.words) {
    const [token] = tokens.within(word);
    if (!token) continue;
    const { line } = token;
    const isNear = (line >= firstLine && line <= lastLine) || beside.has(line);
    const unread =
      (isNear && isMisspelt(word.text)) || (isBrokenRow(line) && beginsAsNumber(word.text));
    tokens.claim(word, unread ? "unread" : "context", { reason: BESIDE_WORDS });
  }
}

// Make a test of lines. A line is a broken row if it has as many numbers, including misspelt
// numbers, as a row of the block.
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

const nameWithoutNumber = ({ words }) =>
  words.map(({ text }) => text.replace(/\d+/g, "#")).join(" ");
const hasWord = ({ words }) => words.some(({ text }) => /\p{L}{2}/u.test(text));
const hasDecimalCell = ({ cells }) => cells.some(({ text }) => hasDecimals(text));

// Return the owner of further numbers on the block's lines. Numbers with a name are context. A time
// or an index at the start of each row is a label. All other numbers with decimals are unread.
function chooseOwnerInside(row, mayBeLabel, isTorn) {
  if (isTorn) return "unread"; // it is named as the rows are: "step 4" beside "step 3"
  if (row.name || hasWord(row)) return "context";
  if (mayBeLabel && row.cells.length === 1) return "label";
  return hasDecimalCell(row) ? "unread" : "context";
}

// Return whether a row holds two or more numbers that are not just joint numbers, such as 1, 2, 3.
function hasValues({ cells }) {
  const numbers = cells.filter(({ text }) => Number.isFinite(Number(text)));
  return numbers.length > 1 && !isJointCount(numbers);
}

// Return the owner of numbers outside the block. They are unread if they may be a row of the block,
// else context.
function chooseOwnerOutside(row, block, beside) {
  const isRow = hasValues(row) || (hasDecimalCell(row) && widthOf(block) < 3);
  const torn = beside.has(row.line) && isRow && !row.name;
  return torn || mayBePart(row, block) ? "unread" : "context";
}

const widthOf = ({ sources }) => Math.max(...sources.map(({ cells }) => cells.length));

// Return whether a row anywhere in the text may be a row of the block. It has the same length,
// holds values, repeats no row of the block, and has no name.
function mayBePart(row, { rows, sources }) {
  const { length } = row.cells;
  if (rows.length < 2 || length < LEAST_ROW || length !== widthOf({ sources })) return false;
  if (!hasValues(row)) return false;
  if (rows.some((cells) => textsOf(cells) === textsOf(row.cells))) return false;
  return !/\p{L}/u.test(row.name) && !namesOtherQuantity(row);
}

const textsOf = (cells) => cells.map(({ text }) => text).join();

const LEAST_ROW = 3; // shorter rows may have the same length by chance

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
 * Raise an error that quotes an unread cell. The numbers of the cell become unread.
 * @param {string} text @param {Token[]} tokens
 * @param {import("./spans.js").Span} cell @param {string} what
 */
export function refuseUnreadCell(text, tokens, { from, to }, what) {
  for (const token of tokens) if (token.from >= from && token.to <= to) token.owner = "unread";
  const line = linesOf(text.slice(0, from)).length;
  const word = quoteText(text.slice(from, to).trim());
  const fields = { what: dropArmName(what), word, line, where: "" };
  throw new ArmError(formatMessage("unread", fields), [], tokens, text);
}

// Drop the name of the arm from a phrase such as "UR10e: your torques".
const dropArmName = (what) => what.slice(what.lastIndexOf(": ") + 1).trim();

const PLAIN_NUMBER = /^[-+−–]?\d*(?:[.,]\d*)?(?:e[-+−–]?\d+)?$/i;

// Return the word around a number, up to the next blanks or separators.
function findWordAround(text, { from, to }) {
  const before = /[^\s|&;[\],]*$/.exec(text.slice(Math.max(0, from - 20), from))[0];
  const behind = /^[^\s|&;[\],]*/.exec(text.slice(to, to + 20))[0];
  const word = before + text.slice(from, to) + behind;
  const bare = word.replace(/^[({]+|[)}]+$/g, "");
  return PLAIN_NUMBER.test(bare) ? bare : word;
}

// Return the joint or the row of a number by the label on its line: " (joint 2)".
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
