// Reads tables whose entries have names, in lists such as a = [0, 0.4], calls such as Link(...),
// dictionaries or pairs such as a_1 = 0. All become rows of entries below column headers.

import { listLines } from "./spans.js";
import { findEntry, nameColumns } from "./table_columns.js";
import { readDictionaries } from "./table_dictionaries.js";
import { readLinks } from "./table_links.js";
import { listBrackets, listEntries, makeUntyped } from "./table_named_entries.js";
import { ENTRIES, isVariable } from "./table_rows.js";
import { refuseLongText } from "./odd_texts.js";
import { ArmError, formatMessage, quoteText } from "../sentences.js";

const MOST_ROWS = 32;

/** @typedef {import("./spans.js").Span} Span */
/** @typedef {import("./table_named_entries.js").Bracket} Bracket */
/** @typedef {import("./table_named_entries.js").Entry} Entry */
/** @typedef {import("./table_named_entries.js").EntryRows} EntryRows */
/**
 * A table whose entries have names. `sources` are the spans of its entries, `parts` the spans of
 * its rows or lists, `context` is the text around them, and
 * `unread` is text between the rows with a number that no row used.
 * @typedef {{ cells: string[][], headers: string[], assumptions: string[], convention?: string,
 *   sources: Source[], parts: Span[], context: string, unread: Span | null }} NamedTable
 */
/** @typedef {Span & { row: number, column: number }} Source `column` in the order of ENTRIES */

/**
 * Read a table whose entries have names, in the first notation that fits.
 * @param {string} typedText
 * @returns {NamedTable | null} null if the text is in no such notation
 */
export function readNamedTable(typedText) {
  const text = typedText.replace(/[“”„‟‘’]/g, '"');
  const brackets = listBrackets(text);
  const table =
    readLinks(text, brackets) ?? readDictionaries(text, brackets) ?? readLists(text, brackets);
  if (!table) return null;
  const { rows, headers, parts, assumptions = [], convention } = table;
  refuseManyRows(rows.length);
  const columns = nameColumns(headers);
  const sources = rows.flatMap((entries, row) =>
    entries.flatMap(({ spans }, k) => {
      const column = ENTRIES.indexOf(columns[k]);
      return spans.map((span) => ({ ...span, row, column }));
    }),
  );
  const cells = rows.map((entries) => entries.map((entry) => entry.text));
  const unread = table.unread ?? findUnreadGap(text, parts);
  const context = findContext(text, parts);
  return { cells, headers, assumptions, sources, parts, unread, convention, context };
}

// Names with their indices, labels such as "joint 2" and comments, whose numbers are no entries.
const NAMES =
  /(?<!\S)(?:#|%|\/\/).*|(?:joint|link|row):? ?\d+|^\s*\d+[.:)]|[\p{L}_]\w*(?:[[({]\d+[\])}])?/gimu;

// An assignment to an entry that changes the rows: L(2).offset = pi/6, r.tool = ..., a(2) = 0.45.
// In YAML a tool has lines of its own.
const ASSIGNED = new RegExp(
  String.raw`(?:\.(?:a|d|alpha|theta|offset|tool|base)|(?<![\w.])(?:a|r|d|alpha|theta|offset)` +
    String.raw` ?[[(]\d{1,2}[\])]) ?=(?!=)[^\n]*[1-9π]|^[ \t]*(?:tool|base):[ \t]*\n[^\n]*[1-9π]`,
  "gm",
);

/**
 * Find text between the rows of a table, or on their lines, with a number that no row used,
 * or an assignment to an entry of a row.
 * @param {string} text @param {Span[]} parts @returns {Span | null}
 */
function findUnreadGap(text, parts) {
  const isOutside = ({ from }) => parts.every((part) => from < part.from || from >= part.to);
  const assigned = [...text.matchAll(ASSIGNED)]
    .map(({ 0: words, index }) => ({ from: index, to: index + words.length }))
    .find(isOutside);
  if (assigned) return assigned;
  const sorted = [...parts].sort((one, other) => one.from - other.from);
  const start = text.lastIndexOf("\n", sorted[0].from) + 1;
  const end = `${text}\n`.indexOf("\n", sorted.at(-1).to);
  const ends = [start, ...sorted.map(({ to }) => to)];
  const gaps = [...sorted.map(({ from }) => from), end].map((to, k) => ({ from: ends[k], to }));
  const hasNumber = ({ from, to }) => /\d/.test(text.slice(from, to).replace(NAMES, ""));
  const gap = gaps.find(hasNumber);
  if (!gap) return null;
  const words = text.slice(gap.from, gap.to).replace(/^[\s,;)]+|[\s,;]+$/g, "");
  const from = text.indexOf(words, gap.from);
  return { from, to: from + words.length };
}

// Return the lines outside the table.
/** @param {string} text @param {Span[]} parts */
function findContext(text, parts) {
  const isInside = (/** @type {Span} */ { from, to }) =>
    parts.some((part) => part.from < to && part.to > from);
  const others = listLines(text).filter((line) => !isInside(line));
  return others.map((line) => line.text.trim()).join("\n");
}

const LIST = /([\p{L}_][\p{L}\p{N}_]*)['"]?\s*[=:]\s*(?:(?:np\.array|Matrix)?\s*\(\s*)?$/u;

/**
 * Read a table from four lists of the same length, or from three lists of a, alpha and d.
 * @param {string} text @param {Bracket[]} brackets @returns {EntryRows | null}
 */
function readLists(text, brackets) {
  const lists = brackets.flatMap(({ open, before, body, start, from, to }) => {
    const name = open === "(" ? null : LIST.exec(before);
    if (!name) return [];
    const part = { from: from - name[0].length, to };
    return [{ column: findListEntry(name[1]), entries: listEntries(body, start), part }];
  });
  if (lists.length < 3 || !lists.every(({ column }) => ENTRIES.includes(column))) return null;
  const columns = new Map(lists.map(({ column, entries }) => [column, entries]));
  refuseTwoLists(lists);
  const counts = [...new Set([...columns.values()].map(({ length }) => length))];
  if (counts.length !== 1)
    throw new ArmError(
      formatMessage("uneven lists", { counts: counts.sort((p, q) => p - q).join(", ") }),
    );
  const table = {
    rows: Array.from({ length: counts[0] }, (_, k) => [...columns.values()].map((list) => list[k])),
    headers: [...columns.keys()],
    parts: lists.map(({ part }) => part),
  };
  return !columns.has("theta") ? addTheta(table, columns.get("d")) : table;
}

// Find the entry that the name of a list names, as a whole or in one of its parts: alpha_test.
function findListEntry(name) {
  const parts = [name, ...name.split("_")].map(findEntry);
  return parts.find((entry) => ENTRIES.includes(entry)) ?? "";
}

// Refuse two different lists of the same column.
/** @param {{ column: string, entries: Entry[] }[]} lists */
function refuseTwoLists(lists) {
  const first = new Map();
  for (const { column, entries } of lists) {
    const list = entries.map(({ text }) => text).join(", ");
    const before = first.get(column) ?? list;
    if (before !== list) {
      const fields = { name: column, one: quoteText(before), other: quoteText(list) };
      throw new ArmError(formatMessage("two lists", fields));
    }
    first.set(column, list);
  }
}

// Add joint angles to lists of d, a and alpha. If d is a variable, the joint is prismatic and theta
// is 0.
/** @param {EntryRows} table @param {Entry[]} distances @returns {EntryRows} */
function addTheta(table, distances) {
  const angles = distances.map(({ text }, k) => makeUntyped(isVariable(text) ? "0" : `q_${k + 1}`));
  return {
    ...table,
    rows: table.rows.map((row, k) => [...row, angles[k]]),
    headers: [...table.headers, "theta"],
    assumptions: [formatMessage("taken: no theta")],
  };
}

/** Refuse a table with too many rows. @param {number} count */
export function refuseManyRows(count) {
  if (count > MOST_ROWS) throw new ArmError(formatMessage("many rows", { count, most: MOST_ROWS }));
}

const LONGEST = 100_000; // characters of a text
const MATRIX_SIZE = 16; // numbers of a link matrix, the longest notation of a row

/**
 * Refuse an empty text, and a text with far more numbers than a table has.
 * @param {string} text
 */
export function refuseSize(text) {
  const what = formatMessage("your table");
  if (text.length > LONGEST)
    throw new ArmError(formatMessage("too long", { what, count: text.length }));
  if (!text.trim()) throw new ArmError(formatMessage("empty", { what }));
  const wanted = formatMessage("table size", { most: MOST_ROWS });
  refuseLongText(text, MOST_ROWS * MATRIX_SIZE, { what, wanted });
}
