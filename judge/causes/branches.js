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
import { jointMistakes } from "./joints.js";
import { combineCauses, makeCause, causeName, joinCauseMessages, causeMessage } from "./ranking.js";
import { tableMistakes } from "./chain.js";

/** @typedef {import("./ranking.js").Cause} Cause */
/** @typedef {import("../verdict.js").Finding} Finding */
/** @typedef {import("../matching.js").Solutions} Solutions */
/** @typedef {import("../reading/joint_vectors.js").Answer} Answer */

const COARSE = 0.0175; // rad or m: with a unit above one degree some slip would fit anything
const QUARTER = Math.PI / 2;
const NUDGE = 1e-6; // rad or m: a difference for a derivative

/**
 * @param {Solutions} right @param {Answer} answer
 * @returns {{ causes: Cause[], finding: Finding }}
 */
export function explainWrongAnswer(right, answer, number, tolerance) {
  const where = formatMessage("answer", { number });
  const plainly = (key) => ({
    causes: [],
    finding: { what: "answer", where, words: formatMessage(key, { number }) },
  });
  if (!right.branches.length) return plainly("ik no branch");
  if (reachesTarget(right, answer.values)) return plainly("ik unlisted");
  const [away, turned] = measureMiss(right, answer.values);
  const { causes, words } = why(right, answer, tolerance);
  const off = describeMiss(away, answer.values.length >= 6 ? turned : 0);
  const what = causes.length ? causeName(causes[0]) : "answer";
  return {
    causes,
    finding: { what, where, words: formatMessage("ik answer", { number, off, words }) },
  };
}

// Explain joint values by a mix of two branches, by one mistake, or by one mistake with a wrong
// shoulder; if none fits, name the joints that occur in no branch.
/** @returns {{ causes: Cause[], words: string }} */
function why(right, answer, tolerance) {
  const fits = matchJointsByBranch(right, answer, tolerance);
  const mixed = mixedOf(right, fits);
  if (mixed) return orPlus(mixed, right, answer, tolerance);
  const causes = mended(right, answer, tolerance);
  if (causes.length) return { causes, words: uncapitalize(joinCauseMessages(causes)) };
  const astray = jointNames(right.arm).filter((_, k) => !fits.some((row) => row[k]));
  const key = astray.length > 1 ? "ik in no branch" : "ik one in no branch";
  return { causes: [], words: formatMessage(key, { joints: joinList(astray) }) };
}

// In a planar arm slip 12 gives the second angle of the other elbow, so both causes are stated.
function orPlus(mixed, right, answer, tolerance) {
  const [plus] = jointMistakes(right.arm).filter(([{ keys }]) =>
    keys.includes("ik.plus for minus"),
  );
  if (!plus || findBranch(right, undone(answer, plus[1]), tolerance) < 0) return mixed;
  const words = formatMessage("or", {
    first: mixed.words,
    others: uncapitalize(causeMessage(plus[0])),
  });
  return { causes: [...mixed.causes, plus[0]], words };
}

// Return whether an answer fits a branch and, with so few digits, a mistake in that branch as well.
export const looksLikeMistake = (right, answer) =>
  jointMistakes(right.arm).some(([, mend]) =>
    right.branches.some(({ q, free }) => {
      const made = { values: mend(q), units: answer.units };
      const slipped = { ...right, branches: [{ q: made.values, free }] };
      const both = findBranch(right, answer, null) >= 0 && findBranch(slipped, answer, null) === 0;
      return both && changes(right, { values: q, units: q.map(() => 0) }, made);
    }),
  );

// List the mistakes without which an answer would equal a branch or reach the target by another
// table; if there are none, those without which only the shoulder would differ.
function mended(right, answer, tolerance) {
  const each = [...jointMistakes(right.arm), ...kept(right, answer)];
  const without = each.map(([one, mend]) => ({ cause: one, mended: undone(answer, mend) }));
  const worth = without.filter((one) => fine(one.mended) && changes(right, answer, one.mended));
  const by = (test) => worth.filter((one) => test(one.mended)).map((one) => one.cause);
  const plain = by((one) => findBranch(right, one, tolerance) >= 0);
  const arrives = (change) => reachesTarget(right, answer.values, answer.units, change);
  const changed = arrives() || !fine(answer) ? [] : tableMistakes(right.arm);
  const tables = changed.flatMap(([one, change]) => (arrives(change) ? [one] : []));
  if (plain.length || tables.length) return distinct([...plain, ...tables]);
  const turned = by((one) => shoulderAlone(matchJointsByBranch(right, one, tolerance)));
  return distinct(turned).map((one) => combineCauses(one, makeCause("ik.shoulder")));
}

const fine = ({ units }) => Math.max(...units) <= COARSE;

const distinct = (found) =>
  found.filter((one, i) => found.findIndex((other) => causeName(other) === causeName(one)) === i);

// Undo a mistake in an answer, and carry the units of its last places along.
function undone({ values, units }, mend) {
  const without = mend(values);
  const slope = values.map(
    (_, k) => (mend(values.map((x, i) => (i === k ? x + NUDGE : x)))[k] - without[k]) / NUDGE,
  );
  return { values: without, units: units.map((u, k) => u * Math.abs(slope[k] || 1)) };
}

// Return whether a mistake changes more than the typed digits; near 0, degrees look like radians.
const changes = ({ arm }, { values, units }, without) => {
  const turns = revoluteFlags(arm);
  return values.some((x, k) => {
    const gap = Math.abs(x - without.values[k]) % (turns[k] ? 2 * Math.PI : Infinity);
    return gap > Math.max(units[k], 1e-3);
  });
};

/**
 * theta_1 = +-pi/2 kept from the singular case of an offset shoulder: slips 14 and 15.
 * @returns {[Cause, (q: number[]) => number[]][]}
 */
function kept({ branches }, { values: [first], units: [unit] }) {
  if (Math.abs(Math.abs(first) - QUARTER) > Math.max(unit, 1e-4)) return [];
  return branches.map((branch) => [
    makeCause("ik.quarter turn"),
    (q) => [branch.q[0], ...q.slice(1)],
  ]);
}

// Return whether an answer is a branch with the first joint of another: report E's list, chapter 5.
const shoulderAlone = (fits) =>
  fits[0].length > 2 &&
  fits.some(([first]) => first) &&
  fits.some(([first, ...rest]) => !first && rest.every(Boolean));

// Explain an answer whose every joint occurs in some branch: name the branch with most of its
// joints, and one that has the others; null if a joint occurs in none.
/** @returns {{ causes: Cause[], words: string } | null} */
function mixedOf({ arm, branches }, fits) {
  const names = jointNames(arm);
  if (!names.every((_, k) => fits.some((row) => row[k]))) return null;
  if (shoulderAlone(fits))
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
