// The ellipses of joints 1 and 3 in the plane of the two numbers that joint 2 leaves alone.

import {
  cross,
  dot,
  linkFrames,
  minus,
  movingRows,
  plus,
  scaled,
} from "../../../judge/geometry/kinematics.js";

const SAMPLES = 180; // of each ellipse

// Turn a point by an angle about an axis (Rodrigues' formula).
function turnAbout({ z, o }, angle, p) {
  const v = minus(p, o);
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const along = scaled((1 - c) * dot(z, v), z);
  return plus(o, plus(plus(scaled(c, v), scaled(s, cross(z, v))), along));
}

/**
 * Return both ellipses as points: height along axis 2, squared distance from a point of it.
 * @param {import("../../../judge/geometry/arm.js").Arm} arm of three joints that turn
 * @param {number[]} tip
 * @returns {number[][][]} points of joint 1 and of joint 3
 */
export function sampleEllipses(arm, tip) {
  const rows = movingRows(arm);
  const [first, second] = rows.map((row) => linkFrames(arm, [0, 0, 0])[row]);
  const invariants = (p) => {
    const v = minus(p, second.o);
    return [dot(second.z, v), dot(v, v)];
  };
  const angles = Array.from({ length: SAMPLES + 1 }, (_, k) => (2 * Math.PI * k) / SAMPLES);
  return [
    angles.map((angle) => invariants(turnAbout(first, -angle, tip))),
    angles.map((angle) => invariants(linkFrames(arm, [0, 0, angle]).at(-1).o)),
  ];
}

/**
 * Return the points where two polylines cross.
 * @param {number[][]} one @param {number[][]} other
 */
export function findCrossings(one, other) {
  const points = [];
  for (let i = 0; i + 1 < one.length; i++)
    for (let j = 0; j + 1 < other.length; j++) {
      const [a, u] = [one[i], [one[i + 1][0] - one[i][0], one[i + 1][1] - one[i][1]]];
      const [b, v] = [other[j], [other[j + 1][0] - other[j][0], other[j + 1][1] - other[j][1]]];
      const area = u[0] * v[1] - u[1] * v[0];
      if (Math.abs(area) < 1e-15) continue;
      const gap = [b[0] - a[0], b[1] - a[1]];
      const s = (gap[0] * v[1] - gap[1] * v[0]) / area;
      const t = (gap[0] * u[1] - gap[1] * u[0]) / area;
      if (s >= 0 && s < 1 && t >= 0 && t < 1) points.push([a[0] + s * u[0], a[1] + s * u[1]]);
    }
  return points;
}
