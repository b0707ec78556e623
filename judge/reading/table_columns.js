// Finds whether a column of a table holds a, alpha, d or theta. The header decides; without headers
// the content of the columns does.

import { hasDecimals, number, plain } from "./formula.js";
import { findLabel } from "./labels.js";
import { ENTRIES, isVariable, VARIABLE } from "./table_rows.js";
import { LENGTH_UNIT } from "./units.js";
import { ArmError, formatMessage, quoteText } from "../sentences.js";

const listSpellings = (words, entry) => words.split(" ").map((word) => [word, entry]);

/** @type {Map<string, string>} */
const HEADERS = new Map([
  ...listSpellings("theta th q jointangle angle thetaoffset jointoffset theta0 q0", "theta"),
  ...listSpellings("d offset linkoffset", "d"),
  ...listSpellings("a r linklength length aprev", "a"),
  ...listSpellings("alpha twist linktwist al alphaprev", "alpha"),
  ...listSpellings("i link joint j row # k", "i"),
]);

const LONGEST = 80; // characters of a header

// The unit behind a header, as in "a (mm)", "a [mm]", "a in mm", "a, mm", "a/mm" and "a_mm".
const UNIT = new RegExp(
  String.raw`\([^)]*\)?|\[[^\]]*\]?|\bin\b.*|[,/].*|_(?:${LENGTH_UNIT}|deg|rad)$`,
  "g",
);

// Find the entry that a column header names: "a", "alpha", "d", "theta", or "i" for row numbers.
export function findEntry(cell) {
  if (cell.length > LONGEST) return undefined;
  const words = plain(replaceSubscripts(cell).replace(/-\s*1/g, ""))
    .replaceAll("*", "")
    .toLowerCase();
  const withoutUnit = words.replace(UNIT, "");
  const last = withoutUnit.trim().split(/\s+/).at(-1); // "Link length a_i [mm]"
  return findSpelling(withoutUnit) ?? findSpelling(last);
}

// Look up a header as it is and without the index of its row: "a_i" is "a".
function findSpelling(text) {
  const word = text.replace(/[\s_{}$\\^'"().]/g, "");
  return HEADERS.get(word) ?? HEADERS.get(word.replace(/[ijkn]$/, ""));
}

// Write aᵢ₋₁ as ai-1, and the APL symbol ⍺, which the Robotics Toolbox prints, as the Greek α.
export const replaceSubscripts = (text) =>
  text
    .replace(/[ᵢⱼₖₙ₋₁]/g, (character) => "ijkn-1"["ᵢⱼₖₙ₋₁".indexOf(character)])
    .replace(/[⍺∝]/g, "α");

/** Maps a header to the entry below it if the headers of alpha and theta are exchanged. */
export const EXCHANGED = { alpha: "theta", theta: "alpha" };

const isOffset = (header) => header.toLowerCase().includes("offset");

// Name the entry below each header. "offset" names d, but beside a column "d" it names theta.
export function nameColumns(headers, offset = "theta") {
  const names = headers.map(findEntry);
  const namesTwoD = names.filter((name) => name === "d").length > 1;
  return names.map((name, k) => (namesTwoD && isOffset(headers[k]) ? offset : name));
}

// The orders of textbooks and programs, the commonest first. Any other order is tried after these.
const KNOWN_ORDERS = [
  "a alpha d theta",
  "theta d a alpha",
  "alpha a d theta",
  "alpha a theta d",
  "d theta a alpha",
  "d a alpha theta",
].map((order) => order.split(" "));

// Drop the column of row numbers. If there is no such column and each row is one cell short, drop
// the first header only: its column is empty, or the header is the word "Joint" of "Joint type".
export function dropIndexColumn(block) {
  const rest = cutIndexColumn(block);
  const fits = rest.cells.every(({ length }) => [4, rest.headers.length].includes(length));
  if (!fits && nameTableColumns(rest.headers) !== null)
    refuseHeaders(block.headers.length, block.cells[0].length);
  return rest;
}

function cutIndexColumn({ cells, headers }) {
  const words = headers.map(findEntry);
  const counted = isCounted(cells.map((row) => plain(row[0])));
  const short = cells.every((row) => row.length === headers.length - 1);
  if (short && !counted && !ENTRIES.includes(words[0])) return { cells, headers: headers.slice(1) };
  if (short && counted && headers.length === 5) refuseHeaders(5, 4);
  const at = words.indexOf("i");
  const cut = (row) => row.filter((_, k) => k !== at);
  if (at >= 0) {
    requireRowNumbers(cells.map((row) => row[at]));
    return { cells: cells.map(cut), headers: cut(headers) };
  }
  if (cells.some((row) => row.length <= 4)) return { cells, headers };
  if (cells.length > 1 && isCounted(cells.map((row) => plain(row[0])).reverse()))
    throw new ArmError(formatMessage("rows reversed", { count: cells.length }));
  if (!counted) return { cells, headers };
  return {
    cells: cells.map((row) => row.slice(1)),
    headers: headers.length > 4 ? headers.slice(1) : headers,
  };
}

function requireRowNumbers(texts) {
  const text = texts.find(hasDecimals);
  if (text) throw new ArmError(formatMessage("row number", { text: quoteText(text) }));
}

function refuseHeaders(headers, count) {
  throw new ArmError(formatMessage("short rows", { headers, count }));
}

// Return whether cells count 0, 1, 2, ... or 1, 2, 3, ..., as "Link 1" or "J1" too.
const isCounted = (cells) =>
  !cells.some(isVariable) &&
  [0, 1].some((from) => cells.every((text, k) => findLabel([{ text }])?.number === k + from));

// List the possible orders of the columns. Return them with the rows, and whether the student
// stated the order.
export const listOrders = (cells, headers, columns) =>
  (columns ? orderByOption(cells, columns) : orderByHeaders(cells, headers)) ??
  orderByContent(cells, headers);

function orderByOption(cells, columns) {
  const words = columns.trim().split(/[\s,;|]+/);
  const order = words.map(findEntry);
  if ([...order].sort().join() !== ENTRIES.join())
    throw new ArmError(formatMessage("no columns", { given: quoteText(columns) }));
  requireFourColumns(cells);
  return { orders: [order], isStated: true, rows: cells };
}

// Name the column below each header: "a", "alpha", "d", "theta", "i" for row numbers, "offset" for
// joint offsets, undefined for anything else. If two headers name the same entry, the first counts.
// Return null unless the headers name all four entries.
export function nameTableColumns(headers) {
  const words = nameColumns(headers, "");
  const entryColumns = ENTRIES.map((entry) => words.indexOf(entry));
  if (entryColumns.includes(-1)) return null;
  const offsetColumn = headers.findIndex(
    (header, i) => isOffset(header) && !entryColumns.includes(i),
  );
  return headers.map((_, i) => {
    if (i === offsetColumn) return "offset";
    return entryColumns.includes(i) || words[i] === "i" ? words[i] : undefined;
  });
}

// Order the columns by headers that name all four entries. Joint offsets in a column of their own
// are added to the joint variables.
function orderByHeaders(cells, headers) {
  const names = nameTableColumns(headers);
  if (!names || cells.some((row) => row.length !== headers.length)) return null;
  const entryColumns = ENTRIES.map((entry) => names.indexOf(entry));
  const offsetColumn = names.indexOf("offset");
  const rows = cells.map((row, k) => {
    const kept = entryColumns.map((i) => row[i] ?? "0");
    const offset = row[offsetColumn] ?? "0";
    const isZero = ["", "-"].includes(offset.trim()) || number(offset) === 0;
    return isZero ? kept : addOffset(k + 1, kept, offset);
  });
  const typedOrder = names.filter((name) => ENTRIES.includes(name));
  return { orders: [ENTRIES], isStated: true, rows, typedOrder };
}

// List the orders in which each cell may be an entry of its column, the likeliest first. A known
// header fixes its column.
function orderByContent(cells, headers) {
  requireFourColumns(cells);
  const names = headers.length === 4 ? nameColumns(headers) : [];
  refuseUnknownHeader(names, headers);
  const agrees = (order) => names.every((name, k) => !ENTRIES.includes(name) || order[k] === name);
  const descriptions = cells.map((row) => row.map(describeCell));
  const all = new Map(
    [...KNOWN_ORDERS, ...listPermutations(ENTRIES)].map((order) => [order.join(), order]),
  );
  const orders = [...all.values()].filter(
    (order) => agrees(order) && isPossibleOrder(descriptions, order),
  );
  return { orders: orders.length ? orders : [KNOWN_ORDERS[0]], isStated: false, rows: cells };
}

// Refuse four headers that name three of the columns and something else, such as "home". A single
// letter, such as h, may be a student's name for the fourth.
function refuseUnknownHeader(names, headers) {
  const known = new Set(names.filter((name) => ENTRIES.includes(name)));
  const header = headers[names.findIndex((name) => !ENTRIES.includes(name))];
  if (known.size === 3 && /\p{L}{3}/u.test(header ?? ""))
    throw new ArmError(formatMessage("unknown column", { header: quoteText(header) }));
}

// Add the offset, which was typed in its own column, to the joint variable of a row.
function addOffset(i, row, offset) {
  const [d, theta] = [2, 3].map((k) => number(row[k]) === null);
  const at = d && !theta ? 2 : 3;
  const moves = VARIABLE.test(plain(row[at])) ? `q_${i}` : row[at];
  return row.map((cell, k) => (k === at ? `${moves} + (${offset})` : cell));
}

const listPermutations = (list) =>
  list.length < 2
    ? [list]
    : list.flatMap((item, k) =>
        listPermutations(list.filter((_, j) => j !== k)).map((rest) => [item, ...rest]),
      );

function requireFourColumns(cells) {
  const row = cells.find(({ length }) => length !== 4);
  if (row) throw new ArmError(formatMessage("row width", { widths: row.length }));
}

// Describe what a cell looks like, apart from its position.
function describeCell(text) {
  return {
    variable: isVariable(text),
    angular: /pi|deg/.test(plain(text)),
    number: number(text),
  };
}

// Return whether the joint variables stand in theta or d, and no length looks like an angle.
function isPossibleOrder(descriptions, order) {
  const [a, alpha, d] = ENTRIES.map((name) => descriptions.map((row) => row[order.indexOf(name)]));
  if ([...a, ...d].some(({ angular }) => angular)) return false;
  if ([...a, ...alpha].some(({ variable }) => variable)) return false;
  return alpha.every((cell) => cell.number === null || isAngleLike(cell.number));
}

function isAngleLike(x) {
  const parts = x / (Math.PI / 12);
  const inRadians = Math.abs(x) <= 2 * Math.PI + 0.01 && Math.abs(parts - Math.round(parts)) < 0.02;
  return inRadians || (x % 15 === 0 && Math.abs(x) <= 360);
}
