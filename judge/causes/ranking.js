// Which mistakes explain an answer.

import { minusEach } from "../geometry/linear.js";
import { listed, lower, say, upper } from "../sentences.js";

const SHARE = 0.6; // of the wrong entries that a single mistake must gain
const PAIR_SHARE = 0.85;
const ODD = 0.7; // what an entry that stays unexplained weighs against a second mistake

/** @typedef {{ keys: string[], fields: Record<string, any>[] }} Cause one mistake or two */

/** @returns {Cause} */
export const cause = (key, fields = {}) => ({ keys: [key], fields: [fields] });

/** @returns {Cause} */
export const both = (one, two) => ({
  keys: [...one.keys, ...two.keys],
  fields: [...one.fields, ...two.fields],
});

// How reports and the corpus call a cause, as "J.frame:3 + J.millimetres".
export const nameOf = ({ keys, fields }) =>
  keys.map((key, i) => partName(key, fields[i])).join(" + ");

function partName(key, fields) {
  if ("_of" in fields) return fields._of;
  const shown = Object.entries(fields).filter(([name]) => !name.startsWith("_"));
  return [key, ...shown.map(([, value]) => value)].join(":");
}

// What a cause says, without a full stop.
export function wordsOf({ keys, fields }) {
  const [first, second] = keys.map((key, i) => say(key, fields[i]));
  return second === undefined ? first : say("and also", { first, second: lower(second) });
}

/**
 * Causes, best first, the entries that the best leaves, and what each entry is off by from what the
 * best gives.
 * @typedef {{ causes: Cause[], odd: boolean[], rest: number[] }} Found
 */

// The causes that explain mine within the band; null where none does.
/** @returns {Found | null} */
export function explain(mine, right, band, { causes, made }, weight = ODD) {
  const candidates = causes.map((one, k) => [[one], made[k]]);
  return explainAll(mine, right, [band], candidates, weight)[0];
}

/**
 * The same for several bands at once, of candidates that are made one after another: a cause, or
 * the two of a pair, and what the answer would be. Thousands of them are looked at and dropped.
 * @param {number[]} mine @param {number[]} right @param {number[][]} bands
 * @param {Iterable<[Cause[], number[]]>} candidates
 * @returns {(Found | null)[]}
 */
export function explainAll(mine, right, bands, candidates, weight = ODD) {
  const tests = bands.map((band) => {
    const count = mine.filter((x, i) => Math.abs(x - right[i]) > band[i]).length;
    const least = [Math.max(3, SHARE * count), Math.max(4, PAIR_SHARE * count)];
    return { band, count, least, named: [] };
  });
  for (const [parts, A] of candidates) {
    const edits = parts.length > 1 ? 2 : parts[0].keys.length;
    for (const { band, count, least, named } of tests) {
      const odd = misfits(mine, A, band, count, least[edits - 1]);
      const fits = odd ? count - odd >= least[edits - 1] : count >= edits;
      if (fits) named.push({ cost: edits + weight * odd, parts, A });
    }
  }
  return tests.map((test) => best(mine, test));
}

// How many entries differ, counted until they are too many. An answer gains the wrong entries that
// it explains and loses the right ones that it spoils, which is what is wrong less all that differ.
function misfits(mine, other, band, count, least) {
  let odd = 0;
  for (let i = 0; i < mine.length; i++) {
    if (Math.abs(mine[i] - other[i]) <= band[i]) continue;
    odd++;
    if (count - odd < least) return odd;
  }
  return odd;
}

function best(mine, { band, named }) {
  if (!named.length) return null;
  const least = Math.min(...named.map(({ cost }) => cost));
  const found = named.filter(({ cost }) => cost === least);
  const causes = found.map(({ parts }) => parts.reduce(both));
  const [{ A }] = found;
  const rest = minusEach(mine, A);
  return { causes, odd: rest.map((x, i) => !(Math.abs(x) <= band[i])), rest };
}

export const complete = (found) => Boolean(found) && !found.odd.includes(true);

// What the causes say: single ones that explain equally well one after another, of pairs the first.
export function several(found, most = 3) {
  const words = [...new Set(found.map(wordsOf))].slice(0, found[0].keys.length === 1 ? most : 1);
  if (words.length === 1) return words[0];
  return say("or", { first: words[0], others: listed(words.slice(1).map(lower), "or") });
}

// A cause that leaves something unexplained is no more than likely.
export const perhaps = (words, left) =>
  left.length ? upper(say("perhaps", { cause: lower(words) })) : words;

// The one with the least cost.
export function better(all, weight = ODD) {
  const cost = (f) => f.causes[0].keys.length + weight * f.odd.filter(Boolean).length;
  return all.filter(Boolean).reduce((best, f) => (best && cost(best) <= cost(f) ? best : f), null);
}
