// Judges a joint trajectory by whether its tip follows the path and how its joints move.

import { makeFinding } from "../verdict.js";
import { describeBeginning } from "./beginning.js";
import { makeJudge } from "./frame.js";
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
import { causeName } from "../causes/ranking.js";
import {
  findJumps,
  findSingularStart,
  listNotes,
  measureStep,
  removeWholeTurns,
} from "./trace_steps.js";
import { arrangeBySteps } from "./layout.js";
import { describeWrongRow, findOnlyWrongRow } from "./trace_row.js";
import { boundTipError, isDriftOfEuler, findUntrimmedUnits } from "./trace_units.js";
import { findUnfilledRow } from "../reading/unfilled.js";
import { ArmError, formatMessage, formatNumber, quoteText, toClause } from "../sentences.js";
import { makeTrace, METHOD_TILT, findTraceCause, METHOD_ERROR } from "../causes/trace.js";

/** @typedef {import("../geometry/arm.js").Arm} Arm */

const INDEPENDENT_CAUSES = ["trace.one more", "trace.jump"]; // named beside any other mistake
const FEWEST_STEPS = 2; // rows of a trajectory whose last rows are missing
const SAME_ERROR = 1e-9; // m: errors that differ by less are equal

/** @typedef {import("../geometry/path.js").Path} Path */
/** @typedef {import("../verdict.js").Finding} Finding */
/** @typedef {import("./layout.js").Trajectory} Trajectory */
/** Judge joint vectors, a text such as CSV or nested lists, along a path. */
export const compareTrace = makeJudge({
  name: "trace",
  sentences: { [RIGHT]: "trace right", wrong: "trace wrong" },
  otherUnit: { deg: "trace.degrees", rad: "trace.radians" },
  ask: (arm, path, options) => ({ angles: "rad", tolerance: null, ...options, arm, path }),
  read(mine, { arm, path, angles, which, stated }) {
    const typed = readTrace(mine, arm, which, stated);
    const unit = typed.statedUnits?.angles ?? angles;
    const arranged = arrangeBySteps(typed, arm, path.times.length, unit);
    return { typed, unit, arranged };
  },
  compare({ typed, unit, arranged }, question) {
    const { arm, path, tolerance } = question;
    if (!arranged)
      return compareFirstSteps(typed, unit, question) ?? describeWrongShape(typed, arm, path);
    const { q, taken } = arranged;
    const units = findUntrimmedUnits(arranged, arm, path);
    const allowed = boundTipErrors({ q, units }, question);
    const trajectory = { ...arranged, units };
    return { ...compareTrajectory(trajectory, arm, path, allowed, tolerance !== null), taken };
  },
  getAngles: ({ unit, arranged }) => arranged && { values: arranged.q.flat(), angles: unit },
  listBeginnings: () => [],
});

/**
 * Return the joint values as typed, before any correction.
 * @throws {ArmError} if a line between the rows has no numbers yet
 */
export function readTrace(mine, arm, which = null, stated = undefined) {
  const unfilled = typeof mine === "string" ? findUnfilledRow(mine) : null;
  if (unfilled !== null)
    throw new ArmError(formatMessage("unfilled row", { line: quoteText(unfilled.trim()) }));
  return numbers(mine, `${arm.name}: your joints`, undefined, undefined, {
    wants: jointShapes(arm)
      .filter(({ rows, columns }) => rows === null || columns === null)
      .map((want) => ({ ...want, largest: true })),
    names: JOINT_NAMES,
    which,
    stated,
  });
}

// Return the largest allowed error of the tip at each step (m).
const boundTipErrors = ({ q, units }, { arm, tolerance }) =>
  q.map((row, k) => tolerance ?? METHOD_ERROR + boundTipError(row, units[k], arm));

// Compare the first rows of a trajectory whose last rows are missing. Refuse a trajectory with gaps
// between its rows. Return null if the rows leave the path, turn the tool or jump, or if at most a
// single row is missing.
/** @returns {import("./frame.js").Outcome | null} */
function compareFirstSteps(typed, unit, question) {
  const { arm, path } = question;
  const [count, all] = [typed.shape[0], path.times.length];
  const isFirstPart = count >= FEWEST_STEPS && count < all - 1;
  const arranged = isFirstPart ? arrangeBySteps(typed, arm, count, unit) : null;
  if (!arranged) return null;
  const { q, taken } = arranged;
  const firstPart = { ...path, times: path.times.slice(0, count) };
  const allowed = boundTipErrors(arranged, question);
  const frames = q.map((row) => linkFrames(arm, row).at(-1));
  const errors = measureDistances(
    firstPart.times.map(path.position),
    frames.map(({ o }) => o),
  );
  const isTurned = measureToolTurns(frames, arm)[0] > METHOD_TILT;
  if (exceedsAllowed(errors, allowed) && liesOnPath(frames, path, allowed))
    throw new ArmError(formatMessage("trace rows left out", { count, all }));
  if (isTurned || exceedsAllowed(errors, allowed) || findJumps(q, arm, firstPart).length)
    return null;
  const headline = formatMessage("trace so far", { arm: arm.name, count, all });
  const figures = { position_error: Math.max(...errors), q };
  return describeBeginning(headline, `steps ${count} to ${all - 1}`, { taken, figures });
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

const exceedsAllowed = (errors, allowed) => errors.some((error, k) => error > allowed[k]);

// Return the distance of each point from the path's point at the same time.
const measureDistances = (pathPoints, points) =>
  points.map((point, k) => norm(minus(point, pathPoints[k])));

/** @returns {import("./frame.js").Outcome} */
function describeWrongShape({ shape }, arm, { times }) {
  const fields = { shape: shape.join("x") || "1", rows: times.length, dof: movingRows(arm).length };
  const findings = [{ ...makeFinding("shape", formatMessage("trace.shape", fields)), mine: shape }];
  return { grade: WRONG, findings, causeNames: ["trace.shape"] };
}

/**
 * Compare a trajectory with its path.
 * @param {Trajectory} trajectory
 * @param {Arm} arm
 * @param {Path} path
 * @param {number[]} allowed largest error of the tip at each step (m)
 * @param {boolean} hasTolerance whether the question gives the allowed error, so that a trajectory
 *   within it is right by whatever method
 * @returns {import("./frame.js").Outcome}
 */
function compareTrajectory(trajectory, arm, path, allowed, hasTolerance) {
  const [q, turnNotes] = removeWholeTurns(trajectory.q, arm, path);
  const frames = q.map((row) => linkFrames(arm, row).at(-1));
  const motion = { q, turnNotes, frames };
  return (
    compareOnlyWrongRow({ ...trajectory, q }, frames, arm, path, allowed) ??
    compareMotion(trajectory, motion, { arm, path, allowed, hasTolerance })
  );
}

// Compare the motion, which is the joint values without whole turns and the frames of the tip. It
// may have a known mistake, the drift of Euler's method, symptoms only, or nothing wrong.
/** @returns {import("./frame.js").Outcome} */
function compareMotion(trajectory, { q, turnNotes, frames }, { arm, path, allowed, hasTolerance }) {
  const tip = frames.map(({ o }) => o);
  const errors = measureDistances(path.times.map(path.position), tip);
  const isOff = exceedsAllowed(errors, allowed);
  const [turn, lean] = measureToolTurns(frames, arm);
  const jumps = findJumps(q, arm, path);
  const singularStart = findSingularStart(q, arm, jumps);
  const jump = singularStart ? [] : describeJump(q, arm, jumps, !isOff);
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
  const shared = { notes, figures: { position_error: Math.max(...errors), tool_turn: turn, q } };
  if (cause) {
    const findings = dropExplainedJumps(cause, symptoms, jump);
    const kinds = findings.map(({ what }) => what);
    const causeNames = kinds.filter((kind) => INDEPENDENT_CAUSES.includes(kind));
    return { grade: WRONG, causes: [cause], causeNames, findings, ...shared };
  }
  const mayDrift = isOff && !hasTolerance && !jump.length && !trajectory.hasExtraStep;
  if (mayDrift && isDriftOfEuler({ ...trajectory, q }, arm, path, errors[0])) {
    // The method gives these joint values with the student's steps.
    const fields = { error: formatMillimetres(Math.max(...errors), 4), steps: errors.length - 1 };
    const headline = formatMessage("trace right by euler", { arm: arm.name });
    const drift = formatMessage("trace euler drift", fields);
    return { grade: RIGHT, headline, ...shared, notes: [...notes, drift] };
  }
  return symptoms.length
    ? { ...shared, ...describeSymptoms(symptoms, arm) }
    : { grade: RIGHT, ...shared };
}

// Describe a wrong motion whose mistake is unknown: the headline has the first symptom.
function describeSymptoms(symptoms, arm) {
  const [first, ...others] = symptoms;
  const causeNames = symptoms.map(({ what }) => what).filter((what) => what.includes("."));
  const headline = formatMessage("trace wrong", { arm: arm.name, cause: toClause(first.words) });
  const findings = [{ ...first, what: "cause" }, ...others];
  return { grade: WRONG, headline, findings, causeNames };
}

const listExtraStep = ({ hasExtraStep }) =>
  hasExtraStep ? [makeFinding("trace.one more", formatMessage("trace.one more"))] : [];

// Do not report jumps if all steps are too long, or if a mistake in the joint values makes them.
const dropExplainedJumps = (cause, symptoms, jump) =>
  causeName(cause) === "trace.millimetres" || cause.keys[0].startsWith("ik.")
    ? symptoms.filter((symptom) => !jump.includes(symptom))
    : symptoms;

// Describe a trajectory with a single wrong row, or return null. A wrong first or last row may
// belong to a jump, unless the change of one joint puts it right.
/** @returns {import("./frame.js").Outcome | null} */
function compareOnlyWrongRow(trajectory, frames, arm, path, allowed) {
  const wrongRow = findOnlyWrongRow(trajectory, arm, path, frames, allowed);
  if (!wrongRow || trajectory.hasExtraStep) return null;
  const { row, correction } = wrongRow;
  const isInside = row > 0 && row < frames.length - 1;
  return isInside || correction ? describeRow(arm, wrongRow, trajectory, path) : null;
}

/** @param {import("./trace_row.js").WrongRow} wrongRow */
function describeRow(arm, wrongRow, trajectory, path) {
  const { row, distance, angle, correction } = wrongRow;
  const { q, isPerJoint } = trajectory;
  const isWrong = (k, i) => k === row && (!correction || i === correction.index);
  const wrong = q.flatMap((values, k) => values.map((_, i) => isWrong(k, i)));
  const corrected = q.map((values, k) =>
    values.map((x, i) => (correction && isWrong(k, i) ? correction.value : x)),
  );
  const words = describeWrongRow(wrongRow, q[row], arm);
  return {
    grade: WRONG,
    findings: [makeFinding("step", words, `step ${row}`)],
    notes: correction ? [...listNotes(arm, path, corrected)] : [],
    figures: { position_error: distance, tool_turn: angle, q },
    ...(isPerJoint ? {} : { wrong }),
  };
}

// Return the largest rotation of the tool from its first frame, and the largest angle of its z axis
// from its first direction (rad). They are 0 for an arm that cannot hold its tool.
function measureToolTurns(frames, arm) {
  if (movingRows(arm).length < 6) return [0, 0];
  const turns = frames.map((frame) => rotationBetween(frames[0], frame));
  const leans = frames.map(({ z }) => measureAngle(z, frames[0].z));
  return [Math.max(...turns), Math.max(...leans)];
}

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

// Report the first jump, if there is one. It leads to a different branch only if the tip stays on
// the path.
/** @returns {Finding[]} */
function describeJump(q, arm, jumps, isOnPath) {
  if (!jumps.length) return [];
  const { step, ...fields } = measureStep(q, arm, jumps[0]);
  const key = isOnPath ? "trace.jump" : "trace jump off";
  const words = formatMessage(key, { step, to: step + 1, count: jumps.length, ...fields });
  return [makeFinding("trace.jump", words, `step ${step}`)];
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
