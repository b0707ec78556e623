// Selects the rows of a Jacobian that were typed, and names them.

import { norm } from "../geometry/kinematics.js";
import { subtractEach } from "../geometry/linear.js";
import { isPlanar, movableLinearRows, movableRows, pick } from "../geometry/task_rows.js";
import { formatMessage, joinList } from "../sentences.js";

export const ROWS = ["vx", "vy", "vz", "wx", "wy", "wz"];
export const ALL_ROWS = [0, 1, 2, 3, 4, 5];
export const HALVES = ["linear", "angular"];
const PLANE_NAMES = ["x", "y", "z", "φ", "φ", "φ"]; // of a planar arm's rows

/**
 * Some rows of a Jacobian, by their indices. `half` is 0 or 1 if they are its linear or angular
 * half and the other half is missing. It is null if they are all rows that the arm can move.
 * @typedef {{ rows: number[], half: number | null }} RowSelection
 */

/** Pick the selected rows of a whole Jacobian. */
export const pickRows = (J, { rows }) =>
  rows.flatMap((i) => J.slice((i * J.length) / 6, ((i + 1) * J.length) / 6));

/**
 * List the selections with so many rows. Those of a planar arm come first.
 * @returns {RowSelection[]}
 */
export function listRowSelections(arm, count) {
  const [movable, linear] = [movableRows(arm), movableLinearRows(arm)];
  const reduced = [movable, ...(linear.length < 3 ? [linear] : [])];
  const halves = [ALL_ROWS.slice(0, 3), ALL_ROWS.slice(3)];
  const selections = [
    ...(movable.length < 6 ? reduced.map((rows) => ({ rows, half: null })) : []),
    ...halves.map((rows, half) => ({ rows, half })),
  ];
  return selections.filter(({ rows }) => rows.length === count);
}

/**
 * Select the rows that were typed. Of the selections that fit, this is the nearest to the right
 * entries. A half of a planar arm's rows has rows of zeros, so it is read only if zeros were typed.
 * @returns {RowSelection}
 */
export function selectRows({ values, shape }, arm, expected) {
  if (shape[0] === 6) return { rows: ALL_ROWS, half: null };
  const selections = listRowSelections(arm, shape[0]);
  const [first] = selections;
  if (first.half === null && values.every(Boolean)) return first;
  const measureDistance = (selection) => norm(subtractEach(pickRows(expected, selection), values));
  return selections.reduce((best, selection) =>
    measureDistance(selection) < measureDistance(best) ? selection : best,
  );
}

/** Name the selected rows. @param {RowSelection} selection */
export const nameRows = ({ rows, half }) =>
  pick(half === null && rows.length < 6 ? PLANE_NAMES : ROWS, rows);

/** Describe how the rows were read. @param {RowSelection} selection @param {any} arm */
export function describeSelection({ rows, half }, arm) {
  if (half !== null) return [formatMessage("taken: half", { half: HALVES[half] })];
  if (rows.length === 6) return [];
  const names = joinList(pick(PLANE_NAMES, rows));
  return [formatMessage(isPlanar(arm) ? "taken: planar rows" : "taken: movable rows", { names })];
}
