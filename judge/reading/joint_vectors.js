// Joint vectors as they are typed: one for each row or each column, with the units of their digits.

import { transpose } from "../geometry/chains.js";
import { movingRows, revoluteFlags } from "../geometry/kinematics.js";
import { formatMessage } from "../sentences.js";
import {
  JOINT_NAMES,
  eachJoint,
  inRadians,
  jointShapes,
  notPerJoint,
  numbers,
  rowsOf,
  noteLockedValues,
  unnamed,
} from "./numbers.js";
import { LENGTH_UNITS } from "./units.js";

/** @typedef {import("../geometry/arm.js").Arm} Arm */

/**
 * A joint vector with the units of its last places.
 * @typedef {{ values: number[], units: number[] }} Answer
 */

/**
 * Joint vectors with their units, however they were held, and how they were read; a square is read
 * by rows unless told. Where each row of a locked arm has a value, those of its locked joints are
 * set aside.
 * @param {any} mine @param {Arm} arm @param {string} angles @param {any} asked
 * @returns {{ answers: Answer[], taken: string[], typed: import("./numbers.js").Typed }}
 */
export function answers(mine, arm, angles, { byColumns = false, ...asked } = {}) {
  const moving = movingRows(arm);
  const dof = moving.length;
  const what = `${arm.name}: your answer`;
  const wants = { wants: jointShapes(arm), names: JOINT_NAMES, ...asked };
  const typed = numbers(unnamed(mine), what, undefined, eachJoint(arm), wants);
  if (!typed.values.length) return { answers: [], taken: [], typed };
  const shape = shapeOf(typed, dof);
  const width = !shape.includes(dof) && shape.includes(arm.rows.length) ? arm.rows.length : dof;
  const lies = shape[0] === width && (byColumns || shape[1] !== width);
  if (shape.length !== 2 || shape[lies ? 0 : 1] !== width)
    throw notPerJoint(what, arm, typed.shape);
  const upright = (list) => (lies ? transpose(list, shape) : list);
  const kept = (list) =>
    upright(list).filter((_, i) => width === dof || moving.includes(i % width));
  const [values, units, entries] = [typed.values, typed.units, typed.entries].map(kept);
  const flat = inRadians({ ...typed, values, units, entries }, arm, angles);
  const [each, places] = [rowsOf(flat.values, dof), rowsOf(flat.units, dof)];
  const locked = width > dof ? [noteLockedValues(arm, upright(typed.values))] : [];
  const notes = [...describeUnits(typed, angles, arm), ...perColumn(lies, each), ...locked];
  const taken = [...typed.taken, ...notes];
  return { answers: each.map((one, i) => ({ values: one, units: places[i] })), taken, typed };
}

/**
 * Describe the units that a text names: of angles if it is not the question's, of slides.
 * @param {import("./numbers.js").Typed} typed @param {string} angles @param {Arm} arm
 */
export const describeUnits = ({ statedUnits }, angles, arm) => [
  ...(statedUnits?.angles && statedUnits.angles !== angles
    ? [formatMessage(statedUnits.angles === "deg" ? "taken: degrees" : "taken: radians")]
    : []),
  ...(statedUnits?.lengths && revoluteFlags(arm).includes(false)
    ? [formatMessage("taken: lengths", { unit: LENGTH_UNITS[statedUnits.lengths] })]
    : []),
];

const perColumn = (lies, { length }) =>
  lies && length > 1 ? [formatMessage("taken: answer per column")] : [];

// Rows and columns: a list is one row, and a single one however deep it lies.
function shapeOf({ shape, values }, dof) {
  if (shape[1] === 1 && shape[0] > dof && shape[0] % dof === 0) return [shape[0] / dof, dof];
  const flat = shape.length > 2 ? shape.filter((n) => n !== 1) : shape;
  return flat.length < 2 ? [1, values.length] : flat;
}
