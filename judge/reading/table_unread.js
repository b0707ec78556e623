// Finds a cell of a table that was not read, on the line of a row or on a line that looks like a
// further row.

import { isDate, refuseUnreadCell } from "./owners.js";
import { listLines } from "./spans.js";
import { MOST_RADIANS } from "./table_conversion.js";
import { ENTRIES } from "./table_rows.js";
import { LENGTH_UNIT } from "./units.js";
import { formatMessage } from "../sentences.js";

/** @typedef {import("./blocks.js").Block} Block */
/** @typedef {import("./lines.js").Cell} Cell */
/** @typedef {import("./lines.js").Row} Row */
/** @typedef {import("./spans.js").Span} Span */
/** @typedef {import("./table_blocks.js").TableBlock} TableBlock */
/**
 * The contents of a line that do not belong to the rows of the table. `candidates` are the words
 * that may be entries.
 * @typedef {{ rows: Row[], words: Cell[], entries: Cell[], candidates: Cell[] }} Rest
 */

const FEWEST = 2; // a line with two entries may be a row
const FEWEST_SEPARATORS = 3; // three separators part four entries
const MARK = "·"; // begins a word that the judge inserted, such as a mark for column headers

/**
 * Find the first cell that may belong to a table and was not read. If all cells of a line are
 * entries, but too few for a row, return the line without a cell.
 * @param {TableBlock} table
 * @param {string} text as it was pasted
 * @param {(cell: string) => boolean} isEntry whether a cell may be an entry of a table
 * @returns {{ line: number, cell: Span | undefined } | null}
 */
export function findUnreadCell(table, text, isEntry) {
  const { sources } = table.block;
  const unclear =
    findLostSign(text, sources) ??
    findUnclearComma(text, sources) ??
    findManyRadians(text, sources);
  return unclear ?? findUnreadInLines(table, text, isEntry);
}

// Find the first unread cell on the line of a row, or on a line that looks like a row.
function findUnreadInLines(table, text, isEntry) {
  const { block, plainLines } = table;
  const { sources } = block;
  const rests = listRests(block, isEntry);
  const isTyped = (line) => /[\p{L}\d]/u.test(plainLines[line]); // "|---|---|" draws a line
  const isHeader = (line) => isUnknownHeader(table, line);
  const lines = [...rests.keys()]
    .filter((line) => isTyped(line) && !isHeader(line))
    .sort((p, q) => p - q);
  const isBeside = makeBesideTest(lines, table);
  const starts = new Map(sources.map(({ line, cells: [first] }) => [line, first.from]));
  const separators = countSeparators(plainLines[sources[0].line]);
  const typedLines = listLines(text);
  const list = findList(text, sources);
  for (const line of lines) {
    const [rest, plainLine] = [rests.get(line), plainLines[line]];
    const [first] = [...rest.candidates, ...rest.words];
    const inList = findWordInList(rest, list, text);
    if (inList) return { line, cell: inList };
    if (starts.has(line)) {
      const unread = findUnreadInRow(rest, line, starts.get(line));
      if (unread) return unread;
    } else if (isBeside(line)) {
      const isEntries = !namesOtherList(plainLine, sources) && isMostlyEntries(rest, plainLine);
      if (isEntries || hasSameSeparators(plainLine, separators)) return { line, cell: first };
      if (hidesCells(typedLines[line].text, plainLine, separators))
        return { line, cell: typedLines[line] };
    }
  }
  return null;
}

// Return whether a comment mark hides cells, as in "q1 # base | 0.5 | 0 | 90".
const hidesCells = (typedLine, plainLine, separators) =>
  !plainLine.includes(MARK) && hasSameSeparators(typedLine, separators);

// Find an entry whose minus was lost because it stands outside of the cell, as in "!-$\pi/2$".
/** @param {string} text @param {Row[]} sources */
function findLostSign(text, sources) {
  for (const { line, cells } of sources)
    for (const [k, { from, to }] of cells.entries()) {
      if (from === to) continue; // an empty cell, whose dash was removed
      const gap = text.slice(Math.max(cells[k - 1]?.to ?? 0, from - NEAR), from);
      const sign = LOST_SIGN.exec(gap.replace(NO_SIGN, makeBlank));
      if (sign) return { line, cell: { from: from - sign[0].length, to } };
    }
  return null;
}

const NEAR = 20; // characters before an entry that may hold its sign
const NO_SIGN = /\\h?phantom\{[^}]*\}|-+>/g; // an invisible minus of LaTeX, and arrows
const makeBlank = (match) => " ".repeat(match.length);
const LOST_SIGN = /\S*[-−–—][^\p{L}\d\n|&;,\t-]*$/u;

// Find an entry such as 1,000, which may be 1 or a thousand. It is clear that the comma is decimal
// if any entry is like 0,5.
/** @param {string} text @param {Row[]} sources */
function findUnclearComma(text, sources) {
  const typed = sources.flatMap(({ line, cells }) =>
    cells.map((cell) => ({ line, cell, entry: text.slice(cell.from, cell.to) })),
  );
  const isUnclear = ({ entry }) => UNCLEAR_COMMA.test(entry);
  const hasDecimalComma = typed.some((cell) => /\d,\d/.test(cell.entry) && !isUnclear(cell));
  return hasDecimalComma ? undefined : typed.find(isUnclear);
}

// Find an entry of more than a full turn in radians, such as 90 rad.
/** @param {string} text @param {Row[]} sources */
function findManyRadians(text, sources) {
  for (const { line, cells } of sources)
    for (const cell of cells) {
      const [, number] = RADIANS.exec(text.slice(cell.from, cell.to)) ?? [];
      if (Number(number) > MOST_RADIANS) return { line, cell };
    }
  return null;
}

const RADIANS = /^[-+−]?\s*([\d.]+)\s*rad/;
const UNCLEAR_COMMA = /^[-+−]?[1-9]\d{0,2},\d{3}(?![\d,])/;

// Find the first unread cell behind the first entry of a row, or a further row on the same line.
/** @param {Rest} rest @param {number} line @param {number} start of the row's first entry */
function findUnreadInRow({ rows, words, candidates }, line, start) {
  const cell = candidates.find(({ from }) => from > start);
  if (!cell && !rows.some(isPartOfRow)) return null;
  return { line, cell: cell ?? candidates[0] ?? words[0] };
}

// Make a test of lines. A line is beside a table if it stands between the rows or next to them. A
// turned table has no such lines: the line of joints above it is no row.
/** @param {number[]} lines @param {TableBlock} table */
function makeBesideTest(lines, { block: { firstLine, lastLine }, isTurned }) {
  if (isTurned) return () => false;
  const above = lines.findLast((line) => line < firstLine) ?? firstLine;
  const below = lines.find((line) => line > lastLine) ?? lastLine;
  return (line) => line >= above && line <= below;
}

const isPartOfRow = ({ cells, name }) => cells.length >= FEWEST && !name;

// Find a word within the list that holds the rows, as in [[...], *wrist]. The list's name is no
// such word.
/** @param {Rest} rest @param {Span | null} list @param {string} text */
const findWordInList = ({ words }, list, text) =>
  list && words.find((word) => isWithin(word, list) && !isName(word, text));

// Return whether "=" follows a word, as in \\[ DH = \\begin{pmatrix}.
const isName = ({ to }, text) => /^\s*=/.test(text.slice(to, to + 9));

// For each line, list what the rows of a block do not use of it.
/**
 * @param {Block} block @param {(cell: string) => boolean} isEntry
 * @returns {Map<number, Rest>}
 */
function listRests({ sources, lines }, isEntry) {
  const rests = new Map();
  const getRest = (line) => {
    if (!rests.has(line)) rests.set(line, { rows: [], words: [], entries: [], candidates: [] });
    return rests.get(line);
  };
  const rowsOfBlock = new Set(sources);
  for (const row of lines.all)
    if (!rowsOfBlock.has(row)) {
      getRest(row.line).rows.push(row);
      getRest(row.line).entries.push(...row.cells);
    }
  for (const word of lines.words) {
    if (word.line === undefined || isDate(word.text)) continue; // the name of a value
    const { words, candidates } = getRest(word.line);
    if (word.text.startsWith(MARK)) continue;
    words.push(word);
    if (isEntry(trimMarks(word.text)) || /\d/.test(word.text)) candidates.push(word);
  }
  return rests;
}

const PROSE = /(?<![\p{L}\d_\\])\p{L}{3,}(?![\p{L}\d_(])/gu;
const FEWEST_PROSE = 3; // a sentence has three words or more

// Return whether a line may hold headers of unknown names. It has no digit and stands above a table
// without headers.
const isUnknownHeader = ({ headers, block, plainLines }, line) =>
  !headers.length && line < block.firstLine && !/\d/.test(plainLines[line]);

const trimMarks = (text) => text.replace(/^[^\p{L}\d.+-]+|[^\p{L}\d]+$/gu, "");

const isSentence = (line) => (line.match(PROSE) ?? []).length >= FEWEST_PROSE;

// Return whether at least half of the cells on a line may be entries.
function isMostlyEntries({ entries, words, candidates }, plainLine) {
  const count = entries.length + candidates.length;
  return !isSentence(plainLine) && count >= FEWEST && 2 * count >= entries.length + words.length;
}

// Count each separator of a line.
const countSeparators = (line = "") =>
  SEPARATORS.map((separator) => line.trim().split(separator).length - 1);
const SEPARATORS = ["|", "&", "\t", ";", ",", / {2,}/];

// Return whether a line has as many separators as a row. The commas of a sentence do not count.
function hasSameSeparators(line, separators) {
  const counts = countSeparators(line);
  const k = separators.findIndex((count) => count >= FEWEST_SEPARATORS);
  if (SEPARATORS[k] === "," && isSentence(line)) return false;
  return k >= 0 && counts[k] === separators[k];
}

/**
 * Find a list in brackets around all rows, as in DH = [[0, 0], [0, 1]].
 * @param {string} text @param {Row[]} sources
 * @returns {Span | null}
 */
function findList(text, sources) {
  const [from, to] = [sources[0].cells[0].from, sources.at(-1).cells.at(-1).to];
  const lists = ["[]", "{}"].flatMap(([open, close]) => {
    const starts = [];
    for (let at = 0; at < text.length; at++) {
      if (text[at] === open) starts.push(at);
      else if (text[at] === close && starts.length) {
        const start = starts.pop();
        if (start < from && at >= to) return [{ from: start, to: at }];
      }
    }
    return [];
  });
  return lists[0] ?? null;
}

const isWithin = ({ from, to }, list) => from >= list.from && to <= list.to;

// Return whether a line assigns a list of its own, as in "masses: 1.2, 3.4". Rows of the table may
// have names, too; then the line must hold two "=".
const namesOtherList = (line, sources) =>
  /^[^=:]*\p{L}[^=:]*[=:]/u.test(line) &&
  (line.split("=").length > 2 || !sources.some(({ name }) => name));

const UNIT_BEHIND = new RegExp(String.raw`^ ?(?:(${LENGTH_UNIT})|rad|deg|°)(?![\p{L}\p{N}])`, "u");

/**
 * Refuse an angle in mm and a length in degrees.
 * @param {import("./table.js").TypedTable} table @param {string} text as it was pasted
 */
export function refuseMixedUnits({ tokens, isOrderGuessed }, text) {
  for (const token of isOrderGuessed ? [] : tokens) {
    const [unit, lengthUnit] = UNIT_BEHIND.exec(text.slice(token.to, token.to + 9)) ?? [];
    if (unit === undefined || token.owner !== "entry") continue;
    const isLength = ["a", "d"].includes(ENTRIES[token.column]);
    if (isLength === (lengthUnit !== undefined)) continue;
    const cell = { from: token.from, to: token.to + unit.length };
    refuseUnreadCell(text, tokens, cell, formatMessage("your table"));
  }
}
