// What the digits of an answer promise.

import { say } from "./sentences.js";

export const [RIGHT, SO_FAR, ROUNDED, WRONG] = ["right", "so far", "rounded", "wrong"];

export const HALF = 0.51; // units: a number rounded rightly, and a hair for the arithmetic
export const HAND = 3.01; // units: products of rounded numbers
const EXACT = 1e-6; // of the scale
export const SLOPPY = 1e-3; // of the scale: full floats from inputs that were rounded on the way
export const TELLING = 2.1e-3; // a mistake that changes less cannot be asked for
const FINE = 2e-3; // rad or m: a place that is coarser is no rounding of a joint's value
const NUDGE = 1e-6; // rad or m: a difference for a derivative
const FULL = 13; // significant digits from which a float was never rounded
const LEFT = 5; // times a unit that no number may be smaller than
const NOISE = -12; // the power of ten below which a number is a rounded zero
const NUMBER = /^[+-]?\s*(\d*)\.?(\d*)(?:[eE]([+-]?\d+))?$/;

const ten = (power) => Number(`1e${power}`);

// Decimals, significant digits and the exponent of the first one of a plain number as typed; null
// for a formula.
function literal(text) {
  const match = NUMBER.exec(text.trim());
  if (!match || !(match[1] || match[2])) return null;
  const digits = (match[1] + match[2]).replace(/^0+/, "").length;
  const decimals = match[2].length - Number(match[3] ?? 0);
  return { decimals, digits, first: digits - 1 - decimals };
}

// The unit of the last place of each of a set of numbers typed together; 0 for formulas and for
// full floats.
export function units(texts) {
  const found = texts.map(literal);
  const plain = found.filter((f) => f && f.digits && f.first > NOISE);
  const most = (key) =>
    plain.reduce((top, f) => Math.max(top, f[key]), plain.length ? -Infinity : 0);
  const [decimals, figures] = [most("decimals"), most("digits")];
  if (figures >= FULL || (found.includes(null) && decimals <= 0)) return texts.map(() => 0);
  const byFigures =
    plain.every((f) => f.decimals <= figures - 1 - f.first) &&
    plain.some((f) => f.digits === figures && f.decimals < decimals);
  return found.map((f) => {
    if (!f) return 0;
    if (!byFigures || !f.digits || f.first <= NOISE) return bounded(-decimals, f);
    return bounded(Math.max(-decimals, f.first - figures + 1), f);
  });
}

// A place left of the point is rounded away only in a larger number: 1e9 is no torque of 56 N m.
const bounded = (place, { first }) => Math.min(ten(place), Math.max(1, ten(first) / LEFT));

// How many decimals the entries show, or null where they show all a computer has.
export function decimalsOf(steps) {
  const coarse = steps.filter((u) => u > 0);
  return coarse.length ? Math.max(0, Math.round(-Math.log10(Math.min(...coarse)))) : null;
}

/**
 * Per entry: up to allowed it is right, up to band it was rounded on the way, up to loose perhaps;
 * slop is what the unwritten digits of q add, tried only where it fails without.
 * @typedef {{ allowed: number[], band: number[], loose: number[], units: number[], slop: number[]
 *   }} Margins
 */

/** @returns {Margins} */
export function margins(steps, scale, slop = null, tolerance = null) {
  const floor = scale.map((s) => EXACT * s);
  const none = steps.map(() => 0);
  if (tolerance !== null) {
    const allowed = floor.map((x) => Math.max(tolerance, x * 1e-3));
    return { allowed, band: allowed, loose: allowed, units: none, slop: none };
  }
  const allowed = steps.map((u, i) => Math.max(HALF * u, floor[i]));
  const band = steps.map((u, i) => Math.max(HAND * u, floor[i]));
  const loose = band.map((b, i) => Math.max(b, SLOPPY * scale[i]));
  return { allowed, band, loose, units: steps, slop: slop ?? none };
}

// What the unwritten digits of joint values change in each number that is made of them: of those
// with three decimals or more; null where there are none.
export function slopOf(steps, q, made) {
  const fine = steps.map((u) => (u > 0 && u < FINE ? u : 0));
  if (!fine.some(Boolean)) return null;
  const here = made(q);
  const total = here.map(() => 0);
  fine.forEach((u, k) => {
    const there = made(q.map((x, i) => (i === k ? x + NUDGE : x)));
    there.forEach((x, i) => (total[i] += (HALF * u * Math.abs(x - here[i])) / NUDGE));
  });
  return total;
}

const plus = (p, q, k) => p.map((x, i) => x + k * q[i]);

// The farthest that an answer may be off and still be right but for its digits.
export const farthest = ({ loose, band, slop }) =>
  plus(band, slop, 2).map((x, i) => Math.max(x, loose[i]));

// What the digits of q allow, too.
export const generous = ({ allowed, slop }) => plus(allowed, slop, 1);

// How near an answer may be to a mistake's, the narrowest first.
export function bands(m) {
  const wide = m.slop.some(Boolean) ? [plus(m.band, m.slop, 2)] : [];
  return [m.band, ...wide, farthest(m), m.allowed];
}

const within = (p, q, most) => p.every((x, i) => Math.abs(x - q[i]) <= most[i]);
const apart = (p, q) => p.reduce((top, x, i) => Math.max(top, Math.abs(x - q[i])), 0);

// The grade of an answer; `made` holds the answers of known mistakes.
export function graded(mine, right, m, made) {
  const telling = made.filter((A) => apart(A, right) > TELLING);
  for (const allowed of [m.allowed, generous(m)]) {
    const mistaken = telling.some((A) => within(mine, A, allowed));
    if (within(mine, right, allowed)) {
      const coarse = Math.max(0, ...m.units);
      const gap = telling.reduce((least, A) => Math.min(least, apart(A, right)), Infinity);
      return mistaken || coarse > gap / 2.1 ? SO_FAR : RIGHT;
    }
    if (mistaken) return WRONG;
  }
  // what is no rounding of the right answer, and one of a mistake's, is the mistake's
  const slipped = !within(mine, right, m.band) && made.some((A) => within(mine, A, m.allowed));
  if (slipped || !within(mine, right, farthest(m))) return WRONG;
  const off = apart(mine, right);
  return telling.some((A) => apart(mine, A) <= off) ? SO_FAR : ROUNDED;
}

// How the last digits came to be off: cut, where that explains all that are, and at least two.
export function lastDigit(mine, right, steps) {
  const off = mine.flatMap((x, i) => (Math.abs(x - right[i]) > HALF * steps[i] ? [i] : []));
  const isCut = (i) => {
    const lost = right[i] * Math.sign(mine[i] || right[i]) - Math.abs(mine[i]);
    return lost > 0 && lost < steps[i];
  };
  return say(off.length > 1 && off.every(isCut) ? "cut" : "rounded on the way");
}

// Which entries are wrong: beyond the band, or, where none is, beyond what is right.
export function beyond(mine, right, { band, allowed }) {
  const past = (most) => mine.map((x, i) => Math.abs(x - right[i]) > most[i]);
  const wrong = past(band);
  return wrong.includes(true) ? wrong : past(allowed);
}
