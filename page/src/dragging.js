// Joint values while the reader drags the arm: a link turns its own joint, the arm follows a
// dragged tip, the elbow swings while the tip is pinned. All of them respect the joint limits and
// report what stops them.

import { jointRange } from "../../judge/geometry/arm.js";
import {
  cross,
  dot,
  jacobianColumns,
  movingRows,
  linkFrames,
  minus,
  norm,
  plus,
  pointInBase,
  scaled,
} from "../../judge/geometry/kinematics.js";
import { nullSpace, decomposeSingular } from "../../judge/geometry/linear.js";
import { clamp } from "../../judge/geometry/planar.js";
import { pick } from "../../judge/geometry/task_rows.js";
import {
  solveDamped,
  dotProduct,
  isAtConfiguration,
  searchAround,
  getPoseError,
  solvePose,
} from "./motion.js";

/** @typedef {import("../../judge/geometry/arm.js").Arm} Arm */
/** @typedef {(point: number[]) => number[]} Pixel projects a point of the world to CSS pixels */

const getJointRanges = (arm) => movingRows(arm).map((i) => jointRange(arm.rows[i]));

const PIXEL_DAMPING = 30; // px per rad; damping for a link seen end-on, which would otherwise jump
const PIXEL_STEP = 1e-4; // rad or m, for the finite difference of a projected motion

// Return the pixel of a point p and its rate on the screen when p moves with velocity v.
function projectMotion(pixel, p, v) {
  const [a, b] = [pixel(p), pixel(plus(p, scaled(PIXEL_STEP, v)))];
  return { at: a, rate: [(b[0] - a[0]) / PIXEL_STEP, (b[1] - a[1]) / PIXEL_STEP] };
}

/**
 * Turn one joint so that a grabbed point follows the pointer.
 * @param {Arm} arm
 * @param {number[]} q
 * @param {{ row: number, local: number[], to: number[], joint: number, pixel: Pixel }} grab the
 *   grabbed point `local` in the frame of `row`, the pointer's pixel `to`, and the index in q of
 *   the joint that turns
 * @returns {number[]} new joint values
 */
export function dragLink(arm, q, { row, local, to, joint, pixel }) {
  const index = movingRows(arm)[joint];
  const turns = arm.rows[index].kind === "revolute";
  const limits = jointRange(arm.rows[index]);
  const next = [...q];
  for (let round = 0; round < 4; round++) {
    const frames = linkFrames(arm, next);
    const p = pointInBase(frames[row + 1], local);
    const { z, o } = frames[index];
    const { at, rate } = projectMotion(pixel, p, turns ? cross(z, minus(p, o)) : z);
    const [step] = solveDamped(
      [rate],
      [dotProduct(rate, [to[0] - at[0], to[1] - at[1]])],
      PIXEL_DAMPING ** 2,
    );
    next[joint] += clamp(step, -0.2, 0.2);
  }
  next[joint] = clamp(next[joint], Math.min(limits[0], q[joint]), Math.max(limits[1], q[joint]));
  return next;
}

const LENGTH_PER_RADIAN = 0.3; // m; weight of one radian of the tool direction

// Return the part of a motion (v, ω) that a dragged tip must match.
const selectTaskRows = (motion, turns) =>
  turns ? motion.map((v, i) => (i < 3 ? v : LENGTH_PER_RADIAN * v)) : motion.slice(0, 3);

const MAX_FRAME_STEP = 0.12; // rad or m that a joint moves in one frame
const REST_WEIGHT = 1e-4; // weight of the pull of the joints towards the start of the drag

/**
 * Move the joints one frame closer to a dragged tip's target, within their limits.
 * The joints are also pulled towards `rest`, so that dragging back returns them to where they were.
 * The step is capped after solving: a cap inside the loop makes a stretched arm tremble.
 * @param {Arm} arm
 * @param {number[]} start
 * @param {import("./state.js").Frame} target
 * @param {number[]} rest joint values at the start of the drag
 * @returns {{ q: number[], arrived: boolean }}
 */
export function dragTip(arm, start, target, rest, { turns = false } = {}) {
  const open = getJointRanges(arm).map(([lower, upper], k) => [
    Math.min(lower, start[k]),
    Math.max(upper, start[k]),
  ]);
  const problem = { arm, target, rest, turns, limits: open };
  let best = minimizeError(problem, start);
  if (isAtConfiguration(best.q, start) && norm(minus(target.o, best.frames.at(-1).o)) > 2e-3)
    best = searchAround(best, best.q, (q) => minimizeError(problem, q));
  const most = Math.max(1e-12, ...best.q.map((v, k) => Math.abs(v - start[k])));
  const share = Math.min(1, MAX_FRAME_STEP / most);
  return { q: start.map((v, k) => v + share * (best.q[k] - v)), arrived: share === 1 };
}

// Minimize the tip's error by damped steps; a step is accepted only if it reduces the cost.
function minimizeError({ arm, target, rest, turns, limits }, start) {
  const errorOf = (frames) => selectTaskRows(getPoseError(frames.at(-1), target), turns);
  const cost = (frames, q) =>
    norm(errorOf(frames)) ** 2 + REST_WEIGHT * q.reduce((s, v, k) => s + (v - rest[k]) ** 2, 0);
  let [q, lambda] = [start.map((v, k) => clamp(v, ...limits[k])), 1e-3];
  let frames = linkFrames(arm, q);
  let least = cost(frames, q);
  for (let round = 0; round < 12; round++) {
    const error = errorOf(frames);
    const J = jacobianColumns(arm, frames).map((c) => selectTaskRows(c, turns));
    const pull = J.map((column, k) => dotProduct(column, error) - REST_WEIGHT * (q[k] - rest[k]));
    const free = [...q.keys()].filter(
      (k) => !(q[k] <= limits[k][0] && pull[k] < 0) && !(q[k] >= limits[k][1] && pull[k] > 0),
    );
    const [columns, pulls] = [J, pull].map((of) => free.map((k) => of[k]));
    const step = solveDamped(columns, pulls, REST_WEIGHT + lambda);
    const next = [...q];
    free.forEach((k, i) => (next[k] = clamp(q[k] + step[i], ...limits[k])));
    const nextFrames = linkFrames(arm, next);
    const nextCost = cost(nextFrames, next);
    if (nextCost >= least) {
      lambda *= 6;
      continue;
    }
    const gain = least - nextCost;
    [q, frames, least, lambda] = [next, nextFrames, nextCost, Math.max(1e-5, lambda / 4)];
    if (gain < 1e-10) break;
  }
  return { q, frames, error: least };
}

/**
 * Find what keeps the tip from its target.
 * @param {Arm} arm
 * @param {number[]} q
 * @param {number[]} target
 * @returns {{ short: number, stops: string[] }} the remaining distance (m), and the reasons: joints
 *   at their limits, a joint at which the arm is stretched or folded
 */
export function findStopReasons(arm, q, target) {
  const frames = linkFrames(arm, q);
  const tip = frames.at(-1).o;
  const away = minus(target, tip);
  const short = norm(away);
  const stops = [];
  if (short < 2e-3 || !q.length) return { short, stops };
  const moving = movingRows(arm);
  const columns = jacobianColumns(arm, frames).map((c) => c.slice(0, 3));
  const limits = moving.map((row) => [
    arm.rows[row].lower ?? -Infinity,
    arm.rows[row].upper ?? Infinity,
  ]);
  const pull = columns.map((c) => dot(c, away) / short);
  const stuck = q.map(
    (v, k) =>
      (v <= limits[k][0] + 1e-6 && pull[k] < -1e-3) || (v >= limits[k][1] - 1e-6 && pull[k] > 1e-3),
  );
  stuck.forEach((is, k) => is && stops.push(`joint ${moving[k] + 1} at its limit`));
  const bent = findStraightJoint(arm, q, frames);
  const { values, vectors } = decomposeSingular(
    columns.filter((_, k) => !stuck[k]),
    3,
  );
  const lost = vectors.filter((_, i) => !(values[i] > 0.05 * values[0]));
  const along = lost.reduce((sum, v) => sum + (dot(v, away) / short) ** 2, 0);
  if (along > 0.5 && bent) stops.push(bent);
  else if (along > 0.5) stops.push("no joint moves the tip that way here");
  return { short, stops };
}

// a direction fades if its speed is below this share of the fastest direction's speed
const FADING_SHARE = 0.1;

/**
 * Find the directions in which the tip hardly moves, however fast the joints turn.
 * @param {number[][]} columns of the Jacobian
 * @param {boolean} turns whether the tool must keep its direction meanwhile
 * @param {number[]} rows the axes, of x, y and z, along which the tip can move at a configuration
 * @returns {{ direction: number[], share: number }[]} each direction and its speed, as a share of
 *   the fastest
 */
export function findFadingDirections(columns, turns = false, rows = [0, 1, 2]) {
  const moves = turns
    ? nullSpace(columns.map((c) => c.slice(3))).map((rates) =>
        rates.reduce((sum, rate, k) => plus(sum, scaled(rate, columns[k])), [0, 0, 0]),
      )
    : columns.map((c) => c.slice(0, 3));
  // With fewer joints than axes the tip never moves in every direction.
  if (moves.length < rows.length) return [];
  const picked = moves.map((move) => pick(move, rows));
  const { values, vectors } = decomposeSingular(picked, rows.length);
  const shares = values.map((value) => value / values[0]);
  const toAxes = (vector) => [0, 1, 2].map((i) => vector[rows.indexOf(i)] ?? 0);
  return vectors.flatMap((vector, i) =>
    shares[i] < FADING_SHARE ? [{ direction: toAxes(vector), share: shares[i] }] : [],
  );
}

// Return how clearly a fading direction is drawn: 0 where it starts to fade, 1 where it is lost.
export const getFadingStrength = ({ share }) => 1 - share / FADING_SHARE;

// Name the joint at which the arm is stretched straight or folded, or return null if there is none.
function findStraightJoint(arm, q, frames) {
  const moving = movingRows(arm);
  const base = frames[moving[1] ?? 0].o;
  const far = (p) => norm(minus(linkFrames(arm, p).at(-1).o, base));
  const here = far(q);
  let [best, words] = [0.01 * Math.max(here, 0.1), null];
  q.forEach((_, k) => {
    if (k === 0 || arm.rows[moving[k]].kind !== "revolute") return;
    const [less, more] = [-0.4, 0.4].map(
      (step) => far(q.map((v, i) => (i === k ? v + step : v))) - here,
    );
    const bend = Math.min(Math.abs(less), Math.abs(more));
    if (Math.sign(less) !== Math.sign(more) || bend < best) return;
    [best, words] = [
      bend,
      `joint ${moving[k] + 1} ${less < 0 ? "straight" : "folded"}, ` +
        `in line with joint ${moving[1] + 1} and the tip`,
    ];
  });
  return words;
}

// Return the rows of a motion (v, ω) that a pinned tip holds: of its orientation too if `turns`.
export const listHeldRows = (turns) => (turns ? [0, 1, 2, 3, 4, 5] : [0, 1, 2]);

/**
 * Move a grabbed link towards the pointer while the tip stays at a pose.
 * @param {Arm} arm
 * @param {number[]} q
 * @param {{ row: number, local: number[], to: number[], pixel: Pixel }} grab
 * @param {import("./state.js").Frame} pinnedPose pose at which the tip stays
 * @returns {{ q: number[], free: number }} new joint values and the dimension of the null space
 */
export function swingElbow(arm, q, grab, pinnedPose, { turns = true } = {}) {
  const limits = getJointRanges(arm);
  const within = (v, k) =>
    v >= Math.min(limits[k][0], q[k]) - 1e-9 && v <= Math.max(limits[k][1], q[k]) + 1e-9;
  const rows = listHeldRows(turns);
  let next = q;
  let free = 0;
  for (let round = 0; round < 4; round++) {
    const frames = linkFrames(arm, next);
    const still = nullSpace(jacobianColumns(arm, frames).map((column) => pick(column, rows)));
    free = still.length;
    if (!free) break;
    const moved = add(next, findElbowStep(arm, frames, still, grab));
    const { q: solution, error } = solvePose(arm, moved, pinnedPose, { rows });
    if (!solution.every(within) || error > 1e-4) break;
    next = solution;
  }
  return { q: next, free };
}

const add = (p, q) => p.map((v, k) => v + q[k]);

// Return the short step within the null space that moves the grabbed point closest to the pointer.
function findElbowStep(arm, frames, still, { row, local, to, pixel }) {
  const p = pointInBase(frames[row + 1], local);
  const moving = movingRows(arm);
  const before = jacobianColumns(arm, frames, p).filter((_, k) => moving[k] <= row);
  const rates = still.map((direction) => {
    const v = before.reduce((sum, c, k) => plus(sum, scaled(direction[k], c)), [0, 0, 0]);
    return projectMotion(pixel, p, v);
  });
  const away = minus([...to, 0], [...rates[0].at, 0]).slice(0, 2);
  const columns = rates.map(({ rate }) => rate);
  const step = solveDamped(
    columns,
    columns.map((rate) => dotProduct(rate, away)),
    PIXEL_DAMPING ** 2,
  );
  const share = Math.min(1, MAX_FRAME_STEP / Math.max(1e-12, ...step.map(Math.abs)));
  return moving.map((_, k) =>
    still.reduce((sum, direction, i) => sum + share * step[i] * direction[k], 0),
  );
}
