// A text as runs of entries: what stands beside each other with no word, and no row's end, between.

import { isFunction, isNumber } from "./formula.js";
import { GOES_ON, ROW } from "./signs.js";

/**
 * Entries of one row, the words before them since the run before on the line, and whether they are
 * the whole of a list; `break` counts the rows' ends before them.
 * @typedef {{ cells: string[], words: string[], name: string, line: number, last: number,
 *   scale: string, part: number, above: string[], listed: boolean }} Run
 */
/**
 * How a text is parted: whether the innermost lists are taken for one row each, whether commas
 * between digits are decimal ones, and whether only gaps part entries, single blanks not.
 * @typedef {{ wrapped: boolean, decimal: boolean, gaps: boolean }} Way
 */

const OPEN = "[({";
const CLOSE = "])}";
const PARTS = `,;&|\t\n${ROW}`;
const WORD_BEFORE = /([A-Za-z]\w*)$/;
const MOST_INDEX = 6; // characters of [1, 1] behind a name

/**
 * What each bracket of a text is: "list", "leaf" for one that holds none, or "group" in a formula
 * or a name.
 * @param {string} text
 * @returns {Map<number, string>}
 */
function bracketsOf(text) {
  const found = new Map();
  const open = [];
  for (let at = 0; at < text.length; at++) {
    const sign = text[at];
    if (OPEN.includes(sign)) open.push({ at, sign, parted: false, leaf: true });
    else if (CLOSE.includes(sign) && open.length) {
      const one = open.pop();
      const kind = isList(text, one, at) ? (one.leaf ? "leaf" : "list") : "group";
      found.set(one.at, kind).set(at, kind);
      if (open.length && kind !== "group") open.at(-1).leaf = false;
    } else if (open.length && PARTS.includes(sign)) open.at(-1).parted = true;
  }
  return found;
}

function isList(text, { at, sign, parted, leaf }, end) {
  const before = text[at - 1] ?? " ";
  const word = WORD_BEFORE.exec(text.slice(Math.max(0, at - 12), at))?.[1] ?? "";
  if (word && isFunction(word.toLowerCase())) return false;
  if (sign === "{") return !/[\w^}]/.test(before);
  if (sign === "[") return !/[\w})]/.test(before) || end - at > MOST_INDEX;
  return isRound(text, { at, parted, leaf }, end, before);
}

// Round brackets that are no index and hold several things.
function isRound(text, { at, parted, leaf }, end, before) {
  if (/\w/.test(before) && end - at <= MOST_INDEX) return false;
  return parted || !leaf || (/[\s=]/.test(before) && NUMBERS.test(text.slice(at + 1, end)));
}

const NUMBERS = /^\s*[-+]?[\d.]+(?:\s+[-+]?[\d.]+)+\s*$/; // beside each other

/**
 * @param {string} text in plain signs
 * @param {(cell: string) => boolean} isEntry
 * @param {Way} way
 * @returns {Run[]}
 */
export function runsOf(text, isEntry, way) {
  const state = started(isEntry, way);
  const brackets = bracketsOf(text);
  let [from, groups] = [0, 0];
  for (let at = 0; at < text.length; at++) {
    const kind = brackets.get(at);
    if (kind === "group") groups += OPEN.includes(text[at]) ? 1 : -1;
    const ends = kind ? kind !== "group" : endsRow(text[at], state);
    if (groups || !ends) continue;
    segment(text.slice(from, at), state);
    from = at + 1;
    if (kind) crossed(state, kind, OPEN.includes(text[at]) ? 1 : -1);
    else ended(state, text[at]);
  }
  segment(text.slice(from), state);
  return state.runs;
}

// Semicolons part rows in lists, and cells outside.
const endsRow = (sign, { leaves }) => sign === "\n" || sign === ROW || (sign === ";" && leaves > 0);

// Where the walk through a text stands: the run that goes on, the words before the next one and of
// the line above, how deep in lists.
const started = (isEntry, way) => ({
  isEntry,
  way,
  runs: /** @type {Run[]} */ ([]),
  run: /** @type {Run | null} */ (null),
  words: /** @type {string[]} */ ([]),
  above: /** @type {string[]} */ ([]),
  name: "",
  named: -1, // the line of a name before =
  scale: "",
  line: 0,
  part: 0,
  depth: 0,
  leaves: 0,
});

// A list begins or ends.
function crossed(state, kind, step) {
  state.run = null;
  state.depth += step;
  if (kind === "leaf") state.leaves += step;
}

// A row ends, unless the list that it stands in is taken for one row.
function ended(state, sign) {
  if (sign === "\n") state.line++;
  if (sign !== ROW && state.way.wrapped && state.leaves) return;
  state.run = null;
  if (sign === "\n") lineEnded(state);
}

const FACTOR = "·factor·"; // what MATLAB's heads are turned into: words of their own
const PART = "·columns·";

// A text whose heads "1.0e+03 *" and "Columns 1 through 4" are words.
export const withHeads = (text) =>
  text.replace(SCALE, (_, power) => FACTOR + power).replace(COLUMNS, PART);

const SCALE = /^[ \t]*(1(?:\.0+)?e[+-]?\d+)[ \t]*\*[ \t]*$/gim;
const COLUMNS = /^[ \t]*Columns?[ \t]+\d+(?:[ \t]+(?:through|and)[ \t]+\d+)?:?[ \t]*$/gim;

function lineEnded(state) {
  const said = state.words.join(" ");
  if (said.startsWith(FACTOR)) state.scale = `*${said.slice(FACTOR.length)}`;
  if (said === PART) state.part++;
  if (said) state.above = state.words;
  state.words = [];
}

const PARTING = ["\t", "&", "|", ";"];
const DECIMAL_COMMA = /^\s*[-+]?\d+,\d+\s*$/; // where another sign parts the cells

// The cells of what stands between two brackets or row's ends go to the runs.
function segment(text, state) {
  const { way } = state;
  const line = state.line;
  state.line += text.split(GOES_ON).length - 1;
  if (!text.trim()) return;
  const strong = PARTING.filter((sign) => text.includes(sign));
  const parts = strong.length ? partedAt(text, strong) : partedAt(text, way.decimal ? [] : [","]);
  for (const part of parts) {
    if (!part.trim()) continue;
    const how = strong.length && DECIMAL_COMMA.test(part) ? { ...way, decimal: true } : way;
    for (const cell of parts.length > 1 ? together(part, how, state) : cellsOf(part, how))
      put(cell, line, state);
  }
}

// The cells of a part: one, where it is an entry as a whole or holds none.
function together(part, way, { isEntry }) {
  const beside = cellsOf(part, way);
  const whole = cleaned(part, way);
  const cells = !beside.every(isNumber) && isEntry(whole) ? [whole] : beside;
  return cells.some((cell) => isMark(cell) || isEntry(cell)) ? cells : [part.trim()];
}

// A text parted at the signs that stand in no bracket; marks of naming are parts themselves.
/** @param {string} text @param {(k: number) => string} signAt "" for none @returns {string[]} */
function parted(text, signAt) {
  const parts = [];
  let [depth, from] = [0, 0];
  for (let k = 0; k < text.length; k++) {
    if (OPEN.includes(text[k])) depth++;
    else if (CLOSE.includes(text[k])) depth = Math.max(0, depth - 1);
    const sign = depth ? "" : signAt(k);
    if (!sign) continue;
    parts.push(text.slice(from, k));
    if (isMark(sign)) parts.push(sign);
    k += sign.length - 1;
    from = k + 1;
  }
  return [...parts, text.slice(from)];
}

const partedAt = (text, signs) => parted(text, (k) => (signs.includes(text[k]) ? text[k] : ""));

const STAMP = /^\d{9,}\.\d+$|^\d{4}-\d\d-\d\d|^\d{1,2}[/.]\d{1,2}[/.]\d{2,4}$|^\d{1,2}:\d\d/;
// Units behind a number, as a factor of SI or a sign of degrees.
const UNITS = new Map(
  Object.entries({
    ...{ m: "", N: "", Nm: "", rad: "", radians: "", deg: " deg", degrees: " deg", "°": " deg" },
    ...{ mm: "*1e-3", cm: "*1e-2", Nmm: "*1e-3" },
  }),
);
const unitOf = (word) => UNITS.get(word.replace(/[·*⋅. \0]/g, ""));
const MEASURED = /^([-+]? ?[\d.,]+(?:e[-+]?\d+)?)\s*([A-Za-z°][A-Za-z°·*⋅. ]{0,9})$/;

// A cell without what is written around it, its unit as a factor.
function cleaned(cell, way) {
  let text = cell.trim().replace(/^"|"$|"?[.,;]$/g, "");
  if (way.decimal) text = text.replace(/(?<=\d),(?=\d)/g, ".");
  if (text.includes("[")) text = text.replaceAll("[", "(").replaceAll("]", ")");
  const [, number, word = ""] = MEASURED.exec(text) ?? [];
  const unit = unitOf(word);
  return unit === undefined ? text : `${number}${unit}`;
}

// The cells of a line whose entries stand beside each other; a comma and "and" part them too.
function cellsOf(text, way) {
  const list = way.decimal ? text : partedAt(text, [","]).join(`${PARTED} `);
  const pieces = way.gaps ? list.trim().split(/[ ]{2,}/) : joined(wordsOf(list));
  return pieces.map((piece) => cleaned(piece.replaceAll(PARTED, ""), way)).filter(Boolean);
}

const PARTED = "\u0000"; // where a comma stood
const MARKS = [":=", "<<", "->", ":", "="];
const isMark = (cell) => MARKS.includes(cell);

// What blanks part, outside brackets; marks of naming stand alone.
const wordsOf = (text) =>
  parted(text, (k) => (/\s/.test(text[k]) ? text[k] : markAt(text, k))).filter(Boolean);

// A colon between digits is a clock's.
function markAt(text, k) {
  if (!"=:<-".includes(text[k])) return "";
  const mark = MARKS.find((one) => text.startsWith(one, k)) ?? "";
  return mark === ":" && /^\d:\d/.test(text.slice(k - 1, k + 2)) ? "" : mark;
}

// Words that belong together: a sum with blanks about its signs, a number and its unit.
function joined(words) {
  const found = [];
  for (const word of words) {
    if (found.length && joins(found.at(-1), word)) found.push(`${found.pop()} ${word}`);
    else found.push(word);
  }
  return found;
}

const OPERATED = /[*/^]$|(?:^|\s)[-+±~≈]$/; // something must follow
const OPERATES = /^[*/^]|^[-+±]$/; // something must stand before

function joins(before, word) {
  if (before.endsWith(PARTED) || isMark(before) || isMark(word)) return false;
  if (OPERATED.test(before) || OPERATES.test(word)) return true;
  if (isFunction(before.replace(/^[-+]+/, ""))) return true;
  return unitOf(word) !== undefined && /[\d.)](?: N)?$/.test(before);
}

// What stands before a mark of naming is a name, though it may look like an entry.
function unsaid(state) {
  if (!state.run) return;
  const { cells, words } = state.run;
  const name = cells.pop();
  if (!cells.length) {
    state.runs.pop();
    state.words = words;
  }
  state.words.push(name);
}

// The name before a mark; of tau = g - JTF = [...] the first.
function marked(cell, state) {
  unsaid(state);
  const goes = cell === "=" && state.name && state.named === state.line;
  state.name = goes ? state.name : (state.words.at(-1) ?? "");
  state.named = cell === "=" ? state.line : -1;
  state.scale = "";
  state.run = null;
}

function put(cell, line, state) {
  if (cell === "and" && state.run) return;
  if (isMark(cell)) {
    marked(cell, state);
    return;
  }
  if (cell.startsWith("·") || STAMP.test(cell) || !state.isEntry(cell)) {
    if (state.run && !/[\p{L}\d]/u.test(cell)) return;
    if (!/[\p{L}\d#<>]/u.test(cell)) return;
    state.words.push(cell);
    state.run = null;
    return;
  }
  if (!state.run) {
    const { words, name, scale, part, above } = state;
    const listed = state.depth > 0;
    state.run = { cells: [], words, name, line, last: line, scale, part, above, listed };
    state.runs.push(state.run);
    state.words = [];
    state.name = "";
  }
  state.run.cells.push(cell);
  state.run.last = state.line;
}
