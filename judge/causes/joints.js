// What slips make of right joint angles, undone: the cause, and the angles that would have come out
// without it. Behind each, where it was seen: a slip's number in homework.md, or work handed in.

import { cosSin, jointNumbers, revoluteFlags } from "../geometry/kinematics.js";
import { RAD } from "../geometry/angles.js";
import { makeCause } from "./ranking.js";
import { makerJointSigns } from "./tables.js";

const QUARTER = Math.PI / 2;
/** @type {[string, (x: number) => number][]} */
const JOINT = [
  ["ik.sign", (x) => -x], // slip 22: one sign of acos
  ["ik.half turn", (x) => x + Math.PI], // slip 13: atan for atan2
  ["ik.other axis", (x) => QUARTER - x], // slip 13: x/y for y/x
  ["ik.supplement", (x) => Math.PI - x], // slip 16: cos(pi - x)
  ["ik.offset", (x) => x + QUARTER], // the UR10e's offsets in theta
  ["ik.offset", (x) => x - QUARTER],
];

/** @typedef {import("./ranking.js").Cause} Cause */
/** @typedef {[Cause, (q: number[]) => number[]]} JointMistake */

export const jointNames = (arm) => jointNumbers(arm).map((i) => `q_${i}`);

/** Slips of any joint vector. @returns {JointMistake[]} */
export const jointMistakes = (arm) => [...single(arm), ...whole(arm)];

/** Slips in all joints at once. @returns {Generator<JointMistake>} */
function* whole(arm) {
  const turns = revoluteFlags(arm);
  yield [makeCause("ik.degrees"), (q) => q.map((x, k) => (turns[k] ? x * RAD : x))];
  // handed in: q6 ... q1
  if (turns.length > 1) yield [makeCause("ik.reversed order"), (q) => [...q].reverse()];
  const signs = makerJointSigns(arm); // handed in
  if (signs) yield [makeCause("ik.makers signs"), (q) => q.map((x, k) => signs[k] * x)];
}

/** Slips in one joint, or in one step of a closed form. @returns {Generator<JointMistake>} */
function* single(arm) {
  const turns = revoluteFlags(arm);
  const names = jointNames(arm);
  yield* elbowFormula(arm);
  for (const [k, joint] of names.entries()) {
    for (const [key, change] of turns[k] ? JOINT : JOINT.slice(0, 1))
      yield [makeCause(key, { joint }), (q) => q.map((x, i) => (i === k ? change(x) : x))];
    for (let n = k + 1; n < names.length; n++) {
      const exchanged = (q) => q.map((x, i) => (i === k ? q[n] : i === n ? q[k] : x)); // handed in
      yield [makeCause("ik.exchanged", { first: joint, second: names[n] }), exchanged];
    }
  }
}

// theta_2 = atan2(s, r) + ... for minus, where two parallel axes carry two links: slip 12.
/** @returns {Generator<JointMistake>} */
function* elbowFormula({ rows }) {
  if (rows.length < 3) return;
  const [, second, third] = rows;
  const [ca, sa] = cosSin(second.alpha);
  if (Math.abs(sa) > 1e-9 || !second.a || !third.a) return;
  const lean = (q) => {
    const bend = ca * (q[2] + third.theta);
    return Math.atan2(third.a * Math.sin(bend), second.a + third.a * Math.cos(bend));
  };
  yield [makeCause("ik.plus for minus"), (q) => q.map((x, i) => (i === 1 ? x - 2 * lean(q) : x))];
}
