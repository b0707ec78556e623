// Judges a trajectory of joints: whether its tip follows the path, and how the joints move.

import { completeVerdicts, makeVerdict } from "../verdict.js";
import { askAboutDegrees } from "./degrees.js";
import {
  dot,
  movingRows,
  linkFrames,
  minus,
  norm,
  rotationBetween,
} from "../geometry/kinematics.js";
import { DEG, RAD } from "../geometry/angles.js";
import { RIGHT, WRONG } from "../digits.js";
import { jointShapes, numbers, asDegrees, rowsOf, setAside } from "../reading/numbers.js";
import { formatMillimetres } from "../matching.js";
import { makeCause, causeName, causeMessage } from "../causes/ranking.js";
import {
  findJumps,
  findSingularStart,
  listNotes,
  measureStep,
  removeWholeTurns,
} from "./trace_steps.js";
import { blurOf, isDriftOfEuler, unitsWithoutTrimming } from "./trace_units.js";
import { uncapitalize, formatMessage, formatNumber } from "../sentences.js";
import {
  followsPathByEuler,
  makeTrace,
  METHOD_TILT,
  findTraceCause,
  METHOD_ERROR,
} from "../causes/trace.js";

/** @typedef {import("../geometry/arm.js").Arm} Arm */

const BESIDES = ["trace.one more", "trace.jump"]; // mistakes of their own, whatever else is wrong
const ALIKE = 1e-9; // m: errors nearer to each other than this are the same

/** @typedef {import("../geometry/path.js").Path} Path */
/** @typedef {import("../verdict.js").Finding} Finding */
/**
 * A typed trajectory: rows of joint values, and the units of their last places.
 * @typedef {{ q: number[][], units: number[][], unit: string, taken: string[],
 *   extra: boolean }} Run
 */

/**
 * Judge joint vectors along a path, a text such as CSV or nested lists.
 * @param {string | any[]} mine @param {Arm} arm @param {Path} path
 * @returns {import("../verdict.js").Verdict}
 */
export function compareTrace(mine, arm, path, options = {}) {
  const typed = readTrace(mine, arm, options.which);
  return { ...judgeTrace(typed, arm, path, options), typed };
}

// Return the joint values as typed, before any correction.
export function readTrace(mine, arm, which = null) {
  return numbers(mine, `${arm.name}: your joints`, undefined, undefined, {
    wants: jointShapes(arm)
      .filter(({ rows, columns }) => rows === null || columns === null)
      .map((want) => ({ ...want, largest: true })),
    names: /^(?:q|th|θ|ans$)/i,
    which,
  });
}

/**
 * @param {import("../reading/numbers.js").Typed} typed @param {Arm} arm @param {Path} path
 * @returns {import("../verdict.js").Verdict}
 */
export const judgeTrace = completeVerdicts(traceJudged);

function traceJudged(typed, arm, path, options = {}) {
  const { angles = "rad", tolerance = null } = options;
  const read = arrangeBySteps(typed, arm, path.times.length, typed.says?.angles ?? angles);
  if (!read) return reportWrongShape(typed, arm, path);
  const run = { ...read, units: unitsWithoutTrimming(read, arm, path) };
  const allowed = run.q.map((row, k) => tolerance ?? METHOD_ERROR + blurOf(row, run.units[k], arm));
  if (run.unit === "rad" && followsOnlyInDegrees(run, arm, path, allowed))
    return reportCause(arm, makeCause("trace.degrees"), [], run.taken, {});
  const verdict = judgeArrangedTrace(run, arm, path, allowed, tolerance !== null);
  return askAboutDegrees(verdict, {
    arm,
    values: run.q.flat(),
    angles: run.unit,
    key: "trace.degrees",
  });
}

// Return whether the joint values follow the path in degrees and not in radians.
function followsOnlyInDegrees({ q, units }, arm, path, allowed) {
  const wanted = path.times.map(path.position);
  const measureTipErrors = (rows) =>
    measureDistances(
      wanted,
      rows.map((row) => linkFrames(arm, row).at(-1).o),
    );
  if (!exceedsAllowed(measureTipErrors(q), allowed)) return false;
  const turned = convertToUnit(
    q.map((values, k) => ({ values, units: units[k] })),
    arm,
    "deg",
  );
  const errors = measureTipErrors(turned.q);
  if (!exceedsAllowed(errors, allowed)) return true;
  const [mine, other] = [{ q, units }, turned].map((run) => makeTrace(run.q, run.units, arm, path));
  return errors[0] <= allowed[0] && followsPathByEuler(other) && !followsPathByEuler(mine);
}

const exceedsAllowed = (errors, allowed) => errors.some((error, k) => error > allowed[k]);

// Return the distance of each point from the path's point at the same time.
const measureDistances = (wanted, points) => points.map((p, k) => norm(minus(p, wanted[k])));

// Return a row for each step. Columns are transposed, a leading column of times or zeros and one
// extra step are dropped, and the verdict reports each change.
/** @returns {Run | null} */
function arrangeBySteps(typed, arm, count, unit) {
  const dof = movingRows(arm).length;
  const shape = typed.shape.filter((n) => n !== 1);
  if (shape.length !== 2) return null;
  const taken = [...typed.said];
  const lengths = [count - 1, count, count + 1];
  const typedUnit = ({ angle }) => (angle && unit === "deg" ? RAD : 1); // an angle is read as rad
  let [rows, units] = [typed.values, typed.units].map((list) =>
    rowsOf(
      list.map((x, i) => x / typedUnit(typed.entries[i])),
      shape[1],
    ),
  );
  if (shape[1] !== dof && [dof, dof + 1].includes(shape[0]) && lengths.includes(shape[1])) {
    [rows, units] = [rows, units].map((list) => list[0].map((_, k) => list.map((row) => row[k])));
    taken.push(formatMessage("taken: list per joint"));
  }
  if (hasLockedColumns(rows, arm)) {
    taken.push(setAside(arm, rows.flat()));
    [rows, units] = [rows, units].map((list) =>
      list.map((row) => row.filter((_, i) => arm.rows[i].kind !== "fixed")),
    );
  }
  const first = rows.map(([x]) => x);
  const isTime = first.every((x) => !x) || first.slice(1).every((x, k) => x - first[k] > 0);
  if (rows[0].length === dof + 1 && isTime) {
    [rows, units] = [rows, units].map((list) => list.map((row) => row.slice(1)));
    taken.push(formatMessage("taken: times"));
  }
  if (rows[0].length !== dof || !lengths.includes(rows.length) || rows.length < 2) return null;
  const typedRows = rows.slice(0, count).map((values, k) => ({ values, units: units[k] }));
  return { ...convertToUnit(typedRows, arm, unit), taken, extra: rows.length === count + 1 };
}

// Return whether rows include constant values of the locked joints.
function hasLockedColumns(rows, arm) {
  const locked = arm.rows.flatMap(({ kind }, i) => (kind === "fixed" ? [i] : []));
  const isConstant = (i) => rows.every((row) => row[i] === rows[0][i]);
  return locked.length > 0 && rows[0].length === arm.rows.length && locked.every(isConstant);
}

function convertToUnit(typedRows, arm, unit) {
  const converted = unit === "deg" ? asDegrees(typedRows, arm) : typedRows;
  return {
    q: converted.map(({ values }) => values),
    units: converted.map((row) => row.units),
    unit,
  };
}

/** @returns {import("../verdict.js").Verdict} */
function makeTraceVerdict(arm, grade, words, taken, rest = {}) {
  const headline = formatMessage(grade === RIGHT ? "trace right" : "trace wrong", {
    arm: arm.name,
    cause: words,
  });
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

// The verdict

/**
 * @param {Run} run @param {Path} path @param {number[]} allowed how far off each row may be (m)
 * @param {boolean} given whether that is all that is asked
 * @returns {import("../verdict.js").Verdict}
 */
function judgeArrangedTrace(run, arm, path, allowed, given) {
  const [q, turned] = removeWholeTurns(run.q, arm, path);
  const frames = q.map((row) => linkFrames(arm, row).at(-1));
  const tip = frames.map(({ o }) => o);
  const errors = measureDistances(path.times.map(path.position), tip);
  const off = exceedsAllowed(errors, allowed);
  const turns = frames.map((one) => rotationBetween(frames[0], one));
  const [turn, leans] =
    movingRows(arm).length >= 6 ? [Math.max(...turns), measureLean(frames)] : [0, 0];
  const far = findJumps(q, arm, path);
  const stuck = findSingularStart(q, arm, far);
  const jump = stuck || !far.length ? [] : [describeJump(q, arm, far, !off)];
  const amiss = [
    ...(off ? [makeFinding("step", describeWorstStep(errors, allowed))] : []),
    ...jump,
    ...listToolTurns(leans, turn),
  ];
  const symptoms = [...amiss, ...listExtraStep(run)];
  const seen = { off, shown: amiss.length > 0 };
  const trace = makeTrace(q, run.units, arm, path, run.q);
  const findCause = () => findTraceCause(trace, tip, allowed, seen);
  const named = stuck ?? (symptoms.length || !given ? findCause() : null);
  const notes = [...turned, ...(stuck ? [] : listNotes(arm, path, q))];
  const figures = { position_error: Math.max(...errors), tool_turn: turn, q };
  const rest = { notes, figures };
  if (named)
    return reportCause(arm, named, dropExplainedJumps(named, symptoms, jump), run.taken, rest);
  const mayDrift = off && !given && !jump.length;
  return reportWithoutCause({ ...run, q }, path, { arm, symptoms, errors, mayDrift, rest });
}

// Return the verdict without a known mistake: Euler's drift, symptoms only, or nothing wrong.
function reportWithoutCause(run, path, { arm, symptoms, errors, mayDrift, rest }) {
  if (mayDrift && !run.extra && isDriftOfEuler(run, arm, path, errors[0]))
    return acceptEulerDrift(arm, errors, run.taken, rest);
  if (symptoms.length) return reportSymptoms(arm, symptoms, run.taken, rest);
  return makeTraceVerdict(arm, RIGHT, "", run.taken, rest);
}

// Accept the drift of Euler's method: the joints are what it gives with the student's steps.
function acceptEulerDrift(arm, errors, taken, rest) {
  const fields = { error: formatMillimetres(Math.max(...errors), 4), steps: errors.length - 1 };
  const notes = [...rest.notes, formatMessage("trace euler drift", fields)];
  const headline = formatMessage("trace right by euler", { arm: arm.name });
  return makeVerdict("trace", arm, RIGHT, headline, { taken, ...rest, notes });
}

const listExtraStep = ({ extra }) =>
  extra ? [makeFinding("trace.one more", formatMessage("trace.one more"))] : [];

// Do not report jumps if all steps are too long, or if a mistake in the joint values makes them.
const dropExplainedJumps = (cause, symptoms, jump) =>
  causeName(cause) === "trace.millimetres" || cause.keys[0].startsWith("ik.")
    ? symptoms.filter((one) => !jump.includes(one))
    : symptoms;

function reportCause(arm, named, symptoms, taken, rest) {
  const words = causeMessage(named);
  const findings = [{ what: "cause", where: "", words: `${words}.` }, ...symptoms];
  const besides = symptoms.map(({ what }) => what).filter((what) => BESIDES.includes(what));
  const causes = [causeName(named), ...besides];
  return makeTraceVerdict(arm, WRONG, `${uncapitalize(words)}.`, taken, {
    findings,
    causes,
    ...rest,
  });
}

function reportSymptoms(arm, symptoms, taken, rest) {
  const [first, ...others] = symptoms;
  const findings = [{ ...first, what: "cause" }, ...others];
  const whats = symptoms.map(({ what }) => what);
  const causes = whats.filter((what) => what.includes("."));
  return makeTraceVerdict(arm, WRONG, uncapitalize(first.words), taken, {
    findings,
    causes,
    ...rest,
  });
}

/** @returns {Finding} */
const makeFinding = (what, words, where = "") => ({ what, where, words });

// Return the largest angle (rad) between the tool's axis and its first direction.
const measureLean = (frames) => Math.max(...frames.map(({ z }) => measureAngle(z, frames[0].z)));

function listToolTurns(lean, turn) {
  const formatDegrees = (angle) => ({ degrees: formatNumber(angle * DEG) });
  if (lean > METHOD_TILT)
    return [makeFinding("trace.leans", formatMessage("trace leans", formatDegrees(lean)))];
  return turn > METHOD_TILT
    ? [makeFinding("trace.spins", formatMessage("trace spins", formatDegrees(turn)))]
    : [];
}

// Return the angle between two unit vectors.
const measureAngle = (u, v) =>
  Math.atan2(
    norm([u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]),
    dot(u, v),
  );

// Report the first jump; it is one to another branch only if the tip stays on the path.
/** @returns {Finding} */
function describeJump(q, arm, far, on) {
  const { step, ...fields } = measureStep(q, arm, far[0]);
  const key = on ? "trace.jump" : "trace jump off";
  const words = formatMessage(key, { step, to: step + 1, count: far.length, ...fields });
  return { what: "trace.jump", where: `step ${step}`, words };
}

// Report the step at which the tip is farthest off, beyond its typed digits.
function describeWorstStep(errors, allowed) {
  const wrong = errors.map((error, k) => (error > allowed[k] ? error : 0));
  const most = Math.max(...wrong);
  const step = wrong.findIndex((error) => error >= most - ALIKE);
  const start =
    errors[0] > 0.5 * most ? formatMessage("already") : `${formatMillimetres(errors[0])} mm`;
  return formatMessage("trace where", {
    error: formatMillimetres(most, 4),
    step,
    steps: errors.length - 1,
    start,
  });
}
