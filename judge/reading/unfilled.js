// Finds entries that were not filled in yet, such as "q_6 = ?".

// Marks in place of a number that is not known yet.
const MARK = /^(?:\?+|…|⋮|\.{2,}|\\[lcdv]?dots|tbd|todo|nan|none|null|xx+)$/i;
const DASH = /^[-–—_]+$/; // may also be a sign or a drawn line
const isMark = (word) => MARK.test(word);

/**
 * Return whether a word stands in place of a number that is not known yet.
 * @param {string} word
 */
export const isPlaceholder = (word) => isMark(word) || DASH.test(word);

const LABEL = /^[\p{L}\p{M}_^{}\\$()\s]{0,40}\d{0,3}[})$\s]{0,9}[=:]/u;
const SEPARATORS = /[\s,;|&$[\](){}=:]+/;
const splitWords = (line) => line.split(SEPARATORS).filter(Boolean);

/**
 * Cut off the end of a text that has a "?", a dash or nothing in place of its numbers.
 * @param {any} answer a text; anything else is returned as it is
 */
export function dropUnfilledEnd(answer) {
  if (typeof answer !== "string") return answer;
  const lines = answer.split("\n");
  const isUnfilled = (line) => splitWords(line.replace(LABEL, "")).every(isPlaceholder);
  while (lines.length > 1 && isUnfilled(lines.at(-1))) lines.pop();
  const filled = lines.join("\n");
  const gap = findUnfilledLabel(filled);
  return filled.slice(0, gap?.isLast ? gap.index : filled.length);
}

// A name with the number of its joint, and the word behind = or :.
const ASSIGNMENT = new RegExp(
  String.raw`(?<![\p{L}\p{M}\d_])(\p{L}[\p{L}\p{M}_{}]{0,12}[\d₀-₉]{1,2}\}?) ?[=:] ?` +
    String.raw`((?:[-+−–] (?=[\d.]))?[^\s,;|&$)}\]]*)`,
  "gu",
);

/**
 * Find the first name that has a placeholder and nowhere a number, in a text that has numbers for
 * other names of its kind: τ2 of "τ1 = 18.2, τ2 = ?". Null if there is none.
 * @param {string} text
 */
export function findUnfilledLabel(text) {
  const stem = (name) => name.replace(/[\d₀-₉{}_]/gu, "").toLowerCase();
  const assignments = [...text.matchAll(ASSIGNMENT)].map(
    ({ 0: quoted, 1: name, 2: value, index }) => ({ quoted, name, value, index }),
  );
  const filled = assignments.filter(({ value }) => !isPlaceholder(value)).map(({ name }) => name);
  const stems = filled.map(stem);
  const first = assignments.findIndex(
    ({ name }) => !filled.includes(name) && stems.includes(stem(name)),
  );
  if (first < 0) return null;
  const { quoted, index } = assignments[first];
  return {
    quoted,
    index,
    isLast: assignments.slice(first).every(({ value }) => isPlaceholder(value)),
  };
}

/**
 * Find the first line with a number and a mark in place of another one; null if there is none.
 * @param {string} text
 */
export const findUnfilledLine = (text) =>
  text.split("\n").find((line) => /\d/.test(line) && splitWords(line).some(isMark)) ?? null;

const PLAIN_NUMBER = /^[-+−]?\d*[.,]?\d+$/;

/**
 * Find the first line that stands in place of a row: it has marks, and rows follow it. A time or a
 * number of the row may lead it. Null if there is none.
 * @param {string} text
 */
export function findUnfilledRow(text) {
  const lines = text.split("\n");
  const words = lines.map(splitWords);
  const isUnfilledRow = (row) =>
    row.some(isMark) &&
    row.every((word, k) => isMark(word) || (k === 0 && PLAIN_NUMBER.test(word)));
  const isRow = (row) => row.length > 1 && row.every((word) => PLAIN_NUMBER.test(word));
  const last = words.findLastIndex(isRow);
  return lines[words.findIndex((row, k) => k < last && isUnfilledRow(row))] ?? null;
}
