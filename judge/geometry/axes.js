// What all Denavit-Hartenberg tables of one arm have in common: the axes that turn are lines in
// space, with a distance and a twist from one to the next, and an offset on each between the feet
// of the two common normals; along parallel axes only the sum of the offsets is fixed. An axis that
// slides has a direction and no place. What is left open is which way each axis points: a sign per
// joint, which the comparison chooses.

import { cross, dot, movingRows, linkFrames, norm } from "./kinematics.js";
import { snapRows } from "./rows.js";
import { listGaps, NORMAL_INDEX, TINY } from "./walk.js";

/**
 * A row of a table in m and rad.
 * @typedef {{ kind: string, a: number, alpha: number, d: number, theta: number }} TableRow
 */

/**
 * From one turning axis to the next, or to the tip, across the slides between them. `joints` are
 * listed by position, from 0; `shape` holds the products that fix the directions in the gap, by
 * their joints; `offset` is null while the parallel axes `bunch` go on.
 * @typedef {object} Gap
 * @property {number[]} joints
 * @property {number[]} normal
 * @property {number} length
 * @property {Map<string, number>} shape
 * @property {number | null} offset
 * @property {number[]} bunch
 * @property {boolean} fromBase whether the offset only tells where the base frame stands
 * @property {boolean} toTip
 */

/**
 * One table's walk, ready to be compared: `joints` are the rows that move, counted from 1; `foot`
 * is how far axis 1 passes from z_0 and how far it leans from it, none but where fixed rows come
 * first; `axis` is its direction.
 * @typedef {{
 * rows: TableRow[], joints: number[], gaps: Gap[], tilt: number, foot: [number, number], axis:
 * number[], up: number, }} AxisWalk
 */

/**
 * What differs in a gap: the key of its sentence, the row and entry it shows in, what it is in both
 * tables (m, rad, or words), and the joints it lies between, 0 for the base and the tip.
 * @typedef {{ key: string, row: number, entry: string, mine: any, reference: any, ends: number[] }}
 *   Difference
 */

/**
 * The differences that are left, which way each axis points, and how the base and the last frame
 * stand.
 * @typedef {object} AxisComparison
 * @property {Difference[]} differences
 * @property {number[]} signs
 * @property {number} baseHigher
 * @property {boolean} upsideDown whether z_0 points the other way
 * @property {[number, number]} tilts
 */

// A table's walk; it needs a joint.
/** @param {TableRow[]} rows @returns {AxisWalk} */
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

// How axis 1 stands to z_0; `up` is -1 where it points down.
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

// The cosine of the angle between the last joint axis and the z axis of the last frame.
function tilt(arm, moving) {
  const frames = linkFrames(
    arm,
    moving.map(() => 0),
  );
  return dot(frames[moving.at(-1)].z, frames.at(-1).z);
}

// Two walks side by side

// Two arms, lengths compared to within `length` (m) and angles to within `angle` (rad); the signs
// of the axes are chosen gap by gap from the base on, keeping for each sign of the last axis the
// cheapest choice.
/** @param {AxisWalk} mine @param {AxisWalk} reference @returns {AxisComparison} */
export function compareAxes(mine, reference, length = 1e-6, angle = 1e-4) {
  const unlike = unlikeJoints(mine, reference);
  if (unlike.length)
    return { differences: unlike, signs: [], baseHigher: 0, upsideDown: false, tilts: [0, 0] };
  const feet = stands(mine, reference, length, angle);
  const far = feet.reduce((sum, x) => sum + Math.abs(x.mine - x.reference), 0);
  let best = new Map(
    [1, -1].map((s) => [s, { cost: [feet.length, far, 0], signs: [s], found: feet }]),
  );
  const sides = { mine, reference, within: { length, angle } };
  for (const gap of mine.gaps.keys()) best = step(sides, gap, best);
  const ends = [...best].map(([last, { cost, signs, found }]) => {
    /** @type {[number, number]} */
    const tilts = [clampedAcos(mine.tilt), clampedAcos(last * reference.tilt)];
    const note = Number(angleDistance(...tilts) > angle);
    const total = signs.reduce((sum, s) => sum + s, 0);
    return { cost: [cost[0], cost[1], cost[2] + note, -total], signs, differences: found, tilts };
  });
  const { signs, differences, tilts } = ends.reduce((p, q) => (less(q.cost, p.cost) ? q : p));
  const turned = {
    baseHigher: baseHigher(mine, reference, signs),
    upsideDown: upsideDown(mine, reference, signs),
  };
  return { differences, signs, ...turned, tilts };
}

// Whether two tables describe the same machine, whatever frames they choose.
/** @param {TableRow[]} mine @param {TableRow[]} reference */
export function isSameMachine(mine, reference) {
  const [ours, theirs] = [mine, reference].map(snapRows);
  return !compareAxes(describeAxes(ours), describeAxes(theirs)).differences.length;
}

// Whether z_0 points the other way, where axis 1 tells.
const upsideDown = (mine, reference, signs) =>
  !isLevel(mine) && signs[0] * mine.up * reference.up < 0;

// Whether axis 1 points neither up nor down.
const isLevel = ({ axis }) => Math.abs(axis[2]) < TINY;

// Whether one list of costs comes before another.
function less(p, q) {
  const k = p.findIndex((x, i) => x !== q[i]);
  return k >= 0 && p[k] < q[k];
}

// All choices of so many signs, 1 before -1.
const signings = (count) =>
  Array.from({ length: 2 ** count }, (_, k) =>
    Array.from({ length: count }, (__, i) => ((k >> (count - 1 - i)) & 1 ? -1 : 1)),
  );

// The cheapest choices up to the end of a gap, for each sign of its last joint; the gap begins with
// the last one's end.
function step(sides, gap, best) {
  const { joints: between } = sides.mine.gaps[gap];
  const found = new Map();
  for (const chosen of signings(between.length)) {
    const choice = continued(sides, gap, chosen, best.get(chosen[0]));
    const last = chosen.at(-1);
    if (!found.has(last) || less(choice.cost, found.get(last).cost)) found.set(last, choice);
  }
  return found;
}

// The choice before a gap with the signs of its joints: what differs there counts, then by how
// much.
function continued({ mine, reference, within }, gap, chosen, { cost, signs: before, found: old }) {
  const [m, r] = [mine.gaps[gap], reference.gaps[gap]];
  const signs = new Map(m.joints.map((k, i) => [k, chosen[i]]));
  const alike = isBaseHeightGap(m) && isBaseHeightGap(r) && `${m.bunch}` === `${r.bunch}`;
  const note = alike && Math.abs(height(m, r, chosen[0])) > within.length;
  const turned =
    upsideDown(mine, reference, before) ||
    (isLevel(mine) && before[0] * dot(mine.axis, reference.axis) < 0);
  const fresh = differences(mine, m, r, signs, within);
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

// Whether a gap's offset is the height of the base frame, with no slide to make up for it.
export const isBaseHeightGap = ({ fromBase, offset, bunch, joints: between, toTip }) =>
  fromBase &&
  offset !== null &&
  bunch.every((k, i) => k === i) &&
  between.length + Number(toTip) === 2;

const height = (m, r, sign) => sign * (r.offset ?? 0) - (m.offset ?? 0);

function baseHigher(mine, reference, signs) {
  const [m, r] = [mine, reference].map((s) => s.gaps.find(isBaseHeightGap));
  if (!m || !r || `${m.bunch}` !== `${r.bunch}`) return 0;
  // The height is along the last of parallel axes, which may point the other way than axis 1.
  const within = mine.gaps.slice(1, m.bunch.length);
  const turned = within.reduce((x, g) => x * g.shape.get(`${g.joints}`), 1);
  return mine.up * Math.round(turned) * height(m, r, signs[m.bunch.at(-1)]);
}

function unlikeJoints(mine, reference) {
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

// Where axis 1 stands to z_0; the other way along it is free.
function stands(mine, reference, length, angle) {
  const [[far, lean], [other, wanted]] = [mine.foot, reference.foot];
  const ends = [0, mine.joints[0]];
  const found = [];
  if (Math.abs(lean - wanted) > angle)
    found.push(difference("table lean", [1, "alpha"], [lean, wanted], ends));
  if (Math.abs(far - other) > length)
    found.push(difference("table foot", [1, "a"], [far, other], ends));
  return found;
}

function differences(mine, m, r, signs, { length, angle }) {
  const found = [];
  const first = mine.joints[m.joints[0]];
  if (Math.abs(m.length - r.length) > length) {
    const end = m.toTip ? 0 : mine.joints[m.joints.at(-1)];
    found.push(difference("table distance", [first, "a"], [m.length, r.length], [first, end]));
  }
  const turned = twists(mine, m, r, signs, angle);
  found.push(...(turned.length ? turned : slide(mine, m, r, signs, angle)));
  if (m.fromBase || `${m.bunch}` !== `${r.bunch}` || m.offset === null || r.offset === null)
    return found;
  const wanted = signs.get(m.joints[0]) * r.offset;
  if (Math.abs(m.offset - wanted) > length) {
    const ends = [mine.joints[m.bunch[0]], mine.joints[m.bunch.at(-1)]];
    found.push(difference("table along", [ends[1], "d"], [m.offset, wanted], ends));
  }
  return found;
}

function twists(mine, m, r, signs, angle) {
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

// The angle between two axes: about their common normal if `sided`, else between 0 and pi.
function twist(found, pair, sided, signs) {
  const cosine = product(found, pair, signs);
  return sided
    ? Math.atan2(product(found, [...pair, NORMAL_INDEX], signs), cosine)
    : clampedAcos(cosine);
}

// One of the gap's products, each joint's direction turned by its sign.
const product = (found, which, signs) =>
  which.reduce((x, k) => x * (signs.get(k) ?? 1), found.shape.get(`${which}`));

// A slide does not turn: it holds what comes before and after it at an angle about itself, and the
// shortest way across it points one way.
function slide(mine, m, r, signs, angle) {
  const slides = m.joints.some((k) => mine.rows[mine.joints[k] - 1].kind === "prismatic");
  const both = slides ? [...m.shape.keys()].filter((key) => r.shape.has(key)) : [];
  const off = (key) => Math.abs(m.shape.get(key) - product(r, key.split(",").map(Number), signs));
  if (both.every((key) => off(key) <= angle)) return [];
  const about = held(mine, m, r, signs).find(([, x, y]) => angleDistance(x, y) > angle);
  if (about) return [difference("table held", [about[0], "theta"], about.slice(1))];
  const [start, end] = [0, -1].map((k) => mine.joints[m.joints.at(k)]);
  return [difference("table side", [start, "a"], [0, Math.PI], [start, m.toTip ? 0 : end])];
}

// The row of each slide between axes that are not parallel to it, and the angle about it from the
// common normal before it to the one after it, these taken the way that is nearer to theta.
function held(mine, m, r, signs) {
  const skew = (...pair) => 1 - m.shape.get(`${pair}`) ** 2 > TINY;
  return m.joints.slice(1, -1).flatMap((k) => {
    const before = m.joints.filter((i) => i < k && skew(i, k)).at(-1);
    const after = m.joints.find((j) => j > k && skew(k, j));
    if (before === undefined || after === undefined) return [];
    const [three, row] = [[before, k, after], mine.joints[k]];
    // Not at a right angle, where it would be left to rounding.
    const back = angleDistance(aboutSecond(m, three, new Map(), 1), mine.rows[row - 1].theta) > 2;
    const way = back ? -1 : 1;
    return [[row, aboutSecond(m, three, new Map(), way), aboutSecond(r, three, signs, way)]];
  });
}

// The angle about the second of three axes from the common normal of the first two to that of the
// last two.
function aboutSecond(found, three, signs, way) {
  const [i, k, j] = three;
  const [u, v, w] = [
    [i, k],
    [k, j],
    [i, j],
  ].map((pair) => product(found, pair, signs));
  const angle = Math.atan2(way * product(found, three, signs), way * (u * v - w));
  return angle < TINY - Math.PI ? Math.PI : angle;
}

// The angle with this cosine, rounding past 1 forgiven.
export const clampedAcos = (cosine) => Math.acos(Math.max(-1, Math.min(1, cosine)));

// How far two angles are apart, whole turns aside.
export function angleDistance(left, right) {
  const turn = 2 * Math.PI;
  const over = (left - right + Math.PI) % turn;
  return Math.abs((over < 0 ? over + turn : over) - Math.PI);
}
