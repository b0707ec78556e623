// Sentences of the explorer about an arm: its rank, its solution branches, why a dragged tip stops,
// whether a typed table is the same arm. tests/test_explorer.py compares them with Python.

import { hasLimits, isOutsideLimits } from "../../judge/geometry/arm.js";
import { isSameMachine } from "../../judge/geometry/axes.js";
import {
  movingRows,
  linkFrames,
  minus,
  norm,
  rotationBetween,
} from "../../judge/geometry/kinematics.js";
import {
  hasTaskOrientation,
  isPlanar,
  movableRows,
  taskRows,
} from "../../judge/geometry/task_rows.js";
import { formatFixed, describeMotion } from "./text.js";
import { joinList, capitalize } from "../../judge/sentences.js";

const RANK_TOLERANCE = 1e-6; // singular values below this share of the largest count as zero

// Name what inverse kinematics solves for.
export const describeTarget = (arm) => (hasTaskOrientation(arm) ? "pose" : "position");

export const countRank = (values) =>
  values.filter((value) => value > RANK_TOLERANCE * values[0]).length;

// Return the rank of the arm at a regular configuration.
export const getFullRank = (arm) => Math.min(taskRows(arm).length, movingRows(arm).length);

/**
 * Describe the rank and, at a singular configuration, the motions that are lost.
 * @param {{ arm: Arm, rank: number, lostMotions: number[][] }} derived
 */
export function describeRank({ arm, rank, lostMotions }) {
  const [full, rows] = [getFullRank(arm), taskRows(arm).length];
  const singular = rank < full;
  if (!singular) return { singular, text: describeReach(arm, rank, full) };
  return {
    singular,
    text: `Singular: rank ${rank} of ${full}. ${describeLostMotions(lostMotions, full < rows)}`,
  };
}

// Describe where a tip of this rank can move.
function describeReach(arm, rank, full) {
  const dof = movingRows(arm).length;
  if (!dof) return "No joint moves this arm.";
  if (full === 6) return "Rank 6: the tip can move along and turn about every direction.";
  if (isPlanar(arm) && full > 1) return describePlanarReach(arm, rank);
  if (movableRows(arm).length <= dof)
    return `Rank ${rank}: the tip can make every motion that these joints allow.`;
  if (full < 3)
    return `Rank ${rank}, the most that ${dof > 1 ? `${dof} joints` : "one joint"} can have.`;
  const turns = "with fewer than six joints it cannot be turned at will as well";
  return `Rank 3: the tip can move along every direction; ${turns}.`;
}

function describePlanarReach(arm, rank) {
  const turn = hasTaskOrientation(arm) ? " and turn in it" : ", but not turn at will as well";
  return `Rank ${rank}: the tip can move along every direction of its plane${turn}.`;
}

const countLargeEntries = (direction) => direction.filter((v) => Math.abs(v) > 0.02).length;

function describeLostMotions(motions, isLostEverywhere) {
  if (!motions.length || isLostEverywhere) return "";
  const single = motions.filter((d) => countLargeEntries(d) === 1).map(describeMotion);
  const blends = motions
    .filter((d) => countLargeEntries(d) > 1)
    .map((d) => `make the motion ${describeMotion(d)}`);
  return `Here the tip cannot ${joinList([...single, ...blends], "nor")}.`;
}

const NUMBER_WORDS = "No One Two Three Four Five Six Seven Eight".split(" ");
const formatBranchCount = (n) => `${NUMBER_WORDS[n] ?? n} ${n === 1 ? "solution" : "solutions"}`;
const listJoints = (arm, moving) => joinList(moving.map((k) => `joint ${movingRows(arm)[k] + 1}`));

/**
 * Describe how many branches there are, or which joints are free if there are infinitely many.
 * @param {import("../../judge/geometry/arm.js").Arm} arm
 * @param {{ list: object[], families: { moving: number[] }[], lockedJoint: number,
 *   hasOrientation: boolean }} branchSet
 */
export function describeBranches(arm, { list, families, lockedJoint, hasOrientation }) {
  const pose = hasOrientation ? "pose" : "position, whatever the tool’s direction";
  const isolatedCount = list.length - families.length;
  const fixedJoint =
    lockedJoint < 0
      ? ""
      : ` with joint ${movingRows(arm)[lockedJoint] + 1} held where it is; ` +
        "free, it makes them infinitely many";
  if (!families.length) return `${formatBranchCount(list.length)} for this ${pose}${fixedJoint}.`;
  const free = families[0].moving;
  const freedom =
    free.length === 1
      ? `${listJoints(arm, free)} is free`
      : `${listJoints(arm, free)} are free to move together`;
  const kinds = families.length > 1 ? `, in ${families.length} families` : "";
  const rest = isolatedCount ? ` and ${formatBranchCount(isolatedCount).toLowerCase()} more` : "";
  const locked = lockedJoint < 0 ? "" : `, joint ${movingRows(arm)[lockedJoint] + 1} held`;
  const shown = `one of each is shown${rest}${locked}`;
  return `Infinitely many solutions for this ${pose}: ${freedom}${kinds}; ${shown}.`;
}

// List the joints for which a condition holds, by their rows in the table.
export const listJointsWhere = (arm, condition) =>
  movingRows(arm).flatMap((row, k) => (condition(row, k) ? [`joint ${row + 1}`] : []));

// List the joints that pass a limit on a path.
export const listJointsPastLimits = (arm, path) =>
  listJointsWhere(arm, (row, k) => path.some((q) => isOutsideLimits(arm.rows[row], q[k])));

// Describe why a dragged tip stops short of the pointer.
export function describeStop({ stops = [], short = 0 }) {
  if (short < 0.002) return "";
  const reason = stops.length ? joinList(stops) : "out of reach";
  return `${capitalize(reason)}: ${formatFixed(1000 * short, 0)} mm short.`;
}

// Describe what stops a dragged tip, or will stop it soon.
export function describeDragLimit(tipHold) {
  if (!tipHold?.target) return "";
  const stop = tipHold.moving ? "" : describeStop(tipHold);
  if (stop || !tipHold.fading?.length) return stop;
  const arrows = tipHold.fading.length > 1 ? "the arrows" : "the arrow";
  const isSingular = tipHold.fading.every(({ share }) => share < 1e-3);
  return isSingular
    ? `Singular: the tip cannot move along ${arrows}.`
    : `Nearly singular along ${arrows}.`;
}

const TABLE_HELP =
  "Type into any entry: 0.333, −90°, pi/2, or paste a whole table. " +
  "The arm follows, and the first one stays as a ghost.";

/**
 * Describe whether a typed table is the same arm as the reference, how far their tips are apart,
 * and whether its joints still have limits.
 * @typedef {import("../../judge/geometry/arm.js").Arm} Arm
 * @param {{ arm: Arm, base?: Arm, reference: Arm, q: number[] }} state
 * @param {{ frames: any[] }} derived
 */
export function describeTable(state, { frames }) {
  const { arm, base = arm, reference } = state;
  if (arm === reference) return TABLE_HELP;
  return [compareWithReference(state, frames), describeKeptLimits(arm, base)].join(" ").trim();
}

// Describe whether a typed arm keeps the limits of the arm whose table was edited.
function describeKeptLimits(arm, base) {
  if (arm === base || !hasLimits(base)) return "";
  if (hasLimits(arm)) return `Its joints keep the limits of the ${base.name}.`;
  return `The limits of the ${base.name} are not those of this table: its joints move freely.`;
}

function compareWithReference({ arm, reference, q }, frames) {
  const counts = [movingRows(arm).length, movingRows(reference).length];
  if (counts[0] !== counts[1])
    return `Yours has ${counts[0]} joints, the ${reference.name} ${counts[1]}.`;
  const [tip, ghostTip] = [frames.at(-1), linkFrames(reference, q).at(-1)];
  const turn = (rotationBetween(tip, ghostTip) * 180) / Math.PI;
  const distance = 1000 * norm(minus(tip.o, ghostTip.o)); // mm
  const apart = `${formatFixed(distance, 1)} mm and ${formatFixed(turn, 1)}°`;
  const here = `at these joint values its tip is ${apart} away from the ghost’s`;
  if (!isSameArm(arm, reference)) return `Not the same arm as the ${reference.name}: ${here}.`;
  if (distance < 0.05 && turn < 0.05) return `The same arm as the ${reference.name}: ${here}.`;
  return (
    `The same arm as the ${reference.name}, ` +
    `with another zero, direction or frame that is free to choose: ` +
    `${here}, but other joint values bring it there.`
  );
}

// The comparison depends only on the tables, so it is not repeated for each configuration.
let lastComparison = { arm: null, reference: null, isSame: false };
function isSameArm(arm, reference) {
  if (lastComparison.arm !== arm || lastComparison.reference !== reference)
    lastComparison = { arm, reference, isSame: isSameMachine(arm.rows, reference.rows) };
  return lastComparison.isSame;
}
