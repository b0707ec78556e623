// Masks the last rows of an unfinished table. Their cells hold marks such as ? and TODO, or nothing
// beside the joint's variable.

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

// Return whether a line holds placeholders and at most the joint's label before them.
function hasOnlyPlaceholders(line) {
  const cells = line
    .replace(FIRST_LABEL, "")
    .replace(ROW_END, "")
    .split(/[ \t|&,;]+/);
  const words = cells.filter(Boolean);
  return words.length > 0 && words.every(isPlaceholder);
}

/**
 * Write blanks over the last rows of a table if they are not finished. A blank cell means that only
 * where no other row has one: there it may stand for 0.
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
