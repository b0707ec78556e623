// Masks the last rows of an unfinished table. Their cells hold marks such as ? and TODO, or nothing
// beside the joint's variable.

import { PLACEHOLDER } from "./unfilled.js";

const LABEL = String.raw`(?:(?:joint|link|row)?[ _]*\d{1,2}[.):]?|J\d)`;
const CELL = String.raw`[ \t|&,;]*(?:${PLACEHOLDER})(?=[ \t|&,;\\]|$)`;
const UNFINISHED = new RegExp(
  String.raw`^[ \t|&,]*(?:${LABEL}(?=[ \t|&,;]))?(?:${CELL})+[ \t|&,;\\]*$`,
  "i",
);
const VARIABLE = String.raw`\$?(?:q|θ|theta|\\theta|th)_?\{?\d{1,2}\}?\$?`;
// | 3 | | | | q3 |
const BLANK = new RegExp(
  String.raw`^[ ]*\|?(?:[ ]*${LABEL}[ ]*)?(?:[|&\t;][ ]*){3,}${VARIABLE}[ ]*\|?(?:\\\\)?[ \t]*$`,
  "i",
);
const EMPTY_CELL = /[|&;\t][ ]*(?=[|&;\t])/;
const DRAWN = /^[\s|:+=_-]*$/;

/**
 * Write blanks over the last rows of a table if they are not finished. A blank cell means that only
 * where no other row has one: there it may stand for 0.
 * @param {string} text
 */
export function maskUnfinishedRows(text) {
  if (!text.includes("\n")) return text;
  const lines = text.split("\n");
  const last = lines.findLastIndex(
    (line) => /\d/.test(line) && !UNFINISHED.test(line) && !BLANK.test(line),
  );
  const isBlankZero = lines
    .slice(0, last + 1)
    .some((line) => !DRAWN.test(line) && EMPTY_CELL.test(line));
  const isUnfinished = (line) => UNFINISHED.test(line) || (!isBlankZero && BLANK.test(line));
  return lines
    .map((line, k) => (k > last && isUnfinished(line) ? line.replace(/./g, " ") : line))
    .join("\n");
}
