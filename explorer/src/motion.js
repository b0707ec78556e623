// Inverse kinematics by damped steps, for any table: circles traced from where the arm stands, and the other ways to
// reach a pose.

import { cross, jacobianColumns, joints, linkFrames, minus, norm, plus, scaled } from "./kinematics.js";
import { solve } from "./linear.js";

// An arm with fewer than six joints is asked for the position only.
const rowsAsked = (arm) => (joints(arm).length < 6 ? 3 : 6);

// How many joints are more than the pose (or, below six, the place) asks for.
export const spareJoints = (arm) => Math.max(0, joints(arm).length - rowsAsked(arm));

function poseError(tip, wanted) {
  const turn = ["x", "y", "z"].reduce((sum, axis) => plus(sum, cross(tip[axis], wanted[axis])), [0, 0, 0]);
  return [...minus(wanted.o, tip.o), ...scaled(0.5, turn)];
}

// The joint vector that brings the tip to the frame `wanted`, by Levenberg and Marquardt's steps damped by the error
// (Sugihara 2011); `held` is the index of a joint that must not move.
export function reach(arm, start, wanted, { held = -1, steps = 60 } = {}) {
  let q = [...start];
  const rows = rowsAsked(arm);
  for (let step = 0; ; step++) {
    const frames = linkFrames(arm, q);
    const error = poseError(frames.at(-1), wanted).slice(0, rows);
    const size = norm(error);
    if (size < 1e-11 || step === steps) return { q, error: size };
    const columns = jacobianColumns(arm, frames).map((c, i) => (i === held ? c.map(() => 0) : c));
    const damping = 0.02 * size * size + 1e-12;
    const A = error.map((_, i) => error.map((_, j) => columns.reduce((s, c) => s + c[i] * c[j], i === j ? damping : 0)));
    const y = solve(A, error);
    const move = columns.map((c) => y.reduce((s, v, i) => s + c[i] * v, 0));
    const most = Math.max(...move.map(Math.abs));
    q = q.map((v, i) => v + move[i] * Math.min(1, 0.6 / most));
  }
}

const PLANES = { x: [[0, 1, 0], [0, 0, 1]], y: [[1, 0, 0], [0, 0, 1]], z: [[1, 0, 0], [0, 1, 0]] };

// Joint vectors along a circle that starts at the tip, hangs below it in the plane with this normal axis, and holds the
// tool's orientation; with the largest distance (m) that the tip strays from it.
export function traceCircle(arm, start, { normal = "x", radius = 0.1, count = 181 } = {}) {
  const tip = linkFrames(arm, start).at(-1);
  const [across, up] = PLANES[normal];
  const centre = minus(tip.o, scaled(radius, up));
  const path = [];
  let [q, stray] = [start, 0];
  for (let k = 0; k < count; k++) {
    const angle = (2 * Math.PI * k) / (count - 1);
    const o = plus(centre, plus(scaled(radius * Math.sin(angle), across), scaled(radius * Math.cos(angle), up)));
    q = reach(arm, q, { ...tip, o }, { steps: 40 }).q;
    stray = Math.max(stray, norm(minus(linkFrames(arm, q).at(-1).o, o)));
    path.push(q);
  }
  return { path, stray };
}

// The same numbers on every machine and at every visit.
function dice(seed) {
  return () => (seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0) / 2 ** 32;
}

export function randomPose(arm, roll = Math.random) {
  return joints(arm).map((i) => {
    const [lower, upper] = range(arm.rows[i]);
    return lower + (upper - lower) * roll();
  });
}

// Where a joint may be put: its limits, or half a turn or a metre either way where none are known.
export function range(row) {
  const reach = row.kind === "revolute" ? Math.PI : 1;
  return [row.lower ?? -reach, row.upper ?? reach];
}

// Other joint vectors with the tip at the same pose, from many starts. Where the arm has a joint to spare, joint 3 is
// held, so that the ways can be counted.
export function otherWays(arm, q, tries = 300) {
  const wanted = linkFrames(arm, q).at(-1);
  const held = spareJoints(arm) ? 2 : -1;
  const roll = dice(1);
  const found = [turned(arm, q)];
  for (let n = 0; n < tries; n++) {
    const start = randomPose(arm, roll).map((v, i) => (i === held ? q[i] : v));
    const { q: way, error } = reach(arm, start, wanted, { held });
    const unwound = turned(arm, way);
    if (error < 1e-9 && found.every((other) => apart(arm, other, unwound) > 1e-3)) found.push(unwound);
  }
  return found.slice(0, 16);
}

// Revolute joints brought to within half a turn, or into their limits where whole turns can do that.
function turned(arm, q) {
  return joints(arm).map((row, i) => {
    if (arm.rows[row].kind !== "revolute") return q[i];
    const [lower, upper] = range(arm.rows[row]);
    const near = Math.atan2(Math.sin(q[i]), Math.cos(q[i]));
    return [near, near + 2 * Math.PI, near - 2 * Math.PI].find((v) => v >= lower && v <= upper) ?? near;
  });
}

function apart(arm, p, q) {
  const gap = (row, i) => (arm.rows[row].kind === "revolute" ? 2 * Math.sin((p[i] - q[i]) / 2) : p[i] - q[i]);
  return Math.max(...joints(arm).map((row, i) => Math.abs(gap(row, i))));
}

// Whether an arm at q stands at a joint vector that may have been rounded.
export const isThere = (way, q) => way.every((v, i) => Math.abs(v - q[i]) < 1e-4);

// Whether a joint is past one of its limits.
export const outside = (row, value) => value < (row.lower ?? -Infinity) - 1e-9 || value > (row.upper ?? Infinity) + 1e-9;
