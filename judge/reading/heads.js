// Heads above columns of numbers, and labels before the rows.

import { isFunction, number, parse, plain } from "./formula.js";
import { ArmError } from "../sentences.js";

// What looks like a number, also one that is not finished: "1,5", "≈ 3", "12.5.1".

const NO_HEAD = /^(?:[≈~]? ?[-+]?[.,0-9][-+.,%0-9 eEdD]*|[-+]?[0-9]{2,}.*)$/;

// Whether every cell is a number without symbols.
const numeric = (rows) => rows.every((row) => row.every((cell) => number(cell) !== null));

// The rows without the first if it is a header: names where numbers follow.
export function withoutHeader(rows) {
  const [first, ...rest] = rows;
  const heads = first.map(plain).filter(Boolean);
  if (!rest.length || heads.some(isEntry)) return rows;
  const unnamed = rest.map((row) => row.slice(1));
  if (!first[0] && heads.length === first.length - 1 && labelRows(rest) && numeric(unnamed))
    return unnamed;
  return numeric(rest) ? rest : rows;
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

// Whether the first cells are different names, or count the rows.
function labelRows(rows) {
  const labels = rows.map((row) => row[0]);
  if ([0, 1].some((from) => labels.every((label, k) => label === `${k + from}`))) return true;
  const different = new Set(labels).size === labels.length;
  return different && labels.every((label) => label && number(label) === null);
}
