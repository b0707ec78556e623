// Finds commas that may be decimal commas or may separate numbers: "10,20" is 10.2, or 10 and 20.
// An answer that is wrong in one reading is judged in the other reading, too.

import { WRONG } from "../digits.js";
import { ArmError, formatMessage } from "../sentences.js";

/** @typedef {import("../verdict.js").Verdict} Verdict */
/** @typedef {import("./owners.js").Token} Token */

const PAIRS = /(?<![\p{L}\d_.])(\d+),(\d+)(?![\d.])/gu;
const WHOLE = /^[-+]?\d+(?: deg)?$/;
const SEPARATES = /,[-+\u2212]|,\d+,/; // 1,-2 and 1,2,3 are no decimal numbers

/**
 * Return whether each row of a block may hold decimal numbers, although it was split at commas.
 * @param {string} text as it was pasted @param {import("./block.js").Block} block
 */
export const mayBeDecimals = (text, { splitsCommas, rows, sources }) =>
  Boolean(splitsCommas) &&
  rows.flat().every((cell) => WHOLE.test(cell.text)) &&
  !sources.some(({ cells }) => SEPARATES.test(text.slice(cells[0].from, cells.at(-1).to)));

/**
 * Ask about the first pair of entries that may be a single number. Return null if there is none.
 * @param {string} text as it was pasted @param {Token[]} tokens
 */
export function askAboutCommas(text, tokens) {
  const entries = new Set(tokens.filter(({ owner }) => owner === "entry").map(({ from }) => from));
  const match = [...text.matchAll(PAIRS)].find(({ index }) => entries.has(index));
  if (!match) return null;
  const [pair, first, second] = match;
  return formatMessage("commas", { pair, decimal: `${first}.${second}`, first, second });
}

// Return whether a reading sets entries of another reading aside.
const dropsEntries = (tokens, others) => {
  const unused = new Set(tokens.flatMap(({ owner, from }) => (owner === "context" ? [from] : [])));
  return others.some(({ owner, from }) => owner === "entry" && unused.has(from));
};

const isMisshapen = ({ findings }) => findings.some(({ what }) => what === "shape");

/**
 * Return the verdict on a wrong answer in the other reading of its commas, if that reading fits.
 * @param {string} text as it was pasted @param {Verdict} verdict
 * @param {(stated: import("./ordering.js").StatedOrder) => Verdict} judgeWith
 * @returns {Verdict}
 * @throws {ArmError} if the answer has the wanted shape and is wrong in both readings
 */
export function tryOtherCommas(text, verdict, judgeWith) {
  const { grade, typed } = verdict;
  const words = grade === WRONG ? askAboutCommas(text, typed?.tokens ?? []) : null;
  if (!words) return verdict;
  const commas = typed.splitsCommas ? "decimal" : "separators";
  let other = null;
  try {
    other = judgeWith({ commas });
  } catch (error) {
    if (!(error instanceof ArmError)) throw error;
    if (error.answers) throw new ArmError(words); // several answers fit
  }
  if (!other || isMisshapen(other) || dropsEntries(other.typed.tokens, typed.tokens))
    return verdict;
  if (String(other.typed.values) === String(typed.values)) return verdict;
  if (other.grade === WRONG && !isMisshapen(verdict)) throw new ArmError(words);
  return { ...other, taken: [...other.taken, formatMessage(`taken: ${commas}`)] };
}
