// Reads a Jacobian as a matrix, and evaluates its formulas at several configurations.

import { RIGHT, ROUNDED, SO_FAR, WRONG } from "../digits.js";
import { listGeneralConfigurations } from "../geometry/general_configurations.js";
import { revoluteFlags } from "../geometry/kinematics.js";
import { isPlanar, movableLinearRows, movableRows } from "../geometry/task_rows.js";
import { formulaSlack, symbols, value } from "../reading/formula.js";
import { lengthFactor, lookup, numbers, unitsOf } from "../reading/numbers.js";
import { LENGTH_UNITS, nameLengthUnit } from "../reading/units.js";
import { ArmError, describeShape, formatMessage } from "../sentences.js";

/** @typedef {import("../geometry/arm.js").Arm} Arm */

const ANSWER_NAMES = /^(?:j|ans$)/i; // variables that may hold the answer

/**
 * Read an answer as a matrix. All entries in a single row or column are read row by row.
 * @param {any} mine
 * @param {any} known values of symbols
 * @param {Arm} arm
 * @param {any} question `generic` if q is unknown, so that only formulas can be judged; `computed`
 *   if the entries are values of a function, which count as formulas; `wants` has the shapes that
 *   are read, if they are not the usual ones; `lengths` is the unit of the linear rows, for a text
 *   that states none
 */
export function readMatrix(mine, known, arm, question) {
  const { typedQ, which, stated, lengths, generic = false, computed = false } = question;
  const [what, dof] = [`${arm.name}: your Jacobian`, typedQ.values.length];
  const wants = question.wants ?? [
    ...listShapes(dof, arm.rows.length),
    ...listReducedShapes(arm, dof),
  ];
  const request = { wants, names: ANSWER_NAMES, given: [typedQ.values], which, stated };
  const typed = numbers(mine, what, known, undefined, request);
  const read = convertToMetres(lengths ? setLengthUnit(typed, LENGTH_UNITS[lengths]) : typed, arm);
  const isEverywhere = read.hasJoints || (generic && computed);
  if (generic && !isEverywhere) throw new ArmError(formatMessage("J needs q"));
  const extraAxis = read.shape.length === 3 ? read.shape.indexOf(1) : -1;
  const shape = read.shape.filter((_, i) => i !== extraAxis);
  if (shape.length !== 2)
    throw new ArmError(formatMessage("no matrix", { what, given: describeShape(shape) }));
  const units = computed ? read.units.map(() => 0) : read.units;
  const count = read.values.length;
  const isFlat = count === 6 * dof && count === Math.max(...shape);
  return { ...read, units, isEverywhere, shape: isFlat ? [6, dof] : shape };
}

// List the shapes that are judged. The whole Jacobian and its halves come first, then the shapes of
// known mistakes, then all entries in a single row.
const listShapes = (dof, all) => [
  { rows: 6, columns: dof, by: "row" },
  { rows: 3, columns: dof, by: "row" },
  { rows: dof, columns: 6 },
  ...[all, dof - 1].map((columns) => ({ rows: 6, columns, by: "row" })),
  { rows: 5, columns: all },
  { rows: 1, columns: 6 * dof },
  { rows: 6 * dof, columns: 1 },
];

// List the shapes without the rows that are always 0, such as 2x2 or 3x3 for a planar arm.
function listReducedShapes(arm, columns) {
  const counts = [movableRows(arm).length, movableLinearRows(arm).length];
  return counts.flatMap((rows) => (rows > 1 && rows < 6 ? [{ rows, columns, by: "row" }] : []));
}

// Set the unit of lengths, unless the text states one.
function setLengthUnit(typed, factor) {
  const { angles = null, lengths, moments = null } = typed.statedUnits ?? {};
  const stated = lengths ?? (factor === 1 ? null : factor);
  return { ...typed, statedUnits: { angles, lengths: stated, moments } };
}

// Convert the linear rows to metres if the text states a different unit of lengths. The column of a
// joint that slides is a length per length, which has no unit.
function convertToMetres(typed, arm) {
  const { shape, statedUnits } = typed;
  const width = shape[1];
  const count = countLinearRows(shape[0], arm) * width;
  if (!statedUnits?.lengths || !count) return typed;
  const turns = revoluteFlags(arm);
  const hasLength = (i) => i < count && (width > turns.length || turns[i % width]);
  const convert = (list) => list.map((x, i) => (hasLength(i) ? x * lengthFactor(typed, i) : x));
  const unit = nameLengthUnit(statedUnits.lengths);
  const taken = [...typed.taken, formatMessage("taken: linear rows", { unit })];
  return { ...typed, values: convert(typed.values), units: convert(typed.units), taken };
}

// Three rows with a unit of lengths are the linear half, but for a planar arm x, y and an angle.
const countLinearRows = (rows, arm) => ({ 6: 3, 3: isPlanar(arm) ? 2 : 3, 2: 2 })[rows] ?? 0;

/**
 * Evaluate an answer with other values of its symbols.
 * @param {any} typed @param {(names: Set<string>) => Map<string, number>} known
 * @returns {import("../digits.js").Entries}
 */
export function evaluateWith({ formulas, entries }, known) {
  const names = new Set();
  for (const tree of formulas) symbols(tree, names);
  const meanings = known(names);
  const findValue = (name) => meanings.get(name);
  const evaluated = entries.map((entry, i) => ({
    ...entry,
    slack: formulaSlack(formulas[i], findValue) / entry.worth,
  }));
  return { values: formulas.map((tree) => value(tree, findValue)), units: unitsOf(evaluated) };
}

/** Return entries without a last typed place. @param {number[]} values */
export const makeExactEntries = (values) => ({ values, units: values.map(() => 0) });

/**
 * Judge an answer at q, or at five general configurations if a joint value occurs in it. It is
 * wrong if it is wrong at one of them, and right if it is right at one and wrong at none.
 * @template {{ grade: string }} T
 * @param {any} typed @param {any} question
 * @param {(question: any) => T} judge
 */
export function judgeAtConfigurations(typed, question, judge) {
  if (!typed.hasJoints) return judge({ ...question, typed });
  const { arm, values = [], isGradeOnly } = question;
  const questions = listGeneralConfigurations(arm).map((q) => {
    const entries = evaluateWith(typed, lookup(arm, q, values));
    const { values: converted, units } = convertToMetres({ ...typed, ...entries }, arm);
    const at = { ...typed, values: converted, units };
    return { ...question, typed: at, typedQ: makeExactEntries(q) };
  });
  const verdicts = questions.map((one) => judge({ ...one, isGradeOnly: true }));
  const grade = [WRONG, ROUNDED, RIGHT, SO_FAR].find((x) => verdicts.some((v) => v.grade === x));
  const index = verdicts.findIndex((verdict) => verdict.grade === grade);
  if (grade !== WRONG || isGradeOnly) return verdicts[index];
  return judge({ ...questions[index], others: questions.filter((_, k) => k !== index) });
}
