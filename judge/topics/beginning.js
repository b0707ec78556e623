// Judges the beginning of an answer whose end is missing: its first rows, columns or joints.

import { SO_FAR } from "../digits.js";
import { jointNames, jointNumbers, movingRows } from "../geometry/kinematics.js";
import { findBranch } from "../matching.js";
import { NoFitError } from "../reading/answers.js";
import { jointShapes } from "../reading/numbers.js";
import { readJointVectors } from "../reading/joint_vectors.js";
import { dropUnfilledEnds } from "../reading/unfilled.js";
import { formatMessage, joinList, tryOrNull } from "../sentences.js";
import { makeFinding, makeVerdict } from "../verdict.js";

/** @typedef {import("../geometry/arm.js").Arm} Arm */
/** @typedef {import("../reading/numbers.js").Typed} Typed */
/** @typedef {import("../verdict.js").Verdict} Verdict */
/**
 * A beginning of an answer.
 * @typedef {object} Beginning
 * @property {string} headline key of the sentence
 * @property {number} count of its rows, columns or joints
 * @property {string[]} names of all rows, columns or joints
 * @property {(text: any) => { typed: Typed, taken: string[] }} read reads an answer of this size
 * @property {(answer: any) => Partial<Verdict> | null} judge returns further fields of the verdict,
 *   or null if the numbers are wrong
 */

// Characters of a half-done answer: five rows of formulas of a Jacobian are the longest, 4 000.
const MOST_CHARACTERS = 6000;

/**
 * Judge an answer. If it has too few numbers, judge them as a beginning. A beginning is read in
 * many shapes, so a long text is judged as a whole only.
 * @param {any} mine text or nested lists
 * @param {() => Verdict} judgeWhole throws a NoFitError if there are too few numbers
 * @param {{ topic: string, arm: Arm, listBeginnings: () => Beginning[] }} question the longest
 *   beginning comes first
 * @returns {Verdict}
 */
export function judgeWholeOrBeginning(mine, judgeWhole, question) {
  const judgePart = () => (mine?.length > MOST_CHARACTERS ? null : judgeBeginning(mine, question));
  try {
    const verdict = judgeWhole();
    const isMisshapen = verdict.findings.some(({ what }) => what === "shape");
    return (isMisshapen && judgePart()) || verdict;
  } catch (error) {
    const verdict = error instanceof NoFitError ? judgePart() : null;
    if (!verdict) throw error;
    return verdict;
  }
}

function judgeBeginning(mine, { topic, arm, listBeginnings }) {
  const text = dropUnfilledEnds(mine);
  for (const { headline, count, names, read, judge } of listBeginnings()) {
    const answer = tryOrNull(() => read(text));
    const fields = answer && ownsAllNumbers(answer.typed, arm) ? judge(answer) : null;
    if (!fields) continue;
    const words = formatMessage(headline, { arm: arm.name, count, all: names.length });
    const { taken, typed } = answer;
    const missing = joinList(names.slice(count));
    const figures = { right: count, of: names.length };
    const begun = describeBeginning(words, missing, { taken, typed, figures, ...fields });
    return makeVerdict(topic, arm, SO_FAR, words, begun);
  }
  return null;
}

/**
 * Describe an answer that is right so far.
 * @param {string} headline @param {string} missing what is not typed yet
 * @param {Partial<Omit<Verdict, "causes">>} fields
 */
export const describeBeginning = (headline, missing, fields) => ({
  grade: SO_FAR,
  headline,
  findings: [makeFinding("missing", formatMessage("still missing", { missing }), missing)],
  ...fields,
});

/**
 * List the beginnings of joint vectors, from which the last joints are missing.
 * @param {import("../matching.js").Solutions} solutions
 * @param {{ angles: string, tolerance: number | null, given: number[][], many: boolean }} question
 *   `given` holds the question's numbers; `many` allows several vectors
 * @returns {Beginning[]}
 */
export function listAngleBeginnings({ arm, branches }, { angles, tolerance, given, many }) {
  const names = jointNames(arm);
  return listCountsBelow(names.length, 2).map((count) => {
    const firstLinks = { ...arm, rows: arm.rows.slice(0, movingRows(arm)[count]) };
    const firstAngles = branches.map((branch) => ({ ...branch, q: branch.q.slice(0, count) }));
    const solutions = { arm: firstLinks, branches: firstAngles, count: firstAngles.length };
    const isRight = (answer) => findBranch(solutions, answer, tolerance) >= 0;
    const wants = jointShapes(firstLinks, many);
    return {
      headline: "ik first joints",
      count,
      names,
      read: (text) => readJointVectors(text, firstLinks, angles, { wants, given }),
      judge: ({ answers }) => (answers.length && answers.every(isRight) ? {} : null),
    };
  });
}

/** List whole numbers below `all`, the largest first. */
export const listCountsBelow = (all, least) =>
  Array.from({ length: Math.max(0, all - least) }, (_, k) => all - 1 - k);

// Return whether each number of a text is an entry, part of a header, or a label that counts joints
// or rows. Any other number may be an entry that could not be read.
/** @param {Typed} typed @param {Arm} arm */
function ownsAllNumbers({ tokens = [], values, shape }, arm) {
  const labels = tokens.filter(({ owner }) => owner !== "entry" && owner !== "header");
  const isCounted = [labels.map((_, k) => k + 1), jointNumbers(arm)].some((numbers) =>
    labels.every(({ owner, text }, k) => owner === "label" && Number(text) === numbers[k]),
  );
  return isCounted && [0, ...shape, values.length].includes(labels.length);
}
