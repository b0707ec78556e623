// Judges whether joint values take the tip to a target. It compares the entries of the target with
// the pose of the tip.

import { listJointMistakes } from "../causes/joints.js";
import { keep, makeCause } from "../causes/ranking.js";
import { listTableMistakes } from "../causes/chain.js";
import { agrees, FINE_UNIT, RIGHT, ROUNDED, computeSlack, SO_FAR, WRONG } from "../digits.js";
import { judgeEntries } from "../entries.js";
import { isOutsideLimits } from "../geometry/arm.js";
import { makeChain, chainFrames } from "../geometry/chains.js";
import { findClosedForm, needsPose } from "../geometry/inverse.js";
import { listConfigurationsWithOneChange } from "../geometry/one_joint.js";
import { orthonormalize, solveTarget } from "../geometry/target.js";
import {
  cross,
  dot,
  frameMatrix,
  minus,
  norm,
  jointNames,
  movingRows,
  revoluteFlags,
  rotationBetween,
} from "../geometry/kinematics.js";
import { describeMiss } from "../matching.js";
import { readJointVectors } from "../reading/joint_vectors.js";
import { jointShapes, lookup, numbers, listGivenRows } from "../reading/numbers.js";
import { makeFinding } from "../verdict.js";
import {
  ArmError,
  describeShape,
  formatMessage,
  formatNumber,
  joinList,
  tryOrNull,
} from "../sentences.js";
import { listAngleBeginnings } from "./beginning.js";
import { makeJudge } from "./frame.js";

const TARGETS = [
  { rows: 4, columns: 4 },
  { rows: 3, columns: 4 },
  { rows: 1, columns: 3 },
  { rows: 3, columns: 1 },
];
const MOST_LISTED = 3; // wrong entries of a target: a wrong q changes more entries

/**
 * A target as the rows of a pose, or as a single row for a point. `formulas` is true if an entry
 * was typed as a formula.
 * @typedef {{ values: number[][], units: number[][], pose: boolean, formulas: boolean }} Target
 */

/**
 * Judge whether a joint vector takes the tip to a target, a pose (4, 4) or a point (3,), which is a
 * text or nested lists.
 */
export const comparePose = makeJudge({
  name: "pose",
  sentences: {
    [RIGHT]: "pose right",
    [SO_FAR]: "pose so far",
    [ROUNDED]: "pose rounded",
    wrong: "pose cause",
    places: "pose wrong",
  },
  otherUnit: { deg: "ik.degrees", rad: "ik.radians" },
  ask: (arm, T, options) => ({ angles: "rad", tolerance: null, ...options, arm, T }),
  read(mine, { arm, T, angles, which = null, stated }) {
    const wants = jointShapes(arm, false);
    const request = { wants, given: listGivenRows(T), which, stated };
    const read = readJointVectors(mine, arm, angles, request);
    const count = read.answers.length;
    if (count !== 1) throw new ArmError(formatMessage("one answer", { arm: arm.name, count }));
    return read;
  },
  compare({ answers: [answer], taken }, question) {
    const { arm, T } = question;
    const target = readTarget(T, arm, lookup(arm, answer.values));
    const units = target.formulas ? answer.units.map(() => 0) : answer.units;
    return { ...compareWithTarget({ ...answer, units }, target, question), taken };
  },
  getAngles: ({ answers: [answer] }) => answer,
  listBeginnings: listFirstJoints,
});

// List the beginnings of joint vectors that reach a target, if the arm has a closed form for it.
function listFirstJoints({ arm, T, angles, tolerance }) {
  const form = findClosedForm(arm);
  const target = tryOrNull(() => readTarget(T, arm, undefined));
  if (!form || target?.pose !== needsPose(form)) return [];
  const values = target.pose ? orthonormalize(target.values) : target.values[0];
  const branches = tryOrNull(() => solveTarget(arm, values)) ?? [];
  const solutions = { arm, branches, count: branches.length };
  const question = { angles, tolerance, given: listGivenRows(T), many: false };
  return listAngleBeginnings(solutions, question);
}

/**
 * Read a typed target, which is a pose or, if allowed, a point.
 * @param {any} T @param {import("../geometry/arm.js").Arm} arm
 * @param {any} known values of symbols
 * @param {boolean} [orPoint] whether a point is allowed
 * @returns {Target}
 */
export function readTarget(T, arm, known, orPoint = true) {
  const what = `${arm.name}: the target`;
  const wanted = formatMessage(orPoint ? "a point or a pose" : "a pose");
  const { values, units, shape, symbolic } = numbers(T, what, known, wanted, { wants: TARGETS });
  const size = shape.filter((n) => n !== 1).join("x");
  const pose = size === "4x4" || size === "3x4";
  if (!pose && !(orPoint && size === "3"))
    throw new ArmError(formatMessage("pose shape", { what, given: describeShape(shape), wanted }));
  const splitRows = (list) => (pose ? [0, 1, 2].map((i) => list.slice(4 * i, 4 * i + 4)) : [list]);
  return { values: splitRows(values), units: splitRows(units), pose, formulas: symbolic };
}

// Return a function that tests whether a mistake moves the tip further than the digits of the typed
// joints do: pi/2 - q_5 does not at q_5 = 0.7854.
function movesTip(q, makeExpected) {
  const expected = makeExpected(q.values);
  const slack = computeSlack(q, q.values.length, makeExpected);
  return (make) => make(q.values).some((x, i) => !(Math.abs(x - expected[i]) <= slack[i]));
}

/** @returns {import("./frame.js").Outcome} */
function compareWithTarget(q, T, { arm, tolerance, isGradeOnly }) {
  const typed = { values: T.values.flat(), units: findTargetUnits(T.units.flat()) };
  const maker = makeTipMaker(arm, T);
  const makeExpected = maker();
  const isFelt = movesTip(q, makeExpected);
  const steps = listTipSteps(arm, T).filter((step) => isFelt(maker(step)));
  const dof = q.values.length;
  const entries = { typed, q, dof, maker, steps, areGiven: true };
  const judged = judgeEntries({ ...entries, tolerance, isGradeOnly });
  const coarseSlack = computeSlack(q, q.values.length, makeExpected, Infinity);
  const causes = judged.mistakes.map(({ cause }) => cause);
  const isUnexplained = judged.grade === WRONG && tolerance === null && !causes.length;
  const hasTooFewDigits = isUnexplained && agrees(typed, makeExpected(q.values), coarseSlack);
  const grade = hasTooFewDigits ? SO_FAR : judged.grade;
  const tip = chainFrames(makeChain(arm, q.values)).at(-1);
  const [distance, angle] = measureTargetMiss(tip, T);
  const off = describeTargetMiss(T, judged.wrong, distance, angle);
  const figures = { position_error: distance, orientation_error: angle };
  const shared = { grade, figures, fields: { off } };
  if (grade !== WRONG) return { ...shared, notes: [...noteBeyondLimits(arm, q)] };
  if (causes.length) return { ...shared, causes };
  const findings = locateWrongJoint(q, arm, T, typed, makeExpected);
  if (findings.length) return { ...shared, findings };
  const headline = formatMessage("pose wrong", { arm: arm.name, off });
  return { ...shared, headline, findings: listWrongEntries(T, judged.wrong) };
}

// Return the finding that a single joint is off, if its change alone takes the tip to a target of
// numbers. There is none if the change of a second joint does so too.
/** @returns {import("../verdict.js").Finding[]} */
function locateWrongJoint(q, arm, T, typed, makeExpected) {
  const [x, y, z] = [0, 1, 2].map((k) => T.values.map((row) => row[k]));
  const goal = T.pose
    ? { point: T.values.map((row) => row[3]), tool: { x, y, z, o: [0, 0, 0] } }
    : { point: T.values[0], tool: null };
  const configurations = T.formulas ? [] : listConfigurationsWithOneChange(arm, q.values, goal);
  const findings = configurations.flatMap((values, k) => {
    const slack = computeSlack({ ...q, values }, values.length, makeExpected);
    if (!agrees(typed, makeExpected(values), slack)) return [];
    const joint = jointNames(arm)[k];
    const off = formatNumber(Math.abs(values[k] - q.values[k]), 2);
    const unit = revoluteFlags(arm)[k] ? "rad" : "m";
    return [makeFinding("joint", formatMessage("pose joint", { joint, off, unit }), joint)];
  });
  return findings.length === 1 ? findings : [];
}

/**
 * Return the units of a target's numbers. A number with a coarse last place is exact, since a
 * question gives 0.4 m. Beside finer numbers it has their unit, since a program left off its zeros.
 * @param {number[]} typedUnits
 */
function findTargetUnits(typedUnits) {
  const fineUnits = typedUnits.filter((unit) => unit && unit < FINE_UNIT);
  const finest = fineUnits.length ? Math.min(...fineUnits) : 0;
  return typedUnits.map((unit) => (unit < FINE_UNIT ? unit : finest));
}

// Describe how far the tip is from the target. An angle is given only if an entry of the rotation
// is wrong; that of a point is 0.
function describeTargetMiss(T, wrong, distance, angle) {
  const isRotationWrong = wrong.some((isWrong, i) => isWrong && i % 4 < 3);
  return describeMiss(distance, isRotationWrong ? angle : 0);
}

// Return a maker of the entries that a target at the tip has. `correct` undoes a mistake in the
// joint values, `change` puts a mistake into the arm's table, and `write` into the target.
/** @returns {import("../causes/ranking.js").Maker} */
const makeTipMaker =
  (arm, T) =>
  ({ correct = keep, change = keep, write = keep } = {}) =>
  (q) => {
    const tip = chainFrames(change(makeChain(arm, correct(q)))).at(-1);
    return write(T.pose ? frameMatrix(tip).slice(0, 3).flat() : tip.o);
  };

/** @returns {import("../causes/ranking.js").Step[]} */
function listTipSteps(arm, T) {
  const isPosition = (i) => !T.pose || i % 4 === 3;
  const changeRotation = (change) => (rows) =>
    rows.map((x, i) => (isPosition(i) ? x : change(rows, Math.floor(i / 4), i % 4)));
  const inMillimetres = (rows) => rows.map((x, i) => (isPosition(i) ? 1000 * x : x));
  return [
    ...listJointMistakes(arm),
    ...listTableMistakes(arm),
    { cause: makeCause("pose.millimetres"), write: inMillimetres }, // slip 26 of the book
    {
      cause: makeCause("pose.transposed"), // slip 4
      write: changeRotation((R, i, j) => R[4 * j + i]),
    },
    {
      cause: makeCause("pose.half turn"), // slip 18
      write: changeRotation((R, i, j) => R[4 * i + j] * (j === 2 ? 1 : -1)),
    },
  ];
}

// Return the distance (m) and angle (rad) between the tip and T. The angle is 0 for a point and
// half a turn for left-handed axes.
/** @returns {[number, number]} */
function measureTargetMiss(tip, { values, pose }) {
  const o = pose ? values.map((row) => row[3]) : values[0];
  const distance = norm(minus(tip.o, o));
  if (!pose) return [distance, 0];
  const [x, y, z] = [0, 1, 2].map((k) => values.map((row) => row[k]));
  return [distance, dot(cross(x, y), z) > 0 ? rotationBetween(tip, { x, y, z, o }) : Math.PI];
}

// List the wrong entries of T if they are few. For a point, only a single wrong formula is listed.
function listWrongEntries(T, wrong) {
  const indices = wrong.flatMap((isWrong, i) => (isWrong ? [i] : []));
  if (!T.pose && (!T.formulas || indices.length !== 1)) return [];
  if (indices.length > MOST_LISTED) return [];
  return indices.map((i) => {
    const [row, column] = [Math.floor(i / 4) + 1, (i % 4) + 1];
    const where = T.pose ? formatMessage("entry", { row, column }) : "xyz"[i];
    const words = formatMessage(T.pose ? "pose entry" : "pose coordinate", {
      row,
      column,
      axis: "xyz"[i],
    });
    return { what: "entry", where, words };
  });
}

function* noteBeyondLimits(arm, { values }) {
  const rows = movingRows(arm).map((row) => arm.rows[row]);
  const beyond = jointNames(arm).filter((_, k) => isOutsideLimits(rows[k], values[k]));
  if (beyond.length) yield formatMessage("beyond limits", { joints: joinList(beyond) });
}
