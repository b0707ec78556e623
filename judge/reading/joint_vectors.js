// Reads the joint vectors of an answer, each in a row or a column, as values in rad and m.

import { RAD } from "../geometry/angles.js";
import { transpose } from "../geometry/chains.js";
import { movingRows, revoluteFlags } from "../geometry/kinematics.js";
import { splitIntoRows } from "../geometry/linear.js";
import { ArmError, formatMessage, quoteText } from "../sentences.js";
import {
  JOINT_NAMES,
  eachJoint,
  hasLockedColumns,
  inRadians,
  jointShapes,
  notPerJoint,
  numbers,
  refuseMisfitUnits,
  noteLockedValues,
} from "./numbers.js";
import { orderByGivenNames } from "./ordering.js";
import { nameLengthUnit } from "./units.js";

/** @typedef {import("../geometry/arm.js").Arm} Arm */

/**
 * A joint vector. `units` has the unit of the last typed decimal place of each value, 0.001 for
 * 0.523.
 * @typedef {{ values: number[], units: number[] }} JointVector
 */

/**
 * Read joint vectors. If the vectors also have values for locked joints, these values are left out.
 * @param {any} mine the answer: a text or nested lists @param {Arm} arm
 * @param {string} angles the unit of angles, "deg" or "rad"
 * @param {any} options `byColumns` reads the columns of a square matrix instead of its rows. The
 *   other options are those of `numbers`.
 * @returns {{ answers: JointVector[], taken: string[], typed: import("./numbers.js").Typed }}
 *   `taken` has messages on how the text was read
 */
export function readJointVectors(mine, arm, angles, { byColumns = false, ...options } = {}) {
  const moving = movingRows(arm);
  const dof = moving.length;
  const what = `${arm.name}: your answer`;
  refuseTwoUnits(mine);
  const wants = { wants: jointShapes(arm), names: JOINT_NAMES, ...options };
  const typed = numbers(orderByGivenNames(mine), what, undefined, eachJoint(arm), wants);
  if (!typed.values.length) return { answers: [], taken: [], typed };
  const shape = findMatrixShape(typed, dof);
  const hasLocked =
    !shape.includes(dof) || hasLockedColumns(splitIntoRows(typed.values, shape[1]), arm);
  const width = hasLocked ? arm.rows.length : dof;
  const areColumns = shape[0] === width && (byColumns || shape[1] !== width);
  if (shape.length !== 2 || shape[areColumns ? 0 : 1] !== width)
    throw notPerJoint(what, arm, typed.shape);
  const toRows = (list) => (areColumns ? transpose(list, shape) : list);
  const dropLocked = (list) =>
    toRows(list).filter((_, i) => width === dof || moving.includes(i % width));
  const [values, units, entries] = [typed.values, typed.units, typed.entries].map(dropLocked);
  refuseMisfitUnits(entries, arm, what, false);
  refuseMixedUnits({ ...typed, entries }, arm, what);
  const flat = inRadians({ ...typed, values, units, entries }, arm, angles);
  const [valueRows, unitRows] = [splitIntoRows(flat.values, dof), splitIntoRows(flat.units, dof)];
  const locked = width > dof ? [noteLockedValues(arm, toRows(typed.values))] : [];
  const notes = [
    ...describeUnits(typed, angles, arm),
    ...noteColumns(areColumns, valueRows),
    ...locked,
  ];
  const vectors = valueRows.map((row, i) => ({ values: row, units: unitRows[i] }));
  return { answers: vectors, taken: [...typed.taken, ...notes], typed };
}

/**
 * Describe the units that a text states for several numbers, as "q (deg)" does. The unit of angles
 * is left out if the question asks for it.
 * @param {import("./numbers.js").Typed} typed @param {string} angles @param {Arm} arm
 */
export const describeUnits = ({ statedUnits }, angles, arm) => [
  ...(statedUnits?.angles && statedUnits.angles !== angles
    ? [formatMessage(statedUnits.angles === "deg" ? "taken: degrees" : "taken: radians")]
    : []),
  ...(statedUnits?.lengths && revoluteFlags(arm).includes(false)
    ? [formatMessage("taken: lengths", { unit: nameLengthUnit(statedUnits.lengths) })]
    : []),
];

// Refuse an angle without a unit beside angles in degrees, unless it is 0 or a multiple of pi.
/** @param {Pick<import("./numbers.js").Typed, "entries" | "statedUnits">} typed @param {Arm} arm */
function refuseMixedUnits({ entries, statedUnits }, arm, what) {
  if (statedUnits?.angles) return;
  const turning = revoluteFlags(arm);
  const angles = entries.filter((_, i) => turning[i % turning.length]);
  const bare = angles.find(({ text, angle, unitBehind }) => !angle && !unitBehind && Number(text));
  if (bare && angles.some(({ worth }) => worth === RAD))
    throw new ArmError(formatMessage("mixed units", { what, text: quoteText(bare.text) }));
}

const noteColumns = (areColumns, { length }) =>
  areColumns && length > 1 ? [formatMessage("taken: answer per column")] : [];

// Return the numbers of rows and columns. A plain or nested list is a single row. A single column
// with the values of several configurations, configuration after configuration, has a row for each
// configuration.
function findMatrixShape({ shape, values }, dof) {
  if (shape[1] === 1 && shape[0] % dof === 0) return [shape[0] / dof, dof];
  const flat = shape.length > 2 ? shape.filter((n) => n !== 1) : shape;
  return flat.length < 2 ? [1, values.length] : flat;
}

// Refuse a text with several lines "rad: ..." and several lines "deg: ...". The reader knows only a
// single unit for all numbers.
/** @param {any} mine */
function refuseTwoUnits(mine) {
  if (typeof mine !== "string") return;
  const [radians, degrees] = [/^\s*rad(?:ians?)?\s*[:=]/i, /^\s*deg(?:rees?)?\s*[:=]/i].map(
    (label) => mine.split("\n").filter((line) => label.test(line)),
  );
  if (radians.length < 2 || degrees.length < 2) return;
  const line = quoteText(degrees[0].trim());
  throw new ArmError(formatMessage("rows in two units", { line }));
}
