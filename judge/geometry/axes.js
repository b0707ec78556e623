// Compares two tables by the distances and angles that all Denavit-Hartenberg tables of an arm
// share. A revolute axis is a line in space. It has a distance and a twist to the next axis, and an
// offset between the ends of its two common normals. Along parallel axes only the sum of the
// offsets is determined. A prismatic axis has a direction and no position. A table is free to
// choose the direction of each axis, so the comparison chooses a sign for each joint.

import { cross, dot, movingRows, linkFrames, norm } from "./kinematics.js";
import { ANGLE_TOLERANCE, isAngleColumn, snapRows } from "./rows.js";
import { listGaps, NORMAL_INDEX, AXIS_ROUND_OFF } from "./axis_gaps.js";

/** @typedef {import("./arm.js").Row} Row */

/**
 * The gap from a revolute axis to the next revolute axis or to the tip. Prismatic axes may lie in
 * it.
 * @typedef {object} Gap
 * @property {number[]} joints the joints in the gap, by index from 0
 * @property {number[]} normal the common normal, from the first axis to the last (m)
 * @property {number} length length of the normal (m)
 * @property {Map<string, number>} shape dot and triple products of the gap's directions, by the
 *   indices of their joints ("0,1"); they determine the directions up to a rotation
 * @property {number | null} offset along the first axis (m); null if the next axis is parallel
 * @property {number[]} parallelJoints the joints with parallel axes whose offsets are added up
 * @property {boolean} fromBase whether the offset depends on the base frame alone
 * @property {boolean} toTip whether the gap ends at the tip
 */

/**
 * The axes of a table, as `compareAxes` needs them.
 * @typedef {object} TableAxes
 * @property {Row[]} rows
 * @property {number[]} joints the rows that move, counted from 1
 * @property {Gap[]} gaps
 * @property {number} toolCosine cosine of the angle between the last joint axis and the last
 *   frame's z
 * @property {number} axis1Distance from z_0 (m); it and the angle are 0 unless fixed rows come
 *   first
 * @property {number} axis1Angle from z_0 (rad)
 * @property {number[]} axis1 direction of axis 1
 * @property {number} up -1 if axis 1 points down, else 1
 */

/**
 * A difference between two tables.
 * @typedef {object} Difference
 * @property {string} key of its message
 * @property {number} row that shows it, counted from 1
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
 * @property {[number, number]} toolAngles from the last joint axis to the last frame's z, in the
 *   student's table and in the reference (rad)
 */

/**
 * Describe the axes of a table with at least one joint.
 * @param {Row[]} rows
 * @returns {TableAxes}
 */
export function describeAxes(rows) {
  const moving = movingRows({ rows });
  const numbers = moving.map((i) => i + 1);
  return {
    rows,
    joints: numbers,
    gaps: listGaps({ rows }),
    toolCosine: computeToolCosine({ rows }, moving),
    ...locateFirstAxis(rows, moving[0]),
  };
}

// Locate axis 1 relative to z_0. The axis of a slide has no position, and its distance is 0.
function locateFirstAxis(rows, first) {
  const { z, o } = linkFrames({ rows: rows.slice(0, first) }, []).at(-1);
  const n = cross([0, 0, 1], z);
  const distance =
    norm(n) > AXIS_ROUND_OFF ? Math.abs(dot(o, n)) / norm(n) : Math.hypot(o[0], o[1]);
  return {
    axis1Distance: rows[first].kind === "revolute" ? distance : 0,
    axis1Angle: clampedAcos(Math.abs(z[2])),
    axis1: z,
    up: z[2] < -AXIS_ROUND_OFF ? -1 : 1,
  };
}

function computeToolCosine(arm, moving) {
  const frames = linkFrames(
    arm,
    moving.map(() => 0),
  );
  return dot(frames[moving.at(-1)].z, frames.at(-1).z);
}

/**
 * Compare two tables with the signs of the axes that leave the fewest differences. The signs are
 * chosen gap by gap from the base, and for each sign of the last axis the cheapest choice is kept.
 * @param {TableAxes} mine of the student's table
 * @param {TableAxes} reference
 * @param {number} [length] tolerance of lengths (m)
 * @param {number} [angle] tolerance of angles (rad)
 * @returns {AxisComparison}
 */
export function compareAxes(mine, reference, length = 1e-6, angle = 1e-4) {
  const kindDifferences = compareKinds(mine, reference);
  if (kindDifferences.length) {
    const noBase = { baseHigher: 0, upsideDown: false };
    return { differences: kindDifferences, signs: [], ...noBase, toolAngles: [0, 0] };
  }
  const baseDifferences = compareFirstAxes(mine, reference, length, angle);
  const cost = [baseDifferences.length, addSizes(baseDifferences), 0];
  let best = new Map(
    [1, -1].map((sign) => [sign, { cost, signs: [sign], differences: baseDifferences }]),
  );
  const comparison = { mine, reference, tolerances: { length, angle } };
  for (const gap of mine.gaps.keys()) best = extendBest(comparison, gap, best);
  const choices = [...best].map(([lastSign, choice]) => addTool(comparison, lastSign, choice));
  const { signs, differences, toolAngles } = choices.reduce((p, q) =>
    isCheaper(q.cost, p.cost) ? q : p,
  );
  return {
    differences,
    signs,
    baseHigher: measureBaseHeight(mine, reference, signs),
    upsideDown: isUpsideDown(mine, reference, signs),
    toolAngles,
  };
}

// Add the angle of the tool to a choice of signs. A tool in another direction costs a remark, and a
// negative sign costs the least.
function addTool({ mine, reference, tolerances }, lastSign, { cost, signs, differences }) {
  /** @type {[number, number]} */
  const toolAngles = [clampedAcos(mine.toolCosine), clampedAcos(lastSign * reference.toolCosine)];
  const remarks = cost[2] + Number(angleDistance(...toolAngles) > tolerances.angle);
  const total = signs.reduce((sum, sign) => sum + sign, 0);
  return { cost: [cost[0], cost[1], remarks, -total], signs, differences, toolAngles };
}

const addSizes = (differences, start = 0) =>
  differences.reduce((sum, x) => sum + Math.abs(x.mine - x.reference), start);

/**
 * Return whether two tables describe the same arm, whatever frames they choose.
 * @param {Row[]} mine @param {Row[]} reference
 */
export function isSameMachine(mine, reference) {
  const [axes, referenceAxes] = [mine, reference].map((rows) => describeAxes(snapRows(rows)));
  return !compareAxes(axes, referenceAxes).differences.length;
}

// Return whether z_0 points down in one table only. A level axis 1 cannot show it.
const isUpsideDown = (mine, reference, signs) =>
  !isLevel(mine) && signs[0] * mine.up * reference.up < 0;

// Return whether axis 1 points neither up nor down.
const isLevel = ({ axis1 }) => Math.abs(axis1[2]) < AXIS_ROUND_OFF;

// Return whether cost p is lower than q. The first entry that differs decides.
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
// gap begins with the last joint of the previous gap.
function extendBest(comparison, gap, best) {
  const choices = new Map();
  for (const gapSigns of listSigns(comparison.mine.gaps[gap].joints.length)) {
    const choice = extendChoice(comparison, gap, gapSigns, best.get(gapSigns[0]));
    const last = gapSigns.at(-1);
    if (!choices.has(last) || isCheaper(choice.cost, choices.get(last).cost))
      choices.set(last, choice);
  }
  return choices;
}

// Add the signs of a gap's joints to a choice. Its cost is the number of differences, then the sum
// of their sizes, then the number of remarks.
function extendChoice({ mine, reference, tolerances }, gap, gapSigns, choice) {
  const [m, r] = [mine.gaps[gap], reference.gaps[gap]];
  const signs = new Map(m.joints.map((k, i) => [k, gapSigns[i]]));
  const setBaseHeight = isBaseHeightGap(m) && isBaseHeightGap(r) && haveSameParallelJoints(m, r);
  const isHigher =
    setBaseHeight && Math.abs(heightDifference(m, r, gapSigns[0])) > tolerances.length;
  const isReversed =
    isUpsideDown(mine, reference, choice.signs) ||
    (isLevel(mine) && choice.signs[0] * dot(mine.axis1, reference.axis1) < 0);
  const differences = compareGap(mine, m, r, signs, tolerances);
  const size = addSizes(differences, choice.cost[1]);
  const remarks = choice.cost[2] + Number(isHigher) + Number(isReversed);
  return {
    cost: [choice.cost[0] + differences.length, Number(size.toFixed(9)), remarks],
    signs: [...choice.signs, ...gapSigns.slice(1)],
    differences: [...choice.differences, ...differences],
  };
}

const haveSameParallelJoints = (m, r) => `${m.parallelJoints}` === `${r.parallelJoints}`;

/**
 * @param {string} key @param {[number, string]} cell row and entry
 * @param {any[]} values in the student's table and in the reference
 * @param {number[]} [ends]
 * @returns {Difference}
 */
const makeDifference = (key, [row, entry], [mine, reference], ends = [0, 0]) => ({
  key,
  row,
  entry,
  mine,
  reference,
  ends,
});

/** Return whether a gap's offset is the height of the base frame, which no slide can change. */
export const isBaseHeightGap = ({ fromBase, offset, parallelJoints, joints, toTip }) =>
  fromBase &&
  offset !== null &&
  parallelJoints.every((k, i) => k === i) &&
  joints.length + Number(toTip) === 2;

const heightDifference = (m, r, sign) => sign * (r.offset ?? 0) - (m.offset ?? 0);

function measureBaseHeight(mine, reference, signs) {
  const [m, r] = [mine, reference].map(({ gaps }) => gaps.find(isBaseHeightGap));
  if (!m || !r || !haveSameParallelJoints(m, r)) return 0;
  // The height is measured along the last of the parallel axes, which may point against axis 1.
  const parallelGaps = mine.gaps.slice(1, m.parallelJoints.length);
  const cosine = parallelGaps.reduce((x, gap) => x * gap.shape.get(`${gap.joints}`), 1);
  return mine.up * Math.round(cosine) * heightDifference(m, r, signs[m.parallelJoints.at(-1)]);
}

function compareKinds(mine, reference) {
  const [numbers, expectedNumbers] = [mine.joints, reference.joints];
  const counts = [numbers.length, expectedNumbers.length];
  if (counts[0] !== counts[1]) {
    const row = numbers[Math.min(...counts) - 1];
    return [makeDifference("table count", [row, "joints"], counts)];
  }
  return numbers.flatMap((number, k) => {
    const kind = mine.rows[number - 1].kind;
    const expected = reference.rows[expectedNumbers[k] - 1].kind;
    if (kind === expected) return [];
    return [makeDifference("table kind", [number, "joint"], [kind, expected])];
  });
}

// Compare the distance and the angle of axis 1 from z_0. Its direction is free.
function compareFirstAxes(mine, reference, length, angle) {
  const ends = [0, mine.joints[0]];
  const differences = [];
  const angles = [mine.axis1Angle, reference.axis1Angle];
  if (Math.abs(angles[0] - angles[1]) > angle)
    differences.push(makeDifference("table lean", [1, "alpha"], angles, ends));
  const distances = [mine.axis1Distance, reference.axis1Distance];
  if (Math.abs(distances[0] - distances[1]) > length)
    differences.push(makeDifference("table foot", [1, "a"], distances, ends));
  return differences;
}

// Compare gap m of the student's table with gap r of the reference, for the signs of its joints.
function compareGap(mine, m, r, signs, { length, angle }) {
  const differences = [];
  const first = mine.joints[m.joints[0]];
  if (Math.abs(m.length - r.length) > length) {
    const end = m.toTip ? 0 : mine.joints[m.joints.at(-1)];
    differences.push(
      makeDifference("table distance", [first, "a"], [m.length, r.length], [first, end]),
    );
  }
  const twists = compareTwists(mine, m, r, signs, angle);
  differences.push(...(twists.length ? twists : compareSlides(mine, m, r, signs, angle)));
  if (m.fromBase || !haveSameParallelJoints(m, r) || m.offset === null || r.offset === null)
    return differences;
  const expected = signs.get(m.joints[0]) * r.offset;
  if (Math.abs(m.offset - expected) > length) {
    const ends = [mine.joints[m.parallelJoints[0]], mine.joints[m.parallelJoints.at(-1)]];
    differences.push(makeDifference("table along", [ends[1], "d"], [m.offset, expected], ends));
  }
  return differences;
}

function compareTwists(mine, m, r, signs, angle) {
  return m.joints.slice(1).flatMap((j, k) => {
    const pair = [m.joints[k], j];
    const normal = `${[...pair, NORMAL_INDEX]}`;
    const isSigned = m.joints.length === 2 && m.shape.has(normal) && r.shape.has(normal);
    const twist = computeTwist(m, pair, isSigned, new Map());
    const expected = computeTwist(r, pair, isSigned, signs);
    if (angleDistance(twist, expected) <= angle) return [];
    const ends = pair.map((i) => mine.joints[i]);
    return [makeDifference("table between", [ends[0], "alpha"], [twist, expected], ends)];
  });
}

// Return the angle between two axes, signed about their common normal or from 0 to pi.
function computeTwist(gap, pair, isSigned, signs) {
  const cosine = signedProduct(gap, pair, signs);
  return isSigned
    ? Math.atan2(signedProduct(gap, [...pair, NORMAL_INDEX], signs), cosine)
    : clampedAcos(cosine);
}

// Return the dot or triple product of directions in a gap, each multiplied by its joint's sign.
const signedProduct = (gap, directions, signs) =>
  directions.reduce((x, k) => x * (signs.get(k) ?? 1), gap.shape.get(`${directions}`));

// Compare the directions in a gap with a slide. A slide does not turn, so the axes before and after
// it keep a fixed angle about it, and the common normal across it has a fixed direction.
function compareSlides(mine, m, r, signs, angle) {
  const slide = m.joints.find((k) => mine.rows[mine.joints[k] - 1].kind === "prismatic");
  if (slide === undefined) return [];
  const deviations = [...m.shape.keys()]
    .filter((key) => r.shape.has(key))
    .map((key) => m.shape.get(key) - signedProduct(r, key.split(",").map(Number), signs));
  const largest = Math.max(...deviations.map(Math.abs));
  if (largest <= angle) return [];
  return [makeDifference("table slide", [mine.joints[slide], "theta"], [largest, 0])];
}

/**
 * List the entries that differ between two tables, row by row.
 * @param {Row[]} rows @param {Row[]} expected @param {number} length tolerance (m)
 * @returns {[number, string][] | null} index of the row and column of each entry; null if the
 *   tables have different numbers of rows
 */
export function listDifferentEntries(rows, expected, length) {
  if (rows.length !== expected.length) return null;
  const isDifferent = (x, y, column) =>
    isAngleColumn(column) ? angleDistance(x, y) > ANGLE_TOLERANCE : Math.abs(x - y) > length;
  return rows.flatMap((row, k) =>
    ["a", "alpha", "d", "theta"]
      .filter((column) => isDifferent(row[column], expected[k][column], column))
      .map((column) => /** @type {[number, string]} */ ([k, column])),
  );
}

/** Return acos of a cosine that round-off may have moved past 1. */
const clampedAcos = (cosine) => Math.acos(Math.max(-1, Math.min(1, cosine)));

/** Return the distance between two angles on the circle, 0 to pi. @param {number} left rad */
export function angleDistance(left, right) {
  const turn = 2 * Math.PI;
  const over = (left - right + Math.PI) % turn;
  return Math.abs((over < 0 ? over + turn : over) - Math.PI);
}
