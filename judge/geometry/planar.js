// The two steps that all closed forms share: turning the shoulder towards a point, and two links in
// a plane. helpers/inverse explains the formulas.

import { cosSin, minus, plus, scaled } from "./kinematics.js";

export const BOUNDARY = 1e-12; // m: a target this close to the workspace boundary is on it

export const SINGULAR = 1e-11; // a sine this small counts as 0

export const ROUND_OFF = 1e-15; // of a point (m) or of a unit vector

export const SIDES = ["front", "back"];

export const WRISTS = ["q_5 > 0", "q_5 < 0"];

/** Round as NumPy does: halves to the even number. */
export function roundHalfToEven(x) {
  const whole = Math.round(x);
  return whole - x === 0.5 && whole % 2 ? whole - 1 : whole;
}

/** Return the same angle in (-pi, pi], up to rounding. */
export const wrapAngle = (angle) =>
  roundHalfToEven(angle * (0.5 / Math.PI)) * (-2 * Math.PI) + angle;

/** Subtract a row's offset from an angle. */
export const subtractOffset = (angle, offset) => (offset ? wrapAngle(angle - offset) : angle);

export const clamp = (x, least, most) => Math.min(Math.max(x, least), most);

/** Add the sine and cosine of its twist to a row. */
export function withTwist(row) {
  const [ca, sa] = cosSin(row.alpha);
  return { ...row, ca, sa };
}

/**
 * Return the two angles of joint 1 that turn the arm's plane to the point p, and p in that plane.
 * @param {any} first row 1 with its twist
 * @param {number} offset of the plane from axis 1, along z_1 (m)
 * @param {number[]} p (m)
 */
export function solveShoulder(first, offset, p) {
  const [x, y, z] = p;
  const delta = first.sa * offset;
  const square = x * x + y * y - delta * delta;
  const rounding = Math.max(2 * Math.abs(delta) * BOUNDARY, BOUNDARY ** 2);
  const one = Math.abs(square) <= rounding;
  const reach = Math.sqrt(square > rounding ? square : 0);
  const both = [reach, -reach];
  const free = one && delta === 0;
  const chosen = [first.theta, first.theta + Math.PI];
  return {
    phi: both.map((b, k) => (free ? chosen[k] : Math.atan2(y * b + x * delta, x * b - y * delta))),
    x: both,
    y: first.sa * (z - first.d),
    exists: square >= -rounding,
    one,
    free,
    blur: one ? 0 : ROUND_OFF / Math.max(reach, BOUNDARY),
  };
}

export const outerRadius = ({ upper, fore }) => Math.abs(upper) + Math.abs(fore);

export const innerRadius = ({ upper, fore }) => Math.abs(Math.abs(upper) - Math.abs(fore));

/**
 * Return the two angles of a planar pair of links that ends at a point.
 * @param {{ upper: number, fore: number }} links lengths (m)
 * @param {number[]} end the point (m)
 * @param {number} sign of sin(phi_3), which chooses the elbow
 * @param {number} chosen phi_2 where it is free
 * @param {number} [blur] how far rounding may have moved the point (m)
 */
export function solveTwoLinks(links, [px, py], sign, chosen, blur = 0) {
  const { upper, fore } = links;
  const [outer, inner, square] = [outerRadius(links), innerRadius(links), px * px + py * py];
  const far = Math.sqrt(square);
  const off = Math.min(Math.abs(far - outer), Math.abs(far - inner));
  const one = off <= BOUNDARY + blur;
  const ratio = clamp((square - (upper ** 2 + fore ** 2)) * (0.5 / (upper * fore)), -1, 1);
  const cosine = off <= BOUNDARY ? Math.round(ratio) : ratio;
  const sine = Math.sqrt(1 - cosine * cosine);
  const [along, across] = [upper + fore * cosine, sign * (fore * sine)];
  const free = one && far <= BOUNDARY;
  const exists = one || (inner < far && far < outer);
  return {
    phi2: free ? chosen : Math.atan2(py * along - px * across, px * along + py * across),
    phi3: sign * Math.atan2(sine, cosine),
    exists,
    one,
    free,
    blur: one || !exists ? 0 : (ROUND_OFF * outer) / (Math.abs(upper * fore) * sine),
  };
}

/** Return the tool's frame before the last row's twist, and the origin before its lengths. */
export function removeLastRow(last, { x, y, z, o }) {
  const [c, s] = [last.ca, last.sa];
  const turned = { x, y: plus(scaled(c, y), scaled(-s, z)), z: plus(scaled(s, y), scaled(c, z)) };
  const centre = minus(o, scaled(last.d, turned.z));
  return { ...turned, centre: last.a ? minus(centre, scaled(last.a, x)) : centre };
}

/** Collect the branches that `make` finds for all combinations of choices. */
export function collectBranches(choices, make, names = [], at = []) {
  if (!choices.length) {
    const found = make(...at);
    const times = found ? countMerged(found.merged, at) : 0;
    return times ? [{ name: names.join(", "), times, ...found }] : [];
  }
  const [first, ...rest] = choices;
  return first.flatMap((name, k) => collectBranches(rest, make, [...names, name], [...at, k]));
}

// Count the branches that coincide here: 1, 2, 4, ... for the first of them, 0 for the others.
const countMerged = (merged, at) =>
  merged.some((one, k) => one && at[k]) ? 0 : 2 ** merged.filter(Boolean).length;
