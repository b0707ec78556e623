// Judges whether joint values reach a target: the target's entries are compared with the tip's.

import { listExchangedDigits, listJointMistakes } from "../causes/joints.js";
import { combineCauses, makeCause, causeName, joinCauseMessages } from "../causes/ranking.js";
import { listTableMistakes } from "../causes/chain.js";
import { agrees, RIGHT, ROUNDED, slackOf, SO_FAR, WRONG } from "../digits.js";
import { judgeEntries } from "../entries.js";
import { makeChain, chainFrames } from "../geometry/chains.js";
import { findClosedForm, needsPose } from "../geometry/inverse.js";
import { orthonormalize, solveTarget } from "../geometry/target.js";
import {
  cross,
  dot,
  frameMatrix,
  minus,
  norm,
  jointNames,
  jointNumbers,
  rotationBetween,
} from "../geometry/kinematics.js";
import { describeMiss } from "../matching.js";
import { answers } from "../reading/joint_vectors.js";
import { jointShapes, lookup, numbers, rowsGiven } from "../reading/numbers.js";
import { completeVerdicts, makeVerdict } from "../verdict.js";
import { askAboutDegrees } from "./degrees.js";
import {
  ArmError,
  describeShape,
  formatMessage,
  joinList,
  tryOrNull,
  uncapitalize,
} from "../sentences.js";
import { judgeFirstAngles, judgeWholeOrPart } from "./first_joints.js";

const TARGETS = [
  { rows: 4, columns: 4 },
  { rows: 3, columns: 4 },
  { rows: 1, columns: 3 },
  { rows: 3, columns: 1 },
];
const FEW = 3; // wrong entries: a wrong q changes more of them

/** @typedef {import("../reading/joint_vectors.js").Answer} Answer */
/**
 * A target: the rows of a pose, or one row for a point; `formulas` is true if some were typed.
 * @typedef {{ values: number[][], units: number[][], pose: boolean, formulas: boolean }} Target
 */

/**
 * Judge whether a joint vector, a text or nested lists, takes the tip to T, a pose (4, 4) or a
 * point (3,).
 * @returns {import("../verdict.js").Verdict}
 */
export const comparePose = completeVerdicts(poseCompared);

function poseCompared(q, arm, T, options = {}) {
  return judgeWholeOrPart(
    () => judgeJoints(q, arm, T, options),
    () => judgeFirstJoints(q, arm, T, options),
  );
}

function judgeJoints(q, arm, T, { angles = "rad", tolerance = null, which = null }) {
  const wants = jointShapes(arm, false);
  const read = answers(q, arm, angles, { wants, given: rowsGiven(T), which });
  const { answers: given, taken, typed } = read;
  if (given.length !== 1)
    throw new ArmError(formatMessage("one answer", { arm: arm.name, count: given.length }));
  const known = lookup(arm, given[0].values);
  const target = readTarget(T, arm, known);
  const units = target.formulas ? given[0].units.map(() => 0) : given[0].units;
  const verdict = judgeTarget({ ...given[0], units }, arm, target, tolerance, taken);
  const [away, turned] = measureTargetMiss(
    chainFrames(makeChain(arm, given[0].values)).at(-1),
    target,
  );
  const off = describeMiss(away, turned);
  const answer = askAboutDegrees(verdict, {
    arm,
    values: given[0].values,
    angles,
    key: "ik.degrees",
    judgeInDegrees: () => judgeJoints(q, arm, T, { angles: "deg", tolerance, which }),
    makeHeadline: (cause) => formatMessage("pose cause", { arm: arm.name, off, cause }),
  });
  return { ...answer, typed };
}

// Judge the angles of the first joints alone, if the arm has a closed form for such targets.
function judgeFirstJoints(q, arm, T, { angles = "rad", tolerance = null }) {
  const form = findClosedForm(arm);
  const target = tryOrNull(() => readTarget(T, arm, undefined));
  if (!form || target?.pose !== needsPose(form)) return null;
  const values = target.pose ? orthonormalize(target.values) : target.values[0];
  const branches = tryOrNull(() => solveTarget(arm, values)) ?? [];
  const right = { arm, branches, count: branches.length };
  const question = { topic: "pose", angles, tolerance, given: rowsGiven(T), many: false };
  return judgeFirstAngles(q, right, question);
}

/**
 * Read a typed target: a pose or, if allowed, a point.
 * @returns {Target}
 */
export function readTarget(T, arm, known, orPoint = true) {
  const what = `${arm.name}: the target`;
  const wanted = formatMessage(orPoint ? "a point or a pose" : "a pose");
  const { values, units, shape, symbolic } = numbers(T, what, known, wanted, { wants: TARGETS });
  const form = shape.filter((n) => n !== 1).join("x");
  const pose = form === "4x4" || form === "3x4";
  if (!pose && !(orPoint && form === "3"))
    throw new ArmError(formatMessage("pose shape", { what, given: describeShape(shape), wanted }));
  const rows = (list) => (pose ? [0, 1, 2].map((i) => list.slice(4 * i, 4 * i + 4)) : [list]);
  return { values: rows(values), units: rows(units), pose, formulas: symbolic };
}

/** @returns {import("../verdict.js").Verdict} */
function judgeTarget(q, arm, T, tolerance, taken) {
  const mine = { values: T.values.flat(), units: T.units.flat() };
  const right = tipOf(arm, T);
  const slips = [...known(arm, T)];
  const digits = () =>
    listExchangedDigits(arm, q).map(([cause, undo]) => ({ cause, make: (x) => right(undo(x)) }));
  const further = [digits, () => listMistakePairs(arm, T)];
  const asked = { mine, q, dof: q.values.length, right, slips, tolerance, further };
  const verdict = judgeEntries(asked);
  const coarse = slackOf(q, q.values.length, right, Infinity);
  const truth = right(q.values);
  const wrong = verdict.grade === WRONG;
  const few = wrong && tolerance === null && !verdict.slips.length && agrees(mine, truth, coarse);
  const grade = few ? SO_FAR : verdict.grade;
  const here = chainFrames(makeChain(arm, q.values)).at(-1);
  const [away, turned] = measureTargetMiss(here, T);
  const rest = { taken, figures: { position_error: away, orientation_error: turned } };
  if (grade !== WRONG)
    return makePoseVerdict(arm, grade, formatMessage(GOOD[grade], { arm: arm.name }), {
      ...rest,
      notes: [...noteBeyondLimits(arm, q)],
    });
  const off = describeTargetMiss(T, verdict.wrong, away, turned);
  if (!verdict.slips.length) {
    const findings = listWrongEntries(T, verdict.wrong);
    const headline = formatMessage("pose wrong", { arm: arm.name, off });
    const causes = [...new Set(findings.map(({ what }) => what))];
    return makePoseVerdict(arm, WRONG, headline, { ...rest, findings, causes });
  }
  const causes = verdict.slips.map((slip) => slip.cause);
  const words = joinCauseMessages(causes);
  const headline = formatMessage("pose cause", { arm: arm.name, off, cause: uncapitalize(words) });
  const findings = [{ what: "cause", where: "", words: `${words}.` }];
  return makePoseVerdict(arm, WRONG, headline, {
    ...rest,
    findings,
    causes: causes.map(causeName),
  });
}

const GOOD = { [RIGHT]: "pose right", [ROUNDED]: "pose rounded", [SO_FAR]: "pose so far" };
const makePoseVerdict = (arm, grade, headline, fields) =>
  makeVerdict("pose", arm, grade, headline, fields);

function describeTargetMiss(T, wrong, away, turned) {
  const tilted = T.pose && wrong.some((is, i) => is && i % 4 < 3);
  return describeMiss(away, tilted ? turned : 0);
}

// Return a function from q to the target's entries at the tip, for a table with a mistake.
const tipOf =
  (arm, T, change = (c) => c) =>
  (q) => {
    const tip = chainFrames(change(makeChain(arm, q))).at(-1);
    return T.pose ? frameMatrix(tip).slice(0, 3).flat() : tip.o;
  };

/** @returns {Generator<import("../causes/ranking.js").Mistake>} */
function* known(arm, T) {
  const right = tipOf(arm, T);
  for (const [one, mended] of listJointMistakes(arm))
    yield { cause: one, make: (q) => right(mended(q)) };
  for (const [one, change] of listTableMistakes(arm))
    yield { cause: one, make: tipOf(arm, T, change) };
  const place = (i) => !T.pose || i % 4 === 3;
  const long = (q) => right(q).map((x, i) => (place(i) ? 1000 * x : x));
  yield { cause: makeCause("pose.millimetres"), make: long }; // slip 26
  if (!T.pose) return;
  const rotation = (change) => (q) => {
    const rows = right(q);
    return rows.map((x, i) => (place(i) ? x : change(rows, Math.floor(i / 4), i % 4)));
  };
  // slip 4
  yield { cause: makeCause("pose.transposed"), make: rotation((R, i, j) => R[4 * j + i]) };
  const turned = rotation((R, i, j) => R[4 * i + j] * (j === 2 ? 1 : -1));
  yield { cause: makeCause("pose.half turn"), make: turned }; // slip 18
}

// Combine a mistake in the joint values with one in the table.
/** @returns {Generator<import("../causes/ranking.js").Mistake>} */
function* listMistakePairs(arm, T) {
  for (const [table, change] of listTableMistakes(arm)) {
    const tip = tipOf(arm, T, change);
    for (const [joints, mended] of listJointMistakes(arm))
      yield { cause: combineCauses(table, joints), make: (q) => tip(mended(q)) };
  }
}

// Return the distance (m) and angle (rad) between a frame and T: no angle for a point, half a turn
// for left-handed axes.
/** @returns {[number, number]} */
function measureTargetMiss(here, { values, pose }) {
  const o = pose ? values.map((row) => row[3]) : values[0];
  const away = norm(minus(here.o, o));
  if (!pose) return [away, 0];
  const [x, y, z] = [0, 1, 2].map((k) => values.map((row) => row[k]));
  return [away, dot(cross(x, y), z) > 0 ? rotationBetween(here, { x, y, z, o }) : Math.PI];
}

// The entries of T that differ, where they are few, or the coordinate of a point in formulas.
function listWrongEntries(T, wrong) {
  const off = wrong.flatMap((is, i) => (is ? [i] : []));
  if (!T.pose && (!T.formulas || off.length !== 1)) return [];
  if (off.length > FEW) return [];
  return off.map((i) => {
    const [row, column] = [Math.floor(i / 4) + 1, (i % 4) + 1];
    const where = T.pose ? formatMessage("entry", { row, column }) : "xyz"[i];
    const words = formatMessage(T.pose ? "pose.entry" : "pose.coordinate", {
      row,
      column,
      axis: "xyz"[i],
    });
    return { what: T.pose ? "pose.entry" : "pose.coordinate", where, words };
  });
}

function* noteBeyondLimits(arm, { values }) {
  const beyond = jointNumbers(arm).flatMap((row, k) => {
    const { lower: least, upper: most } = arm.rows[row - 1];
    const inside = (least ?? -Infinity) <= values[k] && values[k] <= (most ?? Infinity);
    return inside ? [] : [jointNames(arm)[k]];
  });
  if (beyond.length) yield formatMessage("beyond limits", { joints: joinList(beyond) });
}
