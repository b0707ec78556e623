// Solves the steps that the chapters' closed forms share: it turns the shoulder towards a point,
// bends two links in a plane and removes the last row. helpers/inverse explains the formulas.

import { cosSin, minus, plus, scaled } from "./kinematics.js";

// m: a target this close to the workspace boundary counts as on it. 1000 x round-off of a pose.
export const BOUNDARY_DISTANCE = 1e-12;

// A sine below this counts as 0, which turns the tool by at most this angle (rad).
export const SINGULAR = 1e-11;

// Largest error of a computed point (m) or unit vector: 1e-15 is about five units of the last
// digit.
export const VECTOR_ROUND_OFF = 1e-15;

export const SIDES = ["front", "back"];

export const WRISTS = ["q_5 > 0", "q_5 < 0"];

/** Round to the nearest integer and halves to the even one, as NumPy does. */
export function roundHalfToEven(x) {
  const whole = Math.round(x);
  return whole - x === 0.5 && whole % 2 ? whole - 1 : whole;
}

/** Return the same angle in (-pi, pi], up to rounding. */
export const wrapAngle = (angle) =>
  roundHalfToEven(angle * (0.5 / Math.PI)) * (-2 * Math.PI) + angle;

/** Subtract a row's offset from an angle. */
export const subtractOffset = (angle, offset) => (offset ? wrapAngle(angle - offset) : angle);

/** Return the number between two bounds that is nearest to x. */
export const clamp = (x, least, most) => Math.min(Math.max(x, least), most);

/** Return a row with the cosine `ca` and the sine `sa` of its alpha. */
export function withTwist(row) {
  const [ca, sa] = cosSin(row.alpha);
  return { ...row, ca, sa };
}

/**
 * The arm's plane through a point in its two positions, front and back.
 * @typedef {object} ArmPlane
 * @property {number[]} phi angle of joint 1 with its offset (rad), for each position
 * @property {number[]} x the point along x_1 (m), for each position
 * @property {number} y the point along y_1 (m)
 * @property {boolean} exists whether the plane can reach the point
 * @property {boolean} isDouble whether both positions are the same
 * @property {boolean} free whether joint 1 may have any value
 * @property {number} uncertainty of phi because of round-off (rad)
 */

/**
 * Turn the arm's plane to a point.
 * @param {any} first row 1 with the cosine and sine of its alpha
 * @param {number} offset of the plane from axis 1, along z_1 (m)
 * @param {number[]} p the point (m)
 * @returns {ArmPlane}
 */
export function solveShoulder(first, offset, p) {
  const [x, y, z] = p;
  const delta = first.sa * offset;
  const square = x * x + y * y - delta * delta;
  const tolerance = Math.max(2 * Math.abs(delta) * BOUNDARY_DISTANCE, BOUNDARY_DISTANCE ** 2);
  const isDouble = Math.abs(square) <= tolerance;
  const reach = Math.sqrt(square > tolerance ? square : 0);
  const reaches = [reach, -reach];
  const free = isDouble && delta === 0;
  const chosen = [first.theta, first.theta + Math.PI];
  return {
    phi: reaches.map((r, k) =>
      free ? chosen[k] : Math.atan2(y * r + x * delta, x * r - y * delta),
    ),
    x: reaches,
    y: first.sa * (z - first.d),
    exists: square >= -tolerance,
    isDouble,
    free,
    uncertainty: isDouble ? 0 : VECTOR_ROUND_OFF / Math.max(reach, BOUNDARY_DISTANCE),
  };
}

/** Return the largest distance that two links reach (m). */
export const outerRadius = ({ upper, fore }) => Math.abs(upper) + Math.abs(fore);

/** Return the smallest distance that two links reach (m). */
export const innerRadius = ({ upper, fore }) => Math.abs(Math.abs(upper) - Math.abs(fore));

/**
 * Return the angles of two links in a plane whose end is at a point.
 * @param {{ upper: number, fore: number }} links lengths (m)
 * @param {number[]} end the point (m)
 * @param {number} sign of sin(phi_3), which chooses the elbow
 * @param {number} chosen phi_2 if it is free (rad)
 * @param {number} [pointUncertainty] how far round-off may have moved the point (m)
 */
export function solveTwoLinks(links, [px, py], sign, chosen, pointUncertainty = 0) {
  const { upper, fore } = links;
  const [outer, inner, square] = [outerRadius(links), innerRadius(links), px * px + py * py];
  const distance = Math.sqrt(square);
  const fromBoundary = Math.min(Math.abs(distance - outer), Math.abs(distance - inner));
  const isDouble = fromBoundary <= BOUNDARY_DISTANCE + pointUncertainty;
  const ratio = clamp((square - (upper ** 2 + fore ** 2)) * (0.5 / (upper * fore)), -1, 1);
  const cosine = fromBoundary <= BOUNDARY_DISTANCE ? Math.round(ratio) : ratio;
  const sine = Math.sqrt(1 - cosine * cosine);
  const [along, across] = [upper + fore * cosine, sign * (fore * sine)];
  const free = isDouble && distance <= BOUNDARY_DISTANCE;
  const exists = isDouble || (inner < distance && distance < outer);
  return {
    phi2: free ? chosen : Math.atan2(py * along - px * across, px * along + py * across),
    phi3: sign * Math.atan2(sine, cosine),
    exists,
    isDouble,
    free,
    uncertainty:
      isDouble || !exists ? 0 : (VECTOR_ROUND_OFF * outer) / (Math.abs(upper * fore) * sine),
  };
}

/**
 * Return the tool's axes before the last row's alpha, and the origin before its lengths.
 * @param {any} last row with the cosine and sine of its alpha
 * @param {import("./kinematics.js").Frame} tool
 */
export function removeLastRow(last, { x, y, z, o }) {
  const [c, s] = [last.ca, last.sa];
  const turned = { x, y: plus(scaled(c, y), scaled(-s, z)), z: plus(scaled(s, y), scaled(c, z)) };
  const centre = minus(o, scaled(last.d, turned.z));
  return { ...turned, centre: last.a ? minus(centre, scaled(last.a, x)) : centre };
}

/**
 * Collect the branches of all combinations of choices.
 * @param {string[][]} choices the two names of each choice
 * @param {(...options: number[]) => any} solveBranch solves for one option, 0 or 1, of each choice;
 *   null if there is no such branch
 */
export function collectBranches(choices, solveBranch, names = [], options = []) {
  if (!choices.length) {
    const branch = solveBranch(...options);
    const times = branch ? countMerged(branch.merged, options) : 0;
    return times ? [{ name: names.join(", "), times, ...branch }] : [];
  }
  const [first, ...rest] = choices;
  return first.flatMap((name, k) =>
    collectBranches(rest, solveBranch, [...names, name], [...options, k]),
  );
}

// Count the branches that coincide: 1, 2, 4, ... for the first of them, 0 for each other branch.
const countMerged = (merged, options) =>
  merged.some((isMerged, k) => isMerged && options[k]) ? 0 : 2 ** merged.filter(Boolean).length;
