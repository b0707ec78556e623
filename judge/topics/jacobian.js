// Judges a Jacobian of the tip, whole or some of its rows.

import {
  listCopiedColumns,
  makeJacobian,
  listMistakePairs,
  listSingleMistakes,
  listJacobianSteps,
} from "../causes/jacobian.js";
import { causeName, joinCauseMessages } from "../causes/ranking.js";
import { agrees, compareDigits, RIGHT, SO_FAR, canBeDistinguished, WRONG } from "../digits.js";
import { judgeEntries } from "../entries.js";
import * as chains from "../geometry/chains.js";
import { listGeneralConfigurations } from "../geometry/general_configurations.js";
import { DEG } from "../geometry/angles.js";
import { fixedRows, jointNumbers, revoluteFlags } from "../geometry/kinematics.js";
import { lookup, readConfiguration, refuseOtherLists } from "../reading/numbers.js";
import { completeVerdicts, makeVerdict } from "../verdict.js";
import { askAboutDegrees } from "./degrees.js";
import { judgeWholeOrBeginning, listCountsBelow } from "./beginning.js";
import { judgeAtConfigurations, makeExactEntries, readMatrix } from "./jacobian_matrix.js";
import {
  ALL_ROWS,
  describeSelection,
  HALVES,
  listRowSelections,
  nameRows,
  pickRows,
  ROWS,
  selectRows,
} from "./jacobian_rows.js";
import { formatMessage, formatNumber, joinList, uncapitalize } from "../sentences.js";

/** @typedef {import("../geometry/arm.js").Arm} Arm */

/**
 * Judge a Jacobian of an arm's tip. Formulas in the joints are compared at five configurations,
 * numbers at q.
 * @param {string | any[]} mine text or nested lists
 * @param {Arm} arm
 * @param {any} q joint values, a text or a list; an empty text if there are none
 * @returns {import("../verdict.js").Verdict}
 */
export const compareJacobian = completeVerdicts(judgeJacobian);

function judgeJacobian(mine, arm, q, givenOptions = {}) {
  const isMissing = typeof q === "string" && !q.trim();
  const options = isMissing ? { ...givenOptions, generic: true } : givenOptions;
  const typedQ = isMissing
    ? makeExactEntries(listGeneralConfigurations(arm)[0])
    : readConfiguration(q, arm, options.angles);
  return judgeWholeOrBeginning(mine, () => judgeWholeJacobian(mine, arm, q, typedQ, options), {
    topic: "Jacobian",
    arm,
    listBeginnings: () => listFirstParts(arm, typedQ, options),
  });
}

// List the beginnings of a Jacobian: its first rows, or the first columns of all rows. Three rows
// are a half, which is judged as a whole answer.
/** @returns {import("./beginning.js").Beginning[]} */
function listFirstParts(arm, typedQ, options) {
  const { angularFirst = false, tolerance = null, frame = 0, values = [] } = options;
  const dof = typedQ.values.length;
  const known = lookup(arm, typedQ.values, values);
  const makeWhole = makeJacobian(arm, frame);
  const order = (list) => (angularFirst ? exchangeHalves(list) : list);
  const rowNames = order(ROWS);
  const columnNames = typedQ.values.map((_, k) => formatMessage("column", { column: k + 1 }));
  return [
    ...[5, 4, 2].map((rows) => ({ rows, columns: dof })),
    ...listCountsBelow(dof, 1).map((columns) => ({ rows: 6, columns })),
  ].map(({ rows, columns }) => ({
    headline: rows < 6 ? "J first rows" : "J first columns",
    count: rows < 6 ? rows : columns,
    names: rows < 6 ? rowNames : columnNames,
    read(text) {
      const wants = [{ rows, columns, by: "row" }];
      const typed = readMatrix(text, known, arm, { ...options, typedQ, wants });
      return { typed, taken: [...typed.taken, ...(typedQ.locked ?? [])] };
    },
    judge({ typed }) {
      if (`${typed.shape}` !== `${[rows, columns]}`) return null;
      const isTyped = (_, i) => i < rows * dof && i % dof < columns;
      const makeExpected = (q) => order(makeWhole(q)).filter(isTyped);
      const judged = judgeAtConfigurations(typed, { ...options, arm, typedQ }, (at) =>
        judgeEntries({ typed: at.typed, q: at.typedQ, dof, makeExpected, mistakes: [], tolerance }),
      );
      return judged.grade === WRONG
        ? null
        : { wrong: judged.wrong, rowNames: rowNames.slice(0, rows) };
    },
  }));
}

function judgeWholeJacobian(mine, arm, q, typedQ, options) {
  const known = lookup(arm, typedQ.values, options.values ?? []);
  const typed = readMatrix(mine, known, arm, { ...options, typedQ });
  const question = { ...options, arm, typedQ, frame: options.frame ?? 0 };
  const first = judgeAtConfigurations(typed, question, (at) =>
    judgeReadMatrix(at.typed, at, [...typed.taken, ...(at.typedQ.locked ?? [])]),
  );
  if (typed.hasJoints) return { ...first, typed };
  const verdict = askAboutDegrees(first, {
    arm,
    values: typedQ.values,
    angles: options.angles,
    keys: { deg: "J.degrees", rad: "J.degrees" },
    judgeIn: (angles) => judgeJacobian(mine, arm, q, { ...options, angles }),
    makeHeadline: (cause) => formatMessage("J wrong", { arm: arm.name, cause: `${cause}.` }),
  });
  return { ...verdict, typed };
}

function judgeReadMatrix(typed, question, taken) {
  const { arm, typedQ, angularFirst = false, others = [] } = question;
  const [rows, width] = typed.shape;
  const isJudged = rows === 6 || listRowSelections(arm, rows).length > 0;
  if (width !== typedQ.values.length || !isJudged) return reportWrongShape(typed, question, taken);
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
  const exchanged = others.map((one) => ({ ...one, typed: exchangeTypedHalves(one.typed) }));
  const verdict = judgeSelectedRows(
    exchangeTypedHalves(typed),
    { ...question, others: exchanged },
    [...taken, formatMessage("taken: angular first")],
  );
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
    const verdict = reportRight(judged, typed, request, selection.half);
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
  const { arm, typedQ, frame, tolerance = null, isGradeOnly, others = [] } = request;
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
  const fitsOthers = ({ make }) =>
    others.every((other) => {
      const values = make(other.typedQ.values);
      return (
        compareDigits(
          other.typed,
          values,
          values.map(() => 0),
        ) !== ""
      );
    });
  const mayHide = !typed.isEverywhere && selection.rows.length === 6;
  const notes = mayHide ? noteHiddenMistakes(steps, mistakes, request, makeExpected) : [];
  return { judged: { ...judged, mistakes: judged.mistakes.filter(fitsOthers) }, notes };
}

// Note how many mistakes in the recipe give the same Jacobian at this configuration. Name a
// configuration that shows them, unless the page fixes q.
function noteHiddenMistakes(steps, mistakes, question, makeExpected) {
  const { arm, typedQ, angles, isConfigurationFixed = false } = question;
  const { values: q } = typedQ;
  const expected = makeExpected(q);
  const recipe = mistakes.filter((_, k) => !steps[k].change && !("i" in steps[k].cause.fields[0]));
  const zeros = expected.map(() => 0);
  const visible = recipe.filter(({ make }) =>
    canBeDistinguished({ units: zeros }, expected, make(q)),
  );
  const count = recipe.length - visible.length;
  const general = describeConfiguration(listGeneralConfigurations(arm)[0], arm, angles);
  const other = isConfigurationFixed ? "" : formatMessage("J try", { q: general });
  return count ? [formatMessage("J hidden", { count, all: recipe.length, other })] : [];
}

// Report a Jacobian that is right, rounded or right so far. `half` is 0 or 1 if only the linear or
// the angular half was typed, else null.
function reportRight({ grade, agreement, wrong }, typed, { arm, typedQ, angles }, half) {
  const where = typed.isEverywhere
    ? ""
    : formatMessage("at configuration", { q: describeConfiguration(typedQ.values, arm, angles) });
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

// Write joint values in the unit of the question, "0.5, -1.2" or "28.65°, -68.75°".
function describeConfiguration(q, arm, angles) {
  const turns = revoluteFlags(arm);
  const inDegrees = (x) => `${formatNumber(x * DEG, 4)}°`;
  return q
    .map((x, k) => (angles === "deg" && turns[k] ? inDegrees(x) : formatNumber(x, 4)))
    .join(", ");
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
