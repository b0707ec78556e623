// Judges a joint trajectory by whether its tip follows the path and how its joints move.

import { completeVerdicts, makeFinding, makeVerdict } from "../verdict.js";
import { reportBeginning } from "./beginning.js";
import { askAboutDegrees } from "./degrees.js";
import {
  cross,
  dot,
  movingRows,
  linkFrames,
  minus,
  norm,
  rotationBetween,
} from "../geometry/kinematics.js";
import { DEG } from "../geometry/angles.js";
import { RIGHT, WRONG } from "../digits.js";
import { JOINT_NAMES, jointShapes, numbers } from "../reading/numbers.js";
import { formatMillimetres } from "../matching.js";
import { makeCause, causeName, causeMessage } from "../causes/ranking.js";
import {
  findJumps,
  findSingularStart,
  listNotes,
  measureStep,
  removeWholeTurns,
} from "./trace_steps.js";
import { arrangeBySteps, convertToSI } from "./trace_layout.js";
import { describeWrongRow, findOnlyWrongRow } from "./trace_row.js";
import { boundTipError, isDriftOfEuler, findUntrimmedUnits } from "./trace_units.js";
import { findUnfilledRow } from "../reading/unfilled.js";
import { ArmError, uncapitalize, formatMessage, formatNumber, quoteText } from "../sentences.js";
import {
  followsPathByEuler,
  makeTrace,
  METHOD_TILT,
  findTraceCause,
  METHOD_ERROR,
} from "../causes/trace.js";

/** @typedef {import("../geometry/arm.js").Arm} Arm */

const INDEPENDENT_CAUSES = ["trace.one more", "trace.jump"]; // named beside any other mistake
const FEWEST_STEPS = 2; // rows of a trajectory whose last rows are missing
const SAME_ERROR = 1e-9; // m: errors that differ by less are equal

/** @typedef {import("../geometry/path.js").Path} Path */
/** @typedef {import("../verdict.js").Finding} Finding */
/** @typedef {import("./trace_layout.js").Trajectory} Trajectory */
/**
 * Judge joint vectors along a path.
 * @param {string | any[]} mine text such as CSV, or nested lists
 * @param {Arm} arm
 * @param {Path} path
 * @returns {import("../verdict.js").Verdict}
 */
export function compareTrace(mine, arm, path, options = {}) {
  const typed = readTrace(mine, arm, options.which);
  return { ...judgeTrace(typed, arm, path, options), typed };
}

/**
 * Return the joint values as typed, before any correction.
 * @throws {ArmError} if a line between the rows has no numbers yet
 */
export function readTrace(mine, arm, which = null) {
  const unfilled = typeof mine === "string" ? findUnfilledRow(mine) : null;
  if (unfilled !== null)
    throw new ArmError(formatMessage("unfilled row", { line: quoteText(unfilled.trim()) }));
  return numbers(mine, `${arm.name}: your joints`, undefined, undefined, {
    wants: jointShapes(arm)
      .filter(({ rows, columns }) => rows === null || columns === null)
      .map((want) => ({ ...want, largest: true })),
    names: JOINT_NAMES,
    which,
  });
}

/**
 * Judge joint values as `readTrace` returns them.
 * @param {import("../reading/numbers.js").Typed} typed @param {Arm} arm @param {Path} path
 * @returns {import("../verdict.js").Verdict}
 */
export const judgeTrace = completeVerdicts(judgeTypedTrace);

function judgeTypedTrace(typed, arm, path, options = {}) {
  const { angles = "rad", tolerance = null } = options;
  const typedUnit = typed.statedUnits?.angles ?? angles;
  const arranged = arrangeBySteps(typed, arm, path.times.length, typedUnit);
  if (!arranged)
    return judgeTooFewSteps(typed, arm, path, options) ?? reportWrongShape(typed, arm, path);
  const trajectory = { ...arranged, units: findUntrimmedUnits(arranged, arm, path) };
  const { q, units, unit, taken } = trajectory;
  const allowed = q.map((row, k) => tolerance ?? METHOD_ERROR + boundTipError(row, units[k], arm));
  if (unit === "rad" && followsOnlyInDegrees(trajectory, arm, path, allowed))
    return reportCause(arm, makeCause("trace.degrees"), [], taken, {});
  const verdict = judgeTrajectory(trajectory, arm, path, allowed, tolerance !== null);
  return askAboutDegrees(verdict, {
    arm,
    values: q.flat(),
    angles: unit,
    keys: { deg: "trace.degrees", rad: "trace.radians" },
    judgeIn: (unit) => judgeTypedTrace(typed, arm, path, { ...options, angles: unit }),
    makeHeadline: (cause) => formatMessage("trace wrong", { arm: arm.name, cause: `${cause}.` }),
  });
}

// Judge the first rows of a trajectory whose last rows are missing. Refuse a trajectory with gaps
// between its rows. Return null if the rows leave the path, turn the tool or jump.
function judgeTooFewSteps(typed, arm, path, { angles = "rad", tolerance = null }) {
  const count = typed.shape[0];
  const all = path.times.length;
  const arranged = arrangeFirstPart(typed, arm, all, angles);
  if (!arranged) return null;
  const { q, units, taken } = arranged;
  const firstPart = { ...path, times: path.times.slice(0, count) };
  const allowed = q.map((row, k) => tolerance ?? METHOD_ERROR + boundTipError(row, units[k], arm));
  const frames = q.map((row) => linkFrames(arm, row).at(-1));
  const errors = measureDistances(
    firstPart.times.map(path.position),
    frames.map(({ o }) => o),
  );
  const isTurned = movingRows(arm).length >= 6 && measureToolTurns(frames)[0] > METHOD_TILT;
  if (exceedsAllowed(errors, allowed) && liesOnPath(frames, path, allowed))
    throw new ArmError(formatMessage("trace rows left out", { count, all }));
  if (isTurned || exceedsAllowed(errors, allowed) || findJumps(q, arm, firstPart).length)
    return null;
  const headline = formatMessage("trace so far", { arm: arm.name, count, all });
  return reportBeginning("trace", arm, headline, `steps ${count} to ${all - 1}`, {
    taken,
    figures: { position_error: Math.max(...errors), q },
  });
}

// Arrange the rows of the first steps. Return null if there are too few rows, or if at most a
// single row is missing.
function arrangeFirstPart(typed, arm, all, angles) {
  const count = typed.shape[0];
  if (count < FEWEST_STEPS || count >= all - 1) return null;
  return arrangeBySteps(typed, arm, count, typed.statedUnits?.angles ?? angles);
}

// Return whether each row reaches a point of the path, later than the row before.
function liesOnPath(frames, path, allowed) {
  const points = path.times.map(path.position);
  let step = 0;
  return frames.every(({ o }, k) => {
    while (step < points.length && norm(minus(o, points[step])) > allowed[k]) step++;
    return step++ < points.length;
  });
}

// Return whether the joint values follow the path in degrees and not in radians.
function followsOnlyInDegrees({ q, units }, arm, path, allowed) {
  const points = path.times.map(path.position);
  const measureTipErrors = (rows) =>
    measureDistances(
      points,
      rows.map((row) => linkFrames(arm, row).at(-1).o),
    );
  if (!exceedsAllowed(measureTipErrors(q), allowed)) return false;
  const rows = q.map((values, k) => ({ values, units: units[k] }));
  const converted = convertToSI(rows, arm, null, "deg");
  const errors = measureTipErrors(converted.q);
  if (!exceedsAllowed(errors, allowed)) return true;
  const follows = (trajectory) =>
    followsPathByEuler(makeTrace(trajectory.q, trajectory.units, arm, path));
  return errors[0] <= allowed[0] && follows(converted) && !follows({ q, units });
}

const exceedsAllowed = (errors, allowed) => errors.some((error, k) => error > allowed[k]);

// Return the distance of each point from the path's point at the same time.
const measureDistances = (pathPoints, points) =>
  points.map((point, k) => norm(minus(point, pathPoints[k])));

/** @returns {import("../verdict.js").Verdict} */
function makeTraceVerdict(arm, grade, cause, taken, rest = {}) {
  const key = grade === RIGHT ? "trace right" : "trace wrong";
  const headline = formatMessage(key, { arm: arm.name, cause });
  return makeVerdict("trace", arm, grade, headline, { taken, ...rest });
}

function reportWrongShape({ shape }, arm, { times }) {
  const fields = { shape: shape.join("x") || "1", rows: times.length, dof: movingRows(arm).length };
  const words = formatMessage("trace.shape", fields);
  const findings = [{ what: "shape", where: "", mine: shape, words }];
  return makeTraceVerdict(arm, WRONG, uncapitalize(words), [], {
    findings,
    causes: ["trace.shape"],
  });
}

/**
 * Judge a trajectory.
 * @param {Trajectory} trajectory
 * @param {Arm} arm
 * @param {Path} path
 * @param {number[]} allowed largest error of the tip at each step (m)
 * @param {boolean} hasTolerance whether the question gives the allowed error, so that a trajectory
 *   within it is right by whatever method
 * @returns {import("../verdict.js").Verdict}
 */
function judgeTrajectory(trajectory, arm, path, allowed, hasTolerance) {
  const [q, turnNotes] = removeWholeTurns(trajectory.q, arm, path);
  const frames = q.map((row) => linkFrames(arm, row).at(-1));
  const motion = { q, turnNotes, frames };
  return (
    judgeOnlyWrongRow({ ...trajectory, q }, frames, arm, path, allowed) ??
    judgeMotion(trajectory, motion, { arm, path, allowed, hasTolerance })
  );
}

// Judge a trajectory by its motion, which is its joint values without whole turns and the frames of
// its tip.
function judgeMotion(trajectory, { q, turnNotes, frames }, { arm, path, allowed, hasTolerance }) {
  const tip = frames.map(({ o }) => o);
  const errors = measureDistances(path.times.map(path.position), tip);
  const isOff = exceedsAllowed(errors, allowed);
  const [turn, lean] = movingRows(arm).length >= 6 ? measureToolTurns(frames) : [0, 0];
  const jumps = findJumps(q, arm, path);
  const singularStart = findSingularStart(q, arm, jumps);
  const jump = singularStart || !jumps.length ? [] : [describeJump(q, arm, jumps, !isOff)];
  const motionSymptoms = [
    ...(isOff ? [makeFinding("step", describeWorstStep(errors, allowed))] : []),
    ...jump,
    ...listToolTurns(lean, turn),
  ];
  const symptoms = [...motionSymptoms, ...listExtraStep(trajectory)];
  const findCause = () => {
    const trace = makeTrace(q, trajectory.units, arm, path, trajectory.q);
    return findTraceCause(trace, tip, allowed, { isOff, hasSymptoms: motionSymptoms.length > 0 });
  };
  const cause = singularStart ?? (symptoms.length || !hasTolerance ? findCause() : null);
  const notes = [...turnNotes, ...(singularStart ? [] : listNotes(arm, path, q))];
  const figures = { position_error: Math.max(...errors), tool_turn: turn, q };
  const rest = { notes, figures };
  if (cause) {
    const unexplained = dropExplainedJumps(cause, symptoms, jump);
    return reportCause(arm, cause, unexplained, trajectory.taken, rest);
  }
  const mayDrift = isOff && !hasTolerance && !jump.length;
  return reportWithoutCause({ ...trajectory, q }, path, { arm, symptoms, errors, mayDrift, rest });
}

// Return the verdict on a trajectory without a known mistake. It may have the drift of Euler's
// method, symptoms only, or nothing wrong.
function reportWithoutCause(trajectory, path, { arm, symptoms, errors, mayDrift, rest }) {
  const { taken, hasExtraStep } = trajectory;
  if (mayDrift && !hasExtraStep && isDriftOfEuler(trajectory, arm, path, errors[0]))
    return acceptEulerDrift(arm, errors, taken, rest);
  if (symptoms.length) return reportSymptoms(arm, symptoms, taken, rest);
  return makeTraceVerdict(arm, RIGHT, "", taken, rest);
}

// Accept the drift of Euler's method, since the method gives these joint values with the student's
// steps.
function acceptEulerDrift(arm, errors, taken, rest) {
  const fields = { error: formatMillimetres(Math.max(...errors), 4), steps: errors.length - 1 };
  const notes = [...rest.notes, formatMessage("trace euler drift", fields)];
  const headline = formatMessage("trace right by euler", { arm: arm.name });
  return makeVerdict("trace", arm, RIGHT, headline, { taken, ...rest, notes });
}

const listExtraStep = ({ hasExtraStep }) =>
  hasExtraStep ? [makeFinding("trace.one more", formatMessage("trace.one more"))] : [];

// Do not report jumps if all steps are too long, or if a mistake in the joint values makes them.
const dropExplainedJumps = (cause, symptoms, jump) =>
  causeName(cause) === "trace.millimetres" || cause.keys[0].startsWith("ik.")
    ? symptoms.filter((symptom) => !jump.includes(symptom))
    : symptoms;

function reportCause(arm, cause, symptoms, taken, rest) {
  const words = causeMessage(cause);
  const findings = [{ what: "cause", where: "", words: `${words}.` }, ...symptoms];
  const kinds = symptoms.map(({ what }) => what);
  const causes = [causeName(cause), ...kinds.filter((kind) => INDEPENDENT_CAUSES.includes(kind))];
  return makeTraceVerdict(arm, WRONG, `${uncapitalize(words)}.`, taken, {
    findings,
    causes,
    ...rest,
  });
}

// Judge a trajectory with a single wrong row, or return null. A wrong first or last row may belong
// to a jump, unless the change of one joint puts it right.
function judgeOnlyWrongRow(trajectory, frames, arm, path, allowed) {
  const wrongRow = findOnlyWrongRow(trajectory, arm, path, frames, allowed);
  if (!wrongRow || trajectory.hasExtraStep) return null;
  const { row, correction } = wrongRow;
  const isInside = row > 0 && row < frames.length - 1;
  return isInside || correction ? reportWrongRow(arm, wrongRow, trajectory, path) : null;
}

/** @param {import("./trace_row.js").WrongRow} wrongRow */
function reportWrongRow(arm, wrongRow, trajectory, path) {
  const { row, distance, angle, correction } = wrongRow;
  const { q, taken, isPerJoint } = trajectory;
  const isWrong = (k, i) => k === row && (!correction || i === correction.index);
  const wrong = q.flatMap((values, k) => values.map((_, i) => isWrong(k, i)));
  const corrected = q.map((values, k) =>
    values.map((x, i) => (correction && isWrong(k, i) ? correction.value : x)),
  );
  const words = describeWrongRow(wrongRow, q[row], arm);
  return makeTraceVerdict(arm, WRONG, uncapitalize(words), taken, {
    findings: [makeFinding("step", words, `step ${row}`)],
    notes: correction ? [...listNotes(arm, path, corrected)] : [],
    figures: { position_error: distance, tool_turn: angle, q },
    ...(isPerJoint ? {} : { wrong }),
  });
}

function reportSymptoms(arm, symptoms, taken, rest) {
  const [first, ...others] = symptoms;
  const findings = [{ ...first, what: "cause" }, ...others];
  const causes = symptoms.map(({ what }) => what).filter((what) => what.includes("."));
  return makeTraceVerdict(arm, WRONG, uncapitalize(first.words), taken, {
    findings,
    causes,
    ...rest,
  });
}

// Return the largest rotation of the tool from its first frame, and the largest angle of its z axis
// from its first direction (rad).
const measureToolTurns = (frames) => [
  Math.max(...frames.map((frame) => rotationBetween(frames[0], frame))),
  Math.max(...frames.map(({ z }) => measureAngle(z, frames[0].z))),
];

function listToolTurns(lean, turn) {
  const formatDegrees = (angle) => ({ degrees: formatNumber(angle * DEG) });
  if (lean > METHOD_TILT)
    return [makeFinding("trace.leans", formatMessage("trace leans", formatDegrees(lean)))];
  return turn > METHOD_TILT
    ? [makeFinding("trace.spins", formatMessage("trace spins", formatDegrees(turn)))]
    : [];
}

// Return the angle between two unit vectors (rad).
const measureAngle = (u, v) => Math.atan2(norm(cross(u, v)), dot(u, v));

// Report the first jump. It leads to a different branch only if the tip stays on the path.
/** @returns {Finding} */
function describeJump(q, arm, jumps, isOnPath) {
  const { step, ...fields } = measureStep(q, arm, jumps[0]);
  const key = isOnPath ? "trace.jump" : "trace jump off";
  const words = formatMessage(key, { step, to: step + 1, count: jumps.length, ...fields });
  return makeFinding("trace.jump", words, `step ${step}`);
}

// Report the step with the tip's largest error, among the steps that exceed the allowed error.
function describeWorstStep(errors, allowed) {
  const excesses = errors.map((error, k) => (error > allowed[k] ? error : 0));
  const most = Math.max(...excesses);
  const step = excesses.findIndex((error) => error >= most - SAME_ERROR);
  const start =
    errors[0] > 0.5 * most ? formatMessage("already") : `${formatMillimetres(errors[0])} mm`;
  return formatMessage("trace where", {
    error: formatMillimetres(most, 4),
    step,
    steps: errors.length - 1,
    start,
  });
}
