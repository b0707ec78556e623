// Judges a list of inverse kinematics solutions: each answer, and the branches that are missing.

import { looksLikeMistake, explainWrongAnswer } from "../causes/branches.js";
import { causeName, causeMessage } from "../causes/ranking.js";
import { RIGHT, ROUNDED, SO_FAR, WRONG } from "../digits.js";
import { jointNames, movingRows, revoluteFlags } from "../geometry/kinematics.js";
import { solveTarget } from "../geometry/target.js";
import { matchAnswers, NEARLY_ZERO, isSameAnswer } from "../matching.js";
import { answers } from "../reading/joint_vectors.js";
import { rowsGiven } from "../reading/numbers.js";
import { completeVerdicts, makeVerdict } from "../verdict.js";
import { askAboutDegrees } from "./degrees.js";
import { joinList, uncapitalize, formatMessage } from "../sentences.js";
import { judgeFirstAngles, judgeWholeOrPart } from "./first_joints.js";

/** @typedef {import("../geometry/arm.js").Arm} Arm */

/** @typedef {import("../reading/joint_vectors.js").Answer} Answer */
/** @typedef {import("../causes/ranking.js").Cause} Cause */
/** @typedef {import("../verdict.js").Finding} Finding */
/** @typedef {import("../matching.js").Solutions} Solutions */

/**
 * Judge joint vectors, a text or nested lists, for a target of an arm with a closed form: three
 * coordinates or the rows of a pose.
 * @param {string | any[]} mine @param {Arm} arm @param {number[] | number[][]} target
 * @returns {import("../verdict.js").Verdict}
 */
export const compareBranches = completeVerdicts(branchesCompared);

function branchesCompared(mine, arm, target, options = {}) {
  const { angles = "rad", tolerance = null, found = null } = options;
  const isFound = found && found.arm === arm.name;
  const sought = found?.target ?? target;
  const right = makeSolutions(arm, isFound ? found.branches : solveTarget(arm, sought));
  const given = rowsGiven(sought);
  const part = { topic: "branches", angles, tolerance, given, many: true };
  return judgeWholeOrPart(
    () => judgeAnswers(mine, right, sought, options),
    () => judgeFirstAngles(mine, right, part),
  );
}

function judgeAnswers(mine, right, target, options) {
  const { arm } = right;
  const { angles, tolerance = null } = options;
  const { answers: given, taken, typed } = readAnswers(mine, right, target, options);
  const { astray, ...verdict } = judgeReadAnswers(right, given, tolerance, taken);
  const report = askAboutDegrees(verdict, {
    arm,
    values: given.flatMap(({ values }) => values),
    angles,
    key: "ik.degrees",
    judgeInDegrees: () => judgeAnswers(mine, right, target, { ...options, angles: "deg" }),
    makeHeadline: (cause) => formatMessage("ik wrong", { arm: arm.name, cause }),
  });
  const dof = movingRows(right.arm).length;
  const asRows = !taken.length && typed.shape.at(-1) === dof;
  const wrong = asRows && given.flatMap((one, i) => one.values.map(() => astray.includes(i + 1)));
  return wrong ? { ...report, typed, wrong } : { ...report, typed };
}

// Read answers as rows; as columns if the list is square and only its columns are branches.
function readAnswers(mine, right, target, { angles = "rad", tolerance = null, which = null }) {
  const { arm } = right;
  const asked = { given: rowsGiven(target), which };
  const rows = answers(mine, arm, angles, asked);
  const count = rows.answers.length;
  if (count < 2 || count !== movingRows(arm).length) return rows;
  if (matchAnswers(right, rows.answers, tolerance).hits.size) return rows;
  const columns = answers(mine, arm, angles, { ...asked, byColumns: true });
  return matchAnswers(right, columns.answers, tolerance).astray.length ? rows : columns;
}

// Collect the different branches, and their count before equal ones were joined.
/** @returns {Solutions} */
const makeSolutions = (arm, branches) => ({
  arm,
  branches,
  count: branches.reduce((sum, { times }) => sum + times, 0),
});

/** @returns {import("../verdict.js").Verdict & { astray: number[] }} */
function judgeReadAnswers(right, given, tolerance, taken) {
  const { arm, branches } = right;
  const { hits, astray, sharp } = matchAnswers(right, given, tolerance);
  const wrong = astray.map((number) =>
    explainWrongAnswer(right, given[number - 1], number, tolerance),
  );
  const [missing, found] = [false, true].map((there) =>
    branches.flatMap(({ name }, k) => (hits.has(k) === there ? [name] : [])),
  );
  const unreachable = outOfRange(right, hits, missing, found);
  const oneSided = unreachable.length || astray.length ? [] : oneSign(right, hits, missing, found);
  const coarse =
    tolerance === null && given.some((answer) => hits.size && looksLikeMistake(right, answer));
  const unfinished = missing.length > 0 && !unreachable.length;
  const grade = chooseGrade(astray.length > 0, unfinished || coarse, sharp);
  const all = commonCause(wrong);
  const whats = [
    ...wrong.flatMap(({ causes }) => causes.map(causeName)),
    ...oneSided.map(({ what }) => what),
  ];
  return {
    ...makeVerdict("branches", arm, grade, headlineOf(grade, right, { all, found, unfinished })),
    astray,
    findings: [
      ...(all ? [{ what: "cause", where: "", words: `${causeMessage(all)}.` }] : []),
      ...listFoundBranches(found, found.length < branches.length || astray.length > 0),
      ...(all ? [] : wrong.map(({ finding }) => finding)),
      ...listMissingBranches(missing, found.length > 0 || !astray.length),
      ...oneSided,
    ],
    causes: [...new Set(whats)],
    taken,
    notes: [...notesOf(right), ...noteEqualAnswers(arm, given), ...unreachable],
    figures: { found, right: found.length, of: branches.length, wrong: astray.length },
  };
}

// Return the cause that all of several wrong answers share.
function commonCause(wrong) {
  const [first] = wrong;
  const name = ({ causes }) => (causes.length ? causeName(causes[0]) : "");
  if (wrong.length < 2 || !name(first)) return null;
  return wrong.every((one) => name(one) === name(first)) ? first.causes[0] : null;
}

function chooseGrade(faulty, unfinished, sharp) {
  if (faulty) return WRONG;
  if (unfinished) return SO_FAR;
  return sharp ? RIGHT : ROUNDED;
}

// Name the branches in the answer, unless it has all of them, and the missing ones.
const listFoundBranches = (names, told) =>
  told
    ? names.map((name) => ({
        what: "found",
        where: name,
        words: formatMessage("ik found", { name }),
      }))
    : [];

const listMissingBranches = (names, told) =>
  names.length && told
    ? [
        {
          what: "missing",
          where: "",
          words: formatMessage("ik missing", { names: names.join("; ") }),
        },
      ]
    : [];

function headlineOf(grade, { arm, branches }, { all, found, unfinished }) {
  const fields = { arm: arm.name, count: found.length, all: branches.length };
  if (!branches.length) return formatMessage("ik none", fields);
  if (grade === WRONG && all)
    return formatMessage("ik wrong", { cause: uncapitalize(causeMessage(all)), ...fields });
  if (grade === WRONG) return formatMessage("ik some wrong", fields);
  if (grade === SO_FAR) return formatMessage(unfinished ? "ik so far" : "ik so far digits", fields);
  return formatMessage(grade === RIGHT ? "ik right" : "ik rounded", fields);
}

// Report a forgotten sign of a root: a joint with one sign in all answers, the other in all missing
// branches.
/** @returns {Finding[]} */
function oneSign({ arm, branches }, hits, missing, found) {
  if (!found.length || !missing.length) return [];
  const turns = revoluteFlags(arm);
  const k = jointNames(arm).findIndex((_, joint) => {
    const q = branches.map((branch) => branch.q[joint]);
    const clear = Math.min(...q.map((x) => Math.abs(turns[joint] ? Math.sin(x) : x))) > NEARLY_ZERO;
    const there = new Set(q.filter((_, b) => hits.has(b)).map(Math.sign));
    const others = q.filter((_, b) => !hits.has(b)).map(Math.sign);
    return clear && there.size === 1 && others.every((sign) => there.has(-sign));
  });
  if (k < 0) return [];
  const key = k || !turns[0] ? "ik.one sign" : "ik one side";
  return [
    { what: "ik.one sign", where: "", words: formatMessage(key, { joint: jointNames(arm)[k] }) },
  ];
}

// Report missing branches whose prismatic joint is beyond its range.
function outOfRange({ arm, branches }, hits, missing, found) {
  if (!found.length || !missing.length) return [];
  const lacking = branches.filter((_, b) => !hits.has(b));
  const turns = revoluteFlags(arm);
  const beyond = movingRows(arm).flatMap((row, k) => {
    const { lower: least, upper: most } = arm.rows[row];
    const inside = (x) => (least ?? -Infinity) <= x && x <= (most ?? Infinity);
    return turns[k] || lacking.some(({ q }) => inside(q[k])) ? [] : [jointNames(arm)[k]];
  });
  return beyond.length ? [formatMessage("ik out of range", { joints: joinList(beyond) })] : [];
}

// Report each group of equal answers.
function* noteEqualAnswers(arm, given) {
  for (const [n, one] of given.entries()) {
    const same = given.map((other) => isSameAnswer(arm, other, one));
    const alike = same.flatMap((is, k) => (is ? [k + 1] : []));
    if (alike.length > 1 && alike[0] === n + 1)
      yield formatMessage("ik twice", { numbers: joinList(alike.map(String)) });
  }
}

function* notesOf({ arm, branches, count }) {
  if (branches.length < count)
    yield formatMessage("ik together", { count: branches.length, all: count });
  for (const [k, joint] of jointNames(arm).entries()) {
    if (branches.some(({ free }) => free[k])) yield formatMessage("ik free", { joint });
  }
}
