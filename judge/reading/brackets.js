// Nested lists and tuples, MATLAB's bracket with semicolons, rows in round brackets.

import { isNumber, plain } from "./formula.js";
import { split } from "./split.js";
import { beside } from "./surroundings.js";
import { strippedEnd } from "./text.js";

const TAKEN = /^\s*\)*\s*(?:[-+*/^']|\.[*/^'T])/; // what changes the matrix before it
export const deeper = (sign) => ("[({".includes(sign) ? 1 : "])}".includes(sign) ? -1 : 0);

// Where the bracket that a text begins with is closed, -1 where it is not.
export function endOf(text) {
  let depth = 0;
  for (let k = 0; k < text.length; k++) {
    depth += deeper(text[k]);
    if (!depth) return k;
  }
  return -1;
}

export const closesAtEnd = (text) => text !== "" && endOf(text) === text.length - 1;

export function topComma(text) {
  let depth = 0;
  for (let k = 0; k < text.length; k++) {
    depth += deeper(text[k]);
    if (text[k] === "," && !depth) return true;
  }
  return false;
}

// Whether a text is one bracket from end to end that holds a list; round ones only where a comma
// stands in them.
function isList(text) {
  text = text.trim();
  if (!text || !"[({".includes(text[0]) || !closesAtEnd(text)) return false;
  return text[0] !== "(" || topComma(text.slice(1, -1));
}

// What a bracket holds, or a text without one, split where it is meant to be.
function itemsOf(text) {
  text = strippedEnd(text.trim(), ",");
  return split(isList(text) ? text.slice(1, -1) : text);
}

// Nested lists, tuples or MATLAB's one bracket with semicolons.
export function bracketed(text) {
  const items = itemsOf(text);
  if (items.every(isList)) {
    const inner = items.map(itemsOf);
    if (!inner.some((row) => row.some(isList))) return inner;
    const single = (cell) => (isList(cell) && itemsOf(cell).length === 1 ? itemsOf(cell)[0] : cell);
    const flat = inner.map((row) => row.map(single));
    return flat.some((row) => row.some(isList)) ? items.flatMap(bracketed) : flat;
  }
  const body = text.trim().slice(1, -1);
  if (isList(text) && !body.includes("[")) {
    return body
      .replace(/\.\.\.[^\n]*\n/g, " ")
      .split(/[;\n]/)
      .map(split);
  }
  return [items];
}

// An error where something is done to a list after it is closed.
export function untouched(text) {
  const end = endOf(text);
  const after = text.slice(end + 1);
  if (/[0-9][\s,;\]]/.test(text.slice(0, end)) && TAKEN.test(after))
    throw beside(after.replace(/^[ )]+/, ""));
}

// A list in one pair of round brackets without them; any other text as it is.
export function opened(text) {
  const inner = text.slice(1, -1).trim();
  return text[0] === "(" && closesAtEnd(text) && inner[0] === "[" && closesAtEnd(inner)
    ? inner
    : text;
}

// Whether the round bracket that a text begins with is a part of its first entry.
export function beginsACell(text) {
  const end = endOf(text);
  const inner = text.slice(1, Math.max(end, 1));
  return text[0] === "(" && end < text.length - 1 && !/[,;\n]/.test(inner);
}

const words = (line) => line.trim().split(/\s+/).filter(Boolean);
export const ofNumbers = (line) => words(line).every((word) => isNumber(plain(word)));
