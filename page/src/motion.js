// Inverse kinematics by damped steps for any table: circles traced from the current configuration,
// and other branches of a pose. It does not use the page, so that a worker can run it.

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
import { wrapAngle } from "../../judge/geometry/planar.js";
import { hasTaskOrientation, pick, taskRows } from "../../judge/geometry/task_rows.js";
import { replaceAt } from "./text.js";

// Count the joints beyond those that the task needs.
const countSpareJoints = (arm) => Math.max(0, movingRows(arm).length - taskRows(arm).length);

// Return the small motion (v, then ω) from the tip to a frame.
export function getPoseError(tip, wanted) {
  const turn = ["x", "y", "z"].reduce(
    (sum, axis) => plus(sum, cross(tip[axis], wanted[axis])),
    [0, 0, 0],
  );
  return [...minus(wanted.o, tip.o), ...scaled(0.5, turn)];
}

export const dotProduct = (u, v) => u.reduce((sum, x, i) => sum + x * v[i], 0);

// Return the Levenberg-Marquardt step x that minimizes |J x - e|² + damping |x|², from the columns
// of J and from Jᵀ e.
export const solveDamped = (columns, pull, damping) =>
  solveLinear(
    columns.map((a, i) => columns.map((b, j) => dotProduct(a, b) + (i === j ? damping : 0))),
    pull,
  );

// Solve for joint values that bring the tip to the frame `wanted`, as far as the entries `rows` of
// a motion (v, ω) go, by steps damped by the error (Sugihara 2011). `lockedJoint` is the index in q
// of a joint that must not move.
export function solvePose(
  arm,
  start,
  wanted,
  { lockedJoint = -1, rows = taskRows(arm), steps = 60 } = {},
) {
  let q = [...start];
  for (let step = 0; ; step++) {
    const frames = linkFrames(arm, q);
    const error = pick(getPoseError(frames.at(-1), wanted), rows);
    const size = norm(error);
    if (size < 1e-11 || step === steps || !q.length) return { q, error: size };
    const columns = jacobianColumns(arm, frames).map((c, i) =>
      pick(c, rows).map((v) => (i === lockedJoint ? 0 : v)),
    );
    const pull = columns.map((c) => dotProduct(c, error));
    const move = solveDamped(columns, pull, 0.02 * size * size + 1e-12);
    const most = Math.max(1e-12, ...move.map(Math.abs));
    q = q.map((v, i) => v + move[i] * Math.min(1, 0.6 / most));
  }
}

// The circle's plane and sense of rotation on the wall that faces each axis.
const CIRCLE_PLANES = { x: ["zy", 1], y: ["zx", -1], z: ["yx", 1] };

// Return the tip's position and velocity at a share of a circle. The circle begins at `top` and
// hangs below it in the plane with this normal axis.
export function getCirclePoint(top, { normal = "x", radius = 0.1, seconds = 1 }, share) {
  const [plane, sense] = CIRCLE_PLANES[normal];
  const centre = top.map((v, i) => v - ("xyz"[i] === plane[0] ? radius : 0));
  const path = circlePath({ centre, radius, plane, period: sense * seconds, steps: 1 });
  const t = share * seconds;
  return { o: path.position(t), v: path.velocity(t) };
}

const SEARCH_STEP = 0.05; // rad or m: moves a joint out of a singular configuration

// Return the best of a result and of searches that start beside q, a step of one joint away. A
// search that starts in a singular configuration may not move.
export function searchAround(firstResult, q, search) {
  let best = firstResult;
  for (const k of q.keys()) {
    for (const step of [SEARCH_STEP, -SEARCH_STEP]) {
      const result = search(replaceAt(q, k, q[k] + step));
      if (result.error < 0.98 * best.error) best = result;
    }
  }
  return best;
}

// Solve as `solvePose` does, and from around the start if that is singular.
export function solvePoseFromSingular(arm, start, wanted, options) {
  const search = (q) => solvePose(arm, q, wanted, options);
  const result = search(start);
  const stalled = result.error > 1e-6 && isAtConfiguration(result.q, start);
  return stalled ? searchAround(result, start, search) : result;
}

// The same random numbers on every machine and at every visit.
function makeRandomGenerator(seed) {
  return () => (seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0) / 2 ** 32;
}

export function drawRandomConfiguration(arm, roll = Math.random) {
  return movingRows(arm).map((i) => {
    const [lower, upper] = jointRange(arm.rows[i]);
    return lower + (upper - lower) * roll();
  });
}

const MAX_BRANCHES = 16;
const TRIES = 300; // random starts

/**
 * Find joint values with the tip at the same pose: by the arm's closed form, which names the
 * branches, else from many random starts.
 * If the arm has a spare joint, joint 3 is locked so that the solutions can be counted. If joints
 * can move while the tip stays, their solutions form a family, of which the list has one member.
 * @param {import("../../judge/geometry/arm.js").Arm} arm
 * @param {number[]} q
 * @returns {import("./state.js").BranchSet}
 */
export function findBranches(arm, q) {
  const target = linkFrames(arm, q).at(-1);
  const hasOrientation = hasTaskOrientation(arm);
  if (!isJointVector(arm, q) || !q.length)
    return { list: [], families: [], lockedJoint: -1, target, hasOrientation };
  const lockedJoint = countSpareJoints(arm) ? 2 : -1;
  const roll = makeRandomGenerator(1);
  const families = [];
  const solutions = [];
  const addBranch = (branch, label) => {
    if (families.some((family) => isInFamily(arm, family, branch))) return;
    if (solutions.some(({ q: other }) => measureJointDistance(arm, other, branch) < 1e-3)) return;
    const moving = findFreeJoints(arm, branch, target, lockedJoint);
    solutions.push(label ? { q: branch, label } : { q: branch });
    if (moving.length) families.push({ moving, q: branch });
  };
  const closedForm = solveClosedForm(arm, target, hasOrientation);
  for (const { q: branch, name } of closedForm) addBranch(wrapAngles(arm, branch), name);
  addBranch(wrapAngles(arm, q));
  for (let n = 0; !closedForm.length && n < TRIES && solutions.length < MAX_BRANCHES; n++) {
    const start = drawRandomConfiguration(arm, roll).map((v, i) => (i === lockedJoint ? q[i] : v));
    const { q: branch, error } = solvePose(arm, start, target, { lockedJoint });
    if (error < 1e-9) addBranch(wrapAngles(arm, branch));
  }
  // The list begins with the branch on which the arm stands.
  const distance = ({ q: branch }) => measureJointDistance(arm, branch, q);
  const list = [...solutions].sort((one, other) => distance(one) - distance(other));
  return { list, families, lockedJoint, target, hasOrientation };
}

// Find the branches by the arm's closed form, or none if the form needs other targets.
function solveClosedForm(arm, target, hasOrientation) {
  const form = findClosedForm(arm);
  if (!form || needsPose(form) !== hasOrientation) return [];
  return solveInverse(arm, form, hasOrientation ? target : target.o);
}

// rad or m; small beside a turn, large beside the play of a double root
const NULL_SPACE_STEP = 0.1;

// Find the joints that can move while the tip stays. They have a null direction that leads to
// another solution.
function findFreeJoints(arm, q, target, lockedJoint) {
  const rows = taskRows(arm);
  const columns = jacobianColumns(arm, linkFrames(arm, q)).map((c, i) =>
    pick(c, rows).map((v) => (i === lockedJoint ? 0 : v)),
  );
  const { values } = decomposeSingular(columns, rows.length);
  const free = movingRows(arm).length - (lockedJoint < 0 ? 0 : 1);
  if (values.filter((v) => v > 1e-5 * values[0]).length >= Math.min(rows.length, free)) return [];
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

// Return whether a solution differs from a family's member only in the joints that move.
function isInFamily(arm, { moving, q }, branch) {
  const there = branch.map((v, i) => (moving.includes(i) ? q[i] : v));
  return measureJointDistance(arm, q, there) < 1e-3;
}

// Wrap revolute joints to half a turn, or into their limits if whole turns can do that.
function wrapAngles(arm, q) {
  return movingRows(arm).map((row, i) => {
    if (arm.rows[row].kind !== "revolute") return q[i];
    const [lower, upper] = jointRange(arm.rows[row]);
    const near = wrapAngle(q[i]);
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

const SAME = 1e-4; // rad or m between joint values that may have been rounded

// Return whether q equals joint values that may have been rounded.
export const isAtConfiguration = (branch, q) =>
  branch.length === q.length && branch.every((v, i) => Math.abs(v - q[i]) < SAME);

// Return whether q is a solution branch, whose joints may have made whole turns more or less.
export const isAtBranch = (arm, branch, q) =>
  branch.length === q.length && measureJointDistance(arm, branch, q) < SAME;
