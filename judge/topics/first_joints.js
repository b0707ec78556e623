// Judges an unfinished answer, which has the torques or joint angles of the first joints only.

import { makeTorqueMaker } from "../causes/torques.js";
import { SO_FAR, WRONG } from "../digits.js";
import { judgeEntries } from "../entries.js";
import { jointNames, jointNumbers, movingRows } from "../geometry/kinematics.js";
import { findBranch } from "../matching.js";
import { NoFitError } from "../reading/answers.js";
import { jointShapes } from "../reading/numbers.js";
import { readJointVectors } from "../reading/joint_vectors.js";
import { dropUnfilledEnd } from "../reading/unfilled.js";
import { formatMessage, joinList, tryOrNull } from "../sentences.js";
import { makeVerdict } from "../verdict.js";

/** @typedef {import("../geometry/arm.js").Arm} Arm */
/** @typedef {import("../reading/answers.js").Want} Want */
/** @typedef {import("../reading/numbers.js").Typed} Typed */
/** @typedef {import("../verdict.js").Verdict} Verdict */
/**
 * A question about torques at one configuration q of a loaded arm. `taken` describes q and the
 * masses.
 * @typedef {{ arm: Arm, q: import("../digits.js").Entries,
 *   load: import("../causes/torques.js").Load, tolerance: number | null,
 *   isGradeOnly: boolean | undefined, taken: string[] }} TorqueContext
 */

// Characters of a half-done answer: five rows of formulas of a Jacobian are the longest, 4 000.
const MOST_CHARACTERS = 6000;

/**
 * Judge an answer. If it has too few numbers, judge them as the numbers of the first joints. A part
 * is tried in many shapes, so a long text is not tried as a part.
 * @template {Verdict} T
 * @param {any} mine text or nested lists
 * @param {() => T} judge throws a NoFitError if there are too few numbers
 * @param {() => Verdict | null} judgePart returns null if the numbers are not right either
 * @returns {T | Verdict}
 */
export function judgeWholeOrPart(mine, judge, judgePart) {
  try {
    return judge();
  } catch (error) {
    const mayBePart = error instanceof NoFitError && !(mine?.length > MOST_CHARACTERS);
    const verdict = mayBePart ? judgePart() : null;
    if (verdict) return verdict;
    throw error;
  }
}

/**
 * Judge a text with too few torques.
 * @param {(wants: Want[]) => Typed} read reads the text as numbers of some shape
 * @param {TorqueContext} context
 * @returns {Verdict | null} null if its numbers are not the right torques of the first joints
 */
export function judgeFirstTorquesInText(read, context) {
  for (const want of listPartialShapes(context.load.c.dof)) {
    const typed = tryOrNull(() => read([want]));
    if (typed && hasOnlyFirstJoints(typed, context.arm)) return judgeFirstTorques(typed, context);
  }
  return null;
}

/**
 * Judge a list of too few torques.
 * @param {Typed} typed in N m
 * @param {TorqueContext} context
 * @returns {Verdict | null} null if they are not the right torques of the first joints
 */
export function judgeFirstTorques(typed, { arm, q, load, tolerance, taken }) {
  const { dof } = load.c;
  const { values: typedTorques, shape } = typed;
  const count = typedTorques.length;
  const isList = shape.filter((n) => n !== 1).length === 1;
  if (!isList || count >= dof) return null;
  const makeTorques = makeTorqueMaker(load, dof, q.values)();
  const makeExpected = (values) => makeTorques(values).slice(0, count);
  const question = { typed, q, dof, makeExpected, mistakes: [], tolerance };
  const { grade, wrong } = judgeEntries(question);
  if (grade === WRONG) return null;
  const missing = jointNumbers(arm).slice(count);
  const joints = joinList(missing.map((joint) => formatMessage("joint", { joint })));
  const words = formatMessage("tau first missing", { joints });
  const headline = formatMessage("tau first joints", { arm: arm.name, count, all: dof });
  return makeVerdict("torques", arm, SO_FAR, headline, {
    findings: [{ what: "missing", where: joints, words }],
    taken: [...typed.taken, ...taken],
    figures: { right: count, of: dof },
    typed,
    wrong,
  });
}

// List the shapes of two or more torques, the longest first.
/** @param {number} dof @returns {Want[]} */
const listPartialShapes = (dof) =>
  Array.from({ length: Math.max(0, dof - 2) }, (_, k) => dof - 1 - k).flatMap((count) => [
    { rows: 1, columns: count, by: "joint" },
    { rows: count, columns: 1 },
  ]);

/**
 * Judge joint vectors without the last joints, which are missing in all of them.
 * @param {any} mine text or nested lists
 * @param {import("../matching.js").Solutions} right
 * @param {{ topic: string, angles: string, tolerance: number | null, given: number[][],
 *   many: boolean }} question `given` holds the question's numbers; `many` allows several vectors
 * @returns {Verdict | null} null if some vector begins no solution branch
 */
export function judgeFirstAngles(mine, { arm, branches }, question) {
  const { topic, angles, tolerance, given, many } = question;
  const dof = movingRows(arm).length;
  const typedText = dropUnfilledEnd(mine);
  for (let count = dof - 1; count > 1; count--) {
    const firstLinks = { ...arm, rows: arm.rows.slice(0, movingRows(arm)[count]) };
    const wants = jointShapes(firstLinks, many);
    const read = tryOrNull(() => readJointVectors(typedText, firstLinks, angles, { wants, given }));
    if (!read?.answers.length || !hasOnlyFirstJoints(read.typed, arm)) continue;
    const firstAngles = branches.map((branch) => ({ ...branch, q: branch.q.slice(0, count) }));
    const solutions = { arm: firstLinks, branches: firstAngles, count: firstAngles.length };
    const isRight = (answer) => findBranch(solutions, answer, tolerance) >= 0;
    if (!read.answers.every(isRight)) continue;
    const joints = joinList(jointNames(arm).slice(count));
    const words = formatMessage("ik first missing", { joints });
    const headline = formatMessage("ik first joints", { arm: arm.name, count, all: dof });
    return makeVerdict(topic, arm, SO_FAR, headline, {
      findings: [{ what: "missing", where: joints, words }],
      taken: read.taken,
      figures: { right: count, of: dof },
      typed: read.typed,
    });
  }
  return null;
}

// Return whether each number of a text is an entry, or a label that counts joints or vectors. Any
// other number may be an entry that could not be read.
/** @param {Typed} typed @param {Arm} arm */
function hasOnlyFirstJoints({ tokens = [], values, shape }, arm) {
  const labels = tokens.filter(({ owner }) => owner !== "entry");
  const joints = jointNumbers(arm);
  const isCounted = [labels.map((_, k) => k + 1), joints].some((numbers) =>
    labels.every(({ owner, text }, k) => owner === "label" && Number(text) === numbers[k]),
  );
  return isCounted && [0, shape[0], values.length].includes(labels.length);
}
