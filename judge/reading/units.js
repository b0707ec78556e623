// Units of angles, lengths and moments that a text names for several numbers, as "q (deg)" does.

export const LENGTH_UNITS = { 0.001: "mm", 0.01: "cm" }; // by their factors to m
export const MOMENT_UNITS = { 0.001: "N mm", 0.01: "N cm", 1000: "kN m" }; // by factors to N m

const DEGREES = /(?<!\d\s?)(?:\bdeg(?:rees?)?\b|_deg\b|°)/i;
const IN_DEGREES = // np.radians([...]), [...]*pi/180
  /\b(?:deg2rad|radians)\s*\(\s*(?:np\.array\(\s*)?[[(]|[\])]\s*\.?\*\s*(?:\w+\.)?pi\s*\/\s*180/;
const RADIANS = /\brad(?:ians?)?\b/i;
// 10, 20 and 30 deg
const LIST_IN_DEGREES = /,\s*[-\u2212]?[\d.,]+,?\sand\s[-\u2212]?[\d.,]+\s?(?:deg|°)/i;
/**
 * Units of lengths and moments as words of their own, and their factors to m and N m.
 * @type {Record<string, [RegExp, number][]>}
 */
const FACTORS = {
  lengths: [
    [/(?<![\d.]\s?|[\p{L}\d]|\bN\s?[·*]?\s?)mm(?![\p{L}\d])/u, 1e-3],
    [/(?<![\d.]\s?|[\p{L}\d]|\bN\s?[·*]?\s?)cm(?![\p{L}\d])/u, 1e-2],
  ],
  moments: [
    [/(?<!\p{L})(?:N\s?[·*]?\s?mm|mN\s?[·*]?\s?m)(?!\p{L})/u, 1e-3],
    [/(?<!\p{L})N\s?[·*]?\s?cm(?!\p{L})/u, 1e-2],
    [/(?<!\p{L})kN\s?[·*]?\s?m(?!\p{L})/u, 1e3],
  ],
};
const findFactor = (text, kind) => FACTORS[kind].find(([unit]) => unit.test(text))?.[1] ?? null;

/**
 * Find the units that a text names.
 * @param {string} text
 * @returns {{ angles: string | null, lengths: number | null, moments: number | null }} "deg" or
 *   "rad", null if neither or both are named; factors to m and N m, null if no unit is named
 */
export function readUnits(text) {
  const [degrees, radians] = IN_DEGREES.test(text)
    ? [true, false]
    : [DEGREES.test(text) || LIST_IN_DEGREES.test(text), RADIANS.test(text)];
  return {
    angles: degrees === radians ? null : degrees ? "deg" : "rad",
    lengths: findFactor(text, "lengths"),
    moments: findFactor(text, "moments"),
  };
}

// Units that are not converted: minutes of arc, milliradians, turns, gon, and the word that is a
// degree in German and a gon in English.
const OTHER_UNIT = new RegExp(
  [
    String.raw`(?<=\d ?°\s?\d{1,2} ?)['′’]`,
    String.raw`(?<!\p{L})(?:mrad|milliradians?|gon|grads?|gradians?|arcmin)(?!\p{L})`,
    String.raw`(?<=\d[.,]\d+\s?)(?:turns?|revs?|revolutions?)(?!\p{L})`,
    String.raw`(?<=[[(]\s?|\bin )(?:turns?|revs?|revolutions?)(?=\s?[\]):])`,
    String.raw`(?<!\p{L})(?:lbf?[ ·*-]?(?:ft|in)|(?:ft|in)[ ·*-]?lbf?|kgf?[·*]?cm|kgf ?m)(?!\p{L})`,
  ].join("|"),
  "iu",
);

/**
 * Find a unit that is not converted, so that no number is taken for another unit's.
 * @param {string} text @returns {string | null} the unit as it is typed
 */
export const findOtherUnit = (text) => OTHER_UNIT.exec(text)?.[0] ?? null;
