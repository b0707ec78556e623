// Put an arm on a base or a tool on an arm: read their poses and turn them into fixed rows, as
// helpers/base_and_tool.py does.

import { cross, dot, minus, norm, scaled } from "../../judge/geometry/kinematics.js";
import { orthonormalize } from "../../judge/geometry/target.js";
import { readEntry } from "../../judge/reading/entry.js";

/** @typedef {import("../../judge/geometry/kinematics.js").Frame} Frame */

const ROUND_OFF = 1e-12; // m, and sines
const RIGID = 1e-6; // larger errors of a typed pose's rotation are corrected or refused
const DECIMALS = [3, 4, 5, 6, 7]; // fewer leave a rotation uncertain by a degree
const EXPECTED = "expected x, y, z, roll, pitch, yaw, or the rows of a 4 x 4 pose";

/**
 * Read a pose: x, y, z, roll, pitch, yaw, or the entries of a 4x4 matrix row by row.
 * @param {string} text
 * @param {string} unit of angles without a unit
 * @returns {{ pose: Frame, note?: string } | { error: string }} `note` says that the nearest
 *   rotation was taken; it continues a sentence about the pose, as the error does
 */
export function readPose(text, unit) {
  const parts = text.split(/[\s,;|&[\]()]+/).filter(Boolean);
  if (parts.length !== 6 && parts.length !== 16)
    return { error: `has ${parts.length} numbers; ${EXPECTED}` };
  const isMatrix = parts.length === 16;
  const isAngle = (i) => !isMatrix && i > 2;
  const entries = parts.map((part, i) => readEntry(part, isAngle(i) ? "angle" : "length", unit));
  const bad = entries.find(({ error }) => error);
  if (bad) return { error: bad.error };
  const values = entries.map(({ value }) => value);
  return isMatrix ? readMatrix(values) : { pose: makePose(values) };
}

function readMatrix(values) {
  const [x, y, z, o] = [0, 1, 2, 3].map((k) => [0, 1, 2].map((i) => values[4 * i + k]));
  const last = values.slice(12).map((v, k) => v - (k === 3 ? 1 : 0));
  const gaps = [...minus(cross(x, y), z), norm(x) - 1, norm(y) - 1, ...last];
  const error = Math.max(...gaps.map(Math.abs));
  if (error <= RIGID) return { pose: { x, y, z, o } };
  const rows = [0, 1, 2].map((i) => values.slice(4 * i, 4 * i + 4));
  return (
    mendRotation(rows, last) ?? {
      error: `is no rigid pose, even if its numbers are rounded to three decimals or more`,
    }
  );
}

// Return the pose with the nearest rotation if rounding explains why its own is none, else null.
// Nine entries of a rotation were rounded by half a unit each at most (helpers/poses.py).
function mendRotation(rows, last) {
  const entries = rows.flatMap((row) => row.slice(0, 3));
  const isRounded = (n) => entries.every((v) => Math.abs(v - Number(v.toFixed(n))) < ROUND_OFF);
  const decimals = DECIMALS.find(isRounded);
  const nearest = orthonormalize(rows);
  const moved = Math.hypot(...nearest.flatMap((row, i) => row.map((v, k) => v - rows[i][k])));
  const isExplained = moved > 0 && decimals && moved <= 1.5 * 10 ** -decimals;
  if (!isExplained || Math.max(...last.map(Math.abs)) > RIGID) return null;
  const [x, y, z, o] = [0, 1, 2, 3].map((k) => nearest.map((row) => row[k]));
  const note = `has only ${decimals} decimals; the nearest rotation was taken`;
  return { pose: { x, y, z, o }, note };
}

// The pose of R = Rot_z(yaw) Rot_y(pitch) Rot_x(roll).
function makePose(/** @type {number[]} */ [px, py, pz, roll, pitch, yaw]) {
  const [cr, sr, cp, sp] = [Math.cos(roll), Math.sin(roll), Math.cos(pitch), Math.sin(pitch)];
  const [cy, sy] = [Math.cos(yaw), Math.sin(yaw)];
  const x = [cy * cp, sy * cp, -sp];
  const y = [cy * sp * sr - sy * cr, sy * sp * sr + cy * cr, cp * sr];
  return { x, y, z: cross(x, y), o: [px, py, pz] };
}

const clean = (value) => (Math.abs(value) < ROUND_OFF ? 0 : value);
/** @returns {import("../../judge/geometry/arm.js").Row} */
const makeFixedRow = (a, alpha, d, theta) => ({
  kind: "fixed",
  a: clean(a),
  alpha: clean(alpha),
  d: clean(d),
  theta: clean(theta),
});

/**
 * Return the one or two fixed rows that make a pose.
 * @param {Frame} pose
 */
export function makePoseRows({ x: xAxis, z, o }) {
  const sine = Math.hypot(z[0], z[1]);
  const isParallel = sine < ROUND_OFF;
  let theta = isParallel ? Math.atan2(o[1], o[0]) : Math.atan2(z[0], -z[1]);
  if (isParallel && Math.hypot(o[0], o[1]) < ROUND_OFF) theta = 0;
  // The row's x axis may point either way: take the smaller turn.
  if (Math.abs(theta) > Math.PI / 2 + ROUND_OFF) theta -= Math.sign(theta) * Math.PI;
  const [c, s] = [Math.cos(theta), Math.sin(theta)];
  const [x, across] = [
    [c, s, 0],
    [-s, c, 0],
  ];
  const lastD = isParallel ? 0 : dot(o, across) / dot(z, across);
  const rest = minus(o, scaled(lastD, z));
  const lastTheta = Math.atan2(dot(xAxis, cross(z, x)), dot(xAxis, x));
  const first = makeFixedRow(dot(o, x), Math.atan2(-dot(across, z), z[2]), rest[2], theta);
  const last = makeFixedRow(0, 0, lastD, lastTheta);
  if (!first.a && !first.alpha) return [makeFixedRow(0, 0, first.d + last.d, theta + lastTheta)];
  return last.d || last.theta ? [first, last] : [first];
}
