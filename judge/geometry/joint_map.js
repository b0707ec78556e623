// Finds how the joints of a student's valid table count in the joints of the reference. A joint's
// zero follows from the next axis that the joint moves; for the last joint from the tip and the
// tool.

import {
  cross,
  dot,
  movingRows,
  linkFrames,
  minus,
  plus,
  pointInBase,
  scaled,
  vectorInBase,
} from "./kinematics.js";
import { DEG } from "./angles.js";
import { partAcross } from "./joint_equations.js";
import { wrapAngle } from "./planar.js";
import { formatNumber } from "../sentences.js";

const DIRECTION_TOLERANCE = 1e-6; // m, or the sine of an angle: less than this fixes no direction
// The map is confirmed at these configurations: joint k (from 0) of each has the value sin((k + 1)
// x step).
const POSE_STEPS = [0.3, 0.7, 1.1, 1.9];

/** @typedef {import("./axes.js").AxisComparison} AxisComparison */
/** @typedef {import("./axes.js").TableAxes} TableAxes */

/**
 * How the student's joints count in the reference's: joint k of the reference is signs[k] times the
 * student's plus offsets[k].
 * @typedef {object} JointMap
 * @property {number[]} signs 1 or -1
 * @property {number[]} offsets (rad or m)
 * @property {import("./kinematics.js").Frame} base the student's base frame in the reference's
 */

/**
 * Return the joint map between two tables that describe one arm.
 * @param {TableAxes} student
 * @param {TableAxes} reference
 * @param {AxisComparison} comparison of the two
 * @param {number} [tolerance] of the tips (m)
 * @returns {JointMap | null} null if the tips differ at some configuration
 */
export function findJointMap(student, reference, comparison, tolerance = 1e-6) {
  const { signs } = comparison;
  const base = placeBase(student, reference, comparison);
  const zeros = student.joints.map(() => 0);
  const positive = student.joints.map(() => 1);
  const studentFeatures = listFeatures(student.rows, zeros, base, signs);
  const studentOrigins = linkFrames(student, zeros).map(({ o }) => pointInBase(base, o));
  const offsets = [...zeros];
  const joints = [...reference.joints.entries()];
  // If the next axis does not fix a joint's zero, a later axis does once the zeros between are
  // known. The second pass knows them.
  for (const [k, number] of [...joints, ...joints]) {
    const { z, o } = linkFrames(reference, offsets)[number - 1];
    const features = listFeatures(reference.rows, offsets, BASE, positive);
    const isRevolute = reference.rows[number - 1].kind === "revolute";
    const origin = studentOrigins[student.joints[k] - 1];
    for (let n = k + 1; n < features.length; n++) {
      const [feature, target] = [features[n], studentFeatures[n]];
      const change = isRevolute
        ? findTurn(z, origin, target, o, feature)
        : findSlide(z, target, feature);
      if (change === null) continue;
      offsets[k] += change;
      break;
    }
  }
  const wrapped = offsets.map((c, k) =>
    reference.rows[reference.joints[k] - 1].kind === "revolute" ? wrap(c) : c,
  );
  return confirmMap(student, reference, { signs, offsets: wrapped, base }, tolerance);
}

const BASE = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1], o: [0, 0, 0] };

const UPSIDE_DOWN = { x: [1, 0, 0], y: [0, -1, 0], z: [0, 0, -1], o: [0, 0, 0] };

// Return the student's base frame in the reference's base, as far as axis 1 fixes it.
function placeBase(student, reference, { upsideDown, baseHigher, signs }) {
  const axis = linkFrames({ rows: reference.rows.slice(0, reference.joints[0] - 1) }, []).at(-1).z;
  const up = student.up * signs[0];
  return { ...(upsideDown ? UPSIDE_DOWN : BASE), o: scaled(up * baseHigher, axis) };
}

// List the features of an arm that its joints move, in the reference's base: each joint axis as a
// point and a direction, the tip, and the tool's z and x axes. The axis of a slide has no point.
function listFeatures(rows, q, base, signs) {
  const T = linkFrames({ rows }, q).map((frame) => placeFrame(base, frame));
  const axes = movingRows({ rows }).map((i, k) => ({
    point: rows[i].kind === "revolute" ? T[i].o : null,
    direction: scaled(signs[k], T[i].z),
  }));
  const { x, z, o } = T.at(-1);
  return [
    ...axes,
    { point: o, direction: null },
    { point: null, direction: z },
    { point: null, direction: x },
  ];
}

const placeFrame = (base, { x, y, z, o }) => ({
  x: vectorInBase(base, x),
  y: vectorInBase(base, y),
  z: vectorInBase(base, z),
  o: pointInBase(base, o),
});

// Return the angle about z that turns the reference's feature to its target, or null if both are on
// the axis. The axis passes through `origin` in the student's arm and through `o` in the reference.
function findTurn(z, origin, target, o, feature) {
  const pairs = [];
  if (target.direction) pairs.push([target.direction, feature.direction]);
  if (target.point) pairs.push([minus(target.point, origin), minus(feature.point, o)]);
  for (const pair of pairs) {
    const [u, v] = pair.map((w) => partAcross(z, w));
    if (fixesDirection(u) && fixesDirection(v)) return Math.atan2(dot(z, cross(v, u)), dot(u, v));
  }
  return null;
}

// Return the distance along z that takes the reference's feature to its target, or null if no slide
// along z changes the feature.
function findSlide(z, target, feature) {
  if (!target.point) return null;
  const w = minus(target.point, feature.point);
  if (!target.direction) return dot(w, z);
  const along = partAcross(feature.direction, z);
  return fixesDirection(along) ? dot(w, along) / dot(along, along) : null;
}

const fixesDirection = (v) => dot(v, v) > DIRECTION_TOLERANCE ** 2;

// Return the map if it makes the tips agree at each test configuration, else null. The tips may
// differ in height, which then becomes the height of the student's base.
function confirmMap(student, reference, map, tolerance) {
  const differences = POSE_STEPS.map((step) => {
    const studentQ = student.joints.map((_, k) => Math.sin(step * (k + 1)));
    const q = studentQ.map((x, k) => map.signs[k] * x + map.offsets[k]);
    const studentTip = pointInBase(map.base, linkFrames(student, studentQ).at(-1).o);
    return minus(linkFrames(reference, q).at(-1).o, studentTip);
  });
  const allowed = 10 * Math.max(tolerance, 1e-6);
  const height = differences[0][2];
  const isFar = ([x, y, z]) => Math.max(Math.abs(x), Math.abs(y), Math.abs(z - height)) > allowed;
  if (differences.some(isFar)) return null;
  if (Math.abs(height) <= allowed) return map;
  return { ...map, base: { ...map.base, o: plus(map.base.o, [0, 0, height]) } };
}

/**
 * Return the same angle in (-pi, pi], where -pi counts as pi up to round-off.
 * @param {number} angle rad
 */
export function wrap(angle) {
  const wrapped = wrapAngle(angle);
  return wrapped <= -Math.PI + 1e-9 ? Math.PI : wrapped;
}

/**
 * A joint of the reference beside the student's joint.
 * @typedef {object} MappedJoint
 * @property {number} number of the reference's joint
 * @property {boolean} isRevolute
 * @property {boolean} countsOtherwise whether the two joint values differ
 * @property {number} sign of the student's joint value in the reference's
 * @property {number} ownNumber number of the student's joint
 * @property {string} shift the constant that is added, such as " + 90°"
 */

/**
 * List the joints of the reference with how each counts.
 * @param {JointMap} map
 * @param {number[]} ownNumbers of the student's joints
 * @param {TableAxes} reference
 * @returns {MappedJoint[]}
 */
export function listMappedJoints({ signs, offsets }, ownNumbers, reference) {
  return signs.map((sign, k) => {
    const number = reference.joints[k];
    const isRevolute = reference.rows[number - 1].kind === "revolute";
    const shown = formatJointValue(Math.abs(offsets[k]), isRevolute);
    const isShifted = /[1-9]/.test(shown);
    const shift = isShifted ? ` ${offsets[k] < 0 ? "-" : "+"} ${shown}` : "";
    const countsOtherwise = sign < 0 || isShifted;
    return { number, isRevolute, countsOtherwise, sign, ownNumber: ownNumbers[k], shift };
  });
}

/** Format a joint value in degrees or millimetres. @param {number} value rad or m */
export function formatJointValue(value, isRevolute) {
  const rounded = Number((value * (isRevolute ? DEG : 1000)).toFixed(2)) + 0;
  return `${formatNumber(rounded, 5)}${isRevolute ? "°" : " mm"}`;
}
