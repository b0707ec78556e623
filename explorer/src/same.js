// Whether two tables describe the same arm: what no choice of frames can change (axes.js) is the same in both.

import { compared, side } from "./axes.js";
import { joints } from "./kinematics.js";

const WITHIN_ANGLE = 1e-4; // rad

/** @typedef {import("./arm.js").Arm} Arm */

/** @param {Arm} mine @param {Arm} reference */
export function sameArm(mine, reference) {
  const [ours, theirs] = [squared(mine.rows), squared(reference.rows)];
  if (!joints(mine).length || !joints(reference).length) return false;
  return !compared(side(ours), side(theirs)).differences.length;
}

// Angles near a multiple of a right angle are meant as that.
const squared = (rows) => rows.map((row) => ({ ...row, alpha: square(row.alpha), theta: square(row.theta) }));

function square(angle) {
  const right = (Math.round(angle / (Math.PI / 2)) * Math.PI) / 2;
  return Math.abs(angle - right) < WITHIN_ANGLE ? right : angle;
}
