// Compares the names of rows, and finds other quantities and old answers by the words before rows.

import { findLabel } from "./labels.js";

/** @typedef {import("./lines.js").Row} Row */

// Masses, forces, points and lengths: m, F_ext, d_1, l_pen.
const OTHER_NAMES = /^(?:[fFgmpw]|mass(?:es)?|force|wrench|F_?ext|[adhlLmr](?:_?\{?\d\}?|_\w+))$/;
const OTHER_WORDS =
  /\b(?:mass(?:es)?|wrench|force|target|given|lengths?|at q|for F|norm|elapsed time)\b/i;

/**
 * Return whether the words before a row name a quantity that is no answer: masses, lengths, a
 * force, a target.
 * @param {Row} row
 */
export function namesOtherQuantity({ name, words }) {
  const lastWords = words.slice(-4).map(({ text }) => text);
  return (
    OTHER_NAMES.test(name.split(" ").at(-1)) || OTHER_WORDS.test([...lastWords, name].join(" "))
  );
}

const OLD = /\b(?:old|wrong|first (?:try|attempt|run)|previous|earlier|before I)\b/i;

/**
 * Return whether the words before a row call it an old answer.
 * @param {Row} row
 */
export const isCalledOld = ({ name, words }) =>
  OLD.test([...words.map(({ text }) => text), name].join(" "));

/**
 * Return whether two single values may be entries of one column. On one line both or neither have a
 * name; on two lines their labels are of one kind, and both or neither stand in a sentence. Entries
 * of a list share its name.
 * @param {Row} row @param {Row} other
 */
export function haveSimilarLabels(row, other) {
  if (row.depth) return true;
  if (row.line === other.line) return !row.name === !other.name;
  return (
    haveSimilarStems(row, other) &&
    findLabelKind(row) === findLabelKind(other) &&
    row.tail > 1 === other.tail > 1
  );
}

// Return whether the labels of two rows differ by their numbers only, or have consecutive numbers,
// as q2 and d3. A label without a number fits every other.
function haveSimilarStems(row, other) {
  const [label, before] = [findLabel(row.words), findLabel(other.words)];
  if (label?.kind !== "joint" || before?.kind !== "joint") return true;
  return readStem(row) === readStem(other) || label.number === before.number + 1;
}

const readStem = ({ words }) =>
  words
    .at(-1)
    .text.toLowerCase()
    .replace(/[^\p{L}]/gu, "");

const findLabelKind = ({ name, words }) =>
  /^\(?\d{1,3}\)?$/.test(name) ? "count" : (findLabel(words)?.kind ?? "");
