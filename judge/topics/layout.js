// Arranges typed torques or joint values with a row for each configuration.

import { RAD } from "../geometry/angles.js";
import { transpose } from "../geometry/chains.js";
import { movingRows, revoluteFlags } from "../geometry/kinematics.js";
import { pick } from "../geometry/task_rows.js";
import { splitIntoRows } from "../geometry/linear.js";
import { describeUnits } from "../reading/joint_vectors.js";
import { hasLockedColumns, noteLockedValues } from "../reading/numbers.js";
import { formatMessage } from "../sentences.js";

/**
 * A typed joint trajectory with a row for each step.
 * @typedef {object} Trajectory
 * @property {number[][]} q joint values (rad or m)
 * @property {number[][]} units of the last typed digits
 * @property {string} unit of the typed angles, "rad" or "deg"
 * @property {string[]} taken
 * @property {boolean} hasExtraStep whether it has one step too many
 * @property {boolean} isPerJoint whether it was typed as a list for each joint
 */

/**
 * Arrange typed numbers with a row for each configuration. Lists for each joint are transposed, and
 * values of locked joints dropped. `taken` reports both.
 * @param {{ values: number[], units: number[], shape: number[], taken: string[] }} typed
 * @param {import("../geometry/arm.js").Arm} arm
 * @param {number[]} counts of the rows that are possible
 * @param {boolean} [isTrace] whether a column of times may stand before the joints. The values of a
 *   locked joint are then constant.
 * @returns null if the shape is wrong; `isPerJoint` if a list for each joint was typed
 */
export function arrangeByRows({ values, units, shape, taken }, arm, counts, isTrace = false) {
  const moving = movingRows(arm);
  const [dof, all] = [moving.length, arm.rows.length];
  const omitOnes = (sizes) => sizes.filter((n) => n !== 1).join();
  const hasShape = (...sizes) => omitOnes(sizes) === omitOnes(shape);
  for (const width of [dof, all, ...(isTrace ? [dof + 1] : [])])
    for (const count of counts) {
      const isPerJoint = !hasShape(count, width);
      if (isPerJoint && !hasShape(width, count)) continue;
      const order = (list) => (isPerJoint ? transpose(list, [width, count]) : list);
      const [rows, rowUnits] = [values, units].map((list) => splitIntoRows(order(list), width));
      const isLocked = isTrace ? hasLockedColumns(rows, arm) : width > dof;
      const select = (list) => (isLocked ? list.map((row) => pick(row, moving)) : list);
      const notes = [
        ...(isPerJoint ? [formatMessage("taken: list per joint")] : []),
        ...(isLocked ? [noteLockedValues(arm, rows.flat())] : []),
      ];
      return {
        rows: select(rows),
        units: select(rowUnits),
        taken: [...taken, ...notes],
        isPerJoint,
      };
    }
  return null;
}

/**
 * Arrange a trajectory with a row for each step. A leading column of times or zeros and one extra
 * step are dropped, and the verdict reports each change.
 * @param {import("../reading/numbers.js").Typed} typed
 * @param {import("../geometry/arm.js").Arm} arm
 * @param {number} count of the steps, with the start
 * @param {string} unit of the typed angles, "rad" or "deg"
 * @returns {Trajectory | null} null if the shape is wrong
 */
export function arrangeBySteps(typed, arm, count, unit) {
  const dof = movingRows(arm).length;
  const [values, lastUnits] = [typed.values, typed.units].map((list) =>
    convertToNamedUnits(list, typed, unit),
  );
  const numbers = { ...typed, values, units: lastUnits };
  const arranged = arrangeByRows(numbers, arm, [count - 1, count, count + 1], true);
  if (!arranged || arranged.rows.length < 2) return null;
  let { rows, units, taken } = arranged;
  const first = rows.map(([x]) => x);
  const isTime = first.every((x) => !x) || first.slice(1).every((x, k) => x - first[k] > 0);
  if (rows[0].length === dof + 1 && isTime) {
    [rows, units] = [rows, units].map((list) => list.map((row) => row.slice(1)));
    taken = [...taken, formatMessage("taken: times")];
  }
  if (rows[0].length !== dof) return null;
  const typedRows = rows.slice(0, count).map((row, k) => ({ values: row, units: units[k] }));
  return {
    ...convertToSI(typedRows, arm, typed.statedUnits, unit),
    taken: [...taken, ...describeUnits(typed, unit, arm)],
    hasExtraStep: rows.length === count + 1,
    isPerJoint: arranged.isPerJoint,
  };
}

// Write all values in the units that the text states for them. Values that were typed with a unit
// are in SI.
/** @param {number[]} list @param {import("../reading/numbers.js").Typed} typed */
function convertToNamedUnits(list, { entries, statedUnits }, unit) {
  const findFactor = (/** @type {any} */ { angle, hasUnit }) => {
    if (angle) return unit === "deg" ? RAD : 1;
    return hasUnit ? (statedUnits?.lengths ?? 1) : 1;
  };
  return list.map((x, i) => x / findFactor(entries[i]));
}

/** Convert rows of joint values to rad and m. */
function convertToSI(typedRows, arm, statedUnits, unit) {
  const [angular, linear] = [unit === "deg" ? RAD : 1, statedUnits?.lengths ?? 1];
  const factors = revoluteFlags(arm).map((turns) => (turns ? angular : linear));
  const convert = (list) => list.map((x, i) => x * factors[i]);
  const q = typedRows.map(({ values }) => convert(values));
  return { q, units: typedRows.map(({ units }) => convert(units)), unit };
}
