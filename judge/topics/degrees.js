// Asks whether joint values that were read in one unit of angles are in the other one.

import { causeMessage, causeName, makeCause } from "../causes/ranking.js";
import { RIGHT, ROUNDED, SO_FAR, WRONG } from "../digits.js";
import { DEG } from "../geometry/angles.js";
import { jointNames, revoluteFlags } from "../geometry/kinematics.js";
import { formatMessage, formatNumber, uncapitalize } from "../sentences.js";

const TURN = 2 * Math.PI;

/** @typedef {import("../verdict.js").Verdict} Verdict */
/**
 * The question, and how to judge it again.
 * @typedef {object} DegreesQuestion
 * @property {import("../geometry/arm.js").Arm} arm
 * @property {number[]} values joint values as they were read, one configuration after another
 * @property {string} [angles] unit that the question names, "rad" or "deg"
 * @property {Record<string, string>} keys of the message that the other unit was typed, by the unit
 *   that was typed
 * @property {(angles: string) => Verdict} judgeIn judges the same answer in a unit
 * @property {(cause: string) => string} makeHeadline for an answer that is right in the other unit
 */

/**
 * Judge a wrong answer in the other unit of angles, and report if it is right there. Radians are
 * taken for degrees only if an angle exceeds a whole turn, since nobody types such an angle in
 * radians; if the answer is wrong in degrees too, the verdict asks. Degrees are taken for radians
 * only if no angle exceeds a whole turn.
 * @param {Verdict} verdict
 * @param {DegreesQuestion} question
 * @returns {Verdict}
 */
export function askAboutDegrees(verdict, question) {
  const { arm, values, angles = "rad", keys, judgeIn, makeHeadline } = question;
  const isRevolute = revoluteFlags(arm);
  const isAngle = (i) => isRevolute[i % isRevolute.length];
  const typed = values.map((x, i) => (angles === "deg" && isAngle(i) ? x * DEG : x));
  const large = typed.findIndex((x, i) => isAngle(i) && Math.abs(x) > TURN);
  const other = angles === "deg" ? "rad" : "deg";
  const isExplained = verdict.causes.some((name) => name.split(" + ").includes(keys[other]));
  const isOther = other === "deg" ? large >= 0 : large < 0 && verdict.grade === WRONG;
  if (!isOther || isExplained || ![WRONG, SO_FAR].includes(verdict.grade)) return verdict;
  const { grade, notes } = judgeIn(other);
  if ([RIGHT, ROUNDED, SO_FAR].includes(grade)) {
    const cause = makeCause(keys[other]);
    const words = causeMessage(cause);
    const findings = [{ what: "cause", where: "", words: `${words}.` }];
    const headline = makeHeadline(uncapitalize(words));
    const names = [causeName(cause)];
    return { ...verdict, grade: WRONG, headline, findings, causes: names, notes };
  }
  if (other === "rad" || verdict.grade !== WRONG || verdict.causes.length) return verdict;
  const joint = jointNames(arm)[large % isRevolute.length];
  const note = formatMessage("more than a turn", { joint, value: formatNumber(values[large], 6) });
  const setting = { field: "angles", value: "deg" };
  return {
    ...verdict,
    notes: [...verdict.notes, note],
    advice: [setting, ...(verdict.advice ?? [])],
  };
}
