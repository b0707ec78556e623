// What slips make of right joint angles, undone: the cause, and the angles that would have come out
// without it.

import { cosSin } from "../geometry/kinematics.js";
import { RAD } from "../geometry/angles.js";
import { numbered, turning } from "../reading/numbers.js";
import { both, cause } from "./ranking.js";

const QUARTER = Math.PI / 2;
/** @type {[string, (x: number) => number][]} */
const JOINT = [
  ["ik.sign", (x) => -x],
  ["ik.half turn", (x) => x + Math.PI],
  ["ik.other axis", (x) => Math.PI / 2 - x],
  ["ik.supplement", (x) => Math.PI - x],
  ["ik.offset", (x) => x + Math.PI / 2],
  ["ik.offset", (x) => x - Math.PI / 2],
];

const SCALES = { "ik.slide in millimetres": 1e-3, "ik.slide in centimetres": 1e-2 };

/** @typedef {import("./ranking.js").Cause} Cause */
/** @typedef {[Cause, number[]]} Slip */

export const variable = (arm) => numbered(arm).map((i) => `q_${i}`);
const changed = (q, k, x) => q.map((value, i) => (i === k ? x : value));

// Every choice of so many of n things, in order.
export function* choices(n, count, from = 0) {
  if (!count) yield [];
  else
    for (let k = from; k < n; k++)
      for (const rest of choices(n, count - 1, k + 1)) yield [k, ...rest];
}

/** Slips in all joints at once. @returns {Generator<Slip>} */
export function* whole(arm, q) {
  const turns = turning(arm);
  const names = variable(arm);
  const radians = (x) => x * RAD;
  const eachOf = (turn, slide) => q.map((x, k) => (turns[k] ? turn(x) : slide(x)));
  const same = (x) => x;
  yield [cause("ik.degrees"), eachOf(radians, same)];
  yield [cause("ik.all signs"), q.map((x) => -x)];
  if (turns.includes(false)) {
    yield [cause("ik.slide in millimetres"), eachOf(same, (x) => x / 1000)];
    yield [cause("ik.slide in centimetres"), eachOf(same, (x) => x / 100)];
    const twice = both(cause("ik.degrees"), cause("ik.slide in millimetres"));
    yield [twice, eachOf(radians, (x) => x / 1000)];
  }
  if (q.length > 1) yield [cause("ik.reversed order"), [...q].reverse()];
  for (const which of choices(q.length, 3)) {
    const joints = which.map((k) => names[k]).join(", ");
    yield [cause("ik.signs", { joints }), q.map((x, k) => (which.includes(k) ? -x : x))];
  }
}

// Whether a slip only scales joints, so that near zero it cannot be told.
/** @param {Cause} one */
export const scales = ({ keys }) => keys.some((key) => key in SCALES || key === "ik.degrees");

// What such a slip's units are worth, by joint.
/** @param {Cause} one */
export function scale({ keys }, arm) {
  const slide = SCALES[keys.find((key) => key in SCALES)] ?? 1;
  const turn = keys.includes("ik.degrees") ? RAD : 1;
  return turning(arm).map((turns) => (turns ? turn : slide));
}

/** Slips in one joint, or in one step of a closed form. @returns {Generator<Slip>} */
export function* single(arm, q) {
  const turns = turning(arm);
  const names = variable(arm);
  yield* elbowFormula(arm, q);
  for (let k = 0; k < q.length; k++) {
    for (const [key, change] of JOINT) {
      if (turns[k] || key === "ik.sign")
        yield [cause(key, { joint: names[k] }), changed(q, k, change(q[k]))];
    }
  }
}

/**
 * theta_1 = +-pi/2 kept from the singular case of an offset shoulder.
 * @returns {Generator<Slip>}
 */
export function* kept(q, branches) {
  if (Math.abs(Math.abs(q[0]) - QUARTER) >= 1e-4) return;
  for (const branch of branches) yield [cause("ik.quarter turn"), changed(q, 0, branch[0])];
}

// theta_2 = atan2(s, r) + ... for minus, where two parallel axes carry two links.
/** @returns {Generator<Slip>} */
function* elbowFormula({ rows }, q) {
  if (q.length < 3 || rows.length < 3) return;
  const [, second, third] = rows;
  const [ca, sa] = cosSin(second.alpha);
  if (Math.abs(sa) > 1e-9 || !second.a || !third.a) return;
  const bend = ca * (q[2] + third.theta);
  const lean = Math.atan2(third.a * Math.sin(bend), second.a + third.a * Math.cos(bend));
  yield [cause("ik.plus for minus"), changed(q, 1, q[1] - 2 * lean)];
}

/**
 * Slips in two joints, of those pairs of them that are worth a try.
 * @param {(i: number, j: number) => boolean} worth
 * @returns {Generator<Slip>}
 */
export function* double(arm, q, worth = () => true) {
  const turns = turning(arm);
  const names = variable(arm);
  for (const [i, j] of choices(q.length, 2)) {
    if (!turns[i] || !turns[j] || !worth(i, j)) continue;
    for (const [key, change] of JOINT) {
      for (const [other, then] of JOINT) {
        const mended = changed(changed(q, i, change(q[i])), j, then(q[j]));
        yield [both(cause(key, { joint: names[i] }), cause(other, { joint: names[j] })), mended];
      }
    }
  }
}
