// An arm taken by the hand: a link that turns its joint, a tip that the arm follows, an elbow that
// swings while the tip stays. Everything here keeps the joints within their limits, and says what
// stops them.

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
  scaled,
} from "../../judge/geometry/kinematics.js";
import { nullSpace, decomposeSingular } from "../../judge/geometry/linear.js";
import { damped, inner, isThere, orBeside, poseError, reach } from "./motion.js";

/** @typedef {import("../../judge/geometry/arm.js").Arm} Arm */
/** @typedef {(point: number[]) => number[]} Pixel from a point of the world to CSS pixels */

const limitsOf = (arm) => movingRows(arm).map((i) => jointRange(arm.rows[i]));
const clamped = (value, [lower, upper]) => Math.min(upper, Math.max(lower, value));

// A point of a link's frame in the world, and back.
const inWorld = ({ x, y, z, o }, local) =>
  plus(o, plus(plus(scaled(local[0], x), scaled(local[1], y)), scaled(local[2], z)));
export const inFrame = ({ x, y, z, o }, p) => [x, y, z].map((axis) => dot(axis, minus(p, o)));

const SOFT = 30; // px per rad: below it a link seen end-on hardly turns, instead of jumping
const PIXEL_STEP = 1e-4; // rad or m, over which a pixel's motion is measured

// How a point that moves with velocity v goes over the screen.
function onScreen(pixel, p, v) {
  const [a, b] = [pixel(p), pixel(plus(p, scaled(PIXEL_STEP, v)))];
  return { at: a, rate: [(b[0] - a[0]) / PIXEL_STEP, (b[1] - a[1]) / PIXEL_STEP] };
}

/**
 * Joint values after the point `local` of the frame that row `row` carries went towards the pointer
 * `to`, by one joint alone: the one with this index in q.
 * @param {Arm} arm
 * @param {number[]} q
 * @param {{ row: number, local: number[], to: number[], joint: number, pixel: Pixel }} grab
 */
export function dragLink(arm, q, { row, local, to, joint, pixel }) {
  const index = movingRows(arm)[joint];
  const turns = arm.rows[index].kind === "revolute";
  const limits = jointRange(arm.rows[index]);
  const next = [...q];
  for (let round = 0; round < 4; round++) {
    const frames = linkFrames(arm, next);
    const p = inWorld(frames[row + 1], local);
    const { z, o } = frames[index];
    const { at, rate } = onScreen(pixel, p, turns ? cross(z, minus(p, o)) : z);
    const [step] = damped([rate], [inner(rate, [to[0] - at[0], to[1] - at[1]])], SOFT ** 2);
    next[joint] += clamped(step, [-0.2, 0.2]);
  }
  next[joint] = clamped(next[joint], [
    Math.min(limits[0], q[joint]),
    Math.max(limits[1], q[joint]),
  ]);
  return next;
}

const TURN = 0.3; // m that a radian of the tool's direction counts for, where it is to be kept

// Of a motion (v, ω) what a dragged tip is asked for.
const task = (motion, turns) =>
  turns ? motion.map((v, i) => (i < 3 ? v : TURN * v)) : motion.slice(0, 3);

const MOST = 0.12; // rad or m that a joint moves in a frame
const TO_REST = 1e-4; // how much each joint is drawn to where the drag began

/**
 * One frame of a dragged tip: the joint values a little nearer to those that bring the tip to the
 * target, never past a limit, and near `rest`, where the drag began, so that the way back is the
 * way there. The cap on a frame's motion comes after the solution, since inside the loop it makes a
 * stretched arm tremble.
 * @param {Arm} arm
 * @param {number[]} start
 * @param {import("./state.js").Frame} target
 * @param {number[]} rest
 */
export function dragTip(arm, start, target, rest, { turns = false } = {}) {
  const open = limitsOf(arm).map(([lower, upper], k) => [
    Math.min(lower, start[k]),
    Math.max(upper, start[k]),
  ]);
  const problem = { arm, target, rest, turns, limits: open };
  let best = descend(problem, start);
  if (isThere(best.q, start) && norm(minus(target.o, best.frames.at(-1).o)) > 2e-3)
    best = orBeside(best, best.q, (q) => descend(problem, q));
  const most = Math.max(1e-12, ...best.q.map((v, k) => Math.abs(v - start[k])));
  const share = Math.min(1, MOST / most);
  return { q: start.map((v, k) => v + share * (best.q[k] - v)), arrived: share === 1 };
}

// By damped steps, of which each is taken only if it leads nearer.
function descend({ arm, target, rest, turns, limits }, start) {
  const errorOf = (frames) => task(poseError(frames.at(-1), target), turns);
  const cost = (frames, q) =>
    norm(errorOf(frames)) ** 2 + TO_REST * q.reduce((s, v, k) => s + (v - rest[k]) ** 2, 0);
  let [q, lambda] = [start.map((v, k) => clamped(v, limits[k])), 1e-3];
  let frames = linkFrames(arm, q);
  let least = cost(frames, q);
  for (let round = 0; round < 12; round++) {
    const error = errorOf(frames);
    const J = jacobianColumns(arm, frames).map((c) => task(c, turns));
    const pull = J.map((column, k) => inner(column, error) - TO_REST * (q[k] - rest[k]));
    const free = [...q.keys()].filter(
      (k) => !(q[k] <= limits[k][0] && pull[k] < 0) && !(q[k] >= limits[k][1] && pull[k] > 0),
    );
    const [columns, pulls] = [J, pull].map((of) => free.map((k) => of[k]));
    const step = damped(columns, pulls, TO_REST + lambda);
    const next = [...q];
    free.forEach((k, i) => (next[k] = clamped(q[k] + step[i], limits[k])));
    const there = linkFrames(arm, next);
    const found = cost(there, next);
    if (found >= least) {
      lambda *= 6;
      continue;
    }
    const gain = least - found;
    [q, frames, least, lambda] = [next, there, found, Math.max(1e-5, lambda / 4)];
    if (gain < 1e-10) break;
  }
  return { q, frames, error: least };
}

/**
 * What keeps the tip from the target: how far it is short of it (m), which joints stand at their
 * limits there, and whether the arm is stretched out or folded at a joint.
 * @param {Arm} arm
 * @param {number[]} q
 * @param {number[]} target
 */
export function whyStopped(arm, q, target) {
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
  const bent = bentJoint(arm, q, frames);
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

// share of the quickest direction's speed below which a direction counts as fading
const NEAR = 0.1;

/**
 * The directions in which the tip hardly moves, or not at all, however fast the joints turn: { way,
 * share }, the share being its speed beside that in the quickest direction. With `turns` the tool
 * keeps its direction meanwhile.
 * @param {number[][]} columns of the Jacobian
 */
export function fadingWays(columns, turns = false) {
  const moves = turns
    ? nullSpace(columns.map((c) => c.slice(3))).map((rates) =>
        rates.reduce((sum, rate, k) => plus(sum, scaled(rate, columns[k])), [0, 0, 0]),
      )
    : columns.map((c) => c.slice(0, 3));
  if (moves.length < 3) return []; // it never could go everywhere
  const { values, vectors } = decomposeSingular(moves, 3);
  const shares = values.map((value) => value / values[0]);
  return vectors.flatMap((way, i) => (shares[i] < NEAR ? [{ way, share: shares[i] }] : []));
}

// How plainly a fading direction is shown: 0 where it begins to fade, 1 where it is gone.
export const goneness = ({ share }) => 1 - share / NEAR;

// The joint at which the arm is stretched straight or folded flat, in words; null where it is bent.
function bentJoint(arm, q, frames) {
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
      less < 0 ? `joint ${moving[k] + 1} straight` : `joint ${moving[k] + 1} folded`,
    ];
  });
  return words;
}

/**
 * Joint values after the grabbed point of a link went towards the pointer while the tip stays where
 * `held` says: only through the null space. `free` says how many dimensions that has; 0 where the
 * held tip leaves no freedom.
 * @param {Arm} arm
 * @param {number[]} q
 * @param {{ row: number, local: number[], to: number[], pixel: Pixel }} grab
 * @param {{ o: number[], x: number[], y: number[], z: number[] }} held
 */
export function swingElbow(arm, q, grab, held, { turns = true } = {}) {
  const limits = limitsOf(arm);
  const within = (v, k) =>
    v >= Math.min(limits[k][0], q[k]) - 1e-9 && v <= Math.max(limits[k][1], q[k]) + 1e-9;
  let next = q;
  let free = 0;
  for (let round = 0; round < 4; round++) {
    const frames = linkFrames(arm, next);
    const still = nullSpace(jacobianColumns(arm, frames).map((c) => c.slice(0, turns ? 6 : 3)));
    free = still.length;
    if (!free) break;
    const moved = added(next, stepWithin(arm, frames, still, grab));
    const { q: there, error } = reach(arm, moved, held, { rows: turns ? 6 : 3 });
    if (!there.every(within) || error > 1e-4) break;
    next = there;
  }
  return { q: next, free };
}

const added = (p, q) => p.map((v, k) => v + q[k]);

// The motion along the directions `still`, a short one, that takes the grabbed point nearest to
// the pointer.
function stepWithin(arm, frames, still, { row, local, to, pixel }) {
  const p = inWorld(frames[row + 1], local);
  const moving = movingRows(arm);
  const before = jacobianColumns(arm, frames, p).filter((_, k) => moving[k] <= row);
  const rates = still.map((direction) => {
    const v = before.reduce((sum, c, k) => plus(sum, scaled(direction[k], c)), [0, 0, 0]);
    return onScreen(pixel, p, v);
  });
  const away = minus([...to, 0], [...rates[0].at, 0]).slice(0, 2);
  const columns = rates.map(({ rate }) => rate);
  const step = damped(
    columns,
    columns.map((rate) => inner(rate, away)),
    SOFT ** 2,
  );
  const share = Math.min(1, MOST / Math.max(1e-12, ...step.map(Math.abs)));
  return moving.map((_, k) =>
    still.reduce((sum, direction, i) => sum + share * step[i] * direction[k], 0),
  );
}
