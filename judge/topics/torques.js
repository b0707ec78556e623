// Judges joint torques at a single configuration or along a trajectory.

import { causeName } from "../causes/ranking.js";
import { listTorqueSteps, makeLoad, makeTorqueMaker } from "../causes/torques.js";
import { agrees, RIGHT, ROUNDED, SO_FAR, WRONG } from "../digits.js";
import { judgeEntries } from "../entries.js";
import { selectColumn, transpose } from "../geometry/chains.js";
import { GRAVITY, movingRows, jointNumbers, revoluteFlags } from "../geometry/kinematics.js";
import { splitIntoRows, subtractEach } from "../geometry/linear.js";
import {
  eachJoint,
  inRadians,
  jointShapes,
  numbers,
  notPerJoint,
  ofMoving,
  refuseMisfitUnits,
  refuseOtherLists,
} from "../reading/numbers.js";
import { orderByGivenNames } from "../reading/ordering.js";
import { MOMENT_UNITS, momentFactor } from "../reading/units.js";
import { makeFinding } from "../verdict.js";
import { listCountsBelow } from "./beginning.js";
import { makeJudge } from "./frame.js";
import { arrangeByRows } from "./layout.js";
import { ArmError, joinList, formatMessage, formatNumber } from "../sentences.js";

// Names of variables that hold the answer; "effort" is the name in ROS.
const ANSWER_NAMES = /^(?:tau|τ|t$|torque|effort|ans$)/i;
const SAMPLE_SIZE = 5; // configurations of a trajectory at which mistakes are tried first

/**
 * A question about torques at the configurations q of a loaded arm. `taken` describes q and the
 * masses; `request` is how to read an answer.
 * @typedef {{ arm: import("../geometry/arm.js").Arm, q: import("../digits.js").Entries,
 *   load: import("../causes/torques.js").Load, tolerance: number | null,
 *   isGradeOnly: boolean | undefined, taken: string[], request: any }} TorqueQuestion
 */

/** Judge torques at q or along a list of q, which is a text or nested lists. */
export const compareTorques = makeJudge({
  name: "torques",
  sentences: {
    [RIGHT]: "tau right",
    [SO_FAR]: "tau so far",
    [ROUNDED]: "tau rounded",
    wrong: "tau wrong",
    places: "tau wrong places",
  },
  otherUnit: { deg: "tau.degrees", rad: "tau.degrees" },
  ask(arm, q, options) {
    const {
      tolerance = null,
      gravity = GRAVITY,
      isGradeOnly,
      angles,
      wrench,
      which,
      stated,
    } = options;
    const dof = movingRows(arm).length;
    const read = readConfigurations(q, arm, angles);
    const [typedQ, wrenches] = pairConfigurationsWithWrenches(read, dof, wrench);
    const load = makeLoad(arm, wrenches, gravity);
    if (![...load.masses, ...wrenches.flat()].some(Boolean))
      throw new ArmError(formatMessage("no load", { arm: arm.name }));
    const given = [...splitIntoRows(typedQ.values, dof), ...wrenches];
    const request = { names: ANSWER_NAMES, given, which, stated };
    const taken = [...(typedQ.locked ?? []), ...describeModel(load)];
    return { arm, q: typedQ, load, tolerance, isGradeOnly, taken, request };
  },
  read: (mine, question) => readTorques(mine, question, listShapes(question)),
  compare({ typed }, question) {
    const { arm, load, taken } = question;
    const count = load.wrenches.length;
    const arranged = arrangeByRows(typed, arm, [count]);
    if (!arranged) return describeWrongShape(typed, count, arm);
    const torques = { values: arranged.rows.flat(), units: arranged.units.flat() };
    const outcome = compareArranged(torques, question);
    const shape = [count, movingRows(arm).length];
    return {
      ...outcome,
      taken: [...arranged.taken, ...taken],
      wrong: arranged.isPerJoint ? transpose(outcome.wrong, shape) : outcome.wrong,
    };
  },
  getAngles: (_, { q }) => q,
  listBeginnings: listFirstTorques,
});

function readTorques(mine, { arm, request }, wants) {
  const what = `${arm.name}: your torques`;
  const typed = numbers(orderByGivenNames(mine), what, undefined, undefined, { ...request, wants });
  if (typed.values.length === movingRows(arm).length)
    refuseMisfitUnits(typed.entries, arm, what, true);
  return { typed: convertToNewtonMetres(typed) };
}

// List the beginnings of torques at one configuration, of two joints at least.
/** @returns {import("./beginning.js").Beginning[]} */
function listFirstTorques(question) {
  const { arm, q, load, tolerance, taken } = question;
  if (load.wrenches.length > 1) return [];
  const names = jointNumbers(arm).map((joint) => formatMessage("joint", { joint }));
  const { dof } = load.c;
  const makeTorques = makeTorqueMaker(load, dof, q.values)();
  return listCountsBelow(dof, 2).map((count) => ({
    headline: "tau first joints",
    count,
    names,
    read(text) {
      const wants = [
        { rows: 1, columns: count, by: "joint" },
        { rows: count, columns: 1 },
      ];
      const { typed } = readTorques(text, question, wants);
      return { typed, taken: [...typed.taken, ...taken] };
    },
    judge({ typed }) {
      const isList = typed.shape.every((n) => n === 1 || n === count);
      if (!isList || typed.values.length !== count) return null;
      const maker = () => (values) => makeTorques(values).slice(0, count);
      const { grade, wrong } = judgeEntries({ typed, q, dof, maker, tolerance });
      return grade === WRONG ? null : { wrong };
    },
  }));
}

// List the shapes that are read. They have a row for each configuration or a list for each joint,
// with or without locked joints. A single number for each configuration is an energy.
function listShapes({ arm, load }) {
  const count = load.wrenches.length;
  const widths = [...new Set([movingRows(arm).length, arm.rows.length])];
  return [
    ...widths.flatMap((columns) => [
      { rows: count, columns, by: "joint" },
      { rows: columns, columns: count },
    ]),
    ...(count > 1 ? [{ rows: count, columns: 1 }] : []),
  ];
}

// Convert torques to N m if the text gives their unit. An entry with its own unit is converted
// already.
function convertToNewtonMetres(typed) {
  const own = typed.entries.map(({ unitBehind = "" }) => momentFactor(unitBehind));
  if (own.every(Boolean) && new Set(own).size > 1) {
    const scaleEach = (list) => list.map((x, i) => (typed.entries[i].hasUnit ? x : x * own[i]));
    return { ...typed, values: scaleEach(typed.values), units: scaleEach(typed.units) };
  }
  const unit = typed.statedUnits?.moments;
  if (!unit) return typed;
  const scale = (list) => list.map((x, i) => (typed.entries[i].hasUnit ? x : x * unit));
  const taken = [...typed.taken, formatMessage("taken: moments", { unit: MOMENT_UNITS[unit] })];
  return { ...typed, values: scale(typed.values), units: scale(typed.units), taken };
}

// Pair configurations with wrenches. A single wrench belongs to all configurations, a single
// configuration to all wrenches.
function pairConfigurationsWithWrenches(typedQ, dof, wrench = [0, 0, 0, 0, 0, 0]) {
  const count = typedQ.values.length / dof;
  const wrenches = Array.isArray(wrench[0])
    ? wrench
    : splitIntoRows(typedQ.values, dof).map(() => wrench);
  if (count !== 1) return [typedQ, wrenches];
  const repeat = (list) => wrenches.flatMap(() => list);
  return [{ ...typedQ, values: repeat(typedQ.values), units: repeat(typedQ.units) }, wrenches];
}

/** Read a joint vector or a list of joint vectors. */
export function readConfigurations(q, arm, angles) {
  const dof = movingRows(arm).length;
  const read = numbers(orderByGivenNames(q), `${arm.name}: q`, undefined, eachJoint(arm), {
    wants: jointShapes(arm),
  });
  const typed = read.shape.at(-1) === arm.rows.length ? ofMoving(read, arm) : read;
  if (typed.shape.at(-1) !== dof) throw notPerJoint(`${arm.name}: q`, arm, typed.shape);
  return inRadians(typed, arm, angles);
}

// Describe the masses that are used for comparison.
const describeModel = ({ masses, gravity }) => [
  masses.some(Boolean)
    ? formatMessage("taken: masses", {
        masses: masses.map((mass) => formatNumber(mass, 3)).join(", "),
        g: formatNumber(Math.hypot(...gravity), 4),
      })
    : formatMessage("taken: no masses"),
];

/** @returns {import("./frame.js").Outcome} */
function describeWrongShape(typed, count, arm) {
  const { shape, values } = typed;
  const dof = movingRows(arm).length;
  const key = values.length === count ? "tau.energy" : "tau.shape";
  const wanted = count > 1 ? `${count}x${dof}` : String(dof);
  refuseOtherLists(typed, `${arm.name}: your torques`, wanted);
  const sizes = count > 1 ? shape : shape.filter((n) => n !== 1);
  const words = formatMessage(key, { shape: sizes.join("x") || "1", wanted, dof });
  const findings = [{ what: "shape", where: "", mine: shape, expected: [count, dof], words }];
  return { grade: WRONG, findings, causeNames: [key] };
}

// Compare torques with a row for each configuration.
/** @returns {import("./frame.js").Outcome} */
function compareArranged(typed, question) {
  const { arm, q, load } = question;
  const judged = judgeBySample(typed, question);
  const { grade, wrong, agreement } = judged;
  const expected = makeTorqueMaker(load, load.c.dof, q.values)()(q.values);
  const shared = {
    grade,
    wrong,
    figures: measureErrors(typed.values, expected, judged, load.c.dof),
  };
  const wrongJoints = listWrongJoints(wrong, arm);
  const places = joinList(wrongJoints.map((k) => nameJoint(arm, k)));
  if (grade !== WRONG) {
    const precision = typed.units.some(Boolean) ? formatMessage("to your digits") : "";
    const notes = agreement === "cut" ? [formatMessage("cut")] : [];
    return { ...shared, fields: { precision, places }, notes };
  }
  const causes = judged.mistakes.map(({ cause }) => cause);
  // An answer of zeros is empty, or a load was forgotten: the message asks about both.
  if (!typed.values.some(Boolean)) {
    const findings = [makeFinding("zero", formatMessage("tau zero"))];
    return { ...shared, findings, causeNames: causes.slice(0, 1).map(causeName) };
  }
  if (causes.length) return { ...shared, causes };
  const findings = wrongJoints.map((k) => describeWrongJoint(arm, k, typed, expected));
  return {
    ...shared,
    findings,
    headline: formatMessage("tau wrong places", { arm: arm.name, places }),
  };
}

// Judge torques at all configurations. If there are many configurations, each mistake is tried at a
// few configurations first. Only mistakes that fit there are tried at all configurations.
function judgeBySample(typed, { arm, q: typedQ, load, tolerance, isGradeOnly }) {
  const { dof } = load.c;
  const count = load.wrenches.length;
  const isEmpty = !typed.values.some(Boolean);
  const judgeWith = (torques, q, loadAtConfigurations, steps, hasPairs) => {
    const maker = makeTorqueMaker(loadAtConfigurations, dof, q.values);
    const request = { dof, maker, steps, hasPairs, tolerance, isGradeOnly };
    return judgeEntries({ ...request, typed: torques, q });
  };
  const steps = listTorqueSteps(arm, load);
  if (count <= SAMPLE_SIZE) return judgeWith(typed, typedQ, load, steps, !isEmpty);
  const indices = Array.from({ length: SAMPLE_SIZE }, (_, i) =>
    Math.round((i * (count - 1)) / (SAMPLE_SIZE - 1)),
  );
  const select = (list) => indices.flatMap((i) => list.slice(i * dof, (i + 1) * dof));
  const sample = ({ values, units }) => ({ values: select(values), units: select(units) });
  const wrenches = indices.map((i) => load.wrenches[i]);
  const part = { ...load, wrenches };
  const { mistakes } = judgeWith(sample(typed), sample(typedQ), part, steps, !isEmpty);
  const likely = mistakes.map(({ cause, steps: wrong }) => ({ ...wrong, cause }));
  return judgeWith(typed, typedQ, load, likely, false);
}

// Return the largest error of a torque, and the number of joints that are right at every
// configuration.
function measureErrors(actual, expected, { grade, wrong }, dof) {
  const errors = subtractEach(actual, expected).map(Math.abs);
  const wrongJoints = new Set(
    wrong.flatMap((isWrong, i) => (isWrong && grade === WRONG ? [i % dof] : [])),
  );
  return { worst: Math.max(0, ...errors), right: dof - wrongJoints.size, of: dof };
}

const nameJoint = (arm, k) => formatMessage("joint", { joint: jointNumbers(arm)[k] });
const listWrongJoints = (wrong, arm) => {
  const dof = movingRows(arm).length;
  return jointNumbers(arm).flatMap((_, k) =>
    selectColumn(wrong, k, dof).includes(true) ? [k] : [],
  );
};

// Describe a wrong joint by its largest error, or report that its torques have the opposite sign.
function describeWrongJoint(arm, k, typed, expectedTorques) {
  const dof = movingRows(arm).length;
  const [actual, units, expected] = [typed.values, typed.units, expectedTorques].map((list) =>
    selectColumn(list, k, dof),
  );
  const largestError = Math.max(...subtractEach(actual, expected).map(Math.abs));
  const isNegated = agrees({ values: actual.map((x) => -x), units }, expected);
  const words = formatMessage(isNegated ? "tau other way" : "tau off", {
    joint: jointNumbers(arm)[k],
    most: actual.length > 1 ? formatMessage("up to") : "",
    off: formatNumber(largestError, 2),
    unit: revoluteFlags(arm)[k] ? "N m" : "N",
  });
  return { what: "joint", where: nameJoint(arm, k), words };
}
