// Reads the lines of a text as rows of cells, each of which keeps its place in the pasted text.

import { isFunction, isNumber } from "./formula.js";
import { CONTINUED, ROW_END } from "./characters.js";

/**
 * A cell in plain characters, a unit as its factor. A word has its line, a header its label.
 * @typedef {import("./spans.js").Span & { text: string, line?: number,
 *   label?: import("./labels.js").Label, stretches?: import("./spans.js").Span[] }} Cell
 */
/**
 * Entries beside each other without a word between; the words before them; the name that they are
 * assigned to; the words of the line above; `tail` counts the words behind them, `hasAnd` says
 * whether "and" stands between two of them, `isColumn` whether semicolons do, `isAssigned` whether
 * the first follows "=" or ":".
 * @typedef {{ cells: Cell[], words: Cell[], name: string, line: number, last: number,
 *   scale: string, part: number, above: Cell[], depth: number, tail: number,
 *   hasAnd: boolean, isColumn?: boolean, isAssigned: boolean }} Row
 */
/**
 * How a text is parted: whether the innermost lists are taken for one row each, whether commas
 * between digits are decimal ones, and whether only gaps part entries, single blanks not.
 * @typedef {{ wrapped: boolean, decimal: boolean, gaps: boolean }} Parting
 */

const OPEN = "[({";
const CLOSE = "])}";
const SEPARATORS = `,;&|\t\n${ROW_END}`;
const WORD_BEFORE = /([A-Za-z]\w*)$/;
const MOST_INDEX = 6; // characters of [1, 1] behind a name

/**
 * Return each bracket's kind: "list", "leaf" (a list without lists), "group" in formulas and names.
 * @param {string} text
 * @returns {Map<number, string>}
 */
function bracketKinds(text) {
  const kinds = new Map();
  const open = [];
  for (let at = 0; at < text.length; at++) {
    const character = text[at];
    if (OPEN.includes(character)) open.push({ at, character, parted: false, leaf: true });
    else if (CLOSE.includes(character) && open.length) {
      const bracket = open.pop();
      const kind = isList(text, bracket, at) ? (bracket.leaf ? "leaf" : "list") : "group";
      kinds.set(bracket.at, kind).set(at, kind);
      if (open.length && kind !== "group") open.at(-1).leaf = false;
    } else if (open.length && SEPARATORS.includes(character)) open.at(-1).parted = true;
  }
  return kinds;
}

const OPENS_LIST = /^\s*(?:np\.array\(|\[)/; // np.radians([...])

function isList(text, { at, character, parted, leaf }, end) {
  const before = text[at - 1] ?? " ";
  const word = WORD_BEFORE.exec(text.slice(Math.max(0, at - 12), at))?.[1] ?? "";
  if (word && isFunction(word.toLowerCase()))
    return (
      OPENS_LIST.test(text.slice(at + 1, at + 20)) || (/rad/.test(word) && text[at + 1] === "(")
    );
  if (character === "{") return !/[\w^}]/.test(before);
  if (character === "[") return !/[\w})]/.test(before) || end - at > MOST_INDEX;
  return isRoundList(text, { at, parted, leaf }, end, before);
}

// Round brackets that are no index and hold several things.
function isRoundList(text, { at, parted, leaf }, end, before) {
  if (/\w/.test(before) && end - at <= MOST_INDEX) return false;
  return parted || !leaf || (/[\s=]/.test(before) && NUMBERS.test(text.slice(at + 1, end)));
}

const NUMBERS = /^\s*[-+]?[\d.]+(?:\s+[-+]?[\d.]+)+\s*$/; // beside each other

/**
 * Read the rows of a text.
 * @param {import("./spans.js").SpannedText} plain
 * @param {(cell: string) => boolean} isEntry
 * @param {Parting} parting
 * @returns {{ rows: Row[], words: Cell[] }} `words` are all cells that are no entries
 */
export function readRows(plain, isEntry, parting) {
  const { text } = plain;
  const state = startState(plain, isEntry, parting);
  const brackets = bracketKinds(text);
  let [from, groups] = [0, 0];
  for (let at = 0; at < text.length; at++) {
    const kind = brackets.get(at);
    if (kind === "group") groups += OPEN.includes(text[at]) ? 1 : -1;
    const ends = kind ? kind !== "group" : endsRow(text[at], state);
    if (groups || !ends) continue;
    readSegment(from, at, state);
    from = at + 1;
    if (kind) crossBracket(state, kind, OPEN.includes(text[at]) ? 1 : -1);
    else endRow(state, text[at]);
  }
  readSegment(from, text.length, state);
  return { rows: state.rows, words: state.allWords };
}

// Semicolons part rows in lists, and cells outside.
const endsRow = (character, { leaves }) =>
  character === "\n" || character === ROW_END || (character === ";" && leaves > 0);

// The state of the walk: `words` are those before the next row, `above` those of the line above.
const startState = (plain, isEntry, parting) => ({
  plain,
  text: plain.text,
  isEntry,
  parting,
  rows: /** @type {Row[]} */ ([]),
  row: /** @type {Row | null} */ (null),
  words: /** @type {Cell[]} */ ([]),
  above: /** @type {Cell[]} */ ([]),
  allWords: /** @type {Cell[]} */ ([]),
  name: "",
  nameLine: -1, // of a name before =
  wordsAtMark: -1, // words before the row at the last mark of naming
  scale: "",
  line: 0,
  part: 0,
  depth: 0,
  leaves: 0,
});

// A list begins or ends.
function crossBracket(state, kind, step) {
  state.row = null;
  state.depth += step;
  if (kind === "leaf") state.leaves += step;
}

// A row ends, unless the list that it stands in is taken for one row.
function endRow(state, character) {
  if (character === "\n") state.line++;
  const isInRow = character !== ROW_END && state.parting.wrapped && state.leaves > 0;
  if (isInRow && character === ";" && state.row) state.row.isColumn = true;
  if (isInRow) return;
  state.row = null;
  if (character === "\n") endLine(state);
}

const FACTOR = "·factor·"; // MATLAB's headings become words of their own
const PART = "·columns·";
const SCALE_HEADING = /^[ \t]*(1(?:\.0+)?e[+-]?\d+)[ \t]*\*[ \t]*$/gim;
const COLUMNS_HEADING = /^[ \t]*Columns?[ \t_]+\d+(?:[ \t]+(?:through|and)[ \t]+\d+)?:?[ \t]*$/gim;

/**
 * Turn MATLAB's headings "1.0e+03 *" and "Columns 1 through 4" into words.
 * @param {import("./spans.js").SpannedText} text
 */
export const markHeadings = (text) =>
  text.replace(SCALE_HEADING, (_, power) => FACTOR + power).replace(COLUMNS_HEADING, PART);

function endLine(state) {
  const line = state.words.map(({ text }) => text).join(" ");
  if (line.startsWith(FACTOR)) state.scale = `*${line.slice(FACTOR.length)}`;
  if (line === PART) state.part++;
  if (line) state.above = state.words;
  if (/^\d{1,3}$/.test(state.name)) state.name = ""; // "Problem 3: Jacobian" names no row below
  Object.assign(state, { words: [], wordsAtMark: -1 });
}

const STRONG = ["\t", "&", "|", ";"];
const DECIMAL_COMMA = /^\s*[-+]?\d*,\d+[^,\d]*$/; // where another character parts the cells

// The cells between two brackets or rows' ends go to the rows.
function readSegment(from, to, state) {
  const { parting, text } = state;
  const line = state.line;
  const segment = text.slice(from, to);
  state.line += segment.split(CONTINUED).length - 1;
  if (!segment.trim()) return;
  const strong = STRONG.filter((character) => segment.includes(character));
  const separators = strong.length ? strong : parting.decimal ? [] : [","];
  const parts = partAt(text, from, to, (k) => (separators.includes(text[k]) ? text[k] : ""));
  for (const part of parts) {
    const piece = text.slice(part.from, part.to);
    if (!piece.trim()) continue;
    const decimal = strong.length && DECIMAL_COMMA.test(piece);
    const own = decimal ? { ...parting, decimal: true } : parting;
    const cells = parts.length > 1 ? cellsTogether(part, own, state) : cellsOf(part, own, state);
    for (const cell of cells) putCell(cell, line, state);
  }
}

// The cells of a part: a single one, where it is an entry as a whole or holds none.
function cellsTogether(part, parting, state) {
  const beside = cellsOf(part, parting, state);
  const whole = cellAt(part, parting, state);
  const isOne = !beside.every(({ text }) => isNumber(text)) && state.isEntry(whole.text);
  const cells = isOne ? [whole] : beside;
  if (cells.some(({ text }) => isMark(text) || state.isEntry(text))) return cells;
  return [{ ...whole, text: state.text.slice(part.from, part.to).trim() }];
}

/**
 * Part a stretch of a text at the characters that stand in no bracket; marks of naming are parts
 * themselves.
 * @param {string} text @param {number} from @param {number} to
 * @param {(at: number) => string} separatorAt "" for none
 * @returns {import("./spans.js").Span[]}
 */
function partAt(text, from, to, separatorAt) {
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

const STAMPS = [
  /^\d{9,}\.\d+$/,
  /^\d{4}-\d\d-\d\d/,
  /^\d{1,2}[/.]\d{1,2}[/.]\d{2,4}$/,
  /^\d{1,2}:\d\d(?:$|:\d\d)/,
];
const isStamp = (text) => STAMPS.some((pattern) => pattern.test(text));
// Units behind a number, as a factor of SI or a sign of degrees.
const UNITS = new Map(
  Object.entries({
    ...{ m: "", N: "", Nm: "", rad: "", radians: "", deg: " deg", degrees: " deg", "°": " deg" },
    ...{ Newtonmeters: "", Newtonmetres: "" },
    ...{ mm: "*1e-3", cm: "*1e-2", Nmm: "*1e-3", mNm: "*1e-3", kNm: "*1e3", kN: "*1e3" },
  }),
);
const unitOf = (word) => UNITS.get(word.replace(/[-·*⋅. ]/g, ""));
// Return whether a word is a unit of a length, an angle, a force or a moment.
export const isUnit = (word) => unitOf(word) !== undefined;
const MEASURED =
  /^([-+]? ?[\d.,]+(?:e[-+]?\d+)?(?: ?(?:π|pi\b))?)\s*([A-Za-z°][-A-Za-z°·*⋅. ]{0,12})$/;

// A text without what is written around it, its unit as a factor.
function cleaned(text, { decimal }) {
  let cell = text.trim().replace(/^"|"$|"?[.,;]$/g, "");
  if (decimal) cell = cell.replace(/(?<=\d|^[-+]?),(?=\d)/g, ".");
  if (cell.includes("[")) cell = cell.replaceAll("[", "(").replaceAll("]", ")");
  const [, number, word = ""] = MEASURED.exec(cell) ?? [];
  const unit = unitOf(word);
  return unit === undefined ? cell : `${number}${unit}`;
}

/** @returns {Cell} */
function cellAt({ from, to }, parting, { plain }) {
  const raw = plain.text.slice(from, to);
  const [start, end] = [from + raw.length - raw.trimStart().length, from + raw.trimEnd().length];
  const text = cleaned(raw.replace(/\s+/g, " "), parting);
  const span = plain.span(start, Math.max(start, end));
  return { text, ...span, stretches: plain.stretches(start, end) };
}

// The cells of a line whose entries stand beside each other; a comma and "and" part them too.
function cellsOf({ from, to }, parting, state) {
  const pieces = parting.gaps
    ? partedByGaps(state.text, from, to)
    : joinedPieces(piecesOf(state.text, from, to, parting), state.text);
  return pieces.map((piece) => cellAt(piece, parting, state)).filter(({ text }) => text);
}

function partedByGaps(text, from, to) {
  const pieces = [];
  let start = from;
  for (const gap of text.slice(from, to).matchAll(/, +|[ \t\v]{2,}/g)) {
    pieces.push({ from: start, to: from + gap.index });
    start = from + gap.index + gap[0].length;
  }
  return [...pieces, { from: start, to }].flatMap((piece) => withoutMark(piece, text));
}

// A name and the mark behind it, as in "tau =", apart.
function withoutMark(piece, text) {
  const [mark] = /(?<=\S\s*)=(?=\s*$)/.exec(text.slice(piece.from, piece.to)) ?? [];
  if (!mark) return [piece];
  const at = text.lastIndexOf(mark, piece.to - 1);
  return [
    { from: piece.from, to: at },
    { from: at, to: at + 1 },
  ];
}

const MARKS = [":=", "<<", "->", ":", "="];
const isMark = (text) => MARKS.includes(text);

// The pieces that blanks and commas part, outside brackets; marks of naming stand alone. Nothing is
// joined to a piece that is closed by a comma.
function piecesOf(text, from, to, { decimal }) {
  const separatorAt = (at) => {
    if (/\s/.test(text[at]) || (text[at] === "," && !decimal)) return text[at];
    return markAt(text, at);
  };
  return partAt(text, from, to, separatorAt)
    .filter((part) => part.to > part.from)
    .map((part) => ({ ...part, closed: text[part.to] === "," && !decimal }));
}

// A colon between the digits of a clock is no mark.
function markAt(text, at) {
  if (!"=:<-".includes(text[at])) return "";
  const mark = MARKS.find((one) => text.startsWith(one, at)) ?? "";
  return mark === ":" && CLOCK.test(text.slice(Math.max(0, at - 3), at + 4)) ? "" : mark;
}

const CLOCK = /(?:^|[^\p{L}\d_])\d{1,2}:\d\d(?![.\d])|:\d\d:\d|^\d\d:\d\d[.:]?\d?|\d{1,2}:\d\d:/u;

// Pieces that belong together: a sum with blanks about its signs, a number and its unit.
function joinedPieces(pieces, text) {
  const joined = [];
  for (const piece of pieces) {
    const last = joined.at(-1);
    if (last && belongs(last, piece, text))
      joined[joined.length - 1] = { ...piece, from: last.from };
    else joined.push(piece);
  }
  return joined;
}

const OPERATED = /[*/^]$|(?:^|\s)[-+±~≈]$|\\(?:times|cdot)$/; // something must follow
const OPERATES = /^[*/^]|^[-+±]$|^\\(?:times|cdot)$/; // something must stand before
const FACTOR_END = /^ *(?:rad|[\t\n|&;,]|$)/; // behind a factor π, which no entry follows

function belongs(last, piece, text) {
  const [before, word] = [last, piece].map(({ from, to }) => text.slice(from, to));
  if (last.closed || isMark(before) || isMark(word)) return false;
  if (OPERATED.test(before) || OPERATES.test(word)) return true;
  if (isFunction(before.replace(/^[-+]+/, ""))) return true;
  if (/^(?:π|pi)$/.test(word) && piece.from === last.to + 1)
    return /\d[.,]\d+$/.test(before) && FACTOR_END.test(text.slice(piece.to));
  return isUnit(word) && /(?:[\d.)](?: [kmM]?N)?|[\d ](?:π|pi))$/.test(before);
}

// A text before a mark of naming is a name, though it may look like an entry.
function takeBackName(state) {
  if (!state.row) return;
  const { cells, words } = state.row;
  const name = cells.pop();
  if (!cells.length) {
    state.rows.pop();
    state.words = words;
  }
  state.words.push(name);
  state.allWords.push(name);
}

// The name before a mark; of tau = g - JTF = [...] the first.
function nameRow(mark, state) {
  takeBackName(state);
  const isSame = mark === "=" && state.name && state.nameLine === state.line;
  state.name = isSame ? state.name : (state.words.at(-1)?.text ?? "");
  state.nameLine = mark === "=" ? state.line : -1;
  Object.assign(state, { scale: "", row: null, wordsAtMark: state.words.length });
}

function putCell(cell, line, state) {
  const { text } = cell;
  if (text === "and" && state.row) {
    state.row.hasAnd = true;
    return;
  }
  if (isMark(text)) {
    nameRow(text, state);
    return;
  }
  if (text.startsWith("·") || isStamp(text) || !state.isEntry(text)) {
    putWord(cell, state);
    return;
  }
  if (!state.row) {
    const { words, name, scale, part, above, depth, wordsAtMark } = state;
    const place = { line, last: line, part, depth, isAssigned: words.length === wordsAtMark };
    state.row = { cells: [], words, name, scale, above, ...place, tail: 0, hasAnd: false };
    state.rows.push(state.row);
    state.words = [];
    state.name = "";
  }
  state.row.cells.push(cell);
  state.row.tail = 0;
  state.row.last = state.line;
}

function putWord(typed, state) {
  if (state.row && !/[\p{L}\d]/u.test(typed.text)) {
    state.row.tail++; // an empty cell, as - or ✓
    return;
  }
  if (!/[\p{L}\d#<>]/u.test(typed.text)) return;
  const cell = { ...typed, line: state.line };
  state.words.push(cell);
  state.allWords.push(cell);
  if (state.row) state.row.tail++;
  state.row = null;
}
