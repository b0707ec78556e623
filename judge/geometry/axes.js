// Compares two tables by what all Denavit-Hartenberg tables of one arm have in common. Revolute
// axes are lines in space: each has a distance and a twist to the next one, and an offset between
// the feet of its two common normals. Along parallel axes only the sum of the offsets is
// determined. A prismatic axis has a direction and no position. A table is free to choose the
// direction of each axis; the comparison therefore chooses a sign per joint.

import { cross, dot, movingRows, linkFrames, norm } from "./kinematics.js";
import { snapRows } from "./rows.js";
import { listGaps, NORMAL_INDEX, TINY } from "./walk.js";

/** @typedef {import("./arm.js").Row} Row */

/**
 * The gap from one revolute axis to the next one or to the tip, with the prismatic axes between.
 * @typedef {object} Gap
 * @property {number[]} joints the joints in the gap, by index from 0
 * @property {number[]} normal the common normal, from the first axis to the last (m)
 * @property {number} length of the normal (m)
 * @property {Map<string, number>} shape dot and triple products of the gap's directions, by the
 *   indices of their joints ("0,1"); they determine the directions up to a rotation
 * @property {number | null} offset along the axis (m); null while the next axis is parallel
 * @property {number[]} bunch the parallel axes whose offsets are added up
 * @property {boolean} fromBase whether the offset depends on the base frame alone
 * @property {boolean} toTip
 */

/**
 * The axes of one table, ready to be compared.
 * @typedef {object} AxisWalk
 * @property {Row[]} rows
 * @property {number[]} joints the rows that move, counted from 1
 * @property {Gap[]} gaps
 * @property {number} tilt cosine of the angle between the last joint axis and the last frame's z
 * @property {[number, number]} foot distance (m) and angle (rad) from z_0 to axis 1, not 0 only if
 *   fixed rows come first
 * @property {number[]} axis the direction of axis 1
 * @property {number} up -1 if axis 1 points down, else 1
 */

/**
 * One difference between two tables.
 * @typedef {object} Difference
 * @property {string} key of its message
 * @property {number} row where it shows, counted from 1
 * @property {string} entry a, alpha, d, theta, "joint" or "joints"
 * @property {any} mine its value in the student's table (m, rad or a kind of joint)
 * @property {any} reference its value in the reference
 * @property {number[]} ends the joints that it lies between; 0 for the base and the tip
 */

/**
 * The result of comparing two tables with the best choice of signs.
 * @typedef {object} AxisComparison
 * @property {Difference[]} differences none if both describe one arm
 * @property {number[]} signs for each joint 1, or -1 if its axis points the other way
 * @property {number} baseHigher how much higher the student's base frame is on axis 1 (m)
 * @property {boolean} upsideDown whether z_0 points the other way
 * @property {[number, number]} tilts the angle from the last joint axis to the last frame's z (rad)
 */

/** Describe the axes of a table with at least one joint. @param {Row[]} rows @returns {AxisWalk} */
export function describeAxes(rows) {
  const moving = movingRows({ rows });
  const numbers = moving.map((i) => i + 1);
  return {
    rows,
    joints: numbers,
    gaps: listGaps({ rows }),
    tilt: tilt({ rows }, moving),
    ...foot(rows, moving[0]),
  };
}

// Axis 1 relative to z_0.
/** @returns {{ foot: [number, number], axis: number[], up: number }} */
function foot(rows, first) {
  const { z, o } = linkFrames({ rows: rows.slice(0, first) }, []).at(-1);
  const n = cross([0, 0, 1], z);
  const far = norm(n) > TINY ? Math.abs(dot(o, n)) / norm(n) : Math.hypot(o[0], o[1]);
  return {
    foot: [rows[first].kind === "revolute" ? far : 0, clampedAcos(Math.abs(z[2]))],
    axis: z,
    up: z[2] < -TINY ? -1 : 1,
  };
}

function tilt(arm, moving) {
  const frames = linkFrames(
    arm,
    moving.map(() => 0),
  );
  return dot(frames[moving.at(-1)].z, frames.at(-1).z);
}

// The comparison

/**
 * Compare two arms, choosing the signs of the axes that leave the fewest differences. The signs are
 * chosen gap by gap from the base, and for each sign of the last axis the cheapest choice is kept.
 * @param {AxisWalk} mine
 * @param {AxisWalk} reference
 * @param {number} [length] tolerance of lengths (m)
 * @param {number} [angle] tolerance of angles (rad)
 * @returns {AxisComparison}
 */
export function compareAxes(mine, reference, length = 1e-6, angle = 1e-4) {
  const unlike = compareKinds(mine, reference);
  if (unlike.length)
    return { differences: unlike, signs: [], baseHigher: 0, upsideDown: false, tilts: [0, 0] };
  const feet = compareFeet(mine, reference, length, angle);
  const far = feet.reduce((sum, x) => sum + Math.abs(x.mine - x.reference), 0);
  let best = new Map(
    [1, -1].map((s) => [s, { cost: [feet.length, far, 0], signs: [s], found: feet }]),
  );
  const sides = { mine, reference, within: { length, angle } };
  for (const gap of mine.gaps.keys()) best = extendBest(sides, gap, best);
  const ends = [...best].map(([last, { cost, signs, found }]) => {
    /** @type {[number, number]} */
    const tilts = [clampedAcos(mine.tilt), clampedAcos(last * reference.tilt)];
    const note = Number(angleDistance(...tilts) > angle);
    const total = signs.reduce((sum, s) => sum + s, 0);
    return { cost: [cost[0], cost[1], cost[2] + note, -total], signs, differences: found, tilts };
  });
  const { signs, differences, tilts } = ends.reduce((p, q) => (isCheaper(q.cost, p.cost) ? q : p));
  const turned = {
    baseHigher: measureBaseHeight(mine, reference, signs),
    upsideDown: isUpsideDown(mine, reference, signs),
  };
  return { differences, signs, ...turned, tilts };
}

/**
 * Return whether two tables describe the same arm, whatever frames they choose.
 * @param {Row[]} mine @param {Row[]} reference
 */
export function isSameMachine(mine, reference) {
  const [ours, theirs] = [mine, reference].map(snapRows);
  return !compareAxes(describeAxes(ours), describeAxes(theirs)).differences.length;
}

// Return whether z_0 points the other way. A level axis 1 cannot show it.
const isUpsideDown = (mine, reference, signs) =>
  !isLevel(mine) && signs[0] * mine.up * reference.up < 0;

// Return whether axis 1 points neither up nor down.
const isLevel = ({ axis }) => Math.abs(axis[2]) < TINY;

// Return whether the costs p are lower than q: the first that differs decides.
function isCheaper(p, q) {
  const k = p.findIndex((x, i) => x !== q[i]);
  return k >= 0 && p[k] < q[k];
}

// List all combinations of this many signs, 1 before -1.
const listSigns = (count) =>
  Array.from({ length: 2 ** count }, (_, k) =>
    Array.from({ length: count }, (__, i) => ((k >> (count - 1 - i)) & 1 ? -1 : 1)),
  );

// Return the cheapest choice of signs up to the end of a gap, for each sign of its last joint. Each
// gap begins with the last joint of the previous one.
function extendBest(sides, gap, best) {
  const { joints: between } = sides.mine.gaps[gap];
  const found = new Map();
  for (const chosen of listSigns(between.length)) {
    const choice = extendChoice(sides, gap, chosen, best.get(chosen[0]));
    const last = chosen.at(-1);
    if (!found.has(last) || isCheaper(choice.cost, found.get(last).cost)) found.set(last, choice);
  }
  return found;
}

// Add the signs of a gap's joints to a choice. Its cost is the number of differences, then their
// size, then the number of remarks.
function extendChoice(
  { mine, reference, within },
  gap,
  chosen,
  { cost, signs: before, found: old },
) {
  const [m, r] = [mine.gaps[gap], reference.gaps[gap]];
  const signs = new Map(m.joints.map((k, i) => [k, chosen[i]]));
  const alike = isBaseHeightGap(m) && isBaseHeightGap(r) && `${m.bunch}` === `${r.bunch}`;
  const note = alike && Math.abs(heightDifference(m, r, chosen[0])) > within.length;
  const turned =
    isUpsideDown(mine, reference, before) ||
    (isLevel(mine) && before[0] * dot(mine.axis, reference.axis) < 0);
  const fresh = compareGap(mine, m, r, signs, within);
  const far = fresh.reduce((sum, x) => sum + Math.abs(x.mine - x.reference), cost[1]);
  const notes = cost[2] + Number(note) + Number(turned);
  return {
    cost: [cost[0] + fresh.length, Number(far.toFixed(9)), notes],
    signs: [...before, ...chosen.slice(1)],
    found: [...old, ...fresh],
  };
}

/** @returns {Difference} */
const difference = (key, [row, entry], [mine, reference], ends = [0, 0]) => ({
  key,
  row,
  entry,
  mine,
  reference,
  ends,
});

/** Return whether a gap's offset is the height of the base frame, and no slide makes up for it. */
export const isBaseHeightGap = ({ fromBase, offset, bunch, joints: between, toTip }) =>
  fromBase &&
  offset !== null &&
  bunch.every((k, i) => k === i) &&
  between.length + Number(toTip) === 2;

const heightDifference = (m, r, sign) => sign * (r.offset ?? 0) - (m.offset ?? 0);

function measureBaseHeight(mine, reference, signs) {
  const [m, r] = [mine, reference].map((s) => s.gaps.find(isBaseHeightGap));
  if (!m || !r || `${m.bunch}` !== `${r.bunch}`) return 0;
  // The height is along the last of parallel axes, which may point the other way than axis 1.
  const within = mine.gaps.slice(1, m.bunch.length);
  const turned = within.reduce((x, g) => x * g.shape.get(`${g.joints}`), 1);
  return mine.up * Math.round(turned) * heightDifference(m, r, signs[m.bunch.at(-1)]);
}

function compareKinds(mine, reference) {
  const [ours, theirs] = [mine.joints, reference.joints];
  if (ours.length !== theirs.length) {
    const row = ours[Math.min(ours.length, theirs.length) - 1];
    return [difference("table count", [row, "joints"], [ours.length, theirs.length])];
  }
  return ours.flatMap((i, k) => {
    const [kind, wanted] = [mine.rows[i - 1].kind, reference.rows[theirs[k] - 1].kind];
    return kind === wanted ? [] : [difference("table kind", [i, "joint"], [kind, wanted])];
  });
}

// Compare the distance and the angle of axis 1 from z_0. Its direction is free.
function compareFeet(mine, reference, length, angle) {
  const [[far, lean], [other, wanted]] = [mine.foot, reference.foot];
  const ends = [0, mine.joints[0]];
  const found = [];
  if (Math.abs(lean - wanted) > angle)
    found.push(difference("table lean", [1, "alpha"], [lean, wanted], ends));
  if (Math.abs(far - other) > length)
    found.push(difference("table foot", [1, "a"], [far, other], ends));
  return found;
}

function compareGap(mine, m, r, signs, { length, angle }) {
  const found = [];
  const first = mine.joints[m.joints[0]];
  if (Math.abs(m.length - r.length) > length) {
    const end = m.toTip ? 0 : mine.joints[m.joints.at(-1)];
    found.push(difference("table distance", [first, "a"], [m.length, r.length], [first, end]));
  }
  const turned = compareTwists(mine, m, r, signs, angle);
  found.push(...(turned.length ? turned : compareSlides(mine, m, r, signs, angle)));
  if (m.fromBase || `${m.bunch}` !== `${r.bunch}` || m.offset === null || r.offset === null)
    return found;
  const wanted = signs.get(m.joints[0]) * r.offset;
  if (Math.abs(m.offset - wanted) > length) {
    const ends = [mine.joints[m.bunch[0]], mine.joints[m.bunch.at(-1)]];
    found.push(difference("table along", [ends[1], "d"], [m.offset, wanted], ends));
  }
  return found;
}

function compareTwists(mine, m, r, signs, angle) {
  return m.joints.slice(1).flatMap((j, k) => {
    const pair = [m.joints[k], j];
    const normal = `${[...pair, NORMAL_INDEX]}`;
    const sided = m.joints.length === 2 && m.shape.has(normal) && r.shape.has(normal);
    const [x, y] = [twist(m, pair, sided, new Map()), twist(r, pair, sided, signs)];
    if (angleDistance(x, y) <= angle) return [];
    const ends = pair.map((i) => mine.joints[i]);
    return [difference("table between", [ends[0], "alpha"], [x, y], ends)];
  });
}

// Return the angle between two axes: signed about their common normal if `sided`, else 0 to pi.
function twist(gap, pair, sided, signs) {
  const cosine = product(gap, pair, signs);
  return sided
    ? Math.atan2(product(gap, [...pair, NORMAL_INDEX], signs), cosine)
    : clampedAcos(cosine);
}

// Return a product of the gap's directions, each multiplied by its joint's sign.
const product = (gap, which, signs) =>
  which.reduce((x, k) => x * (signs.get(k) ?? 1), gap.shape.get(`${which}`));

// A slide does not turn: it holds the axes before and after it at a fixed angle about itself, and
// the shortest line across it has a direction.
function compareSlides(mine, m, r, signs, angle) {
  const slides = m.joints.some((k) => mine.rows[mine.joints[k] - 1].kind === "prismatic");
  const both = slides ? [...m.shape.keys()].filter((key) => r.shape.has(key)) : [];
  const off = (key) => Math.abs(m.shape.get(key) - product(r, key.split(",").map(Number), signs));
  if (both.every((key) => off(key) <= angle)) return [];
  const about = anglesAboutSlides(mine, m, r, signs).find(
    ([, x, y]) => angleDistance(x, y) > angle,
  );
  if (about) return [difference("table held", [about[0], "theta"], about.slice(1))];
  const [start, end] = [0, -1].map((k) => mine.joints[m.joints.at(k)]);
  return [difference("table side", [start, "a"], [0, Math.PI], [start, m.toTip ? 0 : end])];
}

// List for each slide between axes not parallel to it: its row, and in each table the angle about
// it from the common normal before it to the one after it. Its direction is chosen near theta.
function anglesAboutSlides(mine, m, r, signs) {
  const skew = (...pair) => 1 - m.shape.get(`${pair}`) ** 2 > TINY;
  return m.joints.slice(1, -1).flatMap((k) => {
    const before = m.joints.filter((i) => i < k && skew(i, k)).at(-1);
    const after = m.joints.find((j) => j > k && skew(k, j));
    if (before === undefined || after === undefined) return [];
    const [three, row] = [[before, k, after], mine.joints[k]];
    // 2 rad instead of a right angle, where rounding would choose the direction.
    const back =
      angleDistance(angleAboutSecond(m, three, new Map(), 1), mine.rows[row - 1].theta) > 2;
    const direction = back ? -1 : 1;
    return [
      [
        row,
        angleAboutSecond(m, three, new Map(), direction),
        angleAboutSecond(r, three, signs, direction),
      ],
    ];
  });
}

// Return the angle about the second of three axes, from the common normal of the first two to that
// of the last two.
function angleAboutSecond(gap, three, signs, direction) {
  const [i, k, j] = three;
  const [u, v, w] = [
    [i, k],
    [k, j],
    [i, j],
  ].map((pair) => product(gap, pair, signs));
  const angle = Math.atan2(direction * product(gap, three, signs), direction * (u * v - w));
  return angle < TINY - Math.PI ? Math.PI : angle;
}

/** Return acos of a cosine that rounding may have taken past 1. */
export const clampedAcos = (cosine) => Math.acos(Math.max(-1, Math.min(1, cosine)));

/** Return the distance of two angles, whole turns aside (rad). */
export function angleDistance(left, right) {
  const turn = 2 * Math.PI;
  const over = (left - right + Math.PI) % turn;
  return Math.abs((over < 0 ? over + turn : over) - Math.PI);
}
