// Units of angles, lengths and moments that a text names for several numbers, as "q (deg)" does.

import { foldCharacters } from "./characters.js";

/** Units of lengths with their factors to m, and a pattern of their names. */
export const LENGTH_UNITS = { mm: 1e-3, cm: 1e-2, m: 1 };
export const LENGTH_UNIT = Object.keys(LENGTH_UNITS).join("|");
export const MOMENT_UNITS = { 0.001: "N mm", 0.01: "N cm", 1000: "kN m" }; // by factors to N m

// Degrees in English, German, French, Italian, Spanish, Portuguese and Russian, Chinese.
const DEGREE =
  String.raw`deg(?:rees?)?(?!\p{L})|degr[ée]s?(?!\p{L})|grad[io]s?(?!\p{L})|` +
  String.raw`graus|градус|度|°`;
const DEGREES = new RegExp(String.raw`(?<!\d\s?|\p{L})(?:${DEGREE})`, "iu");
const GERMAN_DEGREES = /(?<!\d\s?|\p{L})Grad(?!\p{L})/u;
const IN_DEGREES = // np.radians([...]), [...]*pi/180
  /\b(?:deg2rad|radians)\s*\(\s*(?:np\.array\(\s*)?[[(]|[\])]\s*\.?\*\s*(?:\w+\.)?pi\s*\/\s*180/;
const RADIANS = /\brad(?:ians?)?\b/i;

/** @param {"mm" | "cm"} unit that no number stands before @returns {[RegExp, number]} */
function makeLengthFactor(unit) {
  const before = String.raw`(?<![\d.]\s?|[\p{L}\d]|\bN\s?[·*]?\s?)`;
  return [new RegExp(String.raw`${before}${unit}(?![\p{L}\d])`, "u"), LENGTH_UNITS[unit]];
}

/**
 * Units of lengths and moments as words of their own, and their factors to m and N m.
 * @type {Record<string, [RegExp, number][]>}
 */
const FACTORS = {
  lengths: [makeLengthFactor("mm"), makeLengthFactor("cm")],
  moments: [
    [/(?<!\p{L})(?:N\s?[·*]?\s?mm|mN\s?[·*]?\s?m)(?!\p{L})/u, 1e-3],
    [/(?<!\p{L})N\s?[·*]?\s?cm(?!\p{L})/u, 1e-2],
    [/(?<!\p{L})kN\s?[·*]?\s?m(?!\p{L})/u, 1e3],
  ],
};
const findFactor = (text, kind) => FACTORS[kind].find(([unit]) => unit.test(text))?.[1] ?? null;

/**
 * Find the units that a text names.
 * @param {string} typed a text
 * @param {boolean} [hasDegrees] whether degrees were found already
 * @returns {{ angles: string | null, lengths: number | null, moments: number | null }} "deg" or
 *   "rad", null if neither or both are named; factors to m and N m, null if no unit is named
 */
export function readUnits(typed, hasDegrees = false) {
  const text = foldCharacters(typed);
  const [degrees, radians] = IN_DEGREES.test(text)
    ? [true, false]
    : [hasDegrees || DEGREES.test(text) || GERMAN_DEGREES.test(text), RADIANS.test(text)];
  return {
    angles: degrees === radians ? null : degrees ? "deg" : "rad",
    lengths: findFactor(text, "lengths"),
    moments: findFactor(text, "moments"),
  };
}

/**
 * Return whether only the last of several entries on each line is in degrees, as in "10, 20 and 30
 * deg": its unit is that of the whole line.
 * @param {import("./owners.js").Token[]} tokens
 * @param {(token: import("./owners.js").Token) => boolean} isDegrees
 */
export function endInDegrees(tokens, isDegrees) {
  const entries = tokens.filter(({ owner }) => owner === "entry");
  return entries.every((token, k) => {
    const isLast = token.line !== entries[k + 1]?.line;
    const isAlone = isLast && token.line !== entries[k - 1]?.line;
    return !isAlone && isDegrees(token) === isLast;
  });
}

// Units that are not converted: minutes of arc, milliradians, turns and gon, which English also
// calls grad, as German calls a degree; a power of ten above the numbers.
const POWER_OF_TEN = String.raw`10(?:\^\s*[({]?[-\u2212+]?\d+[)}]?|[⁻⁺⁰¹²³⁴-⁹]+)`;
const OTHER_UNIT = new RegExp(
  [
    String.raw`(?<=\d ?°\s?\d{1,2} ?)['′’]`,
    String.raw`(?<!\p{L})(?:mrad|milliradians?|gon|grads|gradians?|arcmin)(?!\p{L})`,
    String.raw`(?<=\d[.,]\d{1,20}\s?)(?:turns?|revs?|revolutions?)(?!\p{L})`,
    String.raw`(?<=[[(]\s?|\bin )(?:turns?|revs?|revolutions?)(?=\s?[\]):])`,
    String.raw`(?<!\p{L})(?:lbf?[ ·*-]?(?:ft|in)|(?:ft|in)[ ·*-]?lbf?)(?!\p{L})`,
    String.raw`(?<!\p{L})(?:kg[·*]?cm|kgf ?[·*]?c?m|inch(?:es)?|feet)(?!\p{L})`,
    String.raw`[([]\s*(?:[×x]\s*${POWER_OF_TEN}|${POWER_OF_TEN}\s*\p{L})[^()\n]{0,9}[)\]]`,
    String.raw`^[ \t\u00a0]*[×x]\s*${POWER_OF_TEN}`, // \s would cross empty lines at each of them
  ].join("|"),
  "imu",
);

const GON = /(?<!\p{L})grad(?!\p{L})/u;

/**
 * Name the unit of lengths that has a factor.
 * @param {number} factor to m
 */
export const nameLengthUnit = (factor) =>
  Object.keys(LENGTH_UNITS).find((name) => LENGTH_UNITS[name] === factor);

// Convert a length to metres without round-off: 72 / 1000 is 0.072, 72 * 0.001 is not.
/** @param {number} length @param {number} factor of its unit, to m */
export const toMetres = (length, factor) => length / Math.round(1 / factor);

/**
 * Find a unit that is not converted, so that no number is taken for another unit's.
 * @param {string} text @returns {string | null} the unit as it is typed
 */
export const findOtherUnit = (text) => (OTHER_UNIT.exec(text) ?? GON.exec(text))?.[0] ?? null;

const TIMES = String.raw`(?:[-·*.⋅×~x]|\\[,;:! ]|\\cdot)`;
const MOMENT = String.raw`(k?N|mN) ?${TIMES}? ?(mm|cm|m)`;
// "·m" behind N, also of "\text{N}\cdot\text{m}".
const METRES_BEHIND = String.raw`[}$]{0,2}\s{0,3}${TIMES}[$\s]{0,3}(?:\\(?:text|mathrm)\{)?[cm]`;
// A unit behind a number, its brackets and LaTeX's spaces. A letter before = is a name.
const UNIT_BEHIND = new RegExp(
  String.raw`^(?:[ \t\])}~]|\\[,;:! ])*(?:\\(?:text|mathrm|si|unit|rm)\{[ ~]*)?` +
    String.raw`(${MOMENT}|mm|cm|m|k?N|kg|s|ms|rad|deg|°|Hz)(?![\p{L}\d_^²³/({\[])(?![ \t]*[=:])` +
    `(?!${METRES_BEHIND})`,
  "u",
);

/**
 * Read the unit that stands behind a number; "" if there is none.
 * @param {string} text @param {number} to the end of the number
 */
export const readUnitBehind = (text, to) => UNIT_BEHIND.exec(text.slice(to, to + 40))?.[1] ?? "";

const ANGLE = /^(?:rad|deg|°)$/;
const LENGTH = /^(?:mm|cm|m)$/;
const FORCE = /^k?N$/;
const ONLY_MOMENT = new RegExp(`^${MOMENT}$`);

/**
 * Return whether a unit may be that of a joint's value, or of its torque or force. Text after a
 * list in N m may name the moments only, so a sliding joint may have N m.
 * @param {string} unit @param {{ turns: boolean, isTorque: boolean }} joint
 */
export function fitsJoint(unit, { turns, isTorque }) {
  if (!unit) return true;
  if (isTorque) return ONLY_MOMENT.test(unit) || (!turns && FORCE.test(unit));
  return turns ? ANGLE.test(unit) : LENGTH.test(unit);
}

/**
 * Return the factor to N m of a moment's unit.
 * @param {string} unit such as "N mm" @returns {number | null} null for another unit
 */
export function momentFactor(unit) {
  const [, force, length] = ONLY_MOMENT.exec(unit) ?? [];
  return length ? { N: 1, kN: 1e3, mN: 1e-3 }[force] * LENGTH_UNITS[length] : null;
}
