// Finds the mistake that explains why a joint vector equals no solution branch.

import { jointNames, revoluteFlags } from "../geometry/kinematics.js";
import {
  findBranch,
  matchJointsByBranch,
  measureMiss,
  describeMiss,
  reachesTarget,
} from "../matching.js";
import { joinList, uncapitalize, formatMessage } from "../sentences.js";
import { listJointMistakes } from "./joints.js";
import { makeCause, causeName, joinCauseMessages, causeMessage } from "./ranking.js";
import { listTableMistakes } from "./chain.js";

/** @typedef {import("./ranking.js").Cause} Cause */
/** @typedef {import("../verdict.js").Finding} Finding */
/** @typedef {import("../matching.js").Solutions} Solutions */
/** @typedef {import("../reading/joint_vectors.js").JointVector} JointVector */

const COARSEST_DIGIT = 0.0175; // rad or m: with coarser digits some mistake would fit any answer
const QUARTER = Math.PI / 2;
const STEP = 1e-6; // rad or m: step of the difference quotient

/**
 * Explain joint values that equal no branch.
 * @param {Solutions} solutions
 * @param {JointVector} answer
 * @param {number} number of the answer, from 1
 * @param {number | null} tolerance
 * @returns {{ causes: Cause[], finding: Finding }}
 */
export function explainWrongAnswer(solutions, answer, number, tolerance) {
  const where = formatMessage("answer", { number });
  const reportWithoutCause = (key) => ({
    causes: [],
    finding: { what: "answer", where, words: formatMessage(key, { number }) },
  });
  if (!solutions.branches.length) return reportWithoutCause("ik no branch");
  if (reachesTarget(solutions, answer.values)) return reportWithoutCause("ik unlisted");
  const [distance, angle] = measureMiss(solutions, answer.values);
  const { causes, words } = findBranchCauses(solutions, answer, tolerance);
  const off = describeMiss(distance, answer.values.length >= 6 ? angle : 0);
  const what = causes.length ? causeName(causes[0]) : "answer";
  return {
    causes,
    finding: { what, where, words: formatMessage("ik answer", { number, off, words }) },
  };
}

// Explain joint values by a mix of two branches or by a single mistake. If nothing fits, name the
// joints that occur in no branch.
/** @returns {{ causes: Cause[], words: string }} */
function findBranchCauses(solutions, answer, tolerance) {
  const fits = matchJointsByBranch(solutions, answer, tolerance);
  const mixed = explainMixedBranches(solutions, fits);
  if (mixed) return addElbowFormula(mixed, solutions, answer, tolerance);
  const causes = listCauses(solutions, answer, tolerance);
  if (causes.length) return { causes, words: uncapitalize(joinCauseMessages(causes)) };
  const strayJoints = jointNames(solutions.arm).filter((_, k) => !fits.some((row) => row[k]));
  const key = strayJoints.length > 1 ? "ik in no branch" : "ik one in no branch";
  return { causes: [], words: formatMessage(key, { joints: joinList(strayJoints) }) };
}

// Add slip 12 to a mix of branches, since in a planar arm both give the other elbow's second angle.
function addElbowFormula(mixed, solutions, answer, tolerance) {
  const elbow = listJointMistakes(solutions.arm).find(
    ({ cause }) => causeName(cause) === "ik.plus for minus",
  );
  if (!elbow || findBranch(solutions, undoMistake(answer, elbow), tolerance) < 0) return mixed;
  const words = formatMessage("or", {
    first: mixed.words,
    others: uncapitalize(causeMessage(elbow.cause)),
  });
  return { causes: [...mixed.causes, elbow.cause], words };
}

// Return whether an answer fits a branch and, with so few digits, a mistake in that branch as well.
export const looksLikeMistake = (solutions, answer) =>
  listJointMistakes(solutions.arm).some(({ correct }) =>
    solutions.branches.some(({ q, free }) => {
      const mistaken = { values: correct(q), units: answer.units };
      const withMistake = { ...solutions, branches: [{ q: mistaken.values, free }] };
      const fitsBoth =
        findBranch(solutions, answer, null) >= 0 && findBranch(withMistake, answer, null) === 0;
      return fitsBoth && exceedsDigits(solutions, { values: q, units: q.map(() => 0) }, mistaken);
    }),
  );

// List the mistakes without which an answer would equal a branch, or reach the target by a wrong
// table.
function listCauses(solutions, answer, tolerance) {
  const corrections = [...listJointMistakes(solutions.arm), ...listQuarterTurns(solutions, answer)]
    .map((mistake) => ({ cause: mistake.cause, corrected: undoMistake(answer, mistake) }))
    .filter(
      ({ corrected }) => hasFineDigits(corrected) && exceedsDigits(solutions, answer, corrected),
    );
  const jointCauses = corrections
    .filter(({ corrected }) => findBranch(solutions, corrected, tolerance) >= 0)
    .map(({ cause }) => cause);
  const reaches = (change) => reachesTarget(solutions, answer.values, answer.units, change);
  const tableChanges = reaches() || !hasFineDigits(answer) ? [] : listTableMistakes(solutions.arm);
  const tableCauses = tableChanges.flatMap(({ cause, change }) => (reaches(change) ? [cause] : []));
  const causes = [...jointCauses, ...tableCauses];
  const names = causes.map(causeName);
  return causes.filter((_, i) => names.indexOf(names[i]) === i);
}

const hasFineDigits = ({ units }) => Math.max(...units) <= COARSEST_DIGIT;

// Undo a mistake in an answer, and carry the units of its last places along.
function undoMistake({ values, units }, { correct }) {
  const corrected = correct(values);
  const slopes = values.map(
    (_, k) => (correct(values.map((x, i) => (i === k ? x + STEP : x)))[k] - corrected[k]) / STEP,
  );
  return { values: corrected, units: units.map((unit, k) => unit * Math.abs(slopes[k] || 1)) };
}

// Return whether a mistake changes more than the typed digits. Near 0, degrees look like radians.
const exceedsDigits = ({ arm }, { values, units }, corrected) => {
  const isRevolute = revoluteFlags(arm);
  return values.some((x, k) => {
    const gap = Math.abs(x - corrected.values[k]) % (isRevolute[k] ? 2 * Math.PI : Infinity);
    return gap > Math.max(units[k], 1e-3);
  });
};

/**
 * List theta_1 = +-pi/2, which is right only in the singular case of an offset shoulder (slips 14
 * and 15).
 * @returns {import("./joints.js").JointMistake[]}
 */
function listQuarterTurns({ branches }, { values: [first], units: [unit] }) {
  if (Math.abs(Math.abs(first) - QUARTER) > Math.max(unit, 1e-4)) return [];
  return branches.map((branch) => ({
    cause: makeCause("ik.quarter turn"),
    correct: (q) => [branch.q[0], ...q.slice(1)],
  }));
}

// Return whether an answer is a branch with the first joint of a different branch. Chapter 5 has an
// example, the list of report E.
const isOnlyShoulderWrong = (fits) =>
  fits[0].length > 2 &&
  fits.some(([first]) => first) &&
  fits.some(([first, ...rest]) => !first && rest.every(Boolean));

// Explain an answer in which every joint occurs in some branch. Name the branch with most of its
// joints, and a branch that has the others. The result is null if a joint occurs in no branch.
/** @returns {{ causes: Cause[], words: string } | null} */
function explainMixedBranches({ arm, branches }, fits) {
  const names = jointNames(arm);
  if (!names.every((_, k) => fits.some((row) => row[k]))) return null;
  if (isOnlyShoulderWrong(fits))
    return {
      causes: [makeCause("ik.shoulder")],
      words: uncapitalize(formatMessage("ik.shoulder")),
    };
  const counts = fits.map((row) => row.filter(Boolean).length);
  const most = counts.indexOf(Math.max(...counts));
  const rest = names.flatMap((_, k) => (fits[most][k] ? [] : [k]));
  const other = fits.findIndex((row) => rest.every((k) => row[k]));
  const causes = [makeCause("ik.mixed")];
  if (other < 0) return { causes, words: uncapitalize(formatMessage("ik.mixed")) };
  const fields = { joints: joinList(rest.map((k) => names[k])), other: branches[other].name };
  return { causes, words: formatMessage("ik mixed", { ...fields, most: branches[most].name }) };
}
