// A text as runs of entries: what stands beside each other with no word, and no row's end, between.

import { isFunction } from "./formula.js";
import { ROW } from "./signs.js";

/**
 * Entries of one row, the words before them since the run before on the line, and whether they are
 * the whole of a list; `break` counts the rows' ends before them.
 * @typedef {{ cells: string[], words: string[], name: string, line: number, scale: string,
 *   part: number, above: string[], listed: boolean }} Run
 */
/**
 * How a text is parted: whether a line's end inside the innermost list ends a row, whether commas
 * between digits are decimal ones, and whether single blanks part entries.
 * @typedef {{ wrapped: boolean, decimal: boolean, gaps: boolean }} Way
 */

const OPEN = "[({";
const CLOSE = "])}";
const WORD_BEFORE = /([A-Za-z]+)$/;
const MOST_INDEX = 6; // characters of [1, 1] behind a name

/**
 * What each bracket of a text is: "list", or "group" in a formula or a name.
 * @param {string} text
 * @returns {Map<number, string>}
 */
function bracketsOf(text) {
  const found = new Map();
  const open = [];
  for (let at = 0; at < text.length; at++) {
    const sign = text[at];
    if (OPEN.includes(sign)) open.push({ at, sign, parted: false, holds: false, leaf: true });
    else if (CLOSE.includes(sign)) {
      const one = open.pop();
      if (!one) continue;
      const list = isList(text, one, at);
      found.set(one.at, list ? (one.leaf ? "leaf" : "list") : "group").set(at, list ? "list" : "group");
      const outer = open.at(-1);
      if (outer && list) outer.holds = true;
      if (outer && list) outer.leaf = false;
    } else if (`,;&|\t\n${ROW}`.includes(sign) && open.length) open.at(-1).parted = true;
  }
  return found;
}

function isList(text, { at, sign, parted, holds }, end) {
  const before = text[at - 1] ?? " ";
  const word = WORD_BEFORE.exec(text.slice(Math.max(0, at - 12), at))?.[1] ?? "";
  if (word && isFunction(word.toLowerCase())) return false;
  if (sign === "{") return !/[\w^}]/.test(before);
  if (sign === "[") return !/[\w})]/.test(before) || end - at > MOST_INDEX;
  return holds || parted;
}

/**
 * @param {string} text in plain signs
 * @param {(cell: string) => boolean} isEntry
 * @param {Way} way
 * @returns {Run[]}
 */
export function runsOf(text, isEntry, way) {
  const brackets = bracketsOf(text);
  const state = /** @type {any} */ ({ runs: [], words: [], run: null, line: 0, scale: "", part: 0, name: "" });
  Object.assign(state, { above: [], listed: false });
  let [from, leaves, groups, depth] = [0, 0, 0, 0];
  const flush = (to) => {
    segment(text.slice(from, to), isEntry, way, state);
    from = to + 1;
  };
  for (let at = 0; at < text.length; at++) {
    const kind = brackets.get(at);
    const opens = OPEN.includes(text[at]);
    if (kind === "group") groups += opens ? 1 : -1;
    else if (kind) {
      flush(at);
      ended(state);
      depth += opens ? 1 : -1;
      state.listed = depth > 0;
      leaves = opens && kind === "leaf" ? leaves + 1 : opens ? leaves : Math.max(0, leaves - 1);
    } else if (groups) continue;
    else if (text[at] === ROW || (text[at] === ";" && leaves)) {
      flush(at);
      ended(state);
    } else if (text[at] === "\n") {
      flush(at);
      state.line++;
      if (!(way.wrapped && leaves)) {
        ended(state);
        lineEnded(state);
      }
    }
  }
  flush(text.length);
  ended(state);
  return state.runs;
}

const FACTOR = "·factor·"; // what MATLAB's heads are turned into: words of their own
const PART = "·columns·";

// A text whose heads "1.0e+03 *" and "Columns 1 through 4" are words.
export const withHeads = (text) =>
  text.replace(SCALE, (_, power) => FACTOR + power).replace(COLUMNS, PART);

function ended(state) {
  state.run = null;
}

const SCALE = /^[ \t]*(1(?:\.0+)?e[+-]?\d+)[ \t]*\*[ \t]*$/gim;
const COLUMNS = /^[ \t]*Columns?[ \t]+\d+(?:[ \t]+(?:through|to|and)[ \t]+\d+)?[ \t]*:?[ \t]*$/gim;

function lineEnded(state) {
  const said = state.words.join(" ");
  if (said.startsWith(FACTOR)) state.scale = `*${said.slice(FACTOR.length)}`;
  if (said === PART) state.part++;
  if (said) state.above = state.words;
  state.words = [];
}

const PARTING = ["\t", "&", "|", ";"];

// The cells of what stands between two brackets or row's ends go to the runs.
function segment(text, isEntry, way, state) {
  if (!text.trim()) return;
  const strong = PARTING.filter((sign) => text.includes(sign));
  const parts = strong.length ? partedAt(text, strong) : partedAt(text, way.decimal ? [] : [","]);
  for (const part of parts) {
    if (!part.trim()) continue;
    const whole = cleaned(part, way);
    const cells = parts.length > 1 && isEntry(whole) ? [whole] : cellsOf(part, way);
    const word = parts.length > 1 && !cells.some((cell) => MARK.test(cell) || isEntry(cell));
    for (const cell of word ? [part.trim()] : cells) put(cell, state, isEntry);
  }
}

// A text parted at signs that stand in no bracket.
function partedAt(text, signs) {
  const parts = [];
  let [depth, from] = [0, 0];
  for (let k = 0; k < text.length; k++) {
    if (OPEN.includes(text[k])) depth++;
    else if (CLOSE.includes(text[k])) depth = Math.max(0, depth - 1);
    else if (!depth && signs.includes(text[k])) {
      parts.push(text.slice(from, k));
      from = k + 1;
    }
  }
  return [...parts, text.slice(from)];
}

const STAMP = /^\d{4}-\d\d-\d\d|^\d{1,2}[/.]\d{1,2}[/.]\d{2,4}$|^\d{1,2}:\d\d/;
const WORTH = { mm: "*1e-3", cm: "*1e-2", Nmm: "*1e-3", "°": " deg" };

// A cell without what is written around it, its unit as a factor.
function cleaned(cell, way) {
  let text = cell.trim().replace(/^"|"$|"?[.,;]$/g, "");
  if (way.decimal) text = text.replace(/(?<=\d),(?=\d)/g, ".");
  if (text.includes("[")) text = text.replaceAll("[", "(").replaceAll("]", ")");
  const number = /^([-+]? ?[\d.,]+(?:e[-+]?\d+)?)\s*(\S.*)$/i.exec(text);
  const [, unit] = (number && /^([A-Za-z°·*⋅. ]{1,8})$/.exec(number[2])) ?? [];
  if (!unit) return text;
  const name = unit.replace(/[·*⋅. ]/g, "");
  if (/^(?:Nm|N|rad(?:ians?)?|m)$/.test(name)) return number[1];
  return /^(?:deg(?:rees?)?|mm|cm|Nmm|°)$/.test(name)
    ? `${number[1]}${WORTH[name] ?? " deg"}`
    : text;
}

// The cells of a line whose entries stand beside each other; a comma and "and" part them too.
function cellsOf(text, way) {
  const list = way.decimal ? text : partedAt(text, [","]).join("\u0000 ");
  const pieces = way.gaps ? list.trim().split(/[ ]{2,}/) : joined(wordsOf(list));
  return pieces.map((piece) => cleaned(piece.replaceAll("\u0000", ""), way)).filter(Boolean);
}

const MARK = /^(?::=|:|=|<<|->|=>)$/;

// What blanks part, outside brackets; marks of naming stand alone.
function wordsOf(text) {
  const parts = [];
  let [depth, from] = [0, 0];
  const cut = (to) => {
    if (to > from) parts.push(text.slice(from, to));
    from = to;
  };
  for (let k = 0; k < text.length; k++) {
    if (OPEN.includes(text[k])) depth++;
    else if (CLOSE.includes(text[k])) depth = Math.max(0, depth - 1);
    if (depth) continue;
    if (/\s/.test(text[k])) {
      cut(k);
      from = k + 1;
    } else if (marks(text, k)) {
      cut(k);
      const mark = [":=", "<<", "->", "=>"].find((one) => text.startsWith(one, k)) ?? text[k];
      parts.push(mark);
      k += mark.length - 1;
      from = k + 1;
    }
  }
  cut(text.length);
  return parts;
}

// A colon between digits is a clock's.
const marks = (text, k) =>
  text[k] === "=" ||
  (text[k] === ":" && !(/\d/.test(text[k - 1]) && /\d/.test(text[k + 1]))) ||
  text.startsWith("<<", k) ||
  text.startsWith("->", k);

const UNIT = /^(?:°|deg(?:rees?)?|rad(?:ians?)?|N|Nm|N[·*⋅.]m|m|mm|cm|Nmm)\u0000?$/;

// Words that belong together: a sum with blanks about its signs, a number and its unit.
function joined(words) {
  const found = [];
  for (let k = 0; k < words.length; k++) {
    const word = words[k];
    const before = found.at(-1) ?? "";
    const last = before.at(-1) ?? "";
    const bare = before.replace(/^[-+]+/, "");
    const joins =
      before &&
      last !== "\u0000" &&
      !MARK.test(before) &&
      ("*/^".includes(last) ||
        /(?:^|\s)[-+]$/.test(before) ||
        "*/^".includes(word[0]) ||
        /^[-+]$/.test(word) ||
        isFunction(bare) ||
        (UNIT.test(word) && /[\d.)]$|[\d.] N$/.test(before)));
    if (joins) found[found.length - 1] = `${before} ${word}`;
    else found.push(word);
  }
  return found;
}

const AND = /^(?:and|und|et|y|e|&)$/;

function put(cell, state, isEntry) {
  if (AND.test(cell) && state.run) return;
  if (MARK.test(cell)) {
    state.name = state.words.at(-1) ?? "";
    state.scale = "";
    state.run = null;
    return;
  }
  if (cell.startsWith("·") || STAMP.test(cell) || !isEntry(cell)) {
    if (state.run && !/[\p{L}\d]/u.test(cell)) return;
    if (!/[\p{L}\d#]/u.test(cell)) return;
    state.words.push(cell);
    state.run = null;
    return;
  }
  if (!state.run) {
    const { words, name, line, scale, part, above, listed } = state;
    state.run = { cells: [], words, name, line, scale, part, above, listed };
    state.runs.push(state.run);
    state.words = [];
    state.name = "";
  }
  state.run.cells.push(cell);
}
