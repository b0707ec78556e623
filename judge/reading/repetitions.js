// Replaces an angle that is typed in radians and in degrees, "0.500 rad (28.65°)", by "28.65°". If
// the two values differ by more than their typed digits allow, the answer is refused.

import { RAD } from "../geometry/angles.js";
import { ArmError, formatMessage, quoteText } from "../sentences.js";

const NUMBER = String.raw`[-+]?\d+(?:[.,]\d+)?`;
const BLANK = String.raw`(?:[ \t]|\\[,;: ])*`;
const DEGREES = String.raw`${BLANK}(?:\^?°|\^\{°\}|deg(?:rees?)?\b)`;
const RADIANS = String.raw`${BLANK}rad(?:ians?)?\b`;
const EQUALS = String.raw`${BLANK}[=≈/]${BLANK}`;
const OPEN = String.raw`${BLANK}[[(]${BLANK}[=≈]?${BLANK}`;
const CLOSE = String.raw`${BLANK}[\])]`;
const DECIMALS_BEFORE = String.raw`(?<=[.,]\d{1,20})`;
const START = String.raw`(?<![\p{L}\d_.,*/^])`;

// Patterns of both values, and whether the degrees stand first. In "0.785 (45°)" the radians have
// no unit, but need decimals: 2(45°) is a product.
/** @type {[RegExp, boolean][]} */
const PAIRS = [
  [`(${NUMBER})(?:${RADIANS}|${DECIMALS_BEFORE})${OPEN}(${NUMBER}${DEGREES})${CLOSE}`, false],
  [`(${NUMBER})${RADIANS}${EQUALS}(${NUMBER}${DEGREES})`, false],
  [`(${NUMBER}${DEGREES})${OPEN}(${NUMBER})${RADIANS}${CLOSE}`, true],
  [`(${NUMBER}${DEGREES})${EQUALS}(${NUMBER})${RADIANS}`, true],
].map(([pattern, hasDegreesFirst]) => [
  new RegExp(START + pattern, "gu"),
  Boolean(hasDegreesFirst),
]);

/**
 * Remove each value in radians that repeats a value in degrees.
 * @param {import("./spans.js").SpannedText} text
 */
export const withoutRepeatedUnits = (text) =>
  PAIRS.reduce(
    (rest, [pattern, hasDegreesFirst]) =>
      rest.replace(pattern, (pair, first, second) => {
        const [degrees, radians] = hasDegreesFirst ? [first, second] : [second, first];
        if (agree(radians, degrees)) return degrees;
        throw new ArmError(formatMessage("two units", { text: quoteText(pair) }));
      }),
    text,
  );

/**
 * Return whether an angle in radians and an angle in degrees are equal within their typed digits.
 * @param {string} radians @param {string} degrees
 */
export function agree(radians, degrees) {
  const [x, y] = [radians, degrees].map((text) => parseFloat(text.replace(",", ".")));
  const unit = (text) => 10 ** -(/[.,](\d*)/.exec(text)?.[1].length ?? 0);
  return Math.abs(x - y * RAD) <= 0.51 * (unit(radians) + unit(degrees) * RAD);
}
