// Heads above columns of numbers, and labels before the rows.

import { isFunction, number, parse, plain } from "./formula.js";
import { ArmError } from "../sentences.js";

// What looks like a number, also one that is not finished: "1,5", "≈ 3", "12.5.1".
const NO_HEAD = /^(?:[≈~]? ?[-+]?[.,0-9][-+.,%0-9 eEdD]*|[-+]?[0-9]{2,}.*)$/;

// Whether there is something in each row, and every cell is a number without symbols.
const numeric = (rows) =>
  rows.every((row) => row.length > 0 && row.every((cell) => number(cell) !== null));

// The rows without heads above them and labels before them.
export function withoutHeader(rows) {
  const bodies = withoutHeads(rows);
  const unnamed = bodies.map((row) => row.slice(1));
  if (bodies.length < 2 || bodies[0].length < 2 || !numeric(unnamed)) return bodies;
  const named = bodies.every(([label]) => number(label) === null && !isEntry(plain(label)));
  return named || (bodies.length > 2 && isSeries(bodies)) ? unnamed : bodies;
}

// Whether numbers with decimals stand behind their counts, a pair on each line, as pandas prints.
const isSeries = (rows) =>
  [0, 1].some((from) => rows.every((row, k) => row.length === 2 && row[0] === `${k + from}`)) &&
  rows.some(([, x]) => x.includes("."));

// The rows without the first if it is a header: names where numbers follow.
function withoutHeads(rows) {
  const [first, ...rest] = rows;
  const heads = first.map(plain).filter(Boolean);
  const entries = heads.some(isEntry);
  if (!rest.length || (entries && !counts(heads))) return rows;
  const unnamed = rest.map((row) => row.slice(1));
  const labelled = rest.length > 1 && labelRows(rest) && numeric(unnamed);
  if (labelled && heads.length === rest[0].length - 1) return unnamed;
  if (entries) return rows;
  if (numeric(rest)) return rest;
  return labelled && first.length === rest[0].length ? unnamed : rows;
}

// Whether a word is a number, looks like one, or is a formula that no column is named by.
function isEntry(word) {
  const bare = word.replace(/^[-+]+/, "");
  if (number(word) !== null || NO_HEAD.test(word) || isFunction(bare)) return true;
  try {
    return isFormula(parse(word));
  } catch (error) {
    if (error instanceof ArmError) return false;
    throw error;
  }
}

// Whether a tree is negative or calls a function.
function isFormula(tree) {
  const parts = [tree];
  for (const part of parts) parts.push(...part.filter(Array.isArray)); // grows by its own parts
  return tree[0] === "neg" || parts.some((part) => part[0] === "call");
}

const counts = (labels) =>
  [0, 1].some((from) => labels.every((label, k) => label === `${k + from}`));

// Whether the first cells are different names, or count the rows.
function labelRows(rows) {
  const labels = rows.map((row) => row[0]);
  if (counts(labels)) return true;
  const different = new Set(labels).size === labels.length;
  return different && labels.every((label) => label && number(label) === null);
}

// What heads of a table's columns say

const meaning = (words, entry) => words.split(" ").map((word) => [word, entry]);

/** @type {Map<string, string>} */
const WORDS = new Map([
  ...meaning("theta th q jointangle angle tht thetai qi thi", "theta"),
  ...meaning("d offset linkoffset di dm dmm", "d"),
  ...meaning("a r linklength length ai ri", "a"),
  ...meaning("alpha twist linktwist alphai al alp", "alpha"),
  ...meaning("i link joint j n frame row # no linki jointi k", "i"),
]);

// Which entry a head names, or "i" for the rows' numbers.
export function headOf(cell) {
  const words = plain(cell.replace(/-\s*1/g, "")).replaceAll("*", "");
  const word = words
    .replace(/\(.*?\)|\[.*?(?:\]|$)|\bin\b.*|[,/].*|_(?:mm|cm|deg|rad)$/g, "")
    .replace(/[\s_{}$\\^'"().]/g, "")
    .toLowerCase();
  return WORDS.get(word) ?? WORDS.get(word.replace(/[ijkn]$/, ""));
}

// Which entry a single name is, as in d_1.
export const columnOf = (name) => WORDS.get(name.toLowerCase());

export function fromHeads(heads) {
  const text = heads.join(" ");
  const unit = ["mm", "cm"].find((u) => new RegExp(String.raw`[(\[ /_]${u}\b`).test(text));
  const own =
    ["m", "in"].find((u) =>
      new RegExp(String.raw`[(\[]\s*${u}\s*(?:[)\]]|$)|/${u}\b`).test(text),
    ) ?? null;
  const angles = /deg|°/i.test(text) ? "deg" : /(?:\b|_)rad/.test(text) ? "rad" : null;
  return { lengths: unit ?? own, angles, convention: /-\s*1/.test(text) ? "craig" : null };
}
