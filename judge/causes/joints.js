// Lists mistakes in joint values. Joint values that were asked for may hold a mistake, which
// `correct` undoes; with joint values that were given, `change` makes it. The comment behind each
// names where the mistake was seen, which is a slip of homework.md by its number, or work that was
// handed in.

import { cosSin, jointNames, movingRows, revoluteFlags } from "../geometry/kinematics.js";
import { DEG, RAD } from "../geometry/angles.js";
import { combinations } from "../geometry/axis_gaps.js";
import { joinList } from "../sentences.js";
import { makeCause } from "./ranking.js";

const QUARTER = Math.PI / 2;
/**
 * Mistakes in a single joint, the commonest first: the key, the function that undoes the mistake,
 * and the one that makes it if it is also made with given joint values.
 * @typedef {[string, (x: number) => number, ((x: number) => number)?]} ValueMistake
 */
/** @type {ValueMistake[]} */
const ANGLE_MISTAKES = [
  ["ik.sign", (x) => -x, (x) => -x], // slip 22: one sign of acos
  ["ik.joint degrees", (x) => x * RAD, (x) => x * DEG], // handed in
  ["ik.half turn", (x) => x + Math.PI], // slip 13: atan for atan2
  ["ik.other axis", (x) => QUARTER - x], // slip 13: x/y for y/x
  ["ik.supplement", (x) => Math.PI - x], // slip 16: cos(pi - x)
  ["ik.offset", (x) => x + QUARTER], // the UR10e's offsets in theta
  ["ik.offset", (x) => x - QUARTER],
];
/** @type {ValueMistake[]} */
const SLIDE_MISTAKES = [
  ["ik.sign", (x) => -x, (x) => -x],
  ["ik.joint millimetres", (x) => x / 1000, (x) => x * 1000], // handed in
];

/** @typedef {import("../geometry/arm.js").Arm} Arm */
/** @typedef {import("../geometry/arm.js").Row} Row */
/** @typedef {import("./ranking.js").Cause} Cause */
/** @typedef {import("./chain.js").ChainMistake} ChainMistake */
/**
 * A mistake in joint values that were asked for, and the function that undoes it.
 * @typedef {{ cause: Cause, correct: (q: number[]) => number[] }} JointMistake
 */

/** List mistakes in joint values that were asked for. @param {Arm} arm @returns {JointMistake[]} */
export const listJointMistakes = (arm) => [
  ...listMistakesInOneJoint(arm),
  ...listMistakesInAllJoints(arm),
];

const changeJoint = (k, change) => (q) => q.map((x, i) => (i === k ? change(x) : x));

/** @param {Arm} arm @returns {Generator<JointMistake>} */
function* listMistakesInAllJoints(arm) {
  const isRevolute = revoluteFlags(arm);
  const toRadians = (q) => q.map((x, k) => (isRevolute[k] ? x * RAD : x));
  yield { cause: makeCause("ik.degrees"), correct: toRadians };
  const reverse = (q) => [...q].reverse(); // handed in: q6 ... q1
  if (isRevolute.length > 1) yield { cause: makeCause("ik.reversed order"), correct: reverse };
  const signs = arm.makerSigns; // handed in
  if (signs) yield { cause: makeMakersCause(arm), correct: (q) => q.map((x, k) => signs[k] * x) };
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
      if (key) yield { cause: makeCause(key, { joint }), correct: changeJoint(k, undo) };
    }
  for (const [i, j] of combinations([...names.keys()], 2)) {
    const exchange = (q) => q.map((x, k) => (k === i ? q[j] : k === j ? q[i] : x)); // handed in
    const cause = makeCause("ik.exchanged", { first: names[i], second: names[j] });
    yield { cause, correct: exchange };
  }
}

// Slip 12: theta_2 = atan2(s, r) + ... in place of minus, on an arm whose parallel axes carry two
// links.
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
  const correct = (q) => q.map((x, i) => (i === 1 ? x - 2 * elbowAngle(q) : x));
  yield { cause: makeCause("ik.plus for minus"), correct };
}

/**
 * List mistakes in joint values that were given. All joints may be in degrees for radians or the
 * reverse, or have the maker's signs. A single joint may have the wrong sign, or be in degrees or
 * in millimetres. All were handed in.
 * @param {string} degreesKey of the message on degrees
 * @param {Arm} arm
 * @returns {Generator<ChainMistake>}
 */
export function* listConfigurationMistakes(degreesKey, arm) {
  const isRevolute = revoluteFlags(arm);
  const makeMistake = (cause, change) => ({ cause, change: (c) => ({ ...c, q: c.q.map(change) }) });
  for (const factor of [RAD, DEG])
    yield makeMistake(makeCause(degreesKey), (x, k) => (isRevolute[k] ? x * factor : x));
  const isSummed = listParallelJoints(arm);
  // handed in: s_2 for s_12
  if (isSummed.includes(true))
    yield makeMistake(makeCause("J.not summed"), (x, k, q) => (isSummed[k] ? x - q[k - 1] : x));
  const signs = arm.makerSigns;
  if (signs) yield makeMistake(makeMakersCause(arm), (x, k) => signs[k] * x);
  for (const [k, joint] of jointNames(arm).entries())
    for (const [key, , make] of isRevolute[k] ? ANGLE_MISTAKES : SLIDE_MISTAKES)
      if (make) yield makeMistake(makeCause(key, { joint }), (x, i) => (i === k ? make(x) : x));
}

// Return for each joint whether it turns about an axis parallel to that of the joint before it.
function listParallelJoints(arm) {
  const rows = movingRows(arm);
  const isRevolute = revoluteFlags(arm);
  const isStraight = (k) => rows[k] === rows[k - 1] + 1 && !arm.rows[rows[k - 1]].alpha;
  return rows.map((_, k) => k > 0 && isRevolute[k] && isRevolute[k - 1] && isStraight(k));
}
