// Finds entries that have no number yet, such as "q_6 = ?".

// Marks in place of a missing number.
const MARK = /^(?:\?+|…|⋮|\.{2,}|\\[lcdv]?dots|tbd|todo|nan|none|null|xx+)$/i;
const DASH = /^[-–—_]+$/; // a mark, a minus or a drawn line
const isMark = (word) => MARK.test(word);

/**
 * Return whether a word stands in place of a missing number.
 * @param {string} word
 */
export const isPlaceholder = (word) => isMark(word) || DASH.test(word);

const LABEL = /^[\p{L}\p{M}_^{}\\$()\s]{0,40}\d{0,3}[})$\s]{0,9}[=:]/u;
const SEPARATORS = /[\s,;|&$[\](){}=:]+/;
const splitWords = (line) => line.split(SEPARATORS).filter(Boolean);

// Marks of missing numbers at the end of a row, as in "0.5 0.1 ? ? ?".
const ROW_END =
  /(?:[\s,;|&]+(?:\?+|…|\.{3}|tbd|todo|xx+)(?![^\s,;|&\]}\\]))+(?=[\s,;|&\]}\\]*$)/gim;

/**
 * Cut off the last columns of a text too if they have no number.
 * @param {any} answer a text; anything else is returned unchanged
 */
export const dropUnfilledEnds = (answer) =>
  typeof answer === "string" ? dropUnfilledEnd(answer).replace(ROW_END, "") : answer;

/**
 * Cut off the last lines and the last names of a text if they have no number, as "q5 = ?, q6 =".
 * @param {any} answer a text; anything else is returned unchanged
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

// A name with a joint number, and the word behind = or :, as in "q6 = ?".
const ASSIGNMENT = new RegExp(
  String.raw`(?<![\p{L}\p{M}\d_])(\p{L}[\p{L}\p{M}_{}]{0,12}[\d₀-₉]{1,2}\}?) ?[=:] ?` +
    String.raw`((?:[-+−–] (?=[\d.]))?[^\s,;|&$)}\]]*)`,
  "gu",
);

/**
 * Find the first name without a number, such as τ2 of "τ1 = 18.2, τ2 = ?". A similar name, here τ1,
 * must have a number. Return null if there is no such name.
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
 * Find the first line with a number and a mark, such as "0.5 ? 0.1". Return null if there is none.
 * @param {string} text
 */
export const findUnfilledLine = (text) =>
  text.split("\n").find((line) => /\d/.test(line) && splitWords(line).some(isMark)) ?? null;

const PLAIN_NUMBER = /^[-+−]?\d*[.,]?\d+$/;

/**
 * Find the first line of marks before the last row, such as "2 ? ? ?". It may begin with a time or
 * the number of the row. Return null if there is no such line.
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
