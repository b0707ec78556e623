// Judges the entries of a Jacobian, of torques or of a pose. It compares them to their digits, and
// finds the mistakes that explain wrong entries or would look the same.

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

/** @typedef {import("./digits.js").Entries} Entries */
/** @typedef {import("./causes/ranking.js").Mistake} Mistake */
/**
 * Entries to be judged.
 * @typedef {object} EntriesQuestion
 * @property {Entries} mine the typed entries
 * @property {Entries} q joint values, `dof` for each pose
 * @property {number} dof
 * @property {(q: number[]) => number[]} right returns the right entries
 * @property {Mistake[]} mistakes usual mistakes
 * @property {(() => Iterable<Mistake>)[]} [further] lists of mistakes that are tried only if the
 *   earlier lists explain nothing
 * @property {number | null} [tolerance] used instead of the typed digits
 * @property {boolean} [isGradeOnly] whether the mistakes in a wrong answer are not asked for
 */
/**
 * The result of judging entries.
 * @typedef {object} EntriesVerdict
 * @property {string} grade
 * @property {string} how the last digits agree: "rounded", "cut", "one off" or ""
 * @property {Mistake[]} mistakes mistakes that explain the answer, or would look the same
 * @property {boolean[]} wrong whether each entry is wrong
 */

/** Judge entries. @param {EntriesQuestion} question @returns {EntriesVerdict} */
export function judgeEntries(question) {
  const { mine, q, dof, right, mistakes, further = [], tolerance = null } = question;
  const expected = right(q.values);
  const zeros = expected.map(() => 0);
  const alike = tolerance === null ? mistakes.filter(looksLike(mine, q, expected)) : [];
  const [grade, slack] =
    tolerance === null
      ? gradeByDigits(mine, expected, slackOf(q, dof, right), alike.length > 0)
      : gradeWithin(tolerance, mine, expected);
  const how = agreement(mine, expected, slack);
  if (grade === RIGHT || grade === SO_FAR)
    return { grade, how, mistakes: alike, wrong: zeros.map(() => false) };
  const actual = tolerance === null ? mine : { values: mine.values, units: zeros };
  const wrong = beyond(actual, expected, slack);
  if (grade === ROUNDED || question.isGradeOnly) return { grade, how, mistakes: [], wrong };
  const answer = { mine, q, dof, expected, slack: tolerance === null ? slack : zeros, wrong };
  const explanations = explainByFirstList(answer, [() => mistakes, ...further]);
  return { grade, how, mistakes: explanations, wrong };
}

// Return the mistakes of the first list in which some explain an answer.
function explainByFirstList(answer, lists) {
  for (const list of lists) {
    const explanations = findExplanations(answer, list());
    if (explanations.length) return explanations;
  }
  return [];
}

// Return whether an answer also fits a mistake that only more digits could exclude.
const looksLike =
  (mine, q, expected) =>
  ({ make }) => {
    const values = make(q.values);
    return tellable(mine, expected, values) && agrees(mine, values);
  };

/** @returns {[string, number[]]} the grade, and the slack of each entry */
function gradeWithin(tolerance, { values }, expected) {
  const slack = expected.map(() => tolerance);
  const units = slack.map(() => 0);
  return [agrees({ values, units }, expected, slack) ? RIGHT : WRONG, slack];
}

// Grade an answer, with slack from the digits of q only if nothing fits without it.
/** @returns {[string, number[]]} the grade, and the slack of each entry */
function gradeByDigits(mine, expected, slack, isAlike) {
  const zeros = slack.map(() => 0);
  const strictly = agreement(mine, expected, zeros);
  if (isAlike) return [strictly ? SO_FAR : WRONG, zeros];
  if (isRight(strictly)) return [RIGHT, zeros];
  const widely = agreement(mine, expected, slack);
  if (!widely) return [WRONG, slack];
  return [isRight(widely) ? RIGHT : ROUNDED, slack];
}
