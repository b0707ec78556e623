// Is a Jacobian wrong, and how?

import {
  listCopiedColumns,
  makeJacobian,
  listMistakePairs,
  listSingleMistakes,
  listJacobianSteps,
} from "../causes/jacobian.js";
import { causeName, joinCauseMessages } from "../causes/ranking.js";
import { agrees, RIGHT, SO_FAR, tellable, WRONG } from "../digits.js";
import { judgeEntries } from "../entries.js";
import * as chains from "../geometry/chains.js";
import { norm, jointNumbers, revoluteFlags } from "../geometry/kinematics.js";
import { isPlanar, movableLinearRows, movableRows, pick } from "../geometry/task_rows.js";
import { lookup, numbers, pose } from "../reading/numbers.js";
import { completeVerdicts, makeVerdict } from "../verdict.js";
import { askAboutDegrees } from "./degrees.js";
import { ArmError, describeShape, joinList, uncapitalize, formatMessage } from "../sentences.js";

/** @typedef {import("../geometry/arm.js").Arm} Arm */

const ROWS = ["vx", "vy", "vz", "wx", "wy", "wz"];
const ALL_ROWS = [0, 1, 2, 3, 4, 5];
const PLANE_NAMES = ["x", "y", "z", "φ", "φ", "φ"]; // of a planar arm's rows
const NAMES = /^(?:j|ans$)/i;
const HALVES = ["linear", "angular"];

/**
 * The report on a Jacobian, a text or nested numbers, of an arm's tip at q.
 * @returns {import("../verdict.js").Verdict}
 */
export const compareJacobian = completeVerdicts(jacobianCompared);

function jacobianCompared(mine, arm, q, options = {}) {
  const at = pose(q, arm, options.angles);
  const known = lookup(arm, at.values, options.values ?? []);
  const typed = readMatrix(mine, known, arm, { ...options, at });
  const asked = { ...options, arm, at, frame: options.frame ?? 0 };
  const report = judgeReadMatrix(typed, asked, [...typed.said, ...(at.locked ?? [])]);
  const verdict = askAboutDegrees(report, {
    arm,
    values: at.values,
    angles: options.angles,
    key: "J.degrees",
    judgeInDegrees: () => jacobianCompared(mine, arm, q, { ...options, angles: "deg" }),
    makeHeadline: (cause) => formatMessage("J wrong", { arm: arm.name, cause: `${cause}.` }),
  });
  return { ...verdict, typed };
}

function judgeReadMatrix(typed, asked, said) {
  const { arm, at, angularFirst = false } = asked;
  const [rows, width] = typed.shape;
  const isJudged = rows === 6 || listRowSelections(arm, rows).length > 0;
  if (width !== at.values.length || !isJudged) return reportWrongShape(typed, asked, said);
  if (!typed.values.some(Boolean)) {
    const headline = formatMessage("J wrong", {
      arm: arm.name,
      cause: uncapitalize(formatMessage("J zero")),
    });
    const wrong = typed.values.map(() => true);
    return { ...makeJacobianVerdict(arm, WRONG, headline, { taken: said }), wrong };
  }
  if (!angularFirst || rows < 6) return judgeSelectedRows(typed, asked, said);
  const report = judgeSelectedRows(exchangeTypedHalves(typed), asked, [
    ...said,
    formatMessage("taken: angular first"),
  ]);
  return { ...report, wrong: exchangeHalves(report.wrong) };
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

// Read what was typed as a matrix; all of its entries in one row or column are taken row by row. A
// formula needs no q; `computed` are the values of a function, which count as one.
/** @param {any} mine @param {any} known @param {Arm} arm @param {any} asked */
function readMatrix(mine, known, arm, { at, which, generic = false, computed = false }) {
  const [what, dof] = [`${arm.name}: your Jacobian`, at.values.length];
  const wants = [...shapes(dof, arm.rows.length), ...reducedShapes(arm, dof)];
  const asked = { wants, names: NAMES, given: [at.values], which };
  const read = convertToMetres(numbers(mine, what, known, undefined, asked));
  const symbolic = read.symbolic || computed;
  if (generic && !symbolic) throw new ArmError(formatMessage("J needs q"));
  const one = read.shape.length === 3 ? read.shape.indexOf(1) : -1;
  const shape = read.shape.filter((_, i) => one < 0 || i !== one);
  if (shape.length !== 2)
    throw new ArmError(formatMessage("no matrix", { what, given: describeShape(shape) }));
  const units = computed ? read.units.map(() => 0) : read.units;
  const count = read.values.length;
  const flat = count === 6 * dof && count === Math.max(...shape);
  return { ...read, units, symbolic, shape: flat ? [6, dof] : shape };
}

// The shapes that are judged: whole or half, then those of known slips, and all in one row.
const shapes = (dof, all) => [
  { rows: 6, columns: dof, by: "row" },
  { rows: 3, columns: dof, by: "row" },
  { rows: dof, columns: 6 },
  ...[all, dof - 1].map((columns) => ({ rows: 6, columns, by: "row" })),
  { rows: 5, columns: all },
  { rows: 1, columns: 6 * dof },
  { rows: 6 * dof, columns: 1 },
];

// The shapes of an arm that moves in fewer than six ways, such as 2x2 or 3x3 for a planar arm.
function reducedShapes(arm, columns) {
  const counts = [movableRows(arm).length, movableLinearRows(arm).length];
  return counts.flatMap((rows) => (rows > 1 && rows < 6 ? [{ rows, columns, by: "row" }] : []));
}

// The linear rows in metres, where the text says that they are in mm.
function convertToMetres(typed) {
  const { shape, says } = typed;
  if (says?.lengths !== "mm" || shape[0] !== 6) return typed;
  const scaled = (list) => list.map((x, i) => (i < 3 * shape[1] ? x / 1000 : x));
  const said = [...typed.said, formatMessage("taken: linear millimetres")];
  return { ...typed, values: scaled(typed.values), units: scaled(typed.units), said };
}

// Another shape: what was forgotten, if the rest is right.
function reportWrongShape({ values, units, shape: [rows, width] }, { arm, at, frame }, taken) {
  const right = computeAllColumns(arm, at.values, frame).sort(([i], [j]) => i - j);
  const dof = at.values.length;
  const is = (kept) => {
    const truth = kept.flatMap((row) => right.map(([, column]) => column[row]));
    return truth.length === values.length && agrees({ values, units }, truth);
  };
  const every = ROWS.map((_, i) => i);
  let key = "J.shape";
  if (rows === dof && width === 6) key = "J.transposed";
  else if (right.length > dof && is(every)) key = "J.locked column kept";
  else if (right.length > dof && rows === 5 && every.some((row) => is(listRowsWithout(row))))
    key = "J.row for column"; // slip 3, by its words
  const words = formatMessage(key, { shape: `${rows}x${width}`, dof });
  const findings = [
    { what: "shape", where: "", mine: [rows, width], expected: [6, dof], words: `${words}.` },
  ];
  const headline = formatMessage("J wrong", { arm: arm.name, cause: `${uncapitalize(words)}.` });
  return makeJacobianVerdict(arm, WRONG, headline, { findings, causes: [key], taken });
}

const listRowsWithout = (row) => ROWS.flatMap((_, i) => (i === row ? [] : [i]));

/** @returns {import("../verdict.js").Verdict} */
function judgeSelectedRows(typed, { arm, at, frame, tolerance = null }, said) {
  const slips = listJacobianSteps(arm, at.values, frame);
  const whole = makeJacobian(arm, frame);
  const selection = selectRows(typed, arm, whole(at.values));
  const { half } = selection;
  const part = (mistake) =>
    selection.rows.length === 6
      ? mistake
      : { ...mistake, make: (q) => rowsOf(mistake.make(q), selection) };
  const right = (q) => rowsOf(whole(q), selection);
  const singles = listSingleMistakes(arm, frame, slips).map(part);
  const of = (make) => () => Array.from(make(arm, frame, slips), part);
  const asked = { mine: typed, q: at, dof: at.values.length, right, slips: singles, tolerance };
  const further = [of(listCopiedColumns), of(listMistakePairs)];
  const verdict = judgeEntries({ ...asked, further });
  const taken = [...said, ...describeSelection(selection, arm)];
  const rowNames = nameRows(selection);
  const truth = right(at.values);
  if (verdict.grade !== WRONG) {
    const isPartial = selection.rows.length < 6;
    const notes =
      typed.symbolic || isPartial ? [] : noteHiddenMistakes(slips, singles, at.values, truth);
    const told = reportRight(verdict, typed, arm, half);
    return { ...told, taken, notes: [...told.notes, ...notes], wrong: verdict.wrong, rowNames };
  }
  const columns = computeAllColumns(arm, at.values, frame).map(([one, J]) => [
    one,
    rowsOf(J, selection),
  ]);
  const where = () => places(typed, columns, verdict.wrong, arm, rowNames);
  const causes = verdict.slips.map(({ cause }) => cause);
  return { ...reportWrong(causes, where, arm), taken, wrong: verdict.wrong, rowNames };
}

/**
 * Some rows of a Jacobian, by their indices. `half` is 0 or 1 where they are its linear or angular
 * half, and the other half is missing; null where they are all that the arm can move.
 * @typedef {{ rows: number[], half: number | null }} RowSelection
 */

const rowsOf = (J, { rows }) =>
  rows.flatMap((i) => J.slice((i * J.length) / 6, ((i + 1) * J.length) / 6));

// The selections that so many rows of a Jacobian may be; those of a planar arm come first.
/** @returns {RowSelection[]} */
function listRowSelections(arm, count) {
  const [movable, linear] = [movableRows(arm), movableLinearRows(arm)];
  const reduced = [movable, ...(linear.length < 3 ? [linear] : [])];
  const halves = [ALL_ROWS.slice(0, 3), ALL_ROWS.slice(3)];
  const selections = [
    ...(movable.length < 6 ? reduced.map((rows) => ({ rows, half: null })) : []),
    ...halves.map((rows, half) => ({ rows, half })),
  ];
  return selections.filter(({ rows }) => rows.length === count);
}

// Select the rows that were typed: of those that fit, the nearest to the right ones. A half of a
// planar arm's rows has rows of zeros, so it is read only where zeros were typed.
/** @returns {RowSelection} */
function selectRows({ values, shape }, arm, right) {
  if (shape[0] === 6) return { rows: ALL_ROWS, half: null };
  const selections = listRowSelections(arm, shape[0]);
  const [first] = selections;
  if (first.half === null && values.every(Boolean)) return first;
  const gap = (selection) => norm(rowsOf(right, selection).map((x, i) => x - values[i]));
  return selections.reduce((best, one) => (gap(one) < gap(best) ? one : best));
}

/** @param {RowSelection} selection */
const nameRows = ({ rows, half }) =>
  pick(half === null && rows.length < 6 ? PLANE_NAMES : ROWS, rows);

function describeSelection({ rows, half }, arm) {
  if (half !== null) return [formatMessage("taken: half", { half: HALVES[half] })];
  if (rows.length === 6) return [];
  const names = joinList(pick(PLANE_NAMES, rows));
  return [formatMessage(isPlanar(arm) ? "taken: planar rows" : "taken: movable rows", { names })];
}

// A word on the mistakes that this pose does not show.
function noteHiddenMistakes(slips, singles, q, truth) {
  const method = singles.filter((_, k) => !slips[k].change && !("i" in slips[k].cause.fields[0]));
  const shown = method.filter(({ make }) =>
    tellable({ units: truth.map(() => 0) }, truth, make(q)),
  );
  const count = method.length - shown.length;
  return count ? [formatMessage("J hidden", { count, all: method.length })] : [];
}

// `half` is which half three rows are, null where all six are there.
function reportRight({ grade, how, wrong }, typed, arm, half) {
  const where = typed.symbolic ? "" : formatMessage("at this pose");
  const precision = typed.units.some(Boolean) ? formatMessage("to your digits") : "";
  const [own, other] = half ? ["angular", "linear"] : HALVES;
  const keys = { [RIGHT]: half === null ? "J right" : "J half right", [SO_FAR]: "J so far" };
  const width = typed.shape[1];
  const off = jointNumbers(arm).flatMap((_, k) =>
    column(wrong, k, width).includes(true) ? [k + 1] : [],
  );
  const places = joinList(off.map((k) => formatMessage("column", { column: k })));
  const fields = { arm: arm.name, where, precision, half: own, other, places };
  const headline = formatMessage(keys[grade] ?? "J rounded", fields);
  const findings =
    half === null
      ? []
      : [
          {
            what: "missing",
            where: `${other} rows`,
            words: formatMessage("J half missing", { other }),
          },
        ];
  const said = half !== null && grade === RIGHT ? SO_FAR : grade;
  return makeJacobianVerdict(arm, said, headline, {
    findings,
    notes: how === "cut" ? [formatMessage("cut")] : [],
  });
}

function reportWrong(causes, where, arm) {
  if (causes.length) {
    const words = joinCauseMessages(causes);
    const findings = [{ what: "cause", where: "", words: `${words}.` }];
    const headline = formatMessage("J wrong", { arm: arm.name, cause: `${uncapitalize(words)}.` });
    return makeJacobianVerdict(arm, WRONG, headline, { findings, causes: causes.map(causeName) });
  }
  const found = where();
  if (found.length === jointNumbers(arm).length && found.every(({ what }) => what === "column")) {
    const question = formatMessage(revoluteFlags(arm)[0] ? "J turns" : "J slides", {
      joint: jointNumbers(arm)[0],
    });
    return makeJacobianVerdict(
      arm,
      WRONG,
      formatMessage("J wrong everywhere", { arm: arm.name, question }),
      {
        findings: found,
      },
    );
  }
  const headline =
    found.length === 1
      ? formatMessage("J wrong", { arm: arm.name, cause: uncapitalize(found[0].words) })
      : formatMessage("J wrong places", {
          arm: arm.name,
          places: joinList(found.map(({ where: at }) => at)),
        });
  return makeJacobianVerdict(arm, WRONG, headline, { findings: found });
}

const column = (list, k, width) => list.filter((_, i) => i % width === k);

// The wrong columns: turned over, another joint's, or wrong in some rows.
function places({ values, units, shape }, columns, wrong, arm, names) {
  const width = shape[1];
  return jointNumbers(arm).flatMap((joint, k) => {
    const [off, own, places] = [wrong, values, units].map((list) => column(list, k, width));
    if (!off.includes(true)) return [];
    const is = (other) => agrees({ values: own, units: places }, other);
    const [, truth] = columns.find(([one]) => one === joint);
    const others = columns.filter(([one, other]) => one !== joint && is(other));
    const rows = joinList(names.filter((_, i) => off[i]));
    const negative = truth.map((x, i) => (off[i] ? -x : x));
    const [what, said] =
      others.length === 1
        ? ["column", formatMessage("J.other column", { joint: others[0][0] })]
        : ["column", formatMessage(is(negative) ? "J.entry signs" : "J.entries", { rows })];
    const words = formatMessage("J column", { column: k + 1, joint, words: said });
    return [{ what, where: `column ${k + 1}`, words }];
  });
}

// Each joint's column in the declared frame, then those that locked joints would have.
function computeAllColumns(arm, q, frame) {
  const here = chains.makeChain(arm, q);
  const T = chains.chainFrames(here);
  const locked = arm.rows.flatMap((row, i) => (row.kind === "fixed" ? [i] : []));
  const loose = { ...here, at: locked, turns: locked.map(() => true), dof: locked.length };
  return [here, loose].flatMap((c) => {
    const J = chains.flatJacobian(c, T);
    const seen = frame ? chains.rotateIntoFrame(J, T[frame]) : J;
    return c.at.map((i, k) => [i + 1, column(seen, k, c.dof)]);
  });
}
