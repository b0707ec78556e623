// Lists the wrong entries that each usual mistake gives, and finds the wrong entry of a DH table.
// The course marks with the same lists, so that marks and messages agree.

import { listTableMistakes } from "./causes/chain.js";
import { listConfigurationMistakes } from "./causes/joints.js";
import { listJacobianSteps, makeJacobianMaker } from "./causes/jacobian.js";
import { causeMessage, causeName, listSingleMistakes, makeCause } from "./causes/ranking.js";
import { makeEntryCause } from "./causes/table.js";
import { listTorqueSteps, makeLoad, makeTorqueMaker } from "./causes/torques.js";
import { RIGHT, RIGHT_BY_MAP, ROUNDED, SO_FAR } from "./digits.js";
import { compareAxes, describeAxes } from "./geometry/axes.js";
import { chainFrames, makeChain, transpose } from "./geometry/chains.js";
import {
  GRAVITY,
  linkFrames,
  minus,
  movingRows,
  norm,
  rotationBetween,
} from "./geometry/kinematics.js";
import { isAngleColumn, jointColumn, snapRows } from "./geometry/rows.js";
import { lookup, numbers } from "./reading/numbers.js";
import { ENTRIES } from "./reading/table_rows.js";
import { compareTables } from "./topics/table.js";

/** @typedef {import("./geometry/arm.js").Arm} Arm */
/** @typedef {import("./causes/ranking.js").Cause} Cause */
/** @typedef {import("./causes/ranking.js").Mistake} Mistake */

const LENGTH_STEP = 0.05; // m: the lengths of the course's random tables are multiples of it
const LONGEST = 0.7; // m: the lengths of such a table add up to less on parallel axes
const SAME_LENGTH = 1e-3; // m: a sheet asks for three decimals
const SAME_NUMBER = 1e-9; // m
const SAME_ANGLE = 0.02; // rad: a right angle was typed with two decimals

// The function that lists the mistakes of each kind of question.
const MISTAKES_BY_KIND = {
  tip: ({ arm }) => listTipMistakes(arm),
  jacobian: ({ arm, q }) =>
    listSingleMistakes(listJacobianSteps(arm, q, 0), makeJacobianMaker(arm, 0)),
  torques({ arm, q, wrench }) {
    const load = makeLoad(arm, [wrench], GRAVITY);
    const maker = makeTorqueMaker(load, movingRows(arm).length, q);
    return listSingleMistakes(listTorqueSteps(arm, load), maker);
  },
};

/**
 * List the usual mistakes in a question, each with its message and the answer that it gives.
 * @param {{ kind: "tip" | "jacobian" | "torques", arm: Arm, q: number[], wrench?: number[],
 *   configurations?: number[][] }} question `configurations` takes the place of q if there are
 *   several joint vectors
 */
export function listMistakes({ kind, configurations, ...question }) {
  const q = question.q ?? configurations?.[0];
  const mistakes = MISTAKES_BY_KIND[kind](/** @type {any} */ ({ ...question, q }));
  return Array.from(mistakes, ({ cause, make }) => ({
    name: causeName(cause),
    message: causeMessage(cause),
    values: configurations
      ? configurations.flatMap((configuration) => make(configuration))
      : make(question.q),
  }));
}

// List the mistakes in the tip's pose, which is the position and then the rotation row by row.
/** @param {Arm} arm @returns {Generator<Mistake>} */
function* listTipMistakes(arm) {
  const makeTip = (change) => (q) => {
    const { x, y, z, o } = chainFrames(change(makeChain(arm, q))).at(-1);
    return [...o, ...[0, 1, 2].flatMap((i) => [x[i], y[i], z[i]])];
  };
  for (const { cause, change } of [
    ...listConfigurationMistakes("J.degrees", arm),
    ...listTableMistakes(arm),
  ])
    yield { cause, make: makeTip(change) };
  const makeRight = makeTip((chain) => chain);
  const makeInMillimetres = (q) => makeRight(q).map((x, i) => (i < 3 ? 1000 * x : x));
  yield { cause: makeCause("course.tip millimetres"), make: makeInMillimetres };
  const makeTransposed = (q) => {
    const values = makeRight(q);
    return [...values.slice(0, 3), ...transpose(values.slice(3), [3, 3])];
  };
  yield { cause: makeCause("course.tip transposed"), make: makeTransposed };
}

/**
 * Evaluate six formulas at several configurations.
 * @param {{ mine: any, arm: Arm, configurations: number[][] }} question
 * @returns {number[]} six values for each configuration
 */
export const evaluateFormulas = ({ mine, arm, configurations }) =>
  configurations.flatMap((q) => {
    const wants = [
      { rows: 6, columns: 1 },
      { rows: 1, columns: 6 },
    ];
    return numbers(mine, "your formulas", lookup(arm, q), "six formulas", { wants }).values;
  });

/**
 * Compare a table with an arm at the configuration q = 0, and name its mistake if it has only one.
 * @param {{ mine: any, arm: Arm, options: any }} question
 * @returns {{ right: boolean, name: string, message: string, headline: string, rows: any[],
 *   share?: number }} `rows` as they were read; `share` of the joints is right if the rows of the
 *   last ones are missing
 */
export function findTableMistake({ mine, arm, options }) {
  const verdict = compareTables(mine, arm, options);
  const { grade, headline, figures } = verdict;
  const rows = verdict.table?.rows ?? [];
  const isSame = makeComparison(arm);
  const answer = { right: false, name: "", message: "", headline, rows };
  if ([RIGHT, ROUNDED, RIGHT_BY_MAP].includes(grade) && isSame(rows))
    return { ...answer, right: true };
  if (grade === SO_FAR)
    return { ...answer, message: headline, share: figures?.right / figures?.of };
  const cause = rows.length ? findWrongEntry(rows, arm, isSame) : null;
  if (cause) return { ...answer, name: causeName(cause), message: causeMessage(cause) };
  return { ...answer, ...nameWholeMistake(verdict) };
}

/**
 * Name the mistake that explains a whole table, such as the wrong convention, or its only wrong
 * entry. There is none if two mistakes are needed, or if findings remain.
 * @param {import("./verdict.js").Verdict} verdict
 */
function nameWholeMistake({ findings, causes }) {
  const [first] = findings;
  const entry = /^row (\d+), (\w+)$/.exec(first?.where ?? "");
  if (findings.length === 1 && first.what === "entry" && entry)
    return { name: `course.entry:${entry[2]}:${entry[1]}`, message: first.words };
  const [name] = causes;
  const isWhole = name && !name.includes("+") && findings.every(({ what }) => what === "cause");
  return isWhole && findings.length ? { name, message: findings[0].words } : {};
}

/**
 * Return a function that compares rows with an arm. Rows may have any choice of frames, but the tip
 * must be right at q = 0.
 * @param {Arm} arm @returns {(rows: any[]) => boolean}
 */
function makeComparison(arm) {
  const expected = snapRows(arm.rows);
  const axes = describeAxes(expected);
  const home = movingRows(arm).map(() => 0);
  const tip = linkFrames({ ...arm, rows: expected }, home).at(-1);
  return (rows) => {
    const snapped = snapRows(rows);
    if (compareAxes(describeAxes(snapped), axes, SAME_LENGTH).differences.length) return false;
    const actual = linkFrames({ ...arm, rows: snapped }, home).at(-1);
    const distance = norm(minus(actual.o, tip.o));
    return distance <= SAME_LENGTH && rotationBetween(actual, tip) <= SAME_ANGLE;
  };
}

/**
 * Find an entry whose correction makes the table describe the arm, and name the mistake in it.
 * @param {any[]} rows @param {Arm} arm @param {(rows: any[]) => boolean} isSame
 * @returns {Cause | null}
 */
function findWrongEntry(rows, arm, isSame) {
  const kinds = rows.map(({ kind }) => kind).join();
  if (kinds !== arm.rows.map(({ kind }) => kind).join()) return null;
  for (const [k, row] of rows.entries())
    for (const column of ENTRIES)
      for (const value of isAngleColumn(column) ? QUARTER_TURNS : listLengths(row[column])) {
        if (value === row[column]) continue;
        const corrected = rows.map((other, i) => (i === k ? { ...row, [column]: value } : other));
        if (isSame(corrected)) return nameEntryMistake(column, k + 1, row, value);
      }
  return null;
}

const QUARTER_TURNS = [0, Math.PI / 2, -Math.PI / 2, Math.PI];

/** List the lengths that may be right in place of a typed length. @param {number} typed m */
function listLengths(typed) {
  const count = 2 * Math.round(LONGEST / LENGTH_STEP) + 1;
  const multiples = Array.from({ length: count }, (_, i) => LENGTH_STEP * (i - (count - 1) / 2));
  return [-typed, ...multiples, ...multiples.map((x) => typed + x)];
}

// Name the mistake in an entry of a typed row, whose right value is `expected`.
/** @param {string} column @param {number} row @param {any} typed @param {number} expected */
function nameEntryMistake(column, row, typed, expected) {
  const actual = typed[column];
  const entry = makeCause("course.entry", { column, row });
  if (column === "theta") return actual ? entry : makeCause("table.offset", { row });
  if (column === jointColumn(typed.kind) && actual) return entry;
  return makeEntryCause(column, row, actual, expected, SAME_NUMBER) ?? entry;
}
