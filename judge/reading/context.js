// What the text around an answer says of its units, and the heads and names beside it.

const DEGREES = /(?<!\d\s?)(?:\bdeg(?:rees?)?\b|_deg\b|°|\bgrad\b|\bgrados\b|\bdegrés\b|度)/i;
const RADIANS = /\brad(?:ians?)?\b|弧度/i;
const MILLIMETRES = /(?<![\d.]\s?|\bN\s?[·*]?\s?)\bmm\b/;
const NEWTON_MILLIMETRES = /\bN\s?[·*]?\s?mm\b/;

/**
 * @param {string} text
 * @returns {{ angles: string | null, lengths: string | null, moments: string | null }} null where
 *   nothing is said, or both
 */
export function unitsSaid(text) {
  const [degrees, radians] = [DEGREES.test(text), RADIANS.test(text)];
  return {
    angles: degrees === radians ? null : degrees ? "deg" : "rad",
    lengths: MILLIMETRES.test(text) ? "mm" : null,
    moments: NEWTON_MILLIMETRES.test(text) ? "Nmm" : null,
  };
}
