// Finds the only wrong row of a typed trajectory, and the joint whose value is wrong there.

import { METHOD_TILT } from "../causes/trace.js";
import {
  jointNumbers,
  linkFrames,
  minus,
  movingRows,
  norm,
  revoluteFlags,
  rotationBetween,
} from "../geometry/kinematics.js";
import { listConfigurationsWithOneChange } from "../geometry/one_joint.js";
import { describeMiss } from "../matching.js";
import { formatMessage, formatNumber } from "../sentences.js";
import { boundTipError } from "./trace_units.js";

/** @typedef {import("../geometry/arm.js").Arm} Arm */
/** @typedef {import("../geometry/kinematics.js").Frame} Frame */
/** @typedef {import("../geometry/path.js").Path} Path */
/**
 * The only wrong row of a trajectory.
 * @typedef {object} WrongRow
 * @property {number} row its index
 * @property {number} distance of its tip from the path (m)
 * @property {number} angle between its tool and the tool of all other rows (rad)
 * @property {{ index: number, value: number } | null} correction the only joint whose change alone
 *   puts the row right, by its index from 0, and the value that does (rad or m)
 */

const FEWEST_RIGHT = 3; // rows; fewer could lie on the path by chance
const AS_NEAR = 3; // a row three times as far from its neighbours is on a different branch

/**
 * Find the only row whose tip is off the path, or whose tool is turned. Null if no or several rows
 * are wrong.
 * @param {{ q: number[][], units: number[][] }} trajectory @param {Arm} arm @param {Path} path
 * @param {Frame[]} frames of the tip in each row
 * @param {number[]} allowed largest error of the tip in each row (m)
 * @returns {WrongRow | null}
 */
export function findOnlyWrongRow({ q, units }, arm, path, frames, allowed) {
  if (q.length <= FEWEST_RIGHT) return null;
  const keepsTool = movingRows(arm).length >= 6; // its tool keeps its orientation
  const points = path.times.map(path.position);
  const distances = frames.map(({ o }, k) => norm(minus(o, points[k])));
  // The tool of the first row is right, unless the first row is the wrong row.
  for (const reference of [frames[0], frames[1]]) {
    const angles = frames.map((frame) => (keepsTool ? rotationBetween(reference, frame) : 0));
    const wrongRows = frames.flatMap((_, k) =>
      distances[k] > allowed[k] || angles[k] > METHOD_TILT ? [k] : [],
    );
    const [row] = wrongRows;
    if (wrongRows.length !== 1 || frames[row] === reference) continue;
    const isOther = (_, k) => k !== row;
    const goal = {
      point: points[row],
      tool: keepsTool ? reference : null,
      distance: Math.max(...distances.filter(isOther)) + boundTipError(q[row], units[row], arm),
      angle: Math.max(...angles.filter(isOther)) + units[row].reduce((sum, unit) => sum + unit, 0),
    };
    return {
      row,
      distance: distances[row],
      angle: angles[row],
      correction: findRowCorrection(q, row, arm, goal),
    };
  }
  return null;
}

// Find the only joint of a row whose change takes the tip to a goal, or return null.
/** @returns {WrongRow["correction"]} */
function findRowCorrection(q, row, arm, goal) {
  const corrections = listConfigurationsWithOneChange(arm, q[row], goal)
    .map((configuration, index) => ({ index, configuration }))
    .filter(({ configuration }) => reachesGoal(linkFrames(arm, configuration).at(-1), goal));
  const nearest = selectNearest(corrections, q[row - 1] ?? q[row + 1], q[row + 1] ?? q[row - 1]);
  if (nearest.length !== 1) return null;
  const [{ index, configuration }] = nearest;
  return { index, value: configuration[index] };
}

const reachesGoal = (tip, { point, tool, distance, angle }) =>
  norm(minus(tip.o, point)) <= distance && (!tool || rotationBetween(tool, tip) <= angle);

// Select the corrections that leave the row nearest to its neighbours. A correction that leads
// farther away is on a different branch.
function selectNearest(corrections, before, after) {
  const distances = corrections.map(({ configuration }) =>
    norm(configuration.map((x, i) => x - (before[i] + after[i]) / 2)),
  );
  const nearest = Math.min(...distances);
  return corrections.filter((_, k) => distances[k] <= AS_NEAR * nearest);
}

/**
 * Describe the only wrong row, with the joint that is off if only one joint can be.
 * @param {WrongRow} wrongRow @param {number[]} typed joint values of the row @param {Arm} arm
 * @returns {string}
 */
export function describeWrongRow({ row: step, distance, angle, correction }, typed, arm) {
  if (!correction) return formatMessage("trace row", { step, miss: describeMiss(distance, angle) });
  const { index, value } = correction;
  const joint = jointNumbers(arm)[index];
  const off = formatNumber(Math.abs(value - typed[index]), 2);
  const unit = revoluteFlags(arm)[index] ? "rad" : "m";
  return formatMessage("trace number", { step, joint, off, unit });
}
