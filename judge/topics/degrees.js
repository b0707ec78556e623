// Asks whether joint values that were read as radians are in degrees.

import { causeMessage, causeName, makeCause } from "../causes/ranking.js";
import { RIGHT, ROUNDED, SO_FAR, WRONG } from "../digits.js";
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
 * @property {string} key of the message that degrees were typed
 * @property {() => Verdict} [judgeInDegrees] judges the same answer with degrees
 * @property {(cause: string) => string} [makeHeadline] for an answer that is right in degrees
 */

/**
 * Ask about degrees if a wrong answer is not explained and some angle exceeds a whole turn. Nobody
 * types such an angle in radians. If the answer is right in degrees, the verdict reports that.
 * @param {Verdict} verdict
 * @param {DegreesQuestion} question
 * @returns {Verdict}
 */
export function askAboutDegrees(verdict, question) {
  const { arm, values, angles = "rad", key, judgeInDegrees, makeHeadline } = question;
  const isRevolute = revoluteFlags(arm);
  const large = values.findIndex((x, i) => isRevolute[i % isRevolute.length] && Math.abs(x) > TURN);
  const isExplained = verdict.causes.some((name) => name.split(" + ").includes(key));
  if (angles === "deg" || large < 0 || isExplained) return verdict;
  if (![WRONG, SO_FAR].includes(verdict.grade)) return verdict;
  if (judgeInDegrees && [RIGHT, ROUNDED, SO_FAR].includes(judgeInDegrees().grade)) {
    const cause = makeCause(key);
    const words = causeMessage(cause);
    const findings = [{ what: "cause", where: "", words: `${words}.` }];
    const headline = makeHeadline(uncapitalize(words));
    return { ...verdict, grade: WRONG, headline, findings, causes: [causeName(cause)] };
  }
  if (verdict.grade !== WRONG || verdict.causes.length) return verdict;
  const joint = jointNames(arm)[large % isRevolute.length];
  const note = formatMessage("more than a turn", { joint, value: formatNumber(values[large], 6) });
  const setting = { field: "angles", value: "deg" };
  return {
    ...verdict,
    notes: [...verdict.notes, note],
    advice: [setting, ...(verdict.advice ?? [])],
  };
}
