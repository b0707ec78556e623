// Judges a list of inverse kinematics solutions. It judges each joint vector, and names the
// solution branches that are missing.

import { looksLikeMistake, explainWrongAnswer } from "../causes/branches.js";
import { causeName } from "../causes/ranking.js";
import { RIGHT, ROUNDED, SO_FAR, WRONG } from "../digits.js";
import { isOutsideLimits } from "../geometry/arm.js";
import { jointNames, movingRows, revoluteFlags } from "../geometry/kinematics.js";
import { solveTarget } from "../geometry/target.js";
import { matchAnswers, NEARLY_ZERO, isSameAnswer } from "../matching.js";
import { readJointVectors } from "../reading/joint_vectors.js";
import { listGivenRows } from "../reading/numbers.js";
import { makeFinding } from "../verdict.js";
import { ArmError, joinList, formatMessage } from "../sentences.js";
import { listAngleBeginnings } from "./beginning.js";
import { makeJudge } from "./frame.js";

/** @typedef {import("../verdict.js").Finding} Finding */
/** @typedef {import("../matching.js").Solutions} Solutions */

// The most joint vectors of an answer, twice the 16 branches that an arm of six joints can have.
// The search for mistakes in each wrong vector takes time.
const MOST_ANSWERS = 32;

/**
 * Judge joint vectors for a target of an arm with a closed form, which is three coordinates or the
 * rows of a pose.
 */
export const compareBranches = makeJudge({
  name: "branches",
  sentences: {
    [RIGHT]: "ik right",
    [SO_FAR]: "ik so far",
    [ROUNDED]: "ik rounded",
    wrong: "ik wrong",
    places: "ik some wrong",
  },
  otherUnit: { deg: "ik.degrees", rad: "ik.radians" },
  ask(arm, typedTarget, { angles = "rad", tolerance = null, which = null, found, stated }) {
    const isSolved = found && found.arm === arm.name;
    const target = found?.target ?? typedTarget;
    const solutions = makeSolutions(arm, isSolved ? found.branches : solveTarget(arm, target));
    return { solutions, given: listGivenRows(target), angles, tolerance, which, stated };
  },
  read: readAnswers,
  compare: compareAnswers,
  getAngles: ({ answers }) => ({ values: answers.flatMap(({ values }) => values) }),
  listBeginnings: ({ solutions, ...question }) =>
    listAngleBeginnings(solutions, { ...question, many: true }),
});

// Read answers as rows, or as columns if the list is square and only its columns are branches.
function readAnswers(mine, { solutions, given, angles, tolerance, which, stated }) {
  const { arm } = solutions;
  const request = { given, which, stated, most: MOST_ANSWERS * arm.rows.length };
  const rows = readJointVectors(mine, arm, angles, request);
  const count = rows.answers.length;
  if (count > MOST_ANSWERS)
    throw new ArmError(formatMessage("many branches", { count, most: MOST_ANSWERS }));
  if (count < 2 || count !== movingRows(arm).length) return rows;
  if (matchAnswers(solutions, rows.answers, tolerance).answerByBranch.size) return rows;
  const columns = readJointVectors(mine, arm, angles, { ...request, byColumns: true });
  return matchAnswers(solutions, columns.answers, tolerance).wrongNumbers.length ? rows : columns;
}

// Collect the different branches, and their count before equal branches were joined.
/** @returns {Solutions} */
const makeSolutions = (arm, branches) => ({
  arm,
  branches,
  count: branches.reduce((sum, { times }) => sum + times, 0),
});

/** @returns {import("./frame.js").Outcome} */
function compareAnswers({ answers, taken, typed }, { solutions, tolerance }) {
  const { arm, branches } = solutions;
  const { answerByBranch, wrongNumbers, isExact } = matchAnswers(solutions, answers, tolerance);
  const explanations = wrongNumbers.map((number) =>
    explainWrongAnswer(solutions, answers[number - 1], number, tolerance),
  );
  const hasWrong = wrongNumbers.length > 0;
  const found = branches.flatMap(({ name }, k) => (answerByBranch.has(k) ? [name] : []));
  const missing = branches.flatMap(({ name }, k) => (answerByBranch.has(k) ? [] : [name]));
  const unreachable = noteOutOfRange(solutions, answerByBranch);
  const forgottenSigns =
    unreachable.length || hasWrong ? [] : findForgottenSign(solutions, answerByBranch);
  const hasTooFewDigits =
    tolerance === null &&
    answers.some((answer) => answerByBranch.size && looksLikeMistake(solutions, answer));
  const isUnfinished = missing.length > 0 && !unreachable.length;
  const grade = chooseGrade(hasWrong, isUnfinished || hasTooFewDigits, isExact);
  const common = findCommonCause(explanations);
  const causeNames = [
    ...explanations.flatMap((explanation) => explanation.causes.map(causeName)),
    ...forgottenSigns.map(({ what }) => what),
  ];
  const fields = { arm: arm.name, count: found.length, all: branches.length };
  const headline = chooseHeadline(grade, { branches, common, isUnfinished });
  const isReadByRows = !taken.length && typed.shape.at(-1) === movingRows(arm).length;
  const flagAnswer = ({ values }, i) => values.map(() => wrongNumbers.includes(i + 1));
  return {
    grade,
    causes: common ? [common] : [],
    causeNames: [...new Set(causeNames)].filter((name) => !common || name !== causeName(common)),
    findings: [...listFindings({ common, explanations, found, missing }), ...forgottenSigns],
    fields,
    ...(headline ? { headline: formatMessage(headline, fields) } : {}),
    taken,
    notes: [...noteBranches(solutions), ...noteEqualAnswers(arm, answers), ...unreachable],
    figures: { found, right: found.length, of: branches.length, wrong: wrongNumbers.length },
    ...(isReadByRows ? { wrong: answers.flatMap(flagAnswer) } : {}),
  };
}

// Return the cause that two or more wrong answers share, or null.
function findCommonCause(explanations) {
  const [first] = explanations;
  const nameFirst = ({ causes }) => (causes.length ? causeName(causes[0]) : "");
  if (explanations.length < 2) return null;
  const isCommon = explanations.every((other) => nameFirst(other) === nameFirst(first));
  return isCommon ? (first.causes[0] ?? null) : null;
}

function chooseGrade(hasWrong, isUnfinished, isExact) {
  if (hasWrong) return WRONG;
  if (isUnfinished) return SO_FAR;
  return isExact ? RIGHT : ROUNDED;
}

// List the wrong answers, the branches in the answer unless it is complete, and the missing
// branches unless no answer is right.
/** @returns {Finding[]} */
function listFindings({ common, explanations, found, missing }) {
  const hasWrong = explanations.length > 0;
  const findings = [];
  if (missing.length || hasWrong)
    for (const name of found)
      findings.push(makeFinding("found", formatMessage("ik found", { name }), name));
  if (!common) findings.push(...explanations.map(({ finding }) => finding));
  if (missing.length && (found.length || !hasWrong))
    findings.push(
      makeFinding("missing", formatMessage("ik missing", { names: missing.join("; ") })),
    );
  return findings;
}

// Return the key of a headline that neither the grade nor a common cause gives, or null.
function chooseHeadline(grade, { branches, common, isUnfinished }) {
  if (!branches.length) return "ik none";
  if (grade === WRONG) return common ? null : "ik some wrong";
  return grade === SO_FAR && !isUnfinished ? "ik so far digits" : null;
}

// Report a forgotten sign of a root. A joint then has the same sign in all answers and the opposite
// sign in all missing branches.
/** @returns {Finding[]} */
function findForgottenSign({ arm, branches }, answerByBranch) {
  if (!isPartial(branches, answerByBranch)) return [];
  const isRevolute = revoluteFlags(arm);
  const k = jointNames(arm).findIndex((_, joint) => {
    const q = branches.map((branch) => branch.q[joint]);
    const sizes = q.map((x) => Math.abs(isRevolute[joint] ? Math.sin(x) : x));
    const foundSigns = new Set(q.filter((_, b) => answerByBranch.has(b)).map(Math.sign));
    const missingSigns = q.filter((_, b) => !answerByBranch.has(b)).map(Math.sign);
    return (
      Math.min(...sizes) > NEARLY_ZERO &&
      foundSigns.size === 1 &&
      missingSigns.every((sign) => foundSigns.has(-sign))
    );
  });
  if (k < 0) return [];
  const key = k || !isRevolute[0] ? "ik.one sign" : "ik one side";
  return [makeFinding("ik.one sign", formatMessage(key, { joint: jointNames(arm)[k] }))];
}

// Return whether some branches are in the answer and some are missing.
const isPartial = (branches, answerByBranch) =>
  answerByBranch.size > 0 && answerByBranch.size < branches.length;

// Note a prismatic joint that is beyond its range in all missing branches.
function noteOutOfRange({ arm, branches }, answerByBranch) {
  if (!isPartial(branches, answerByBranch)) return [];
  const missing = branches.filter((_, b) => !answerByBranch.has(b));
  const isRevolute = revoluteFlags(arm);
  const rows = movingRows(arm).map((row) => arm.rows[row]);
  const beyond = jointNames(arm).filter(
    (_, k) => !isRevolute[k] && missing.every(({ q }) => isOutsideLimits(rows[k], q[k])),
  );
  return beyond.length ? [formatMessage("ik out of range", { joints: joinList(beyond) })] : [];
}

// Note each group of equal answers.
function* noteEqualAnswers(arm, answers) {
  for (const [n, answer] of answers.entries()) {
    const numbers = answers.flatMap((other, k) =>
      isSameAnswer(arm, other, answer) ? [k + 1] : [],
    );
    if (numbers.length > 1 && numbers[0] === n + 1)
      yield formatMessage("ik twice", { numbers: joinList(numbers.map(String)) });
  }
}

// Note branches that coincide and joints that are free.
function* noteBranches({ arm, branches, count }) {
  if (branches.length < count)
    yield formatMessage("ik together", { count: branches.length, all: count });
  for (const [k, joint] of jointNames(arm).entries()) {
    if (branches.some(({ free }) => free[k])) yield formatMessage("ik free", { joint });
  }
}
