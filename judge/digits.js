// Compares numbers to the last decimal place that was typed.

export const [RIGHT, SO_FAR, ROUNDED, WRONG] = ["right", "so far", "rounded", "wrong"];
export const RIGHT_BY_MAP = "right by map"; // same arm, other joint zeros or signs

// Allowed difference of a rounded number, in units of its last place.
const HALF = 0.5;
// Allowed difference of a number that is off by one in its last place, in the same units.
const ONE_OFF = 1.5;
// If the last typed place exceeds this share of the largest entry (as in 1e9), being off by one
// there is an error, not rounding.
const LARGEST_SHARE = 0.1;
// An answer with this number of significant digits was copied from a program without rounding.
const UNROUNDED_DIGITS = 13;
// Round-off of a program: smaller numbers are its zeros, as 6.1e-17 for cos 90°.
const NOISE = 1e-12;
// A difference below this (m, rad or N m) is round-off for entries of any size.
const LEAST_DIFFERENCE = 1e-10;
// Error of pi with seven digits or of a long sum, as a share of the largest entry.
const SUM_ROUND_OFF = 1e-6;
// Joint values with a coarser last place (rad or m) count as exact: 0.3 is not 0.26 rounded.
export const FINE_UNIT = 2e-3;
const STEP = 1e-6; // rad or m: step of the difference quotient
const NUMBER = /^[+-]?\s*(\d*)\.?(\d*)(?:[eE]([+-]?\d+))?$/;
const BARE_DIGIT = /^[+-]?\s*[01]\.?0?$/; // the forms in which programs print an exact 0 or 1

/**
 * Numbers with the unit of the last typed place of each, 0.001 for 1.234.
 * @typedef {{ values: number[], units: number[] }} Entries
 */

/**
 * Return the unit of each number's last typed place.
 *
 * A formula has twice its slack. A bare 0 has the finest unit of the answer, a bare 1 that of
 * findUnitOfOne. All units are 0 if some number shows all digits of a program.
 * @param {string[]} texts @param {number[]} [slacks] of the formulas among them
 */
export function units(texts, slacks = []) {
  const numbers = withoutPadding(texts.map(readLiteral));
  if (numbers.some((number) => number?.digits >= UNROUNDED_DIGITS)) return texts.map(() => 0);
  const typedUnits = numbers.flatMap((number, i) => {
    if (!number) return slacks[i] ? [2 * slacks[i]] : [];
    return !number.isBare && number.size > NOISE ? [number.unit] : [];
  });
  const areBare = numbers.every((number) => number?.isBare) && numbers.some(({ size }) => size);
  const finest = typedUnits.length || areBare ? Math.min(1, ...typedUnits) : 0;
  const longer = numbers.filter((number) => number && !number.isBare);
  const unitOfOne = Math.max(finest, findUnitOfOne(longer));
  const bareUnit = ({ size }) => (size && typedUnits.length ? unitOfOne : finest);
  return numbers.map((number, i) => {
    if (!number) return 2 * (slacks[i] ?? 0);
    return number.isBare ? bareUnit(number) : number.unit;
  });
}

// Return the unit of a bare 1 beside other numbers: the finest of numbers of about its size, but
// not finer than the digits of the longest, since "%.4g" writes 1.0003 as 1.
function findUnitOfOne(numbers) {
  if (!numbers.length) return 0;
  const large = numbers.filter(({ size }) => size >= 0.1);
  const finest = large.length ? Math.min(1, ...large.map(({ unit }) => unit)) : 0;
  const digits = Math.max(...numbers.map((number) => number.digits));
  return Math.max(10 ** (1 - digits), finest);
}

// Change the unit of numbers that a program padded with zeros, such as 6.964900e-01 beside
// 3.883316e+01: use the finest digit other than 0.
function withoutPadding(numbers) {
  const padded = numbers.filter((number) => number && !number.isBare && number.size > NOISE);
  const significant = padded.map(({ unit, endZeros }) => unit * 10 ** endZeros);
  const unit = Math.min(COARSEST_UNIT, ...significant);
  const zeros = padded.map((number) => Math.max(0, Math.round(Math.log10(unit / number.unit))));
  const count = zeros.reduce((sum, more) => sum + more, 0);
  if (padded.length < FEWEST_NUMBERS || count < FEWEST_ZEROS) return numbers;
  return numbers.map((number) => number && { ...number, unit: Math.max(unit, number.unit) });
}

const COARSEST_UNIT = 1e-3; // of padded numbers: 0.500000 may be exact
const FEWEST_NUMBERS = 3; // fewer may end in zeros by themselves
const FEWEST_ZEROS = 3; // in total; one answer in a thousand has so many by chance

/**
 * Return the units that a program's numbers have if it trims zeros: those of the column's finest
 * number, or of as many significant digits as the column's longest.
 * @param {number[][]} rows @param {number[][]} typedUnits
 */
export function findColumnUnits(rows, typedUnits) {
  const columns = rows[0].map((_, k) => {
    const pairs = rows
      .map((row, i) => [Math.abs(row[k]), typedUnits[i][k]])
      .filter(([, unit]) => unit); // exact numbers have no unit
    return {
      finest: Math.min(...pairs.map(([, unit]) => unit)),
      digits: Math.max(...pairs.map(([x, unit]) => Math.ceil(Math.log10(1 + x / unit)))),
    };
  });
  return rows.map((row, i) =>
    row.map((x, k) => {
      const { finest, digits } = columns[k];
      const leading = Math.ceil(Math.log10(Math.abs(x) || finest));
      return Math.min(typedUnits[i][k], Math.max(finest, 10 ** (leading - digits)));
    }),
  );
}

/**
 * Give an entry of few decimals, such as 1.3 beside 0.1157, the finest typed unit if the expected
 * number rounds to it at that unit: its further decimals are zeros that were left out.
 * @param {Entries} typed @param {number[]} expected @returns {Entries}
 */
export function sharpenUnits(typed, expected) {
  const { values, units: lastPlaces } = typed;
  const finest = Math.min(...lastPlaces.filter((unit, i) => unit && values[i]));
  const isExact = (x, i) => lastPlaces[i] > finest && Math.abs(x - expected[i]) <= HALF * finest;
  return { ...typed, units: lastPlaces.map((unit, i) => (isExact(values[i], i) ? finest : unit)) };
}

// Read a plain number as typed; null for a formula.
function readLiteral(text) {
  const trimmed = text.trim();
  const match = NUMBER.exec(trimmed);
  if (!match || !(match[1] || match[2])) return null;
  const digits = (match[1] + match[2]).replace(/^0+/, "").length;
  const exponent = Number(match[3] ?? 0);
  const isZero = !digits; // the exponent of 0 has no meaning: 0.0E7 is 0.0
  const places = (isZero ? Math.min(0, exponent) : exponent) - match[2].length;
  return {
    digits,
    unit: Number(`1e${places}`),
    size: Math.abs(Number(trimmed.replace(/\s/g, ""))),
    isBare: BARE_DIGIT.test(isZero ? trimmed.replace(/e.*/i, "") : trimmed),
    endZeros: /0*$/.exec(match[2])[0].length,
  };
}

export const largest = (list) => list.reduce((top, x) => Math.max(top, Math.abs(x)), 1e-3);
const allowSumRoundOff = (expected) => SUM_ROUND_OFF * largest(expected);
// Return the allowed round-off. It is small for a typed number, whose last place has its own
// tolerance.
const allowRoundOff = (unit, top) =>
  Math.max((unit ? NOISE : SUM_ROUND_OFF) * top, LEAST_DIFFERENCE);

const isShort = (x, expected) => Math.abs(x) <= Math.abs(expected) && x * expected >= 0;

/**
 * Compare entries with the expected entries, to their last typed places.
 * @param {Entries} actual the typed entries
 * @param {number[]} expected
 * @param {number[]} slack further difference allowed in each entry
 * @returns {"rounded" | "cut" | "one off" | ""} "cut" if all last places are cut off, "one off" if
 *   some is off by one, "" if the entries differ
 */
export function compareDigits({ values, units: lastPlaces }, expected, slack) {
  const top = largest(expected);
  let [rounded, cut, oneOff] = [true, true, true];
  for (let i = 0; i < values.length; i++) {
    const [x, unit] = [values[i], lastPlaces[i]];
    const error = Math.abs(x - expected[i]) - allowRoundOff(unit, top) - slack[i];
    if (error <= 0) continue;
    rounded &&= error <= HALF * unit;
    cut &&= error < unit && isShort(x, expected[i]);
    oneOff &&= error <= ONE_OFF * Math.min(unit, LARGEST_SHARE * top);
    if (!rounded && !cut && !oneOff) return ""; // a wrong trajectory is long
  }
  return rounded ? "rounded" : cut ? "cut" : "one off";
}

/** Return whether a result of compareDigits means that all entries are right. */
export const isRight = (agreement) => agreement === "rounded" || agreement === "cut";

/** Return whether entries are the expected ones to their digits. @param {Entries} actual */
export const agrees = (actual, expected, slack = expected.map(() => 0)) =>
  isRight(compareDigits(actual, expected, slack));

// Flag the entries that are off by more than one in the last place. If there are none, flag all
// entries that differ.
export function flagWrongEntries({ values, units: lastPlaces }, expected, slack) {
  const top = largest(expected);
  const flagBeyond = (places) =>
    values.map((x, i) => {
      const allowed = allowRoundOff(lastPlaces[i], top) + slack[i] + places * lastPlaces[i];
      return Math.abs(x - expected[i]) > allowed;
    });
  const wrong = flagBeyond(ONE_OFF);
  return wrong.includes(true) ? wrong : flagBeyond(HALF);
}

/**
 * Return whether two more typed digits would distinguish two lists of entries.
 * @param {{ units: number[] }} typed @param {number[]} expected @param {number[]} other
 */
export function canBeDistinguished({ units: lastPlaces }, expected, other) {
  const least = 2 * allowSumRoundOff(expected);
  return expected.some((x, i) => Math.abs(other[i] - x) > Math.max(lastPlaces[i] / 100, least));
}

// Return the logarithm (base 10) of the number of values that the chosen entries could take.
export function logCountPossibleValues({ values, units: lastPlaces }, expected, slack, chosen) {
  const size = Math.max(largest(expected), largest(values));
  const roundOff = allowSumRoundOff(expected);
  const logCounts = values.map((_, i) =>
    chosen[i] ? Math.max(0, Math.log10(size / (lastPlaces[i] + 2 * slack[i] + roundOff))) : 0,
  );
  return logCounts.reduce((sum, logCount) => sum + logCount, 0);
}

/**
 * Return how far each computed number may move because q was typed with few digits.
 * @param {Entries} q joint values, `dof` for each configuration
 * @param {number} dof
 * @param {(q: number[]) => number[]} compute computes the numbers from q
 * @param {number} [coarsest] units from this one on count as exact (rad or m)
 */
export function computeSlack(q, dof, compute, coarsest = FINE_UNIT) {
  const fineUnits = q.units.map((unit) => (unit < coarsest ? unit : 0));
  const numbers = compute(q.values);
  const slack = numbers.map(() => 0);
  const countPerConfiguration = (numbers.length * dof) / q.values.length;
  for (let k = 0; k < dof; k++) {
    if (!fineUnits.some((unit, i) => unit && i % dof === k)) continue;
    const shifted = compute(q.values.map((x, i) => (i % dof === k ? x + STEP : x)));
    shifted.forEach((x, i) => {
      const unit = fineUnits[Math.floor(i / countPerConfiguration) * dof + k];
      slack[i] += (HALF * unit * Math.abs(x - numbers[i])) / STEP;
    });
  }
  return slack;
}
