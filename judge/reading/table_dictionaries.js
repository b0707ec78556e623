// Reads tables whose rows are dictionaries, {'a': 0, 'alpha': pi/2}, or lines of pairs,
// a = 0, alpha = pi/2.

import { listLines } from "./spans.js";
import { findEntry } from "./table_columns.js";
import { makeEntry, makeUntyped } from "./table_named_entries.js";
import { ENTRIES } from "./table_rows.js";
import { LENGTH_UNIT } from "./units.js";
import { ArmError, formatMessage, quoteText } from "../sentences.js";

/** @typedef {import("./spans.js").Span} Span */
/** @typedef {import("./table_named_entries.js").Bracket} Bracket */
/** @typedef {import("./table_named_entries.js").Entry} Entry */
/** @typedef {import("./table_named_entries.js").EntryRows} EntryRows */

const INDEX = String.raw`_?[({]?(?:i(?: ?- ?1)?|(\d{1,2})|deg|rad|${LENGTH_UNIT})?[)}]?`;
const PAIR = new RegExp(String.raw`['"]?(?<![A-Za-zαθ/])([A-Za-zαθ]+${INDEX})['"]?\s*[:=]\s*`, "g");

const UNIT = new RegExp(String.raw`[:=]\s*["']?(?:${LENGTH_UNIT}|deg|rad)\w*["']?\s*$`);
// Return whether a dictionary holds units only: {length: m, angle: deg}.
const holdsUnits = (body) => body.split(",").every((pair) => UNIT.test(pair));

/**
 * A name with its entry, as "a_1 = 0.5". `index` is the number of the name, `column` the entry that
 * the name stands for.
 * @typedef {{ column: string, name: string, index: string | undefined, entry: Entry }} Pair
 */
/**
 * A dictionary or a line. `body` is its text inside the braces, which begins at `start`.
 * @typedef {Span & { body: string, start: number }} Body
 */
/** @typedef {{ pairs: Pair[], parts: Span[], body: Body, fewest: number }} PairRow */

/**
 * Read a row from each dictionary, {'a': 0, 'alpha': pi/2, ...} or dict(a=0, ...), or from each
 * line of pairs. If the names have numbers, as in a_1 = 0, the number is that of the row. A
 * dictionary may leave out entries that are 0. Otherwise a row needs three pairs. If alpha and a
 * count from 0 but d and theta from 1, the table follows Craig, and alpha0, a0 and d1 share a row.
 * @param {string} text @param {Bracket[]} brackets @returns {EntryRows | null}
 */
export function readDictionaries(text, brackets) {
  const braced = brackets.filter(
    ({ open, before, hasPairs, body }) =>
      hasPairs && (open === "{" || before.endsWith("dict")) && !holdsUnits(body),
  );
  const isBraced = braced.length > 0;
  /** @type {Body[]} */
  const bodies = isBraced ? braced : listLineBodies(text);
  const pairsByBody = bodies.map(listPairs);
  const isCraig = countsTwistsFromZero(pairsByBody.flat());
  const rows = collectRows(
    bodies,
    isCraig ? pairsByBody.map((pairs) => pairs.map(countFromOne)) : pairsByBody,
    isBraced,
  );
  const kept = listRows(rows);
  if (!kept) return null;
  const columnsByRow = kept.map(({ pairs }, k) => mapColumns(pairs, k + 1));
  const isNumbered = kept.some(({ pairs }) => pairs.some(({ index }) => index !== undefined));
  if (isNumbered || !isBraced) requireSameColumns(columnsByRow);
  const columns = columnsByRow.some((map) => map.has(OFFSET)) ? [...ENTRIES, OFFSET] : ENTRIES;
  const table = {
    rows: columnsByRow.map((map, k) =>
      columns.map((name) => map.get(name)?.entry ?? makeOmitted(name, k + 1)),
    ),
    headers: columns.map((name) => columnsByRow[0].get(name)?.name ?? name),
    parts: kept.flatMap(({ parts }) => parts),
  };
  return isCraig ? { ...table, convention: "craig" } : table;
}

// List the lines of a text. If each pair has its own line, as in YAML, the lines of a row are
// joined: a repeated name begins the next row.
/** @param {string} text @returns {Body[]} */
function listLineBodies(text) {
  const lines = listLines(text).map((line) => ({ ...line, body: line.text, start: line.from }));
  const columns = lines.map((line) => listPairs(line).map(({ index, column }) => index ?? column));
  const bodies = [];
  let names = [];
  for (const [k, line] of lines.entries()) {
    const hasEntries = columns[k].length > 0 && columns[k].every((name) => ENTRIES.includes(name));
    if (hasEntries && names.length > 0 && !columns[k].some((name) => names.includes(name))) {
      const { from } = bodies.at(-1);
      bodies[bodies.length - 1] = {
        from,
        to: line.to,
        body: text.slice(from, line.to),
        start: from,
      };
      names.push(...columns[k]);
    } else {
      bodies.push(line);
      names = [...columns[k]];
    }
  }
  return bodies;
}

// Collect the pairs of each row. Pairs belong together if their names have the same number, or if
// they stand in the same dictionary or line.
/** @param {Body[]} bodies @param {Pair[][]} pairsByBody @param {boolean} isBraced */
function collectRows(bodies, pairsByBody, isBraced) {
  /** @type {Map<string | number, PairRow>} */
  const rows = new Map();
  bodies.forEach((body, k) => {
    const isWhole = isBraced && body.body.match(/[:=]/g)?.length === pairsByBody[k].length;
    for (const pair of pairsByBody[k]) {
      const fewest = isWhole && !pair.index ? 1 : 3;
      const row = rows.get(pair.index ?? k) ?? { pairs: [], parts: [], body, fewest };
      rows.set(pair.index ?? k, row);
      row.pairs.push(pair);
      row.parts.push({ from: body.from, to: body.to });
    }
  });
  return rows;
}

// List the rows that have enough entries, or null if there are fewer than two such rows. If these
// rows come from numbered names, return the rows of all numbers.
/** @param {Map<string | number, PairRow>} rows */
function listRows(rows) {
  const kept = [...rows].filter(([, { pairs, fewest }]) => countColumns(pairs) >= fewest);
  if (kept.length < 2) return null;
  const isNumbered = kept.every(([key]) => typeof key === "string");
  const numbered = [...rows].filter(([key]) => typeof key === "string");
  const sorted = isNumbered ? numbered.sort(([one], [other]) => Number(one) - Number(other)) : kept;
  return sorted.map(([, row]) => row);
}

const OFFSET = "offset";
const countColumns = (pairs) => new Set(pairs.map(({ column }) => column)).size;

// Map the columns of a row to its pairs. Refuse two different values of a column. An offset beside
// d belongs to the joint variable.
/** @param {Pair[]} pairs @param {number} row */
function mapColumns(pairs, row) {
  const namesD = pairs.some(({ name }) => name === "d");
  /** @type {Map<string, Pair>} */
  const columns = new Map();
  for (const pair of pairs) {
    const column = namesD && pair.name === OFFSET ? OFFSET : pair.column;
    const before = columns.get(column)?.entry.text;
    if (before !== undefined && before !== pair.entry.text) {
      const values = [before, pair.entry.text].map(quoteText);
      const fields = { row, name: column, one: values[0], other: values[1] };
      throw new ArmError(formatMessage("row two values", fields));
    }
    columns.set(column, pair);
  }
  return columns;
}

// Refuse a row without an entry that other rows have.
/** @param {Map<string, Pair>[]} columnsByRow */
function requireSameColumns(columnsByRow) {
  for (const name of ENTRIES) {
    const row = columnsByRow.findIndex((columns) => !columns.has(name));
    if (row >= 0 && columnsByRow.some((columns) => columns.has(name)))
      throw new ArmError(formatMessage("row lacks", { row: row + 1, name }));
  }
}

const isTwist = ({ column }) => column === "a" || column === "alpha";

// Return whether a and alpha are numbered from 0, and d and theta from 1.
function countsTwistsFromZero(pairs) {
  const least = (list) => Math.min(...list.map(({ index }) => Number(index ?? Infinity)));
  const others = pairs.filter((pair) => !isTwist(pair));
  return least(pairs.filter(isTwist)) === 0 && least(others) === 1;
}

const countFromOne = (pair) =>
  isTwist(pair) && pair.index !== undefined
    ? { ...pair, index: String(Number(pair.index) + 1) }
    : pair;

// List the pairs of a text. A value ends at a comma, a semicolon, a bracket or the next name. A
// comma between digits is a decimal comma.
/** @param {Body} body @returns {Pair[]} */
function listPairs({ body, start }) {
  const names = [...body.matchAll(PAIR)];
  return names.flatMap(({ 0: all, 1: name, 2: index, index: at }, k) => {
    const from = at + all.length;
    const [value] = body.slice(from, names[k + 1]?.index).split(/,(?!\d)|[;[]/);
    const typed = makeEntry(value, start + from);
    const entry = { ...typed, text: typed.text.replace(/(?<=\d),(?=\d)/g, ".") };
    const column = findEntry(name.replace(/\d+/, ""));
    if (!ENTRIES.includes(column) || !entry.text) return [];
    return [{ column, name: index ? column : name, index, entry }];
  });
}

const makeOmitted = (column, row) => makeUntyped(column === "theta" ? `q_${row}` : "0");
