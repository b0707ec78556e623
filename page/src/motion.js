// Inverse kinematics by damped steps, for any table: circles traced from where the arm stands, and
// the other ways to reach a pose. None of it touches the page, so that a worker can do it.

import { isJointVector, jointRange } from "../../judge/geometry/arm.js";
import {
  cross,
  jacobianColumns,
  movingRows,
  linkFrames,
  minus,
  norm,
  plus,
  scaled,
} from "../../judge/geometry/kinematics.js";
import { findClosedForm, needsPose, solveInverse } from "../../judge/geometry/inverse.js";
import { nullSpace, decomposeSingular, solveLinear } from "../../judge/geometry/linear.js";
import { circlePath } from "../../judge/geometry/path.js";
import { replaceAt } from "./text.js";
import { countTaskRows } from "./verdicts.js";

// How many joints are more than the pose (or, below six, the place) asks for.
const countSpareJoints = (arm) => Math.max(0, movingRows(arm).length - countTaskRows(arm));

// The small motion (v, then ω) that is missing from a tip to a frame.
export function getPoseError(tip, wanted) {
  const turn = ["x", "y", "z"].reduce(
    (sum, axis) => plus(sum, cross(tip[axis], wanted[axis])),
    [0, 0, 0],
  );
  return [...minus(wanted.o, tip.o), ...scaled(0.5, turn)];
}

export const dotProduct = (u, v) => u.reduce((sum, x, i) => sum + x * v[i], 0);

// Levenberg and Marquardt's step x, for which |J x - e|² + damping |x|² is least, from the columns
// of J and from Jᵀ e.
export const solveDamped = (columns, pull, damping) =>
  solveLinear(
    columns.map((a, i) => columns.map((b, j) => dotProduct(a, b) + (i === j ? damping : 0))),
    pull,
  );

// The joint vector that brings the tip to the frame `wanted`, or that many rows of it, by steps
// damped by the error (Sugihara 2011); `held` is the index of a joint that must not move.
export function solvePose(
  arm,
  start,
  wanted,
  { lockedJoint = -1, rows = countTaskRows(arm), steps = 60 } = {},
) {
  let q = [...start];
  for (let step = 0; ; step++) {
    const frames = linkFrames(arm, q);
    const error = getPoseError(frames.at(-1), wanted).slice(0, rows);
    const size = norm(error);
    if (size < 1e-11 || step === steps || !q.length) return { q, error: size };
    const columns = jacobianColumns(arm, frames).map((c, i) =>
      c.slice(0, rows).map((v) => (i === lockedJoint ? 0 : v)),
    );
    const pull = columns.map((c) => dotProduct(c, error));
    const move = solveDamped(columns, pull, 0.02 * size * size + 1e-12);
    const most = Math.max(1e-12, ...move.map(Math.abs));
    q = q.map((v, i) => v + move[i] * Math.min(1, 0.6 / most));
  }
}

// For the wall that faces each axis, the circle's plane and which way round it goes.
const CIRCLE_PLANES = { x: ["zy", 1], y: ["zx", -1], z: ["yx", 1] };

// Where the tip should be at a share of the way round a circle that begins at `top` and hangs below
// it in the plane with this normal axis, and how fast it should go.
export function getCirclePoint(top, { normal = "x", radius = 0.1, seconds = 1 }, share) {
  const [plane, sense] = CIRCLE_PLANES[normal];
  const centre = top.map((v, i) => v - ("xyz"[i] === plane[0] ? radius : 0));
  const path = circlePath({ centre, radius, plane, period: sense * seconds, steps: 1 });
  const t = share * seconds;
  return { o: path.position(t), v: path.velocity(t) };
}

const NUDGE = 0.05; // rad or m, out of a pose in which no small motion helps

// What a search finds from a pose, `found`, or from a little beside it, joint by joint: a singular
// pose holds it.
export function searchAround(found, q, search) {
  let best = found;
  for (const k of q.keys()) {
    for (const nudge of [NUDGE, -NUDGE]) {
      const other = search(replaceAt(q, k, q[k] + nudge));
      if (other.error < 0.98 * best.error) best = other;
    }
  }
  return best;
}

// `reach`, out of a singular pose too.
export function solvePoseFromSingular(arm, start, wanted, options) {
  const search = (q) => solvePose(arm, q, wanted, options);
  const found = search(start);
  const stalled = found.error > 1e-6 && isAtPose(found.q, start);
  return stalled ? searchAround(found, start, search) : found;
}

// The same numbers on every machine and at every visit.
function makeRandomGenerator(seed) {
  return () => (seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0) / 2 ** 32;
}

export function drawRandomPose(arm, roll = Math.random) {
  return movingRows(arm).map((i) => {
    const [lower, upper] = jointRange(arm.rows[i]);
    return lower + (upper - lower) * roll();
  });
}

const MAX_BRANCHES = 16;

/**
 * Find the joint vectors with the tip at the same pose: by the arm's closed form, which names them,
 * else from many starts. Where the arm has a joint to spare, joint 3 is held, so that the ways can
 * be counted. Where joints can move with the tip at rest, their ways are one family; the list
 * holds one of them.
 * @param {import("../../judge/geometry/arm.js").Arm} arm
 * @param {number[]} q
 */
export function findBranches(arm, q, tries = 300) {
  const target = linkFrames(arm, q).at(-1);
  const hasOrientation = countTaskRows(arm) === 6;
  if (!isJointVector(arm, q) || !q.length)
    return { list: [], families: [], lockedJoint: -1, target, hasOrientation };
  const lockedJoint = countSpareJoints(arm) ? 2 : -1;
  const roll = makeRandomGenerator(1);
  const families = [];
  const found = [];
  const take = (branch, label) => {
    if (families.some((family) => isInFamily(arm, family, branch))) return;
    if (found.some(({ q: other }) => measureJointDistance(arm, other, branch) < 1e-3)) return;
    const moving = findFreeJoints(arm, branch, target, lockedJoint);
    found.push(label ? { q: branch, label } : { q: branch });
    if (moving.length) families.push({ moving, q: branch });
  };
  const closedForm = solveClosedForm(arm, target, hasOrientation);
  for (const { q: branch, name } of closedForm) take(wrapAngles(arm, branch), name);
  take(wrapAngles(arm, q));
  for (let n = 0; !closedForm.length && n < tries && found.length < MAX_BRANCHES; n++) {
    const start = drawRandomPose(arm, roll).map((v, i) => (i === lockedJoint ? q[i] : v));
    const { q: branch, error } = solvePose(arm, start, target, { lockedJoint });
    if (error < 1e-9) take(wrapAngles(arm, branch));
  }
  return { list: found, families, lockedJoint, target, hasOrientation };
}

// The branches of the arm's closed form, if its targets are those of the explorer; else none.
function solveClosedForm(arm, target, hasOrientation) {
  const form = findClosedForm(arm);
  if (!form || needsPose(form) !== hasOrientation) return [];
  return solveInverse(arm, form, hasOrientation ? target : target.o);
}

// rad or m along the null space: small beside a turn, large beside what a double root gives way by
const NULL_SPACE_STEP = 0.1;

// The joints that can move from here while the tip stays: those of a null direction along which a
// solution really lies.
function findFreeJoints(arm, q, target, lockedJoint = -1) {
  const rows = countTaskRows(arm);
  const columns = jacobianColumns(arm, linkFrames(arm, q)).map((c, i) =>
    c.slice(0, rows).map((v) => (i === lockedJoint ? 0 : v)),
  );
  const { values } = decomposeSingular(columns, rows);
  const free = movingRows(arm).length - (lockedJoint < 0 ? 0 : 1);
  if (values.filter((v) => v > 1e-5 * values[0]).length >= Math.min(rows, free)) return [];
  const moving = new Set();
  for (const direction of nullSpace(columns, lockedJoint)) {
    const start = q.map((v, i) => v + NULL_SPACE_STEP * direction[i]);
    const there = solvePose(arm, start, target, { lockedJoint, steps: 200 });
    if (there.error > 1e-9 || measureJointDistance(arm, there.q, q) < 0.3 * NULL_SPACE_STEP)
      continue;
    there.q.forEach((v, i) => Math.abs(v - q[i]) > 1e-3 && moving.add(i));
  }
  return [...moving].sort((p, r) => p - r);
}

// Whether a way differs from a family's only in the joints that move along it.
function isInFamily(arm, { moving, q }, branch) {
  const there = branch.map((v, i) => (moving.includes(i) ? q[i] : v));
  return measureJointDistance(arm, q, there) < 1e-3;
}

// Revolute joints brought to within half a turn, or into their limits where whole turns can do
// that.
function wrapAngles(arm, q) {
  return movingRows(arm).map((row, i) => {
    if (arm.rows[row].kind !== "revolute") return q[i];
    const [lower, upper] = jointRange(arm.rows[row]);
    const near = Math.atan2(Math.sin(q[i]), Math.cos(q[i]));
    return (
      [near, near + 2 * Math.PI, near - 2 * Math.PI].find((v) => v >= lower && v <= upper) ?? near
    );
  });
}

function measureJointDistance(arm, p, q) {
  const gap = (row, i) =>
    arm.rows[row].kind === "revolute" ? 2 * Math.sin((p[i] - q[i]) / 2) : p[i] - q[i];
  return Math.max(...movingRows(arm).map((row, i) => Math.abs(gap(row, i))));
}

// Whether an arm at q stands at a joint vector that may have been rounded.
export const isAtPose = (branch, q) =>
  branch.length === q.length && branch.every((v, i) => Math.abs(v - q[i]) < 1e-4);
