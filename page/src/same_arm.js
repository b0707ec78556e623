// Whether two tables describe the same arm: what no choice of frames can change (axes.js) is the
// same in both. Yes or no is all that the explorer asks; the judge says what differs.

import { arc, side } from "../../judge/geometry/axes.js";
import { NORMAL } from "../../judge/geometry/walk.js";
import { joints } from "../../judge/geometry/kinematics.js";

const WITHIN_LENGTH = 1e-6; // m
const WITHIN_ANGLE = 1e-4; // rad

/** @typedef {import("../../judge/geometry/arm.js").Arm} Arm */

/** @param {Arm} mine @param {Arm} reference */
export function sameArm(mine, reference) {
  const kinds = (arm) =>
    joints(arm)
      .map((row) => arm.rows[row].kind)
      .join();
  if (!joints(mine).length || kinds(mine) !== kinds(reference)) return false;
  const [ours, theirs] = [mine, reference].map(({ rows }) => side(rows.map(squared)));
  if (!near(ours.foot[0], theirs.foot[0]) || !near(ours.foot[1], theirs.foot[1], WITHIN_ANGLE))
    return false;
  // Each joint of the reference may point either way; the signs of neighbours must fit in every
  // gap.
  let signs = [[]];
  ours.gaps.forEach((gap, i) => {
    for (const k of gap.joints)
      signs = signs.flatMap((s) =>
        s[k] ? [s] : [1, -1].map((x) => Object.assign([...s], { [k]: x })),
      );
    signs = signs.filter((s) => agree(gap, theirs.gaps[i], s));
  });
  return signs.length > 0;
}

const near = (x, y, within = WITHIN_LENGTH) => Math.abs(x - y) <= within;

// Angles near a multiple of a right angle are meant as that.
const squared = (row) => ({ ...row, alpha: square(row.alpha), theta: square(row.theta) });

function square(angle) {
  const right = (Math.round(angle / (Math.PI / 2)) * Math.PI) / 2;
  return Math.abs(angle - right) < WITHIN_ANGLE ? right : angle;
}

function agree(mine, wanted, signs) {
  if (!near(mine.length, wanted.length)) return false;
  for (const [key, value] of mine.shape) {
    if (!wanted.shape.has(key)) continue;
    const which = key.split(",").map(Number);
    const turned = which.reduce((x, k) => x * (k === NORMAL ? 1 : signs[k]), wanted.shape.get(key));
    const [x, y] = which.length === 2 ? [arc(value), arc(turned)] : [value, turned];
    if (!near(x, y, WITHIN_ANGLE)) return false;
  }
  if (mine.fromBase || mine.offset === null || wanted.offset === null)
    return (mine.offset === null) === (wanted.offset === null);
  return near(mine.offset, signs[mine.joints[0]] * wanted.offset);
}
