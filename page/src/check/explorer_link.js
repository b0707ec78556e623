// Makes links to the explorer: the configuration of a question, and a mistake beside the right arm.

import { estimateReach, jointRange } from "../../../judge/geometry/arm.js";
import { listGeneralConfigurations } from "../../../judge/geometry/general_configurations.js";
import {
  jacobianColumns,
  linkFrames,
  minus,
  movingRows,
  norm,
  rotationBetween,
} from "../../../judge/geometry/kinematics.js";
import { splitIntoRows } from "../../../judge/geometry/linear.js";
import { lookup, numbers } from "../../../judge/reading/numbers.js";
import { readSymbolValues } from "../../../judge/reading/values.js";
import { evaluateWith } from "../../../judge/topics/jacobian_matrix.js";
import { formatNumbers, formatRows } from "../fragment.js";
import { DEFAULT_RUN, formatRun, parseRun } from "../homework_run.js";
import { OWN_ARM } from "./question.js";

/** @typedef {import("../../../judge/geometry/arm.js").Arm} Arm */
/** @typedef {import("../../../judge/geometry/arm.js").TableRow} TableRow */
/** @typedef {import("./question.js").Question} Question */
/** @typedef {import("./question.js").Outcome} Outcome */
/** @typedef {import("./question.js").ListedArm} ListedArm */

const VALUES_TRIED = 12; // of each joint, within its limits
const SWEEPS = 2; // over all joints
const TURN_SHARE = 0.01; // 1 rad of turn counts as 1 % of the arm's reach
// Mistakes that the explorer can make in a run, by the judge's names.
const RUN_MISTAKES = {
  "J.z_i angular": "angular",
  "J.origin late": "o_i",
  "trace.next velocity": "next",
  "trace.other side": "sign",
};
const WALL_NORMALS = { zy: "x", xz: "y" }; // of the explorer's circles, which have one sense each
const SEEN = 1e-3; // difference that can be seen: a share of the reach, or an entry of a Jacobian

/**
 * Return the fragment that shows the question's configuration; "" if the explorer has no such arm.
 * @param {Question} question
 * @param {Outcome} outcome
 * @param {ListedArm[]} arms
 */
export function makeConfigurationLink(question, { q }, arms) {
  const arm = findExplorerArm(question, arms);
  if (!arm || !q) return "";
  const view = question.ask === "torques" ? "torque" : "jacobian";
  return formatLink(arm, { q: formatNumbers(unlockJoints(arm, q)), view });
}

/**
 * Return the fragment that shows the mistake of a verdict; "" if it cannot be shown there.
 * @param {Question} question
 * @param {Outcome} outcome
 * @param {ListedArm[]} arms
 */
export function makeMistakeLink(question, { verdict, q }, arms) {
  const arm = findExplorerArm(question, arms);
  if (!arm || verdict?.grade !== "wrong") return "";
  if (question.ask === "table") return makeTableLink(arm, verdict.table?.rows ?? []);
  if (!q) return "";
  if (question.ask === "trace") return makeRunLink(arm, question, verdict, q);
  if (!verdict.typed) return "";
  if (question.ask === "jacobian") return makeJacobianLink(arm, question, verdict.typed, q);
  return question.ask === "torques" ? makeTorqueLink(arm, question, verdict.typed, q) : "";
}

// Show the columns of a typed Jacobian beside the right ones: numbers at the question's
// configuration, formulas at the general one where they differ most.
function makeJacobianLink(arm, question, typed, q) {
  const { frame, first, lengths } = question;
  if (Number(frame) || typed.shape.join() !== `6,${q.length}`) return "";
  const isFormula = typed.hasJoints && !lengths && !typed.statedUnits?.lengths;
  const knownAt = (at) => lookup(arm, at, readSymbolValues(question.values));
  const shown = (isFormula ? listGeneralConfigurations(arm) : [q])
    .map((at) => {
      const { values } = isFormula ? evaluateWith(typed, knownAt(at)) : typed;
      return compareWithRight(arm, first, values, at);
    })
    .reduce((most, one) => (one.size > most.size ? one : most));
  return shown.size < SEEN ? "" : formatLink(arm, { view: "jacobian", ...shown.fields });
}

// Return the fields of the link, and how far a typed entry is off at most. A locked joint gets its
// right column.
function compareWithRight(arm, first, values, at) {
  const typedRows = splitIntoRows(values, at.length);
  if (first === "omega") typedRows.push(...typedRows.splice(0, 3));
  const q = unlockJoints(arm, at);
  const unlocked = { ...arm, rows: unlockRow(arm, arm.rows) };
  const columns = jacobianColumns(unlocked, linkFrames(unlocked, q));
  const lockedIndex = arm.locked ? movingRows(unlocked).indexOf(arm.locked - 1) : -1;
  const rows = typedRows.map((row, i) => {
    if (lockedIndex >= 0) row.splice(lockedIndex, 0, columns[lockedIndex][i]);
    return row;
  });
  const gaps = rows.flatMap((row, i) => row.map((x, k) => Math.abs(x - columns[k][i])));
  const fields = { q: formatNumbers(q), answer: formatNumbers(rows.flat()) };
  return { size: Math.max(...gaps), fields };
}

// Show typed torques beside the right ones.
function makeTorqueLink(arm, { wrench }, { values }, q) {
  if (values.length !== q.length || arm.locked) return "";
  const { values: load } = wrench.trim() ? numbers(wrench, "the wrench") : { values: [] };
  return formatLink(arm, {
    q: formatNumbers(q),
    view: "torque",
    ...(load.length ? { wrench: formatNumbers(load) } : {}),
    answer: formatNumbers(values),
  });
}

/**
 * Show the right run and one with the verdict's mistake, their errors magnified.
 * @param {ListedArm} arm
 * @param {Question} question
 * @param {import("../../../judge/topics/frame.js").Verdict} verdict
 * @param {number[]} start
 */
function makeRunLink(arm, { plane, radius, period, pace }, { causes, figures }, start) {
  const mistake = causes.map((name) => RUN_MISTAKES[name]).find(Boolean);
  const isHomework = start.length >= 6 && pace === "even"; // of the explorer's kind
  if (!mistake || !isHomework) return "";
  const right = formatRun({
    ...DEFAULT_RUN,
    rates: "pseudo", // the inverse, wherever there is one
    cutoff: 1e-3, // as in the book
    steps: figures?.q.length - 1,
    seconds: Number(period),
    radius: Number(radius),
    normal: WALL_NORMALS[plane],
    locked: arm.locked ? arm.locked - 1 : -1,
  });
  if (!parseRun(right)) return "";
  return formatLink(arm, {
    q: formatNumbers(unlockJoints(arm, start)),
    view: "homework",
    runs: `${right};${right}${mistake}`,
  });
}

// Show the typed table beside the right one, at the configuration where their tips differ most.
function makeTableLink(arm, typedRows) {
  const [rows, expected] = [typedRows, arm.rows].map((list) => unlockRow(arm, list));
  const counts = [rows, expected].map((list) => movingRows({ rows: list }).length);
  if (!rows.length || counts[0] !== counts[1]) return "";
  const { q, size } = findLargestDifference({ ...arm, rows }, { ...arm, rows: expected });
  if (size < SEEN * estimateReach(arm)) return "";
  return formatLink(arm, { rows: formatRows(rows), q: formatNumbers(q), view: "table" });
}

const formatLink = (arm, fields) => `#${new URLSearchParams({ arm: arm.explorer, ...fields })}`;

/** @returns {ListedArm | undefined} */
const findExplorerArm = ({ ask, arm: key, joints }, arms) =>
  key === OWN_ARM || (joints && ask !== "table")
    ? undefined
    : arms.find((arm) => arm.key === key && arm.explorer);

// The explorer's arm has no locked joint: its value there is 0.
/** @param {ListedArm} arm @param {number[]} q */
function unlockJoints({ rows, locked }, q) {
  if (!locked) return q;
  const before = movingRows({ rows: rows.slice(0, locked - 1) }).length;
  return [...q.slice(0, before), 0, ...q.slice(before)];
}

/** @param {ListedArm} arm @param {TableRow[]} rows @returns {TableRow[]} */
const unlockRow = ({ locked }, rows) =>
  rows.map((row, i) =>
    i + 1 === locked && row.kind === "fixed" ? { ...row, kind: "revolute" } : row,
  );

/**
 * Find a configuration at which the tips of two arms differ most. The search begins at the best of
 * five general configurations, and goes twice through all joints, one at a time.
 * @param {Arm} arm
 * @param {Arm} reference
 * @returns {{ q: number[], size: number }} size in m; a turn counts little
 */
export function findLargestDifference(arm, reference) {
  const turnSize = TURN_SHARE * estimateReach(reference);
  const measure = (q) => {
    const [tip, expected] = [arm, reference].map((one) => linkFrames(one, q).at(-1));
    return norm(minus(tip.o, expected.o)) + turnSize * rotationBetween(tip, expected);
  };
  const ranges = movingRows(reference).map((row) => jointRange(reference.rows[row]));
  const starts = listGeneralConfigurations(reference).map((start) =>
    start.map((value, k) => Math.min(ranges[k][1], Math.max(ranges[k][0], value))),
  );
  const sized = starts.map((q) => ({ q, size: measure(q) }));
  let best = sized.reduce((largest, one) => (one.size > largest.size ? one : largest));
  for (let sweep = 0; sweep < SWEEPS; sweep++)
    ranges.forEach(([low, high], k) => {
      for (let i = 0; i < VALUES_TRIED; i++) {
        const value = low + ((high - low) * (i + 0.5)) / VALUES_TRIED;
        const q = best.q.map((x, j) => (j === k ? Number(value.toFixed(2)) : x));
        const size = measure(q);
        if (size > best.size + 1e-9) best = { q, size };
      }
    });
  return best;
}
