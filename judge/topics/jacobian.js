// Judges a Jacobian of the tip, whole or some of its rows.

import {
  listCopiedColumns,
  makeJacobian,
  listMistakePairs,
  listSingleMistakes,
  listJacobianSteps,
} from "../causes/jacobian.js";
import { causeName, joinCauseMessages } from "../causes/ranking.js";
import { agrees, RIGHT, SO_FAR, canBeDistinguished, WRONG } from "../digits.js";
import { judgeEntries } from "../entries.js";
import * as chains from "../geometry/chains.js";
import { fixedRows, jointNumbers, revoluteFlags } from "../geometry/kinematics.js";
import { isPlanar, movableLinearRows, movableRows } from "../geometry/task_rows.js";
import {
  lengthFactor,
  lookup,
  numbers,
  readConfiguration,
  refuseOtherLists,
} from "../reading/numbers.js";
import { nameLengthUnit } from "../reading/units.js";
import { completeVerdicts, makeVerdict } from "../verdict.js";
import { dropUnfilledEnd } from "../reading/unfilled.js";
import { askAboutDegrees } from "./degrees.js";
import { judgeWholeOrPart } from "./first_joints.js";
import { judgeFirstRows, PARTIAL_COUNTS } from "./jacobian_part.js";
import {
  ALL_ROWS,
  describeSelection,
  HALVES,
  listRowSelections,
  nameRows,
  pickRows,
  selectRows,
} from "./jacobian_rows.js";
import {
  ArmError,
  describeShape,
  formatMessage,
  joinList,
  tryOrNull,
  uncapitalize,
} from "../sentences.js";

/** @typedef {import("../geometry/arm.js").Arm} Arm */

const ANSWER_NAMES = /^(?:j|ans$)/i; // variables that may hold the answer

/**
 * Judge a Jacobian of an arm's tip at q.
 * @param {string | any[]} mine text or nested lists
 * @param {Arm} arm
 * @param {any} q joint values, a text or a list
 * @returns {import("../verdict.js").Verdict}
 */
export const compareJacobian = completeVerdicts(judgeJacobian);

function judgeJacobian(mine, arm, q, options = {}) {
  const typedQ = readConfiguration(q, arm, options.angles);
  return judgeWholeOrPart(
    mine,
    () => judgeWholeJacobian(mine, arm, q, typedQ, options),
    () => judgeFirstRowsInText(mine, arm, typedQ, options),
  );
}

// Judge a text with too few rows. Return null if they are not the right first rows.
function judgeFirstRowsInText(mine, arm, typedQ, options) {
  const known = lookup(arm, typedQ.values, options.values ?? []);
  const question = { ...options, arm, typedQ, frame: options.frame ?? 0 };
  for (const rows of PARTIAL_COUNTS) {
    const wants = [{ rows, columns: typedQ.values.length, by: "row" }];
    const typed = tryOrNull(() =>
      readMatrix(dropUnfilledEnd(mine), known, arm, { ...options, typedQ, wants }),
    );
    const verdict =
      typed && judgeFirstRows(typed, question, [...typed.taken, ...(typedQ.locked ?? [])]);
    if (verdict) return verdict;
  }
  return null;
}

function judgeWholeJacobian(mine, arm, q, typedQ, options) {
  const known = lookup(arm, typedQ.values, options.values ?? []);
  const typed = readMatrix(mine, known, arm, { ...options, typedQ });
  const question = { ...options, arm, typedQ, frame: options.frame ?? 0 };
  const first = judgeReadMatrix(typed, question, [...typed.taken, ...(typedQ.locked ?? [])]);
  const verdict = askAboutDegrees(first, {
    arm,
    values: typedQ.values,
    angles: options.angles,
    key: "J.degrees",
    judgeInDegrees: () => judgeJacobian(mine, arm, q, { ...options, angles: "deg" }),
    makeHeadline: (cause) => formatMessage("J wrong", { arm: arm.name, cause: `${cause}.` }),
  });
  return { ...verdict, typed };
}

function judgeReadMatrix(typed, question, taken) {
  const { arm, typedQ, angularFirst = false } = question;
  const [rows, width] = typed.shape;
  const isJudged = rows === 6 || listRowSelections(arm, rows).length > 0;
  if (width !== typedQ.values.length || !isJudged)
    return judgeFirstRows(typed, question, taken) ?? reportWrongShape(typed, question, taken);
  if (!typed.values.some(Boolean)) {
    const headline = formatMessage("J wrong", {
      arm: arm.name,
      cause: uncapitalize(formatMessage("J zero")),
    });
    const wrong = typed.values.map(() => true);
    return { ...makeJacobianVerdict(arm, WRONG, headline, { taken }), wrong };
  }
  if (!angularFirst || rows < 6 || typed.hasRowNames)
    return judgeSelectedRows(typed, question, taken);
  const verdict = judgeSelectedRows(exchangeTypedHalves(typed), question, [
    ...taken,
    formatMessage("taken: angular first"),
  ]);
  return { ...verdict, wrong: exchangeHalves(verdict.wrong) };
}

const makeJacobianVerdict = (arm, grade, headline, fields) =>
  makeVerdict("Jacobian", arm, grade, headline, fields);
const exchangeHalves = (list) => [
  ...list.slice(list.length / 2),
  ...list.slice(0, list.length / 2),
];
const exchangeTypedHalves = (typed) => ({
  ...typed,
  values: exchangeHalves(typed.values),
  units: exchangeHalves(typed.units),
});

/**
 * Read an answer as a matrix. All entries in a single row or column are read row by row.
 * @param {any} mine
 * @param {any} known values of symbols
 * @param {Arm} arm
 * @param {any} question `generic` if q is unknown, so that only formulas can be judged; `computed`
 *   if the entries are values of a function, which count as formulas; `wants` has the shapes that
 *   are read, if they are not the usual ones
 */
function readMatrix(mine, known, arm, question) {
  const { typedQ, which, generic = false, computed = false } = question;
  const [what, dof] = [`${arm.name}: your Jacobian`, typedQ.values.length];
  const wants = question.wants ?? [
    ...listShapes(dof, arm.rows.length),
    ...listReducedShapes(arm, dof),
  ];
  const request = { wants, names: ANSWER_NAMES, given: [typedQ.values], which };
  const read = convertToMetres(numbers(mine, what, known, undefined, request), arm);
  const symbolic = read.symbolic || computed;
  if (generic && !symbolic) throw new ArmError(formatMessage("J needs q"));
  const extraAxis = read.shape.length === 3 ? read.shape.indexOf(1) : -1;
  const shape = read.shape.filter((_, i) => i !== extraAxis);
  if (shape.length !== 2)
    throw new ArmError(formatMessage("no matrix", { what, given: describeShape(shape) }));
  const units = computed ? read.units.map(() => 0) : read.units;
  const count = read.values.length;
  const isFlat = count === 6 * dof && count === Math.max(...shape);
  return { ...read, units, symbolic, shape: isFlat ? [6, dof] : shape };
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

// Convert the linear rows to metres if the text states a different unit of lengths.
function convertToMetres(typed, arm) {
  const { shape, statedUnits } = typed;
  const count = countLinearRows(shape[0], arm) * shape[1];
  if (!statedUnits?.lengths || !count) return typed;
  const convert = (list) => list.map((x, i) => (i < count ? x * lengthFactor(typed, i) : x));
  const unit = nameLengthUnit(statedUnits.lengths);
  const taken = [...typed.taken, formatMessage("taken: linear rows", { unit })];
  return { ...typed, values: convert(typed.values), units: convert(typed.units), taken };
}

// Three rows with a unit of lengths are the linear half, but for a planar arm x, y and an angle.
const countLinearRows = (rows, arm) => ({ 6: 3, 3: isPlanar(arm) ? 2 : 3, 2: 2 })[rows] ?? 0;

// Report a wrong shape, with its cause if all entries are right.
function reportWrongShape(typed, { arm, typedQ, frame }, taken) {
  const { values, units, shape } = typed;
  const [rows, width] = shape;
  const columns = computeAllColumns(arm, typedQ.values, frame).sort(([i], [j]) => i - j);
  const dof = typedQ.values.length;
  const hasRows = (indices) => {
    const expected = indices.flatMap((row) => columns.map(([, column]) => column[row]));
    return expected.length === values.length && agrees({ values, units }, expected);
  };
  const hasLocked = columns.length > dof;
  let key = "J.shape";
  if (rows === dof && width === 6) key = "J.transposed";
  else if (hasRows(ALL_ROWS)) key = "J.locked column kept";
  else if (hasLocked && ALL_ROWS.some((row) => hasRows(listRowsWithout(row))))
    key = "J.row for column"; // slip 3 of the book
  if (key === "J.shape") refuseOtherLists(typed, `${arm.name}: your Jacobian`, `6x${dof}`);
  const words = formatMessage(key, { shape: `${rows}x${width}`, dof });
  const findings = [
    { what: "shape", where: "", mine: [rows, width], expected: [6, dof], words: `${words}.` },
  ];
  const headline = formatMessage("J wrong", { arm: arm.name, cause: `${uncapitalize(words)}.` });
  return makeJacobianVerdict(arm, WRONG, headline, { findings, causes: [key], taken });
}

const listRowsWithout = (row) => ALL_ROWS.filter((i) => i !== row);

/** @returns {import("../verdict.js").Verdict} */
function judgeSelectedRows(typed, request, takenBefore) {
  const { arm, typedQ, frame } = request;
  const selection = selectRows(typed, arm, makeJacobian(arm, frame)(typedQ.values));
  const { judged, notes } = judgeSelectedEntries(typed, request, selection);
  const rowNames = nameRows(selection);
  const taken = [...takenBefore, ...describeSelection(selection, arm)];
  const shared = { taken, wrong: judged.wrong, rowNames };
  if (judged.grade !== WRONG) {
    const verdict = reportRight(judged, typed, arm, selection.half);
    return { ...verdict, ...shared, notes: [...verdict.notes, ...notes] };
  }
  const columns = computeAllColumns(arm, typedQ.values, frame).map(([number, J]) => [
    number,
    pickRows(J, selection),
  ]);
  const findWrongColumns = () => listWrongColumns(typed, columns, judged.wrong, arm, rowNames);
  const causes = judged.mistakes.map(({ cause }) => cause);
  return { ...reportWrong(causes, findWrongColumns, arm), ...shared };
}

// Judge the entries of the selected rows. A right Jacobian of numbers gets a note on the mistakes
// that would not change it.
/** @param {import("./jacobian_rows.js").RowSelection} selection */
function judgeSelectedEntries(typed, request, selection) {
  const { arm, typedQ, frame, tolerance = null, isGradeOnly } = request;
  const steps = listJacobianSteps(arm, typedQ.values, frame);
  const makeWhole = makeJacobian(arm, frame);
  const restrict = (mistake) => ({
    ...mistake,
    make: (q) => pickRows(mistake.make(q), selection),
  });
  const makeExpected = (q) => pickRows(makeWhole(q), selection);
  const mistakes = listSingleMistakes(arm, frame, steps).map(restrict);
  const furtherLists = [listCopiedColumns, listMistakePairs].map(
    (list) => () => Array.from(list(arm, frame, steps), restrict),
  );
  const dof = typedQ.values.length;
  const question = { typed, q: typedQ, dof, makeExpected, mistakes, furtherLists };
  const judged = judgeEntries({ ...question, tolerance, isGradeOnly });
  const mayHide = !typed.symbolic && selection.rows.length === 6;
  const expected = makeExpected(typedQ.values);
  const notes = mayHide ? noteHiddenMistakes(steps, mistakes, typedQ.values, expected) : [];
  return { judged, notes };
}

// Note how many mistakes in the recipe give the same Jacobian at this configuration.
function noteHiddenMistakes(steps, mistakes, q, expected) {
  const recipe = mistakes.filter((_, k) => !steps[k].change && !("i" in steps[k].cause.fields[0]));
  const zeros = expected.map(() => 0);
  const visible = recipe.filter(({ make }) =>
    canBeDistinguished({ units: zeros }, expected, make(q)),
  );
  const count = recipe.length - visible.length;
  return count ? [formatMessage("J hidden", { count, all: recipe.length })] : [];
}

// Report a Jacobian that is right, rounded or right so far. `half` is 0 or 1 if only the linear or
// the angular half was typed, else null.
function reportRight({ grade, agreement, wrong }, typed, arm, half) {
  const where = typed.symbolic ? "" : formatMessage("at this configuration");
  const precision = typed.units.some(Boolean) ? formatMessage("to your digits") : "";
  const [typedHalf, other] = half ? ["angular", "linear"] : HALVES;
  const keys = { [RIGHT]: half === null ? "J right" : "J half right", [SO_FAR]: "J so far" };
  const width = typed.shape[1];
  const roundedColumns = jointNumbers(arm).flatMap((_, k) =>
    chains.selectColumn(wrong, k, width).includes(true)
      ? [formatMessage("column", { column: k + 1 })]
      : [],
  );
  const places = joinList(roundedColumns);
  const fields = { arm: arm.name, where, precision, half: typedHalf, other, places };
  const headline = formatMessage(keys[grade] ?? "J rounded", fields);
  const words = formatMessage("J half missing", { other });
  const missing = { what: "missing", where: `${other} rows`, words };
  return makeJacobianVerdict(arm, half !== null && grade === RIGHT ? SO_FAR : grade, headline, {
    findings: half === null ? [] : [missing],
    notes: agreement === "cut" ? [formatMessage("cut")] : [],
  });
}

function reportWrong(causes, findWrongColumns, arm) {
  if (causes.length) {
    const words = joinCauseMessages(causes);
    const findings = [{ what: "cause", where: "", words: `${words}.` }];
    const headline = formatMessage("J wrong", { arm: arm.name, cause: `${uncapitalize(words)}.` });
    return makeJacobianVerdict(arm, WRONG, headline, { findings, causes: causes.map(causeName) });
  }
  const findings = findWrongColumns();
  const numbers = jointNumbers(arm);
  if (findings.length === numbers.length) {
    const key = revoluteFlags(arm)[0] ? "J turns" : "J slides";
    const question = formatMessage(key, { joint: numbers[0] });
    const headline = formatMessage("J wrong everywhere", { arm: arm.name, question });
    return makeJacobianVerdict(arm, WRONG, headline, { findings });
  }
  const [first] = findings;
  const places = joinList(findings.map(({ where }) => where));
  const headline =
    findings.length === 1
      ? formatMessage("J wrong", { arm: arm.name, cause: uncapitalize(first.words) })
      : formatMessage("J wrong places", { arm: arm.name, places });
  return makeJacobianVerdict(arm, WRONG, headline, { findings });
}

// Describe each wrong column. It may be the column of a different joint, or wrong in some rows.
function listWrongColumns({ values, units, shape }, columns, wrong, arm, rowNames) {
  const width = shape[1];
  return jointNumbers(arm).flatMap((joint, k) => {
    const [isWrong, typedValues, typedUnits] = [wrong, values, units].map((list) =>
      chains.selectColumn(list, k, width),
    );
    if (!isWrong.includes(true)) return [];
    const fits = (entries) => agrees({ values: typedValues, units: typedUnits }, entries);
    const [, expected] = columns.find(([number]) => number === joint);
    const others = columns.filter(([number, entries]) => number !== joint && fits(entries));
    const rows = joinList(rowNames.filter((_, i) => isWrong[i]));
    const negative = expected.map((x, i) => (isWrong[i] ? -x : x));
    const description =
      others.length === 1
        ? formatMessage("J.other column", { joint: others[0][0] })
        : formatMessage(fits(negative) ? "J.entry signs" : "J.entries", { rows });
    const words = formatMessage("J column", { column: k + 1, joint, words: description });
    return [{ what: "column", where: `column ${k + 1}`, words }];
  });
}

// Return the number and the column of each joint in the chosen frame. Locked joints come last, with
// the columns that they would have if they could turn.
/** @returns {[number, number[]][]} */
function computeAllColumns(arm, q, frame) {
  const chain = chains.makeChain(arm, q);
  const T = chains.chainFrames(chain);
  const locked = fixedRows(arm);
  const unlocked = { ...chain, at: locked, turns: locked.map(() => true), dof: locked.length };
  return [chain, unlocked].flatMap((c) => {
    const J = chains.flatJacobian(c, T);
    const rotated = frame ? chains.rotateIntoFrame(J, T[frame]) : J;
    return c.at.map((i, k) => [i + 1, chains.selectColumn(rotated, k, c.dof)]);
  });
}
