// Blanks out the last rows of an unfinished table, so that the finished rows can be judged. The
// cells of an unfinished row are marks such as ? and TODO, or empty beside the joint variable.

import { isPlaceholder } from "./unfilled.js";

const LABEL = String.raw`(?:\p{L}+[ _]*)?\d{1,2}[.):]?`; // 3, J3, joint 3
const FIRST_LABEL = new RegExp(String.raw`^[ \t|&,]*${LABEL}(?=[ \t|&,;])`, "u");
const ROW_END = /\\\\[ \t]*$/;
const VARIABLE = String.raw`\$?\\?\p{L}+_?\{?[\d₀-₉]{1,2}\}?\$?`;
// | 3 | | | | q3 |
const BLANK = new RegExp(
  String.raw`^[ ]*\|?(?:[ ]*${LABEL}[ ]*)?(?:[|&\t;][ ]*){3,}${VARIABLE}[ ]*\|?(?:\\\\)?[ \t]*$`,
  "u",
);
const EMPTY_CELL = /[|&;\t][ ]*(?=[|&;\t])/;

// Return whether a line has only placeholders, with or without the joint's label before them.
function hasOnlyPlaceholders(line) {
  const cells = line
    .replace(FIRST_LABEL, "")
    .replace(ROW_END, "")
    .split(/[ \t|&,;]+/);
  const words = cells.filter(Boolean);
  return words.length > 0 && words.every(isPlaceholder);
}

/**
 * Replace the last, unfinished rows of a table by blanks. If a finished row has an empty cell,
 * empty cells may mean 0, and only rows with placeholders are unfinished.
 * @param {string} text
 */
export function maskUnfinishedRows(text) {
  const lines = text.split("\n");
  const last = lines.findLastIndex(
    (line) => /\d/.test(line) && !hasOnlyPlaceholders(line) && !BLANK.test(line),
  );
  if (last < 0) return text;
  const isBlankZero = lines
    .slice(0, last + 1)
    .some((line) => /\d/.test(line) && EMPTY_CELL.test(line));
  const isUnfinished = (line) => hasOnlyPlaceholders(line) || (!isBlankZero && BLANK.test(line));
  return lines
    .map((line, k) => (k > last && isUnfinished(line) ? line.replace(/./g, " ") : line))
    .join("\n");
}
