// Frames placed by hand, as the Denavit-Hartenberg convention wants them: what may be chosen, what
// a choice violates, and the row that follows.

import {
  cross,
  dot,
  joints,
  linkFrames,
  minus,
  norm,
  plus,
  scaled,
} from "../../../judge/geometry/kinematics.js";

/** @typedef {{ x: number[], y: number[], z: number[], o: number[] }} Frame */
const TINY = 1e-6;

const unit = (v) => scaled(1 / norm(v), v);
const angleAbout = (axis, from, to) => Math.atan2(dot(axis, cross(from, to)), dot(from, to));
const isNew = (found, p) => found.every((q) => norm(minus(p, q)) > 1e-4);

// The bare arm: the line of each joint, the tip, and the first frame, with slides drawn out so that
// they can be seen.
export function bareArm(arm) {
  const q = joints(arm).map((row, k) =>
    arm.rows[row].kind === "prismatic" ? Math.max(0.3, arm.home[k] || 0) : 0,
  );
  const frames = linkFrames(arm, q);
  const axes = joints(arm).map((row) => ({ z: frames[row].z, o: frames[row].o, row }));
  return { q, frames, axes, base: frames[0], end: frames.at(-1) };
}

// The feet of the common normal from the line (p, u) to the line (q, v); from parallel lines it
// starts at p.
function feet(p, u, q, v) {
  const away = minus(q, p);
  const n = cross(u, v);
  const size = dot(n, n);
  if (size < TINY) return [p, plus(q, scaled(-dot(v, away), v))];
  return [
    plus(p, scaled(dot(cross(away, v), n) / size, u)),
    plus(q, scaled(dot(cross(away, u), n) / size, v)),
  ];
}

/**
 * The places and directions among which frame `i` is chosen, right ones and wrong ones, after the
 * frames before it.
 * @param {ReturnType<typeof bareArm>} bare
 * @param {Frame[]} placed
 */
export function choices(bare, placed) {
  const i = placed.length;
  const before = placed[i - 1];
  const last = i === bare.axes.length;
  const axis = last ? { z: before.z, o: bare.end.o } : bare.axes[i];
  const [, foot] = feet(before.o, before.z, axis.o, axis.z);
  const next = bare.axes[i + 1];
  const points = [];
  const wanted = last
    ? [bare.end.o]
    : [foot, axis.o, ...(next ? [feet(axis.o, axis.z, next.o, next.z)[0]] : [])];
  for (const p of wanted) if (isNew(points, p)) points.push(p);
  if (!last)
    for (const p of [...points]) if (points.length < 3) points.push(plus(p, scaled(0.12, axis.z)));
  return { zs: [axis.z, scaled(-1, axis.z)], points: points.slice(0, 4), axis };
}

// Directions for x at a frame with this z: along and across the common normal with the z before,
// both ways.
export function directions(before, z, o) {
  let n = cross(before.z, z);
  if (norm(n) < TINY)
    n = minus(minus(o, before.o), scaled(dot(minus(o, before.o), before.z), before.z));
  if (norm(n) < TINY) n = before.x;
  n = unit(n);
  const across = unit(cross(z, n));
  return [n, scaled(-1, n), across, scaled(-1, across)];
}

// What is wrong with a frame after the one before it, in words, or null.
export function violation(before, { x, z, o }, i) {
  if (Math.abs(dot(x, z)) > 1e-4) return `x_${i} is not at a right angle to z_${i}.`;
  if (Math.abs(dot(x, before.z)) > 1e-4)
    return (
      `x_${i} is not at a right angle to z_${i - 1}: ` +
      `no α about x_${i} can then turn z_${i - 1} into z_${i}.`
    );
  const away = minus(o, before.o);
  const rest = minus(minus(away, scaled(dot(away, before.z), before.z)), scaled(dot(away, x), x));
  if (norm(rest) > 1e-4)
    return (
      `The line of x_${i} does not meet the axis z_${i - 1}: ` +
      `no slide a along x_${i} can then bring o_${i} there.`
    );
  return null;
}

// The four numbers between two frames.
export function rowBetween(before, after, kind, slide) {
  const away = minus(after.o, before.o);
  const d = dot(away, before.z);
  return {
    kind,
    a: dot(away, after.x),
    alpha: angleAbout(after.x, before.z, after.z),
    d: kind === "prismatic" ? d - slide : d,
    theta: angleAbout(before.z, before.x, after.x),
  };
}

export const frameOf = (z, x, o) => ({ x, y: cross(z, x), z, o });

// The table that placed frames make.
export function tableOf(arm, bare, placed) {
  return placed.slice(1).map((frame, k) => {
    const { row } = bare.axes[k];
    const sign = Math.sign(dot(placed[k].z, bare.axes[k].z));
    return rowBetween(placed[k], frame, arm.rows[row].kind, sign * bare.q[k]);
  });
}

// An arm that nobody has seen before, with right angles and round lengths.
export function randomArm(roll = Math.random) {
  const pick = (list) => list[Math.floor(roll() * list.length)];
  const count = pick([3, 4, 5]);
  const rows = Array.from({ length: count }, (_, i) => {
    const last = i === count - 1;
    const a = pick(last ? [0.15, 0.2] : [0, 0.2, 0.3]);
    const d = i === 0 ? 0.3 : pick(a ? [0, 0, 0.15] : [0.2, 0.25]);
    const kind = i > 0 && !last && roll() < 0.2 ? "prismatic" : "revolute";
    const turn = pick([0, Math.PI / 2, -Math.PI / 2]);
    const limits = { lower: null, upper: null, speed: null, effort: null };
    return { kind, a, alpha: last ? 0 : turn, d, theta: 0, ...limits };
  });
  return {
    name: "An arm of its own",
    home: rows.map((row) => (row.kind === "prismatic" ? 0.3 : 0)),
    rows,
  };
}
