// Refuses texts with numbers that the judge cannot use, such as "inf", "1 + 2i", "~0.5" and the
// abridged print "0.1 ... 0.9".

import { linesOf } from "./characters.js";
import { ArmError, formatMessage } from "../sentences.js";

/** @type {[string, RegExp][]} */
const ODD = [
  ["no solution", /\bno (?:real )?solution|\bunreachable\b/i],
  ["not finite", /(?<!\p{L})(?:nan|inf(?:inity)?)(?!\p{L})/iu],
  ["doubtful sign", /(?<!~)~\s*[\d.]/],
  ["complex", /\d\s?\*?\s?[ij](?! ?[\p{L}\d])/u], // not "-40 i get"
  ["two signs", /±|\\pm/],
  ["cut print", /\.\.\.(?=[ \t]*,?[ \t]*[-\d[])/],
  ["no text", /[\0-\x08\ufffd]/],
];

/**
 * Raise an error for a text with such numbers.
 * @param {string} text @param {{ what: string, wanted?: string }} question
 */
export function refuseOdd(text, { what, wanted = "numbers" }) {
  const [key] = ODD.find(([, pattern]) => pattern.test(text)) ?? [];
  if (key) throw new ArmError(formatMessage(key, { what, wanted }));
}

const MOST_OTHERS = 500; // numbers in addition to those of the answer
const MOST_LINES = 600; // ten printed pages
const NUMBER = /(?<![\p{L}\d_.]|_\{)\d/gu; // the first digit of a number, but not the 1 of q_1

/**
 * Raise an error if a text has far more numbers or lines than the answer. Reading them would take
 * longer than a student waits. The text may always have as many lines as the answer has numbers.
 * @param {string} text @param {number} size the count of numbers in the answer
 * @param {{ what: string, wanted: string }} question
 */
export function refuseLongText(text, size, { what, wanted }) {
  const count = text.match(NUMBER)?.length ?? 0;
  if (count > size + MOST_OTHERS)
    throw new ArmError(formatMessage("many numbers", { what, count, wanted }));
  const lines = linesOf(text).length;
  if (lines > Math.max(size, MOST_LINES))
    throw new ArmError(formatMessage("many lines", { what, count: lines, wanted }));
}

/**
 * Return whether the numbers of a block are the halves of decimal numbers, as 0, 05, -97 and 53 of
 * "0,05 -97,53". Commas separate them without a blank, but there are blanks elsewhere in a row.
 * @param {string} text @param {import("./block.js").Block} block
 */
export const hasHalfNumbers = (text, { splitsCommas, sources }) =>
  Boolean(splitsCommas) &&
  sources.some(({ cells }) => {
    const gaps = cells.slice(1).map(({ from }, k) => text.slice(cells[k].to, from));
    const isSum = cells.some(({ from, to }) => /\d\s+[-+\u2212]?\d/.test(text.slice(from, to)));
    const [{ from, to }] = cells;
    const isHalf = HALF_BEFORE.test(text.slice(Math.max(0, from - 12), from));
    return (
      (isHalf && /^\d+$/.test(text.slice(from, to))) || isSum || gaps.some((gap) => !gap.trim())
    );
  });

const HALF_BEFORE = /(?<![\p{L}\d_.])\d{1,9},$/u;

const COMMENT = /(?:#|%|\/\/).*/g;

/**
 * Remove comments without entries, if they hold decimals or the word "not". A unit in such a
 * comment is not the unit of the answer.
 * @param {string} text @param {import("./owners.js").Token[]} tokens
 */
export const withoutOtherComments = (text, tokens) =>
  text.replace(COMMENT, (comment, from) => {
    const to = from + comment.length;
    const isEntry = ({ owner, from: at }) => owner === "entry" && at >= from && at < to;
    return tokens.some(isEntry) || !/\d[.,]\d|\bnot\b/.test(comment) ? comment : "";
  });
