// Lists mistakes in joint values. The function of each mistake returns the joint values that the
// student would have had without it. The comment behind each names where the mistake was seen,
// which is a slip of homework.md by its number, or work that was handed in.

import { cosSin, jointNames, revoluteFlags } from "../geometry/kinematics.js";
import { RAD } from "../geometry/angles.js";
import { combinations } from "../geometry/axis_gaps.js";
import { joinList } from "../sentences.js";
import { makeCause } from "./ranking.js";

const QUARTER = Math.PI / 2;
/** Mistakes in a single angle, the commonest first. @type {[string, (x: number) => number][]} */
const ANGLE_MISTAKES = [
  ["ik.sign", (x) => -x], // slip 22: one sign of acos
  ["ik.joint degrees", (x) => x * RAD], // handed in
  ["ik.half turn", (x) => x + Math.PI], // slip 13: atan for atan2
  ["ik.other axis", (x) => QUARTER - x], // slip 13: x/y for y/x
  ["ik.supplement", (x) => Math.PI - x], // slip 16: cos(pi - x)
  ["ik.offset", (x) => x + QUARTER], // the UR10e's offsets in theta
  ["ik.offset", (x) => x - QUARTER],
];
/** Mistakes in a slide. @type {[string, (x: number) => number][]} */
const SLIDE_MISTAKES = [
  ["ik.sign", (x) => -x],
  ["ik.joint millimetres", (x) => x / 1000], // handed in
];

/** @typedef {import("../geometry/arm.js").Arm} Arm */
/** @typedef {import("../geometry/arm.js").Row} Row */
/** @typedef {import("./ranking.js").Cause} Cause */
/**
 * A mistake in joint values, and the function that undoes it.
 * @typedef {[Cause, (q: number[]) => number[]]} JointMistake
 */

/** List usual mistakes in joint values. @param {Arm} arm @returns {JointMistake[]} */
export const listJointMistakes = (arm) => [
  ...listMistakesInOneJoint(arm),
  ...listMistakesInAllJoints(arm),
];

const changeJoint = (k, change) => (q) => q.map((x, i) => (i === k ? change(x) : x));

/** @param {Arm} arm @returns {Generator<JointMistake>} */
function* listMistakesInAllJoints(arm) {
  const isRevolute = revoluteFlags(arm);
  yield [makeCause("ik.degrees"), (q) => q.map((x, k) => (isRevolute[k] ? x * RAD : x))];
  // handed in: q6 ... q1
  if (isRevolute.length > 1) yield [makeCause("ik.reversed order"), (q) => [...q].reverse()];
  const signs = arm.makerSigns; // handed in
  if (signs) yield [makeMakersCause(arm), (q) => q.map((x, k) => signs[k] * x)];
}

/** Make the cause for joints that the maker counts in the opposite direction. @param {Arm} arm */
export function makeMakersCause(arm, key = "ik.makers signs") {
  const reversed = jointNames(arm).filter((_, k) => arm.makerSigns[k] < 0);
  return makeCause(key, { _joints: joinList(reversed.map((name) => name.slice(2))) });
}

/** @param {Arm} arm @returns {Generator<JointMistake>} */
function* listMistakesInOneJoint(arm) {
  const isRevolute = revoluteFlags(arm);
  const names = jointNames(arm);
  yield* listElbowFormulaMistakes(arm);
  // A wrong sign is tried before half a turn of a different joint, which may give the same position
  // and is rarer.
  for (const n of ANGLE_MISTAKES.keys())
    for (const [k, joint] of names.entries()) {
      const [key, undo] = (isRevolute[k] ? ANGLE_MISTAKES : SLIDE_MISTAKES)[n] ?? [];
      if (key) yield [makeCause(key, { joint }), changeJoint(k, undo)];
    }
  for (const [i, j] of combinations([...names.keys()], 2)) {
    const exchange = (q) => q.map((x, k) => (k === i ? q[j] : k === j ? q[i] : x)); // handed in
    yield [makeCause("ik.exchanged", { first: names[i], second: names[j] }), exchange];
  }
}

// theta_2 = atan2(s, r) + ... for minus, where two parallel axes carry two links: slip 12.
/** @param {{ rows: Row[] }} arm @returns {Generator<JointMistake>} */
function* listElbowFormulaMistakes({ rows }) {
  if (rows.length < 3) return;
  const [, second, third] = rows;
  const [ca, sa] = cosSin(second.alpha);
  if (Math.abs(sa) > 1e-9 || !second.a || !third.a) return;
  const elbowAngle = (q) => {
    const bend = ca * (q[2] + third.theta);
    return Math.atan2(third.a * Math.sin(bend), second.a + third.a * Math.cos(bend));
  };
  yield [
    makeCause("ik.plus for minus"),
    (q) => q.map((x, i) => (i === 1 ? x - 2 * elbowAngle(q) : x)),
  ];
}
