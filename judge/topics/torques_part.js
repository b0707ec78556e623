// The verdict on torques of the first joints at one pose; those of the other joints are missing.

import { torqueMaker } from "../causes/torques.js";
import { SO_FAR, WRONG } from "../digits.js";
import { judgeEntries } from "../entries.js";
import { jointNumbers } from "../geometry/kinematics.js";
import { formatMessage, joinList, tryOrNull } from "../sentences.js";
import { makeVerdict } from "../verdict.js";

/** @typedef {import("../geometry/arm.js").Arm} Arm */
/** @typedef {import("../reading/answers.js").Want} Want */
/** @typedef {import("../reading/numbers.js").Typed} Typed */
/** @typedef {import("../verdict.js").Verdict} Verdict */
/**
 * The question: one pose q of a loaded arm, and how the verdict describes q and the masses.
 * @typedef {{ arm: Arm, q: import("../digits.js").Entries,
 *   load: import("../causes/torques.js").Load, tolerance: number | null, taken: string[] }} Context
 */

/**
 * Judge a text with too few torques.
 * @param {(wants: Want[]) => Typed} read reads the text as numbers of some shape
 * @param {Context} context
 * @returns {Verdict | null} null if it has other numbers than right torques of the first joints
 */
export function judgeFirstJointsInText(read, context) {
  for (const want of listPartialShapes(context.load.c.dof)) {
    const typed = tryOrNull(() => read([want]));
    if (typed && hasOnlyFirstJoints(typed)) return judgeFirstJoints(typed, context);
  }
  return null;
}

/**
 * Judge a list of too few torques.
 * @param {Typed} typed in N m
 * @param {Context} context
 * @returns {Verdict | null} null if they are not the right torques of the first joints
 */
export function judgeFirstJoints(typed, { arm, q, load, tolerance, taken }) {
  const { dof } = load.c;
  const { values, shape } = typed;
  const count = values.length;
  const isList = shape.filter((n) => n !== 1).length === 1;
  if (!isList || count >= dof) return null;
  const makeTorques = torqueMaker(load, dof, q.values)();
  const right = (angles) => makeTorques(angles).slice(0, count);
  const { grade, wrong } = judgeEntries({ mine: typed, q, dof, right, slips: [], tolerance });
  if (grade === WRONG) return null;
  const missing = jointNumbers(arm).slice(count);
  const joints = joinList(missing.map((joint) => formatMessage("joint", { joint })));
  const words = formatMessage("tau first missing", { joints });
  const headline = formatMessage("tau first joints", { arm: arm.name, count, all: dof });
  return makeVerdict("torques", arm, SO_FAR, headline, {
    findings: [{ what: "missing", where: joints, words }],
    taken: [...typed.said, ...taken],
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

// Return whether each number of a text is an entry or the label of its joint, counted from 1. Any
// other number may be a torque that could not be read.
/** @param {Typed} typed */
function hasOnlyFirstJoints({ tokens = [], values }) {
  const labels = tokens.filter(({ owner }) => owner !== "entry");
  if (!labels.length) return true;
  const isCounted = labels.every(
    ({ owner, text }, k) => owner === "label" && Number(text) === k + 1,
  );
  return isCounted && labels.length === values.length;
}
