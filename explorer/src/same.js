// Whether two tables describe the same arm: what no choice of frames can change, as helpers/checks/axes.py has it.
// Compared are the kinds of the joints, distances and twists between neighbouring axes that turn, the offsets along
// them, and the place of the tip; free are directions and zeros of the joints, and where common normals between
// parallel axes stand.

import { cross, dot, joints, linkFrames, minus, norm, plus, scaled } from "./kinematics.js";
import { determinant, solvePositive } from "./linear.js";

const TINY = 1e-9; // m, or the sine of an angle: closer than this, axes meet or are parallel
const WITHIN_LENGTH = 1e-6; // m
const WITHIN_ANGLE = 1e-4; // rad
const NORMAL = -1; // stands for the common normal where joints are listed

/** @typedef {import("./arm.js").Arm} Arm */

/** @param {Arm} mine @param {Arm} reference */
export function sameArm(mine, reference) {
  const [ours, theirs] = [squared(mine), squared(reference)];
  const kinds = (arm) => joints(arm).map((row) => arm.rows[row].kind).join(); // prettier-ignore
  if (!joints(ours).length || kinds(ours) !== kinds(theirs)) return false;
  const pairs = gaps(ours).map((gap, i) => [gap, gaps(theirs)[i]]);
  // Each joint of the reference may point either way; the signs of neighbours must fit in every gap.
  let signs = [[]];
  for (const [gap, wanted] of pairs) {
    const next = gap.joints.reduce(
      (all, k) => all.flatMap((s) => (s[k] ? [s] : [with_(s, k, 1), with_(s, k, -1)])),
      signs,
    );
    signs = next.filter((s) => agree(gap, wanted, s));
    if (!signs.length) return false;
  }
  return true;
}

const with_ = (signs, k, sign) => Object.assign([...signs], { [k]: sign });

// Angles near a multiple of a right angle are meant as that.
function squared(arm) {
  const square = (angle) => {
    const turns = Math.round(angle / (Math.PI / 2));
    return Math.abs(angle - (turns * Math.PI) / 2) < WITHIN_ANGLE ? (turns * Math.PI) / 2 : angle;
  };
  return {
    ...arm,
    rows: arm.rows.map((row) => ({ ...row, alpha: square(row.alpha), theta: square(row.theta) })),
  };
}

function agree(mine, wanted, signs) {
  if (Math.abs(mine.length - wanted.length) > WITHIN_LENGTH) return false;
  for (const [key, value] of mine.shape) {
    if (!wanted.shape.has(key)) continue;
    const which = key.split(",").map(Number);
    const turned = wanted.shape.get(key) * which.reduce((p, k) => p * (k === NORMAL ? 1 : signs[k]), 1);
    if (which.length === 2 && Math.abs(arc(value) - arc(turned)) > WITHIN_ANGLE) return false;
    if (which.length === 3 && Math.abs(value - turned) > WITHIN_ANGLE) return false;
  }
  if (mine.fromBase || mine.offset === null || wanted.offset === null)
    return (mine.offset === null) === (wanted.offset === null);
  return Math.abs(mine.offset - signs[mine.joints[0]] * wanted.offset) <= WITHIN_LENGTH;
}

const arc = (cosine) => Math.acos(Math.max(-1, Math.min(1, cosine)));

// The gaps between turning axes from base to tip, with the slides where they make the lengths least.
function gaps(arm) {
  const moving = joints(arm);
  const slides = moving.flatMap((row, k) => (arm.rows[row].kind === "prismatic" ? [k] : []));
  const q = moving.map(() => 0);
  if (!slides.length) return walk(arm, q);
  const start = lengths(walk(arm, q));
  const rates = slides.map((k) =>
    lengths(
      walk(
        arm,
        q.map((_, i) => Number(i === k)),
      ),
    ).map((v, i) => v - start[i]),
  );
  const A = rates.map((u, i) =>
    rates.map((v, j) => u.reduce((s, x, k) => s + x * v[k], i === j ? 1e-15 : 0)),
  );
  const found = solvePositive(
    A,
    rates.map((u) => -u.reduce((s, x, k) => s + x * start[k], 0)),
  );
  slides.forEach((k, i) => (q[k] = found[i]));
  return walk(arm, q);
}

const lengths = (found) => [
  ...found.flatMap(({ normal }) => normal),
  ...found.flatMap(({ offset, fromBase }) => (offset === null || fromBase ? [] : [offset])),
];

function walk(arm, q) {
  const frames = linkFrames(arm, q);
  const moving = joints(arm);
  const axes = moving.map((row) => frames[row].z);
  const points = moving.map((row) => frames[row].o);
  const turning = moving.flatMap((row, k) => (arm.rows[row].kind === "revolute" ? [k] : []));
  const stops = [...turning, moving.length];
  const upTo = (from, to) =>
    Array.from({ length: Math.min(to + 1, moving.length) - from }, (_, k) => from + k);
  const found = [gap(axes, upTo(0, stops[0]), [0, 0, 0], null, true)];
  let foot = frames[0].o;
  let bunch = [];
  turning.forEach((i, n) => {
    const j = stops[n + 1];
    const last = j === moving.length;
    if (!bunch.length) foot = plus(points[i], scaled(dot(axes[i], minus(foot, points[i])), axes[i]));
    const [leave, arrive] = feet(foot, axes[i], last ? frames.at(-1).o : points[j], last ? null : axes[j]);
    bunch.push(i);
    const goesOn = !last && parallel(axes[i], axes[j]);
    const offset = goesOn ? null : dot(axes[i], minus(leave, foot));
    found.push(gap(axes, upTo(i, j), minus(arrive, leave), offset, bunch[0] === turning[0]));
    foot = arrive;
    if (!goesOn) bunch = [];
  });
  return found;
}

function gap(axes, which, normal, offset, fromBase) {
  const length = norm(normal);
  const directions = new Map(which.map((k) => [k, axes[k]]));
  if (length > TINY) directions.set(NORMAL, scaled(1 / length, normal));
  const keys = [...directions.keys()];
  const shape = new Map();
  which.forEach((i, n) => which.slice(n + 1).forEach((j) => shape.set([i, j].join(), dot(axes[i], axes[j]))));
  keys.forEach((i, a) =>
    keys.slice(a + 1).forEach((j, b) =>
      keys.slice(a + b + 2).forEach((k) => {
        shape.set([i, j, k].join(), determinant([i, j, k].map((key) => directions.get(key))));
      }),
    ),
  );
  return { joints: which, normal, length, shape, offset, fromBase };
}

// The feet of the common normal from the line (p, u) to the line (q, v), or to the point q.
function feet(p, u, q, v) {
  const away = minus(q, p);
  if (!v) return [plus(p, scaled(dot(u, away), u)), q];
  if (parallel(u, v)) return [p, plus(q, scaled(-dot(v, away), v))];
  const n = cross(u, v);
  const size = dot(n, n);
  const s = dot(cross(away, v), n) / size;
  const t = dot(cross(away, u), n) / size;
  return [plus(p, scaled(s, u)), plus(q, scaled(t, v))];
}

const parallel = (u, v) => norm(cross(u, v)) < TINY;
