// Finds the unit behind a number, as in "0.5 rad", and the unit that a text states for several
// numbers, as in "q (deg)". Defines the factors of units to SI.

import { foldCharacters, foldNames, withoutSpacing } from "./characters.js";
import { ArmError, formatMessage } from "../sentences.js";

/** The factors of units of lengths to m. */
export const LENGTH_UNITS = { mm: 1e-3, cm: 1e-2, m: 1 };
export const LENGTH_UNIT = "[cm]?m";
export const MOMENT_UNITS = { 0.001: "N mm", 0.01: "N cm", 1000: "kN m" }; // by factors to N m

const TIMES = String.raw`(?: ?[-·*×x] ?|[ .])?`;
const FORCE = "[km]?N";
const MOMENT = `${FORCE}${TIMES}${LENGTH_UNIT}|Newton[- ]?met(?:er|re)s?`;
const DEGREE = "deg(?:rees?)?|Grad|°";
const ANGLE = `rad(?:ians?)?|${DEGREE}`;

/** A pattern of the units that are read behind a number. */
export const UNIT = `(?:${MOMENT}|${FORCE}|${LENGTH_UNIT}|${ANGLE})`;

const isWhole = (pattern) => {
  const whole = new RegExp(`^(?:${pattern})$`);
  return (text) => whole.test(text);
};
const isUnit = isWhole(UNIT);
const isAngle = isWhole(ANGLE);
const isLength = isWhole(LENGTH_UNIT);
const isForce = isWhole(FORCE);
const isMoment = isWhole(MOMENT);
export const isDegree = isWhole(DEGREE);

const PREFIXES = { m: 1e-3, c: 1e-2, k: 1e3 };
const PREFIXED = new RegExp(`^(?:([km])?N)?(?:${TIMES}([cm])?m)?$`);

/**
 * Return the factor of a unit to rad, m, N or N m. Return undefined for degrees and other words.
 * @param {string} unit @returns {number | undefined}
 */
export function findFactor(unit) {
  if (!isUnit(unit) || isDegree(unit)) return undefined;
  const [, force, length] = PREFIXED.exec(unit) ?? [];
  return (PREFIXES[force] ?? 1) * (PREFIXES[length] ?? 1);
}

/**
 * Return the factor from a unit of moments to N m.
 * @param {string} unit such as "N mm" @returns {number | null} null for another unit
 */
export const momentFactor = (unit) => (isMoment(unit) ? findFactor(unit) : null);

/**
 * Return whether a unit fits the value of a joint, or its torque or force. A prismatic joint may
 * have N m, because a unit behind a list may be meant for the torques only.
 * @param {string} unit @param {{ turns: boolean, isTorque: boolean }} joint
 */
export function fitsJoint(unit, { turns, isTorque }) {
  if (!unit) return true;
  if (isTorque) return isMoment(unit) || (!turns && isForce(unit));
  return turns ? isAngle(unit) : isLength(unit);
}

/**
 * Return the name of the unit of lengths with a factor.
 * @param {number} factor to m
 */
export const nameLengthUnit = (factor) =>
  Object.keys(LENGTH_UNITS).find((name) => LENGTH_UNITS[name] === factor);

// Convert a length to metres by a division: 72 / 1000 is 0.072, but 72 * 0.001 has a round-off.
/** @param {number} length @param {number} factor from its unit to m */
export const toMetres = (length, factor) => length / Math.round(1 / factor);

// Remove commands and braces of LaTeX around units.
const withoutTypesetting = (text) =>
  withoutSpacing(foldNames(foldCharacters(text)).replace(/\\[A-Za-z]+ ?(?=\{)|[{}]/g, ""));

// A letter before = is a name, and a letter before a power or a bracket is a factor.
const UNIT_BEHIND = new RegExp(
  String.raw`^[ \t\])]*((?:${UNIT}|kg|m?s|Hz)(?: ?\/ ?(?:${UNIT}|m?s))?)` +
    String.raw`(?![*·]?\p{L}|[\d_^/([]|[ \t]*[=:])`,
  "u",
);

/**
 * Read the unit behind a number. Return "" if there is none.
 * @param {string} text @param {number} to the end of the number
 */
export function readUnitBehind(text, to) {
  return UNIT_BEHIND.exec(withoutTypesetting(text.slice(to, to + 40)))?.[1] ?? "";
}

// Degrees in the headings of English, French, Italian, Spanish, Portuguese, Russian and Chinese.
const DEGREE_WORD =
  String.raw`deg(?:rees?)?(?!\p{L})|degr[ée]s?(?!\p{L})|grad[io]s?(?!\p{L})|` +
  String.raw`graus|градус|度|°`;
const NAMED_DEGREES = new RegExp(String.raw`(?<!\d\s?|\p{L})(?:${DEGREE_WORD})`, "iu");
const GERMAN_DEGREES = /(?<!\d\s?)Grad(?!\p{L})/u;
const IN_DEGREES = // np.radians([...]), [...]*pi/180
  /\b(?:deg2rad|radians)\s*\(\s*(?:[\w.]*array\(\s*)?[[(]|[\])]\s*\.?\*\s*(?:\w+\.)?pi\s*\/\s*180/;
const NAMED_RADIANS = /\brad(?:ians?)?\b/i;

// A unit of lengths that stands alone, neither behind a number nor within a unit of moments.
const NAMED_LENGTH = new RegExp(
  String.raw`(?<![\d.]\s?|[\p{L}\d]|\bN${TIMES})[cm]m(?![\p{L}\d])`,
  "u",
);
const NAMED_MOMENTS = new RegExp(String.raw`(?<!\p{L})(?:${MOMENT})(?!\p{L})`, "gu");

/**
 * Find the units that a text states for several numbers.
 * @param {string} typed a text
 * @param {boolean} [hasDegrees] whether degrees were found already
 * @returns {{ angles: string | null, lengths: number | null, moments: number | null }} `angles` is
 *   "deg" or "rad", and null if the text states neither or both; `lengths` and `moments` are
 *   factors to m and N m, and null if the text states no unit
 */
export function readUnits(typed, hasDegrees = false) {
  const text = foldCharacters(typed);
  const [degrees, radians] = IN_DEGREES.test(text)
    ? [true, false]
    : [
        hasDegrees || NAMED_DEGREES.test(text) || GERMAN_DEGREES.test(text),
        NAMED_RADIANS.test(text),
      ];
  const plain = withoutTypesetting(typed);
  const moments = (plain.match(NAMED_MOMENTS) ?? []).map(findFactor);
  return {
    angles: degrees === radians ? null : degrees ? "deg" : "rad",
    lengths: LENGTH_UNITS[NAMED_LENGTH.exec(plain)?.[0]] ?? null,
    moments: moments.find((factor) => MOMENT_UNITS[factor]) ?? null,
  };
}

/**
 * Return whether only the last of several entries on each line is in degrees, as in "10, 20 and 30
 * deg". The unit then belongs to the whole line.
 * @param {import("./owners.js").Token[]} tokens
 * @param {(token: import("./owners.js").Token) => boolean} isDegrees
 */
export function endInDegrees(tokens, isDegrees) {
  // A decimal comma makes two tokens of an entry; the second counts.
  const entries = tokens.filter(
    ({ owner, index }, k) => owner === "entry" && tokens[k + 1]?.index !== index,
  );
  return entries.every((token, k) => {
    const isLast = token.line !== entries[k + 1]?.line;
    const isAlone = isLast && token.line !== entries[k - 1]?.line;
    return !isAlone && isDegrees(token) === isLast;
  });
}

// Units that the judge does not convert, such as minutes of arc, milliradians, turns and gon, and
// powers of ten above the numbers. English "grad" is gon, but German "Grad" is a degree.
const POWER_OF_TEN = String.raw`10(?:\^\s*[({]?[-\u2212+]?\d+[)}]?|[⁻⁺⁰¹²³⁴-⁹]+)`;
const TURNS = "(?:turn|rev(?:olution)?)s?";
const UNCONVERTED_UNIT = new RegExp(
  [
    String.raw`(?<=\d ?°\s?\d{1,2} ?)['′’]`,
    String.raw`(?<!\p{L})(?:mrad|milliradians?|gon|grads|gradians?|arcmin)(?!\p{L})`,
    String.raw`(?<=\d[.,]\d{1,20}\s?)${TURNS}(?!\p{L})`,
    String.raw`(?<=[[(]\s?|\bin )${TURNS}(?=\s?[\]):])`,
    String.raw`(?<!\p{L})(?:lbf?[ ·*-]?(?:ft|in)|(?:ft|in)[ ·*-]?lbf?)(?!\p{L})`,
    String.raw`(?<!\p{L})(?:kg[·*]?cm|kg ?[·*]? ?m(?![²^\d])|kgf ?[·*]?c?m)(?![\p{L}_])`,
    String.raw`(?<!\p{L})(?:inch(?:es)?|feet)(?!\p{L})`,
    String.raw`[([]\s*(?:[×x]\s*${POWER_OF_TEN}|${POWER_OF_TEN}\s*\p{L})[^()\n]{0,9}[)\]]`,
    String.raw`^[ \t\u00a0]*[×x]\s*${POWER_OF_TEN}`, // \s would cross empty lines at each of them
  ].join("|"),
  "imu",
);

const GON = /(?<!\p{L})grad(?!\p{L})/u;

/**
 * Find a unit that the judge does not convert.
 * @param {string} text @returns {string | null} the unit as it is typed
 */
export const findOtherUnit = (text) => (UNCONVERTED_UNIT.exec(text) ?? GON.exec(text))?.[0] ?? null;

/**
 * Refuse values without a unit if one header or name states degrees and another states radians.
 * @param {import("./block.js").Block} block @param {string} what the answer
 */
export function refuseTwoUnits({ rows, headers, labels, sources }, what) {
  const names = [...headers, ...labels.flat()].map(({ text }) => text);
  const all = [...names, ...sources.map(({ name }) => name)];
  const units = new Set(all.map((name) => readUnits(name).angles));
  const isBare = rows.flat().every(({ text }) => !/ deg$/.test(text));
  if (isBare && units.has("deg") && units.has("rad"))
    throw new ArmError(formatMessage("names in two units", { what }));
}
