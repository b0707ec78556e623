// Judges the entries of a Jacobian, of torques or of a pose. It compares them to their digits, and
// finds the mistakes that explain wrong entries or would look the same.

import { findExplanations, listMistakePairs, listSingleMistakes } from "./causes/ranking.js";
import {
  compareDigits,
  agrees,
  flagWrongEntries,
  isRight,
  RIGHT,
  ROUNDED,
  computeSlack,
  sharpenUnits,
  SO_FAR,
  canBeDistinguished,
  WRONG,
} from "./digits.js";

/** @typedef {import("./digits.js").Entries} Entries */
/** @typedef {import("./causes/ranking.js").Mistake} Mistake */
/**
 * Entries to be judged.
 * @typedef {object} EntriesQuestion
 * @property {Entries} typed
 * @property {Entries} q joint values, `dof` for each configuration
 * @property {number} dof
 * @property {import("./causes/ranking.js").Maker} maker computes the entries from q
 * @property {import("./causes/ranking.js").Step[]} [steps] usual mistakes
 * @property {boolean} [hasPairs] whether pairs of mistakes are tried if no single mistake explains
 *   the entries
 * @property {number | null} [tolerance] used instead of the typed digits
 * @property {boolean} [isGradeOnly] whether the mistakes in a wrong answer are not asked for
 * @property {boolean} [areGiven] whether the entries are those of a given target
 */
/**
 * The result of judging entries.
 * @typedef {object} EntriesVerdict
 * @property {string} grade
 * @property {string} agreement of the last digits: "rounded", "cut", "one off" or ""
 * @property {Mistake[]} mistakes mistakes that explain the answer, or would look the same
 * @property {boolean[]} wrong whether each entry is wrong
 */

/** Judge entries. @param {EntriesQuestion} question @returns {EntriesVerdict} */
export function judgeEntries(question) {
  const { q, dof, maker, steps = [], hasPairs = true, tolerance = null } = question;
  const makeExpected = maker();
  const mistakes = listSingleMistakes(steps, maker);
  const expected = makeExpected(q.values);
  const typed = sharpenUnits(question.typed, expected);
  const zeros = expected.map(() => 0);
  const lookalikes = tolerance === null ? mistakes.filter(looksLike(typed, q, expected)) : [];
  const [grade, slack] =
    tolerance === null
      ? gradeByDigits(typed, expected, computeSlack(q, dof, makeExpected), lookalikes.length > 0)
      : gradeWithin(tolerance, typed, expected);
  const agreement = compareDigits(typed, expected, slack);
  if (grade === RIGHT || grade === SO_FAR)
    return { grade, agreement, mistakes: lookalikes, wrong: zeros.map(() => false) };
  const actual = tolerance === null ? typed : { values: typed.values, units: zeros };
  const wrong = flagWrongEntries(actual, expected, slack);
  if (grade === ROUNDED || question.isGradeOnly) return { grade, agreement, mistakes: [], wrong };
  const { areGiven } = question;
  const usedSlack = tolerance === null ? slack : zeros;
  const answer = { typed, q, dof, expected, slack: usedSlack, wrong, areGiven };
  const single = findExplanations(answer, mistakes);
  const pairs = hasPairs && !single.length ? listMistakePairs(steps, maker) : [];
  const explanations = single.length ? single : findExplanations(answer, pairs);
  return { grade, agreement, mistakes: explanations, wrong };
}

// Return a function that tests whether an answer also fits a mistake that only more digits could
// exclude.
const looksLike =
  (typed, q, expected) =>
  ({ make }) => {
    const values = make(q.values);
    return canBeDistinguished(typed, expected, values) && agrees(typed, values);
  };

/** @returns {[string, number[]]} the grade, and the slack of each entry */
function gradeWithin(tolerance, { values }, expected) {
  const slack = expected.map(() => tolerance);
  const units = slack.map(() => 0);
  return [agrees({ values, units }, expected, slack) ? RIGHT : WRONG, slack];
}

// Grade an answer, with slack from the digits of q only if nothing fits without it.
/** @returns {[string, number[]]} the grade, and the slack of each entry */
function gradeByDigits(typed, expected, slack, hasLookalikes) {
  const zeros = slack.map(() => 0);
  const exactAgreement = compareDigits(typed, expected, zeros);
  if (hasLookalikes) return [exactAgreement ? SO_FAR : WRONG, zeros];
  if (isRight(exactAgreement)) return [RIGHT, zeros];
  const agreement = compareDigits(typed, expected, slack);
  if (!agreement) return [WRONG, slack];
  return [isRight(agreement) ? RIGHT : ROUNDED, slack];
}
