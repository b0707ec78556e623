// Arranges the typed numbers of a trajectory with a row for each step.

import { RAD } from "../geometry/angles.js";
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
 * Arrange typed numbers with a row for each step. Columns are transposed, a leading column of times
 * or zeros and one extra step are dropped, and the verdict reports each change.
 * @param {import("../reading/numbers.js").Typed} typed
 * @param {import("../geometry/arm.js").Arm} arm
 * @param {number} count of the steps, with the start
 * @param {string} unit of the typed angles, "rad" or "deg"
 * @returns {Trajectory | null} null if the shape is wrong
 */
export function arrangeBySteps(typed, arm, count, unit) {
  const dof = movingRows(arm).length;
  const shape = typed.shape.filter((n) => n !== 1);
  if (shape.length !== 2) return null;
  const taken = [...typed.taken];
  const counts = [count - 1, count, count + 1];
  let [rows, units] = [typed.values, typed.units].map((list) =>
    splitIntoRows(convertToNamedUnits(list, typed, unit), shape[1]),
  );
  const isPerJoint =
    shape[1] !== dof && [dof, dof + 1].includes(shape[0]) && counts.includes(shape[1]);
  if (isPerJoint) {
    [rows, units] = [rows, units].map((list) => list[0].map((_, k) => list.map((row) => row[k])));
    taken.push(formatMessage("taken: list per joint"));
  }
  if (hasLockedColumns(rows, arm)) {
    taken.push(noteLockedValues(arm, rows.flat()));
    [rows, units] = [rows, units].map((list) => list.map((row) => pick(row, movingRows(arm))));
  }
  const first = rows.map(([x]) => x);
  const isTime = first.every((x) => !x) || first.slice(1).every((x, k) => x - first[k] > 0);
  if (rows[0].length === dof + 1 && isTime) {
    [rows, units] = [rows, units].map((list) => list.map((row) => row.slice(1)));
    taken.push(formatMessage("taken: times"));
  }
  if (rows[0].length !== dof || !counts.includes(rows.length) || rows.length < 2) return null;
  const typedRows = rows.slice(0, count).map((values, k) => ({ values, units: units[k] }));
  taken.push(...describeUnits(typed, unit, arm));
  const hasExtraStep = rows.length === count + 1;
  return {
    ...convertToSI(typedRows, arm, typed.statedUnits, unit),
    taken,
    hasExtraStep,
    isPerJoint,
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
export function convertToSI(typedRows, arm, statedUnits, unit) {
  const [angular, linear] = [unit === "deg" ? RAD : 1, statedUnits?.lengths ?? 1];
  const factors = revoluteFlags(arm).map((turns) => (turns ? angular : linear));
  const convert = (list) => list.map((x, i) => x * factors[i]);
  const q = typedRows.map(({ values }) => convert(values));
  return { q, units: typedRows.map(({ units }) => convert(units)), unit };
}
