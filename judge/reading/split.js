// A line of entries, or what a bracket holds, parted into its entries.

import { deeper, topComma } from "./brackets.js";
import { isNumber, number } from "./formula.js";

// A joint's variable marked by a star, q_1* or theta*, and one that slides, d_3*.

const STARRED = /(?:^|[\s[(])-?(?:θ|\\?theta|th|q)_?\{?(?:\d+|i)?\}?\^?\*$|^\s*\*$/;
const SLIDING = /(?:^|[\s[(+-])d_?\{?(?:\d+|i)?\}?\^?\*$/;
// A unit that stands a blank behind its number.
const DEGREES = /^(?:°|deg(?:rees?)?(?![A-Za-z0-9_]|\s*\())/;

const RADIANS = /^rad(?:ian)?s?(?![A-Za-z0-9_]|\s*\()/;

// Split at commas outside brackets, or at blanks where there are none, as MATLAB and NumPy print.
export function split(text) {
  const numerals = text.trim().split(/\s+/);
  if (numerals.every(isNumber)) return numerals;
  const comma = topComma(text);
  const ends = (k) => (comma ? text[k] === "," : /\s/.test(text[k]) && !joins(text, k));
  return partsOf(text, ends, !comma)
    .filter((one) => comma || one.trim())
    .map((one) => one.trim());
}

// The parts of a text between the places outside brackets that end one; a list that closes ends one
// too, where told.
function partsOf(text, ends, afterLists) {
  const parts = [];
  let [depth, from] = [0, 0];
  for (let k = 0; k < text.length; k++) {
    depth += deeper(text[k]);
    if (depth) continue;
    const closes = afterLists && text[k] === "]";
    if (!closes && !ends(k)) continue;
    parts.push(text.slice(from, closes ? k + 1 : k));
    from = k + 1;
  }
  if (text.slice(from).trim()) parts.push(text.slice(from));
  return parts;
}

// Whether the blank at k stands beside a sign that joins its neighbours: "a - b" is one cell, "a
// -b" are two.
function joins(text, k) {
  const [before, after] = [text.slice(0, k).trimEnd(), text.slice(k).trim()];
  if (after === "*") return STARRED.test(`${before}*`);
  if (endsWithAMark(before, after)) return false;
  return joinsBySign(before, after) || joinsAUnit(before, after);
}

// Whether the star before the blank marks a joint's variable, and does not multiply.
function endsWithAMark(before, after) {
  if (!before.endsWith("*") || !after || "*/^)=".includes(after[0])) return false;
  return STARRED.test(before) || (SLIDING.test(before) && number(after.split(/\s/)[0]) !== null);
}

function joinsBySign(before, after) {
  if (!before || !after) return true;
  if ("+-*/^=(".includes(before.at(-1)) || "*/^)=".includes(after[0])) return true;
  return "+-".includes(after[0]) && after.length > 1 && /\s/.test(after[1]);
}

const joinsAUnit = (before, after) =>
  DEGREES.test(after) || ("0123456789.)".includes(before.at(-1)) && RADIANS.test(after));
