// Finds the meaning of each column of a table: by the heads above them, else by what stands in
// them.

import { number, plain } from "./formula.js";
import { labelIn } from "./labels.js";
import { ENTRIES, isVariable, VARIABLE } from "./table_rows.js";
import { ArmError, formatMessage, quoteText } from "../sentences.js";

const meaning = (words, entry) => words.split(" ").map((word) => [word, entry]);

/** @type {Map<string, string>} */
const WORDS = new Map([
  ...meaning("theta th q jointangle angle thetaoffset jointoffset theta0 q0", "theta"),
  ...meaning("d offset linkoffset", "d"),
  ...meaning("a r linklength length aprev", "a"),
  ...meaning("alpha twist linktwist al alphaprev", "alpha"),
  ...meaning("i link joint j n frame row # no k", "i"),
]);

const LONGEST = 80; // characters of a head

// Find the entry that a column header names, or "i" for the rows' numbers.
export function headOf(cell) {
  if (cell.length > LONGEST) return undefined;
  const words = plain(withoutSubscripts(cell).replace(/-\s*1/g, ""))
    .replaceAll("*", "")
    .toLowerCase();
  const withoutUnit = words.replace(/\([^)]*\)?|\[[^\]]*\]?|\bin\b.*|[,/].*|_(?:mm|deg)$/g, "");
  const word = withoutUnit.replace(/[\s_{}$\\^'"().]/g, "");
  const last = withoutUnit
    .replace(/[\s_]+$/, "")
    .split(/\s+/)
    .at(-1); // "Link length a [mm]"
  return WORDS.get(word) ?? WORDS.get(word.replace(/[ijkn]$/, "")) ?? WORDS.get(last);
}

// Write aᵢ₋₁ as ai-1, and the α of APL, which the Robotics Toolbox prints, as the Greek one.
const withoutSubscripts = (text) =>
  text.replace(/[ᵢⱼₖₙ₋₁]/g, (one) => "ijkn-1"["ᵢⱼₖₙ₋₁".indexOf(one)]).replaceAll("⍺", "α");

/** The entry that is meant where the headers of alpha and theta are exchanged. */
export const EXCHANGED = { alpha: "theta", theta: "alpha" };

// Name the entry that each column header stands for; an offset beside d is one of theta.
export function nameColumns(heads) {
  const names = heads.map(headOf);
  const isTwice = names.filter((name) => name === "d").length > 1;
  const isOffset = (head) => head.toLowerCase().includes("offset");
  return names.map((name, k) => (isTwice && isOffset(heads[k]) ? "theta" : name));
}

export function fromHeads(heads) {
  const text = withoutSubscripts(heads.join(" "));
  const [, lengths = null] = /[[(/_ ]\s?(mm|cm|m)(?!\w)/.exec(text) ?? [];
  const angles = /deg|°/i.test(text) ? "deg" : /(?:\b|_)rad/.test(text) ? "rad" : null;
  return { lengths, angles, convention: /-\s*1|prev/.test(text) ? "craig" : null };
}

// As textbooks and programs write them, the commonest first; all others are tried behind them.
const KNOWN_ORDERS = [
  "a alpha d theta",
  "theta d a alpha",
  "alpha a d theta",
  "alpha a theta d",
  "d theta a alpha",
  "d a alpha theta",
].map((order) => order.split(" "));

// The cells without the column that numbers the rows. Where they are not numbered and one short,
// the first head goes alone: nobody typed its column, or it is half of "Joint type".
export function withoutIndex({ cells, heads }) {
  const words = heads.map(headOf);
  const counted = isCounted(cells.map((row) => plain(row[0])));
  const short = cells.every((row) => row.length === heads.length - 1);
  if (short && !counted && !ENTRIES.includes(words[0])) return { cells, heads: heads.slice(1) };
  const at = words.indexOf("i");
  const cut = (row) => row.filter((_, k) => k !== at);
  if (at >= 0) return { cells: cells.map(cut), heads: cut(heads) };
  if (!counted || cells.some((row) => row.length <= 4)) return { cells, heads };
  return {
    cells: cells.map((row) => row.slice(1)),
    heads: heads.length > 4 ? heads.slice(1) : heads,
  };
}

// Return whether cells count 0, 1, 2, ... or 1, 2, 3, ..., as "Link 1" or "J1" too.
const isCounted = (first) =>
  !first.some(isVariable) &&
  [0, 1].some((from) => first.every((text, k) => labelIn([{ text }])?.at === k + from));

// The orders of the columns that are possible, whether it was said, and the rows in them.
export const ordered = (cells, heads, columns) =>
  (columns ? byOption(cells, columns) : byHeads(cells, heads)) ?? byLooks(cells);

function byOption(cells, columns) {
  const words = columns.trim().split(/[\s,;|]+/);
  const order = words.map(headOf);
  if ([...order].sort().join() !== ENTRIES.join())
    throw new ArmError(formatMessage("no columns", { given: quoteText(columns) }));
  wide(cells);
  return { orders: [order], sure: true, rows: cells };
}

// By heads that name all four entries; an offset of the joint in a column of its own is added.
function byHeads(cells, heads) {
  const isOffset = (head) => head.toLowerCase().includes("offset");
  const all = heads.map(headOf);
  const twice = all.filter((word) => word === "d").length > 1;
  const words = all.map((word, i) => (twice && isOffset(heads[i]) ? "" : word));
  const keep = ENTRIES.map((entry) => words.indexOf(entry));
  const fits = cells.every((row) => [0, 1].includes(heads.length - row.length));
  if (keep.includes(-1) || !fits) return null;
  const added = heads.findIndex((head, i) => isOffset(head) && !keep.includes(i));
  const rows = cells.map((row, k) => {
    const kept = keep.map((i) => row[i] ?? "0");
    const still = row[added] ?? "0";
    const none = ["", "-"].includes(still.trim()) || number(still) === 0;
    return none ? kept : withOffset(k + 1, kept, still);
  });
  const typedOrder = [...ENTRIES].sort((p, q) => words.indexOf(p) - words.indexOf(q));
  return { orders: [ENTRIES], sure: true, rows, typedOrder };
}

// Without heads: every order in which nothing looks out of its place, the likeliest first.
function byLooks(cells) {
  wide(cells);
  const looks = cells.map((row) => row.map(lookOf));
  const all = new Map([...KNOWN_ORDERS, ...permutations(ENTRIES)].map((one) => [one.join(), one]));
  const orders = [...all.values()].filter((order) => possible(looks, order));
  return { orders: orders.length ? orders : [KNOWN_ORDERS[0]], sure: false, rows: cells };
}

// A row whose joint's offset, in a column of its own, is added to what moves.
function withOffset(i, row, still) {
  const [d, theta] = [2, 3].map((k) => number(row[k] || "0") === null);
  const at = d && !theta ? 2 : 3;
  const moves = VARIABLE.test(plain(row[at])) ? `q_${i}` : row[at] || "0";
  return row.map((cell, k) => (k === at ? `${moves} + (${still})` : cell));
}

const permutations = (list) =>
  list.length < 2
    ? [list]
    : list.flatMap((one, k) =>
        permutations(list.filter((_, j) => j !== k)).map((more) => [one, ...more]),
      );

function wide(cells) {
  const sorted = [...new Set(cells.map((row) => row.length))].sort((p, q) => p - q);
  const widths = sorted.join(", ");
  if (sorted.length > 1) {
    const row = cells.findIndex((one) => one.length !== 4);
    throw new ArmError(
      formatMessage("row widths", { widths, row: row + 1, count: cells[row].length }),
    );
  }
  if (sorted[0] !== 4) throw new ArmError(formatMessage("row width", { widths }));
}

// Describe what a cell looks like, apart from its position.
function lookOf(text) {
  return {
    variable: isVariable(text),
    angular: /pi|deg|°|π/.test(text),
    number: number(text),
  };
}

// Return whether the variables stand in theta or d, and no length looks like a twist.
function possible(looks, order) {
  const [a, alpha, d] = ENTRIES.map((name) => looks.map((row) => row[order.indexOf(name)]));
  if ([...a, ...alpha].some(({ variable }) => variable)) return false;
  if ([...a, ...d].some(({ angular }) => angular)) return false;
  return alpha.every((look) => look.number === null || angleLike(look.number));
}

function angleLike(x) {
  const parts = x / (Math.PI / 12);
  const inRadians = Math.abs(x) <= 2 * Math.PI + 0.01 && Math.abs(parts - Math.round(parts)) < 0.02;
  return inRadians || (x % 15 === 0 && Math.abs(x) <= 360);
}
