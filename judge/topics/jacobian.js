// Judges a Jacobian of the tip, whole or some of its rows.

import { listJacobianSteps, makeJacobianMaker } from "../causes/jacobian.js";
import {
  agrees,
  compareDigits,
  RIGHT,
  ROUNDED,
  SO_FAR,
  canBeDistinguished,
  WRONG,
} from "../digits.js";
import { judgeEntries } from "../entries.js";
import * as chains from "../geometry/chains.js";
import { listGeneralConfigurations } from "../geometry/general_configurations.js";
import { DEG } from "../geometry/angles.js";
import { fixedRows, jointNumbers, revoluteFlags } from "../geometry/kinematics.js";
import { lookup, readConfiguration, refuseOtherLists } from "../reading/numbers.js";
import { makeFinding } from "../verdict.js";
import { listCountsBelow } from "./beginning.js";
import { makeJudge } from "./frame.js";
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
import { formatMessage, formatNumber, joinList } from "../sentences.js";

/**
 * Judge a Jacobian of an arm's tip. Formulas in the joints are compared at five configurations,
 * numbers at q, which is a text or a list; an empty text if there is none.
 */
export const compareJacobian = makeJudge({
  name: "Jacobian",
  sentences: {
    [RIGHT]: "J right",
    [SO_FAR]: "J so far",
    [ROUNDED]: "J rounded",
    wrong: "J wrong",
    places: "J wrong places",
  },
  otherUnit: { deg: "J.degrees", rad: "J.degrees" },
  ask(arm, q, options) {
    const isMissing = typeof q === "string" && !q.trim();
    const typedQ = isMissing
      ? makeExactEntries(listGeneralConfigurations(arm)[0])
      : readConfiguration(q, arm, options.angles);
    const known = lookup(arm, typedQ.values, options.values ?? []);
    const generic = isMissing || options.generic;
    return { ...options, generic, arm, typedQ, known, frame: options.frame ?? 0 };
  },
  read: (mine, question) => ({ typed: readMatrix(mine, question.known, question.arm, question) }),
  compare: ({ typed }, question) => judgeAtConfigurations(typed, question, compareMatrix),
  getAngles: ({ typed }, { typedQ }) => (typed.hasJoints ? null : typedQ),
  listBeginnings: listFirstParts,
});

// List the beginnings of a Jacobian: its first rows, or the first columns of all rows. Three rows
// are a half, which is judged as a whole answer.
/** @returns {import("./beginning.js").Beginning[]} */
function listFirstParts(question) {
  const { arm, typedQ, known, frame, angularFirst = false, tolerance = null } = question;
  const dof = typedQ.values.length;
  const makeWhole = makeJacobianMaker(arm, frame)();
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
      const typed = readMatrix(text, known, arm, { ...question, wants });
      return { typed, taken: listAssumptions(typed, typedQ) };
    },
    judge({ typed }) {
      if (`${typed.shape}` !== `${[rows, columns]}`) return null;
      const isTyped = (_, i) => i < rows * dof && i % dof < columns;
      const maker = () => (q) => order(makeWhole(q)).filter(isTyped);
      const { grade, wrong } = judgeAtConfigurations(typed, question, (at) =>
        judgeEntries({ typed: at.typed, q: at.typedQ, dof, maker, tolerance }),
      );
      return grade === WRONG ? null : { wrong, rowNames: rowNames.slice(0, rows) };
    },
  }));
}

const listAssumptions = ({ taken }, { locked = [] }) => [...taken, ...locked];

// Compare a matrix at a configuration.
/** @returns {import("./frame.js").Outcome} */
function compareMatrix(question) {
  const { typed, arm, typedQ, angularFirst = false, others = [] } = question;
  const [rows, width] = typed.shape;
  const taken = listAssumptions(typed, typedQ);
  const isJudged = rows === 6 || listRowSelections(arm, rows).length > 0;
  if (width !== typedQ.values.length || !isJudged)
    return { ...describeWrongShape(question), taken };
  if (!typed.values.some(Boolean)) {
    const findings = [makeFinding("zero", formatMessage("J zero"))];
    return { grade: WRONG, findings, taken, wrong: typed.values.map(() => true) };
  }
  if (!angularFirst || rows < 6 || typed.hasRowNames) return compareRows(question, taken);
  const exchange = (one) => ({ ...one, typed: exchangeTypedHalves(one.typed) });
  const outcome = compareRows({ ...exchange(question), others: others.map(exchange) }, [
    ...taken,
    formatMessage("taken: angular first"),
  ]);
  return { ...outcome, wrong: exchangeHalves(outcome.wrong) };
}

const exchangeHalves = (list) => [
  ...list.slice(list.length / 2),
  ...list.slice(0, list.length / 2),
];
const exchangeTypedHalves = (typed) => ({
  ...typed,
  values: exchangeHalves(typed.values),
  units: exchangeHalves(typed.units),
});

// Describe a wrong shape, with its cause if all entries are right.
function describeWrongShape({ typed, arm, typedQ, frame }) {
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
  else if (hasLocked && ALL_ROWS.some((row) => hasRows(ALL_ROWS.filter((i) => i !== row))))
    key = "J.row for column"; // slip 3 of the book
  if (key === "J.shape") refuseOtherLists(typed, `${arm.name}: your Jacobian`, `6x${dof}`);
  const words = `${formatMessage(key, { shape: `${rows}x${width}`, dof })}.`;
  const findings = [{ what: "shape", where: "", mine: [rows, width], expected: [6, dof], words }];
  return { grade: WRONG, findings, causeNames: [key] };
}

// Compare the rows that were typed, of a whole Jacobian or a half. A right Jacobian of numbers gets
// a note on the mistakes that would not change it.
/** @returns {import("./frame.js").Outcome} */
function compareRows(question, takenBefore) {
  const { typed, arm, typedQ, frame, tolerance = null, isGradeOnly, others = [] } = question;
  const makeWhole = makeJacobianMaker(arm, frame);
  const selection = selectRows(typed, arm, makeWhole()(typedQ.values));
  const steps = listJacobianSteps(arm, typedQ.values, frame);
  const maker = (step) => {
    const make = makeWhole(step);
    return (q) => pickRows(make(q), selection);
  };
  const entries = { typed, q: typedQ, dof: typedQ.values.length, maker, steps };
  const judged = judgeEntries({ ...entries, tolerance, isGradeOnly });
  const { grade, wrong } = judged;
  const rowNames = nameRows(selection);
  const taken = [...takenBefore, ...describeSelection(selection, arm)];
  const shared = { grade, taken, wrong, rowNames };
  if (grade !== WRONG) {
    const mayHide = !typed.isEverywhere && selection.rows.length === 6;
    const hidden = mayHide ? noteHiddenMistakes(steps, maker, question) : [];
    const right = describeRight(judged, question, selection.half);
    return { ...shared, ...right, notes: [...right.notes, ...hidden] };
  }
  const fitsOther = (make) => (other) => {
    const expected = make(other.typedQ.values);
    const zeros = expected.map(() => 0);
    return compareDigits(other.typed, expected, zeros) !== "";
  };
  const causes = judged.mistakes
    .filter(({ make }) => others.every(fitsOther(make)))
    .map(({ cause }) => cause);
  if (causes.length) return { ...shared, causes };
  const columns = computeAllColumns(arm, typedQ.values, frame).map(([number, J]) => [
    number,
    pickRows(J, selection),
  ]);
  const findings = listWrongColumns(typed, columns, wrong, arm, rowNames);
  return { ...shared, findings, ...askAboutFirstJoint(findings, arm) };
}

// If all columns are wrong without a cause, ask about the first joint in the headline.
function askAboutFirstJoint(findings, arm) {
  const [joint, ...others] = jointNumbers(arm);
  if (findings.length <= others.length) return {};
  const key = revoluteFlags(arm)[0] ? "J turns" : "J slides";
  const question = formatMessage(key, { joint });
  return { headline: formatMessage("J wrong everywhere", { arm: arm.name, question }) };
}

// Note how many mistakes in the recipe give the same Jacobian at this configuration. Name a
// configuration that shows them, unless the page fixes q.
function noteHiddenMistakes(steps, maker, question) {
  const { arm, typedQ, angles, isConfigurationFixed = false } = question;
  const { values: q } = typedQ;
  const expected = maker()(q);
  const recipe = steps.filter(({ change, cause }) => !change && !("i" in cause.fields[0]));
  const zeros = expected.map(() => 0);
  const visible = recipe.filter((step) =>
    canBeDistinguished({ units: zeros }, expected, maker(step)(q)),
  );
  const count = recipe.length - visible.length;
  const general = describeConfiguration(listGeneralConfigurations(arm)[0], arm, angles);
  const other = isConfigurationFixed ? "" : formatMessage("J try", { q: general });
  return count ? [formatMessage("J hidden", { count, all: recipe.length, other })] : [];
}

// Describe a Jacobian that is right, rounded or right so far. `half` is 0 or 1 if only the linear
// or the angular half was typed, else null.
function describeRight({ grade, agreement, wrong }, { typed, arm, typedQ, angles }, half) {
  const where = typed.isEverywhere
    ? ""
    : formatMessage("at configuration", { q: describeConfiguration(typedQ.values, arm, angles) });
  const precision = typed.units.some(Boolean) ? formatMessage("to your digits") : "";
  const width = typed.shape[1];
  const places = joinList(
    typedQ.values.flatMap((_, k) =>
      chains.selectColumn(wrong, k, width).includes(true)
        ? [formatMessage("column", { column: k + 1 })]
        : [],
    ),
  );
  const notes = agreement === "cut" ? [formatMessage("cut")] : [];
  if (half === null) return { fields: { where, precision, places }, notes };
  const other = HALVES[1 - half];
  const findings = [
    makeFinding("missing", formatMessage("J half missing", { other }), `${other} rows`),
  ];
  if (grade !== RIGHT) return { fields: { where, precision, places }, findings, notes };
  const fields = { arm: arm.name, where, precision, half: HALVES[half], other };
  return { grade: SO_FAR, headline: formatMessage("J half right", fields), findings, notes };
}

// Write joint values in the unit of the question, "0.5, -1.2" or "28.65°, -68.75°".
function describeConfiguration(q, arm, angles) {
  const turns = revoluteFlags(arm);
  const inDegrees = (x) => `${formatNumber(x * DEG, 4)}°`;
  return q
    .map((x, k) => (angles === "deg" && turns[k] ? inDegrees(x) : formatNumber(x, 4)))
    .join(", ");
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
