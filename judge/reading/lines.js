// Reads a text as rows of entries with the words before them, as "q = 0.1 0.2". Entries and words
// keep their positions in the pasted text.

import { isFunction, isNumber } from "./formula.js";
import { CONTINUED, ROW_END } from "./characters.js";
import { findLabel } from "./labels.js";
import {
  CLOSE,
  isMark,
  isTimeStamp,
  makeCell,
  OPEN,
  splitCells,
  splitOutsideBrackets,
} from "./cells.js";

/** @typedef {import("./cells.js").Cell} Cell */
/** @typedef {import("./cells.js").Splitting} Splitting */
/**
 * Entries beside each other without a word between them. `words` stand before the entries, and
 * `above` are the words on the line above. `name` is the name before "=" or ":". `line` and `last`
 * are the first and last line. `scale` is the factor of MATLAB's "1.0e+03 *", and `part` counts
 * MATLAB's headings "Columns 1 through 4". `depth` is the number of open lists, and `tail` the
 * number of words behind the entries. `isColumn` is true if semicolons separate the entries, which
 * have no decimal commas, and `isAssigned` if "=" or ":" stands before the first entry.
 * @typedef {{ cells: Cell[], words: Cell[], name: string, line: number, last: number,
 *   scale: string, part: number, above: Cell[], depth: number, list: number, tail: number,
 *   isColumn?: boolean, isAssigned: boolean }} Row
 */
const SEPARATORS = `,;&|\t\n${ROW_END}`;
const WORD_BEFORE = /([A-Za-z]\w*)$/;
const MOST_INDEX = 6; // characters of the index [1, 1] behind a name

/**
 * Return the kind of each bracket by its position. A "group" belongs to a formula or a name.
 * @param {string} text
 * @returns {Map<number, string>}
 */
function classifyBrackets(text) {
  const kinds = new Map();
  const open = [];
  for (let at = 0; at < text.length; at++) {
    const character = text[at];
    if (OPEN.includes(character)) open.push({ at, character, isSplit: false, leaf: true });
    else if (CLOSE.includes(character) && open.length) {
      const bracket = open.pop();
      const kind = isList(text, bracket, at) ? "list" : "group";
      kinds.set(bracket.at, kind).set(at, kind);
      if (open.length && kind === "list") open.at(-1).leaf = false;
    } else if (open.length && SEPARATORS.includes(character)) open.at(-1).isSplit = true;
  }
  return kinds;
}

const TWO_ARGUMENTS = /^(?:arc|a)tan2$/i;
const OPENS_LIST = /^\s*(?:[\w.]*array\(|\[)/; // np.radians([...])

// Return whether a bracket holds a list. The argument of a function, a factor and an index are no
// lists.
function isList(text, { at, character, isSplit, leaf }, end) {
  const before = text[at - 1] ?? " ";
  const word = WORD_BEFORE.exec(text.slice(Math.max(0, at - 12), at))?.[1] ?? "";
  if (TWO_ARGUMENTS.test(word)) return false;
  if (isFunction(word.toLowerCase()))
    return (
      OPENS_LIST.test(text.slice(at + 1, at + 20)) || (/rad/.test(word) && text[at + 1] === "(")
    );
  if (character === "{") return !/[\w^}]/.test(before) || (isSplit && /[^\W_]/.test(before));
  if (character === "[") return !/[\w})]/.test(before) || end - at > MOST_INDEX;
  return isRoundList(text, { at, isSplit, leaf }, end, before);
}

// Return whether round brackets hold several entries and are no index.
function isRoundList(text, { at, isSplit, leaf }, end, before) {
  if (/\w/.test(before) && end - at <= MOST_INDEX) return false;
  return isSplit || !leaf || NUMBERS.test(text.slice(at + 1, end));
}

const NUMBERS = /^\s*[-+]?[\d.]+(?:\s+[-+]?[\d.]+)+\s*$/; // 0.1 0.2

/**
 * Read the rows of a text.
 * @param {import("./spans.js").SpannedText} plain
 * @param {(cell: string) => boolean} isEntry
 * @param {Splitting} splitting
 * @returns {{ rows: Row[], words: Cell[] }} `words` are all cells that are no entries
 */
export function readRows(plain, isEntry, splitting) {
  const { text } = plain;
  const state = startState(plain, isEntry, splitting);
  const brackets = classifyBrackets(text);
  let [from, groups] = [0, 0];
  for (let at = 0; at < text.length; at++) {
    const kind = brackets.get(at);
    if (kind === "group") groups += OPEN.includes(text[at]) ? 1 : -1;
    const ends = kind ? kind === "list" : endsRow(text[at], state);
    if (groups || !ends) continue;
    readSegment(from, at, state);
    from = at + 1;
    if (kind) crossBracket(state, OPEN.includes(text[at]) ? 1 : -1, at);
    else endRow(state, text[at]);
  }
  readSegment(from, text.length, state);
  return { rows: state.rows, words: state.allWords };
}

// Return whether a character ends a row. A semicolon ends a row within a list only; outside of
// lists it separates cells.
const endsRow = (character, { depth }) =>
  character === "\n" || character === ROW_END || (character === ";" && depth > 0);

// Return the state before the first character. `words` stand before the next row, and `above` are
// the words of the line above. `wordsAtMark` is the number of words before the last = or :.
const startState = (plain, isEntry, splitting) => ({
  plain,
  text: plain.text,
  isEntry,
  splitting,
  rows: /** @type {Row[]} */ ([]),
  row: /** @type {Row | null} */ (null),
  words: /** @type {Cell[]} */ ([]),
  above: /** @type {Cell[]} */ ([]),
  allWords: /** @type {Cell[]} */ ([]),
  name: "",
  nameLine: -1, // the line of a name before =
  wordsAtMark: -1,
  scale: "",
  line: 0,
  part: 0,
  depth: 0,
  list: -1,
});

// Begin a list (step 1) or end it (step -1).
function crossBracket(state, step, at) {
  state.row = null;
  if (!state.depth) state.list = at;
  state.depth += step;
  if (!state.depth) state.list = -1;
}

// End a row, unless the list around it counts as a single row.
function endRow(state, character) {
  if (character === "\n") state.line++;
  const isInRow = character !== ROW_END && state.splitting.wrapped && state.depth > 0;
  if (isInRow && character === ";" && state.row) state.row.isColumn = !state.splitting.decimal;
  if (isInRow) return;
  state.row = null;
  if (character === "\n") endLine(state);
}

// Words that replace MATLAB's headings.
const FACTOR = "·factor·";
const PART = "·columns·";
const SCALE_HEADING = /^[ \t]*(1(?:\.0+)?e[+-]?\d+)[ \t]*\*[ \t]*$/gim;
const COLUMNS_HEADING = /^[ \t]*Columns?[ \t_]+\d+(?:[ \t]+(?:through|and)[ \t]+\d+)?:?[ \t]*$/gim;

/**
 * Turn MATLAB's headings "1.0e+03 *" and "Columns 1 through 4" into words.
 * @param {import("./spans.js").SpannedText} text
 */
export const markHeadings = (text) =>
  text.replace(SCALE_HEADING, (_, power) => FACTOR + power).replace(COLUMNS_HEADING, PART);

// End a line. Its words become the words above the next line.
function endLine(state) {
  const line = state.words.map(({ text }) => text).join(" ");
  if (line.startsWith(FACTOR)) state.scale = `*${line.slice(FACTOR.length)}`;
  if (line === PART) state.part++;
  if (line) state.above = state.words;
  if (/^\d{1,3}$/.test(state.name)) state.name = ""; // "Problem 3: Jacobian" names no row below
  Object.assign(state, { words: [], wordsAtMark: -1 });
}

const CELL_SEPARATORS = ["\t", "&", "|", ";"]; // on a line with such a separator, commas are none
const DECIMAL_COMMA = /^\s*[-+]?\d*,\d+[^,\d]*$/; // a cell on such a line

// Add the cells between two brackets or row ends to the rows.
function readSegment(from, to, state) {
  const { splitting, text } = state;
  const line = state.line;
  const segment = text.slice(from, to);
  state.line += segment.split(CONTINUED).length - 1;
  const strong = CELL_SEPARATORS.filter((character) => segment.includes(character));
  const separators = strong.length ? strong : splitting.decimal ? [] : [","];
  const parts = splitOutsideBrackets(text, from, to, (k) =>
    separators.includes(text[k]) ? text[k] : "",
  );
  for (const part of parts) {
    const piece = text.slice(part.from, part.to);
    if (!piece.trim()) continue;
    const decimal = strong.length && DECIMAL_COMMA.test(piece);
    const cellSplitting = decimal ? { ...splitting, decimal: true } : splitting;
    const cells =
      parts.length > 1
        ? readSeparatedCells(part, cellSplitting, state)
        : splitCells(part, cellSplitting, state.plain);
    for (const cell of cells) addCell(cell, line, state);
  }
}

// Read the text between two separators. It is a single cell if the whole text is an entry, or if it
// holds no entry.
function readSeparatedCells(part, splitting, state) {
  const pieces = splitCells(part, splitting, state.plain);
  const whole = makeCell(part, splitting, state.plain);
  const isOne = !pieces.every(({ text }) => isNumber(text)) && state.isEntry(whole.text);
  const cells = isOne ? [whole] : pieces;
  if (cells.some(({ text }) => isMark(text) || state.isEntry(text))) return cells;
  if (cells.every((cell) => findLabel([cell])?.kind === "row")) return cells; // wx wy wz
  return [{ ...whole, text: state.text.slice(part.from, part.to).trim() }];
}

// Turn the entry before an assignment mark into a word, because it is a name.
function turnEntryIntoName(state) {
  if (!state.row) return;
  const { cells, words, name } = state.row;
  const entry = cells.pop();
  if (!cells.length) {
    state.rows.pop();
    Object.assign(state, { words, name });
  }
  state.words.push(entry);
  state.allWords.push(entry);
}

// Store the name before an assignment mark. In "tau = g - JTF = [...]" the first name counts.
function keepName(mark, state) {
  turnEntryIntoName(state);
  const isSame = mark === "=" && state.name && state.nameLine === state.line;
  state.name = isSame ? state.name : (state.words.at(-1)?.text ?? "");
  state.nameLine = mark === "=" ? state.line : -1;
  Object.assign(state, { scale: "", row: null, wordsAtMark: state.words.length });
}

function addCell(cell, line, state) {
  const { text } = cell;
  if (text === "and" && state.row) return;
  if (isMark(text)) {
    keepName(text, state);
    return;
  }
  if (isTimeStamp(text) || !state.isEntry(text)) {
    addWord(cell, state);
    return;
  }
  if (!state.row) {
    const { words, name, scale, part, above, depth, list, wordsAtMark } = state;
    const isAssigned = words.length === wordsAtMark;
    const position = { line, last: line, part, depth, list };
    state.row = { cells: [], words, name, scale, above, ...position, isAssigned, tail: 0 };
    state.rows.push(state.row);
    state.words = [];
    state.name = "";
  }
  state.row.cells.push(cell);
  state.row.tail = 0;
  state.row.last = state.line;
}

function addWord(typed, state) {
  if (state.row && !/[\p{L}\d°]/u.test(typed.text)) {
    state.row.tail++; // an empty cell, such as - or ✓; a unit without its number is a word
    return;
  }
  if (!/[\p{L}\d#<>°]/u.test(typed.text)) return;
  const cell = { ...typed, line: state.line };
  state.words.push(cell);
  state.allWords.push(cell);
  if (state.row) state.row.tail++;
  state.row = null;
}
