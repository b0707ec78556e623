// What all closed forms share: a shoulder that faces a point, and two links in a plane.

import { cosSin, minus, plus, scaled } from "./kinematics.js";

export const BOUNDARY = 1e-12; // m: a target this near to the boundary counts as on it

export const SINGULAR = 1e-11; // a sine this small counts as 0

export const ROUND_OFF = 1e-15; // what rounding does to a point (m) or to an axis

export const SIDES = ["front", "back"];

export const WRISTS = ["q_5 > 0", "q_5 < 0"];

// Rounded to a whole number as NumPy does: halves to the even one.
export function roundHalfToEven(x) {
  const whole = Math.round(x);
  return whole - x === 0.5 && whole % 2 ? whole - 1 : whole;
}

// An angle in (-pi, pi], up to rounding.
export const wrapAngle = (angle) =>
  roundHalfToEven(angle * (0.5 / Math.PI)) * (-2 * Math.PI) + angle;

export const subtractOffset = (angle, offset) => (offset ? wrapAngle(angle - offset) : angle);

export const clamp = (x, least, most) => Math.min(Math.max(x, least), most);

// A row with the sine and cosine of its twist.
export function withTwist(row) {
  const [ca, sa] = cosSin(row.alpha);
  return { ...row, ca, sa };
}

// Joint 1's two angles that turn the plane, `offset` along z_1 beside the axis, to the target p,
// and p in its axes.
export function solveShoulder(first, offset, p) {
  const [x, y, z] = p;
  const delta = first.sa * offset;
  const square = x * x + y * y - delta * delta;
  const edge = Math.max(2 * Math.abs(delta) * BOUNDARY, BOUNDARY ** 2);
  const one = Math.abs(square) <= edge;
  const reach = Math.sqrt(square > edge ? square : 0);
  const both = [reach, -reach];
  const free = one && delta === 0;
  const chosen = [first.theta, first.theta + Math.PI];
  return {
    phi: both.map((b, k) => (free ? chosen[k] : Math.atan2(y * b + x * delta, x * b - y * delta))),
    x: both,
    y: first.sa * (z - first.d),
    exists: square >= -edge,
    one,
    free,
    blur: one ? 0 : ROUND_OFF / Math.max(reach, BOUNDARY),
  };
}

export const outerRadius = ({ upper, fore }) => Math.abs(upper) + Math.abs(fore);

export const innerRadius = ({ upper, fore }) => Math.abs(Math.abs(upper) - Math.abs(fore));

// The two angles of a planar pair of links that ends at (px, py); `sign` is that of sin(phi_3),
// `blur` by how much rounding may move the point.
/** @param {any} links @param {number[]} end @param {number} sign @param {number} chosen */
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

// The tool's frame with the last row's twist taken back, and the origin before that row's lengths.
export function removeLastRow(last, { x, y, z, o }) {
  const [c, s] = [last.ca, last.sa];
  const turned = { x, y: plus(scaled(c, y), scaled(-s, z)), z: plus(scaled(s, y), scaled(c, z)) };
  const centre = minus(o, scaled(last.d, turned.z));
  return { ...turned, centre: last.a ? minus(centre, scaled(last.a, x)) : centre };
}

// Each choice of branches, named, where `make` finds one.
export function collectBranches(choices, make, names = [], at = []) {
  if (!choices.length) {
    const found = make(...at);
    const times = found ? timesOf(found.merged, at) : 0;
    return times ? [{ name: names.join(", "), times, ...found }] : [];
  }
  const [first, ...rest] = choices;
  return first.flatMap((name, k) => collectBranches(rest, make, [...names, name], [...at, k]));
}

// How many branches one is, of choices that make no difference; of those that are one the first is.
const timesOf = (merged, at) =>
  merged.some((one, k) => one && at[k]) ? 0 : 2 ** merged.filter(Boolean).length;
