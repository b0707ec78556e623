// The one judge of entries, those of a Jacobian, of torques, of a pose: are they right to their
// digits, would a known slip look the same, which slip explains them, and which of them are wrong.

import { findExplanations } from "./causes/ranking.js";
import {
  agreement,
  agrees,
  beyond,
  isRight,
  RIGHT,
  ROUNDED,
  slackOf,
  SO_FAR,
  tellable,
  WRONG,
} from "./digits.js";

/**
 * What was typed for joint values q, `dof` for each pose; what it should be, and each of the slips
 * that are known, for any q; slips that are tried after those, a list made when it is needed.
 * @typedef {object} Question
 * @property {import("./digits.js").Entries} mine
 * @property {import("./digits.js").Entries} q
 * @property {number} dof
 * @property {(q: number[]) => number[]} right
 * @property {import("./causes/ranking.js").Mistake[]} slips
 * @property {(() => Iterable<import("./causes/ranking.js").Mistake>)[]} [further]
 * @property {number | null} [tolerance] allowed in place of what the digits allow
 */
/**
 * The grade, how the last digits came about, the slips that explain the answer or would look the
 * same, and which entries are wrong.
 * @typedef {{ grade: string, how: string, slips: import("./causes/ranking.js").Mistake[],
 *   wrong: boolean[] }} Verdict
 */

/** @param {Question} question @returns {Verdict} */
export function judgeEntries({ mine, q, dof, right, slips, further = [], tolerance = null }) {
  const truth = right(q.values);
  const none = truth.map(() => 0);
  const alike = tolerance === null ? slips.filter(looksLike(mine, q, truth)) : [];
  const [grade, slack] =
    tolerance === null
      ? gradeByDigits(mine, truth, slackOf(q, dof, right), alike.length > 0)
      : gradeWithin(tolerance, mine, truth);
  const how = agreement(mine, truth, slack);
  if (grade === RIGHT || grade === SO_FAR)
    return { grade, how, slips: alike, wrong: none.map(() => false) };
  const held = tolerance === null ? mine : { values: mine.values, units: none };
  const wrong = beyond(held, truth, slack);
  if (grade === ROUNDED) return { grade, how, slips: [], wrong };
  const answer = { mine, q, dof, truth, slack: tolerance === null ? slack : none, wrong };
  for (const list of [() => slips, ...further]) {
    const found = findExplanations(answer, list());
    if (found.length) return { grade, how, slips: found, wrong };
  }
  return { grade, how, slips: [], wrong };
}

// Whether an answer fits a slip that more digits would tell from the truth.
const looksLike =
  (mine, q, truth) =>
  ({ make }) => {
    const values = make(q.values);
    return tellable(mine, truth, values) && agrees(mine, values);
  };

/** @returns {[string, number[]]} */
function gradeWithin(tolerance, { values }, truth) {
  const slack = truth.map(() => tolerance);
  const units = slack.map(() => 0);
  return [agrees({ values, units }, truth, slack) ? RIGHT : WRONG, slack];
}

// The grade, and what the digits of q may change: nothing where the answer is right, or a known
// slip's, without it.
/** @returns {[string, number[]]} */
function gradeByDigits(mine, truth, slack, alike) {
  const none = slack.map(() => 0);
  const strictly = agreement(mine, truth, none);
  if (alike) return [strictly ? SO_FAR : WRONG, none];
  if (isRight(strictly)) return [RIGHT, none];
  const widely = agreement(mine, truth, slack);
  if (!widely) return [WRONG, slack];
  return [isRight(widely) ? RIGHT : ROUNDED, slack];
}
