// How the joints of one valid table count in those of another: a joint's zero is found from where
// it carries the next axis, or at the end the tip and the tool.

import { cross, dot, movingRows, linkFrames, minus, plus, scaled } from "./kinematics.js";
import { DEG } from "./angles.js";
import { partAcross } from "./joint_equations.js";
import { wrapAngle } from "./planar.js";
import { formatNumber } from "../sentences.js";

const SEEN = 1e-6; // m, or the sine of an angle: less than this fixes no direction
const POSES = [0.3, 0.7, 1.1, 1.9]; // joint k of each is the sine of k times this

/** @typedef {import("./axes.js").AxisWalk} AxisWalk */

/**
 * The reference's joint k is signs[k] times yours plus offsets[k] (rad or m); your base's frame in
 * the reference's.
 * @typedef {{ signs: number[], offsets: number[], base: any }} JointMap
 */

// Return the joint map between two tables that agree; null if the tips of some poses disagree.
/** @param {AxisWalk} mine @param {AxisWalk} reference @returns {JointMap | null} */
export function findJointMap(mine, reference, found, tolerance = 1e-6) {
  const base = placeBase(mine, reference, found);
  const still = mine.joints.map(() => 0);
  const plain = mine.joints.map(() => 1);
  const ours = listFeatures(mine.rows, still, base, found.signs);
  const own = linkFrames(mine, still).map((F) => placeFrame(base, F).o);
  const offsets = [...still];
  const toCarry = [...reference.joints.entries()];
  // If the next axis does not fix the map, one farther out does, once the zeros between are known.
  for (const [k, i] of [...toCarry, ...toCarry]) {
    const { z, o } = linkFrames(reference, offsets)[i - 1];
    const theirs = listFeatures(reference.rows, offsets, BASE, plain);
    const turns = reference.rows[i - 1].kind === "revolute";
    for (let n = k + 1; n < ours.length; n++) {
      const [m, r] = [ours[n], theirs[n]];
      const moved = turns ? findTurn(z, own[mine.joints[k] - 1], m, o, r) : findSlide(z, m, r);
      if (moved === null) continue;
      offsets[k] += moved;
      break;
    }
  }
  const wrapped = offsets.map((c, k) =>
    reference.rows[reference.joints[k] - 1].kind === "revolute" ? wrap(c) : c,
  );
  return confirmMap(mine, reference, { signs: found.signs, offsets: wrapped, base }, tolerance);
}

const BASE = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1], o: [0, 0, 0] };

const UPSIDE_DOWN = { x: [1, 0, 0], y: [0, -1, 0], z: [0, 0, -1], o: [0, 0, 0] };

// Return the student's base frame in the reference's base, as far as axis 1 fixes it.
function placeBase(mine, reference, { upsideDown, baseHigher, signs }) {
  const axis = linkFrames({ rows: reference.rows.slice(0, reference.joints[0] - 1) }, []).at(-1).z;
  const up = mine.up * signs[0];
  return { ...(upsideDown ? UPSIDE_DOWN : BASE), o: scaled(up * baseHigher, axis) };
}

// List the features that joints carry, in the reference's base: each joint axis as a point and a
// direction (a slide has no point), the tip, and the tool's z and x axes.
function listFeatures(rows, q, base, signs) {
  const T = linkFrames({ rows }, q).map((F) => placeFrame(base, F));
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

const rotateVector = (base, v) =>
  plus(plus(scaled(v[0], base.x), scaled(v[1], base.y)), scaled(v[2], base.z));

const placeFrame = (base, { x, y, z, o }) => ({
  x: rotateVector(base, x),
  y: rotateVector(base, y),
  z: rotateVector(base, z),
  o: plus(base.o, rotateVector(base, o)),
});

// Return the angle about z that carries the reference's feature r to the student's m; null if both
// are on the axis. The axis passes through p in the student's arm and through o in the reference.
function findTurn(z, p, m, o, r) {
  const pairs = [];
  if (m.direction) pairs.push([m.direction, r.direction]);
  if (m.point) pairs.push([minus(m.point, p), minus(r.point, o)]);
  for (const pair of pairs) {
    const [u, v] = pair.map((w) => partAcross(z, w));
    if (dot(u, u) > SEEN ** 2 && dot(v, v) > SEEN ** 2)
      return Math.atan2(dot(z, cross(v, u)), dot(u, v));
  }
  return null;
}

// Return the distance along z that carries feature r to m; null if r does not change along z.
function findSlide(z, m, r) {
  if (!m.point) return null;
  const w = minus(m.point, r.point);
  if (!m.direction) return dot(w, z);
  const along = partAcross(r.direction, z);
  return dot(along, along) > SEEN ** 2 ? dot(w, along) / dot(along, along) : null;
}

// Return the map if it makes the tips of some poses agree, except for the base's height; else null.
function confirmMap(mine, reference, found, tolerance) {
  const off = POSES.map((step) => {
    const q = mine.joints.map((_, k) => Math.sin(step * (k + 1)));
    const other = q.map((x, k) => found.signs[k] * x + found.offsets[k]);
    const here = placeFrame(found.base, linkFrames(mine, q).at(-1)).o;
    return minus(linkFrames(reference, other).at(-1).o, here);
  });
  const allowed = 10 * Math.max(tolerance, 1e-6);
  const height = off[0][2];
  const far = ([x, y, z]) => Math.max(Math.abs(x), Math.abs(y), Math.abs(z - height)) > allowed;
  if (off.some(far)) return null;
  if (Math.abs(height) <= allowed) return found;
  return { ...found, base: { ...found.base, o: plus(found.base.o, [0, 0, height]) } };
}

/** Return the same angle in (-pi, pi]; -pi but for round-off is pi. @param {number} angle rad */
export function wrap(angle) {
  const wrapped = wrapAngle(angle);
  return wrapped <= -Math.PI + 1e-9 ? Math.PI : wrapped;
}

/**
 * A joint of the reference beside the student's: whether it counts otherwise, and its value in
 * terms of the student's joint, as "-q_2 + 90°".
 * @typedef {{ number: number, isRevolute: boolean, countsOtherwise: boolean, sign: number,
 *   ownNumber: number, shift: string }} MappedJoint
 */

/**
 * List the joints of the reference with how each counts.
 * @param {JointMap} map
 * @param {number[]} ownNumbers of the student's joints
 * @param {AxisWalk} reference
 * @returns {MappedJoint[]}
 */
export function listMappedJoints({ signs, offsets }, ownNumbers, reference) {
  return signs.map((sign, k) => {
    const number = reference.joints[k];
    const isRevolute = reference.rows[number - 1].kind === "revolute";
    const shown = formatJointValue(Math.abs(offsets[k]), isRevolute);
    const isShifted = !/^0 ?\D/.test(shown);
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
