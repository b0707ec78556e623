// Finds entries that were not filled in yet, such as "q_6 = ?".

/** Marks, in upper or lower case, that stand in place of a number that is not known yet. */
export const PLACEHOLDER = [
  String.raw`\?+|[-–—_]+|…|\.{2,}|\$?\\[lcdv]?dots\$?`,
  "tbd|todo|none|nan|null|xx+",
].join("|");
const ONLY_PLACEHOLDER = new RegExp(`^(?:${PLACEHOLDER})$`, "i");
const LABEL = /^[\p{L}\p{M}_^{}\\$()\s]{0,40}\d{0,3}[})$\s]{0,9}[=:]/u;
// Placeholders at the end of a list, before its brackets.
const LAST_CELLS = new RegExp(`(?:[ \\t,;|&](?:${PLACEHOLDER})){1,9}(?=[\\])}|$ \\t]{0,20}$)`, "i");

/**
 * Cut off the end of a text that has a "?", a dash or nothing in place of its numbers.
 * @param {any} answer a text; anything else is returned as it is
 */
export function dropUnfilledEnd(answer) {
  if (typeof answer !== "string") return answer;
  const lines = answer.split("\n");
  while (lines.length > 1 && isUnfilled(lines.at(-1))) lines.pop();
  const filled = lines.join("\n");
  const gap = findUnfilledLabel(filled);
  return filled.slice(0, gap?.isLast ? gap.index : filled.length).replace(LAST_CELLS, "");
}

// Return whether a line holds a label and placeholders only.
const isUnfilled = (line) =>
  line
    .replace(LABEL, "")
    .split(/[\s,;|&$]+/)
    .every((word) => !word || ONLY_PLACEHOLDER.test(word));

// A name with the number of its joint, and a placeholder or the beginning of a number.
const ASSIGNED = new RegExp(
  String.raw`(?<![\p{L}\p{M}\d_])(\p{L}[\p{L}\p{M}_{}]{0,12}[\d₀-₉]{1,2}\}?) ?[=:] ?` +
    String.raw`(?:(${PLACEHOLDER})(?=$|[\s,;|&)}\]])|[-+−]?[\d.(√\\])`,
  "giu",
);

/**
 * Find the first name that has a placeholder and nowhere a number, in a text that has numbers for
 * other names of its kind: τ2 of "τ1 = 18.2, τ2 = ?". Null if there is none.
 * @param {string} text
 */
export function findUnfilledLabel(text) {
  const stem = (name) => name.replace(/[\d₀-₉{}_]/gu, "").toLowerCase();
  const all = [...text.matchAll(ASSIGNED)];
  const filled = new Set(all.flatMap(([, name, placeholder]) => (placeholder ? [] : [name])));
  const stems = new Set([...filled].map(stem));
  const gap = all.findIndex(
    ([, name, placeholder]) => placeholder && !filled.has(name) && stems.has(stem(name)),
  );
  if (gap < 0) return null;
  const { 0: quoted, index } = all[gap];
  return { quoted, index, isLast: all.slice(gap).every(([, , placeholder]) => placeholder) };
}

/**
 * Quote the first line with a lone "?" in place of a number; null if there is none.
 * @param {string} text
 */
export const findUnfilledLine = (text) =>
  text.split("\n").find((line) => /\d/.test(line) && LONE_MARK.test(line)) ?? null;

const LONE_MARK = /(?:^|[\s,;|&[(=:])(?:\?+|…)(?=$|[\s,;|&\])])/;

const GAP = /^(?:\?+|…|⋮|\.{3,}|\\[lcdv]?dots|nan|none|null|tbd)$/i; // in place of a row's numbers
const PLAIN_NUMBER = /^[-+−]?\d*[.,]?\d+$/;

/**
 * Find the first line that stands in place of a row: it has placeholders, and rows follow it. A
 * time or a number of the row may lead it. Null if there is none.
 * @param {string} text
 */
export function findUnfilledRow(text) {
  const lines = text.split("\n").map((line) => line.split(/[\s,;|&$[\]()]+/).filter(Boolean));
  const isGap = ([first, ...rest], hasCount) =>
    first !== undefined && rest.every((word) => GAP.test(word)) && (GAP.test(first) || hasCount);
  const isUnfilledRow = (line) => isGap(line, line.length > 1 && PLAIN_NUMBER.test(line[0]));
  const isRow = (line) => line.length > 1 && line.every((word) => PLAIN_NUMBER.test(word));
  const last = lines.findLastIndex(isRow);
  const index = lines.findIndex((line, k) => k < last && isUnfilledRow(line));
  return index < 0 ? null : text.split("\n")[index];
}
