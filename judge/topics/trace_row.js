// Finds the only wrong row of a typed trajectory, and the joint whose value is wrong there.

import { makeCause } from "../causes/ranking.js";
import { METHOD_TILT } from "../causes/trace.js";
import { combinations } from "../geometry/axis_gaps.js";
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
import { formatNumber, joinList } from "../sentences.js";
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
 * @property {{ index: number, value: number }[]} corrections joints whose change alone puts the row
 *   right, by their index from 0, and the value that does (rad or m)
 * @property {[number, number] | null} exchanged indices of two joints whose exchange does
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
      ...findRowCorrections(q, row, arm, goal),
    };
  }
  return null;
}

// Find the joints of a row whose change, or whose exchange, takes the tip to a goal.
/** @returns {Pick<WrongRow, "corrections" | "exchanged">} */
function findRowCorrections(q, row, arm, goal) {
  const typed = q[row];
  const isRight = (configuration) => reachesGoal(linkFrames(arm, configuration).at(-1), goal);
  const corrections = listConfigurationsWithOneChange(arm, typed, goal)
    .map((configuration, index) => ({ index, configuration }))
    .filter(({ configuration }) => isRight(configuration));
  const nearest = selectNearest(corrections, q[row - 1] ?? q[row + 1], q[row + 1] ?? q[row - 1]);
  return {
    corrections: nearest.map(({ index, configuration }) => ({
      index,
      value: configuration[index],
    })),
    exchanged: findExchangedJoints(typed, isRight),
  };
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

// Return the indices of two joints whose exchange makes a row right, or null.
function findExchangedJoints(typed, isRight) {
  const pairs = combinations([...typed.keys()], 2);
  const exchange = ([i, j]) => typed.map((x, k) => (k === i ? typed[j] : k === j ? typed[i] : x));
  return pairs.find((pair) => isRight(exchange(pair))) ?? null;
}

/**
 * Make the cause for the only wrong row. It names the joint that is off, or two joints that are
 * exchanged. If each of several joints could be off, it names them all.
 * @param {WrongRow} wrongRow @param {number[]} typed joint values of the row @param {Arm} arm
 * @returns {import("../causes/ranking.js").Cause}
 */
export function makeRowCause({ row, distance, angle, corrections, exchanged }, typed, arm) {
  const numbers = jointNumbers(arm);
  if (corrections.length > 1) {
    const joints = corrections.map(({ index }) => String(numbers[index]));
    return makeCause("trace.row joints", { step: row, _joints: joinList(joints, "or") });
  }
  if (corrections.length) {
    const [{ index, value }] = corrections;
    const _off = formatNumber(Math.abs(value - typed[index]), 2);
    const _unit = revoluteFlags(arm)[index] ? "rad" : "m";
    return makeCause("trace.number", { step: row, joint: numbers[index], _off, _unit });
  }
  if (!exchanged)
    return makeCause("trace.row", { step: row, _miss: describeMiss(distance, angle) });
  const [first, second] = exchanged.map((i) => numbers[i]);
  return makeCause("trace.row exchanged", { step: row, first, second });
}
