// Compares numbers to the last decimal place that was typed.

export const [RIGHT, SO_FAR, ROUNDED, WRONG] = ["right", "so far", "rounded", "wrong"];
export const RIGHT_BY_MAP = "right by map"; // same arm, other joint zeros or signs

// Allowed difference of a rounded number, in units of its last place.
const HALF = 0.5;
// Allowed difference of a number that is off by one in its last place, in the same units.
const ONE_OFF = 1.5;
// If the last typed place exceeds this share of the largest entry (as in 1e9), being off by one
// there is an error, not rounding.
const COARSE = 0.1;
// An answer with this number of significant digits was copied from a program without rounding.
const FULL = 13;
// Round-off of a program: smaller numbers are its zeros, as 6.1e-17 for cos 90°.
const NOISE = 1e-12;
// A smaller difference (m, rad or N m) is round-off whatever the size of the entries.
const LEAST_DIFFERENCE = 1e-10;
// Error of pi with seven digits or of a long sum, as a share of the largest entry.
const SUM_ROUND_OFF = 1e-6;
// Joint values whose last place exceeds this (rad or m) are exact: q = 0.3 does not stand for 0.26.
export const FINE = 2e-3;
const NUDGE = 1e-6; // step of the difference quotient, rad or m
const NUMBER = /^[+-]?\s*(\d*)\.?(\d*)(?:[eE]([+-]?\d+))?$/;
const BARE = /^[+-]?\s*[01]\.?0?$/; // the forms in which programs print an exact 0 or 1

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
  if (numbers.some((number) => number?.digits >= FULL)) return texts.map(() => 0);
  const typedUnits = numbers.flatMap((number, i) => {
    if (!number) return slacks[i] ? [2 * slacks[i]] : [];
    return !number.bare && number.size > NOISE ? [number.unit] : [];
  });
  const areBare = numbers.every((number) => number?.bare) && numbers.some(({ size }) => size);
  const finest = typedUnits.length || areBare ? Math.min(1, ...typedUnits) : 0;
  const longer = numbers.filter((number) => number && !number.bare);
  const unitOfOne = Math.max(finest, findUnitOfOne(longer));
  const bareUnit = ({ size }) => (size && typedUnits.length ? unitOfOne : finest);
  return numbers.map((number, i) => {
    if (!number) return 2 * (slacks[i] ?? 0);
    return number.bare ? bareUnit(number) : number.unit;
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

// Give numbers that a program padded with zeros, as 6.964900e-01 beside 3.883316e+01, the unit of
// the finest digit that is no zero.
function withoutPadding(numbers) {
  const padded = numbers.filter((number) => number && !number.bare && number.size > NOISE);
  const significant = padded.map(({ unit, zeros }) => unit * 10 ** zeros);
  const unit = Math.min(COARSEST_UNIT, ...significant);
  const zeros = padded.map((number) => Math.max(0, Math.round(Math.log10(unit / number.unit))));
  const count = zeros.reduce((sum, more) => sum + more, 0);
  if (padded.length < FEWEST_NUMBERS || count < FEWEST_ZEROS) return numbers;
  return numbers.map((number) => number && { ...number, unit: Math.max(unit, number.unit) });
}

const COARSEST_UNIT = 1e-3; // of padded numbers: 0.500000 may be exact
const FEWEST_NUMBERS = 3; // fewer may end in zeros by themselves
const FEWEST_ZEROS = 3; // in all: one answer in a thousand ends so by chance

/**
 * Return the units that a program's numbers have if it trims zeros: those of the column's finest
 * number, or of as many significant digits as the column's longest.
 * @param {number[][]} rows @param {number[][]} typedUnits
 */
export function columnUnits(rows, typedUnits) {
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

// Read a plain number as typed; null for a formula.
function readLiteral(text) {
  const trimmed = text.trim();
  const match = NUMBER.exec(trimmed);
  if (!match || !(match[1] || match[2])) return null;
  return {
    digits: (match[1] + match[2]).replace(/^0+/, "").length,
    unit: Number(`1e${Number(match[3] ?? 0) - match[2].length}`),
    size: Math.abs(Number(trimmed.replace(/\s/g, ""))),
    bare: BARE.test(trimmed),
    zeros: /0*$/.exec(match[2])[0].length,
  };
}

export const largest = (list) => list.reduce((top, x) => Math.max(top, Math.abs(x)), 1e-3);
const allowSumRoundOff = (truth) => SUM_ROUND_OFF * largest(truth);
// Return the allowed round-off: little for a typed number, whose last place is allowed for anyway.
const allowRoundOff = (unit, top) =>
  Math.max((unit ? NOISE : SUM_ROUND_OFF) * top, LEAST_DIFFERENCE);

const isShort = (x, expected) => Math.abs(x) <= Math.abs(expected) && x * expected >= 0;

/**
 * Return how entries agree with the right ones: all "rounded" to their last places, all "cut"
 * there, some "one off" in the last place, or "" if they differ.
 * @param {Entries} mine the typed entries
 * @param {number[]} truth the right entries
 * @param {number[]} slack difference allowed in each entry besides
 */
export function agreement({ values, units: lastPlaces }, truth, slack) {
  const top = largest(truth);
  let [rounded, cut, oneOff] = [true, true, true];
  for (let i = 0; i < values.length; i++) {
    const [x, expected, unit] = [values[i], truth[i], lastPlaces[i]];
    const off = Math.abs(x - expected) - allowRoundOff(unit, top) - slack[i];
    if (off <= 0) continue;
    rounded &&= off <= HALF * unit;
    cut &&= off < unit && isShort(x, expected);
    oneOff &&= off <= ONE_OFF * Math.min(unit, COARSE * top);
    if (!rounded && !cut && !oneOff) return ""; // long before the end of a wrong trajectory
  }
  return rounded ? "rounded" : cut ? "cut" : "one off";
}

export const isRight = (how) => how === "rounded" || how === "cut";
export const agrees = (mine, truth, slack = truth.map(() => 0)) =>
  isRight(agreement(mine, truth, slack));

// Flag the entries that are wrong by more than one in the last place; if none is, all that differ.
export function beyond({ values, units: lastPlaces }, truth, slack) {
  const top = largest(truth);
  const exceed = (units) =>
    values.map((x, i) => {
      const allowed = allowRoundOff(lastPlaces[i], top) + slack[i] + units * lastPlaces[i];
      return Math.abs(x - truth[i]) > allowed;
    });
  const wrong = exceed(ONE_OFF);
  return wrong.includes(true) ? wrong : exceed(HALF);
}

/**
 * Return whether two more typed digits would distinguish `truth` from `other`.
 * @param {{ units: number[] }} mine @param {number[]} truth @param {number[]} other
 */
export function tellable({ units: lastPlaces }, truth, other) {
  const least = 2 * allowSumRoundOff(truth);
  return truth.some((x, i) => Math.abs(other[i] - x) > Math.max(lastPlaces[i] / 100, least));
}

// Return the logarithm (base 10) of the number of values that the chosen entries could take.
export function room({ values: mine, units: lastPlaces }, truth, slack, chosen) {
  const size = Math.max(largest(truth), largest(mine));
  const values = (i) => size / (lastPlaces[i] + 2 * slack[i] + allowSumRoundOff(truth));
  const logarithms = chosen.map((isChosen, i) => (isChosen ? Math.log10(values(i)) : 0));
  return logarithms.reduce((sum, logarithm) => sum + Math.max(0, logarithm), 0);
}

/**
 * Return how far each computed number may move because q was typed with few digits.
 * @param {Entries} q joint values, `dof` for each pose
 * @param {number} dof
 * @param {(q: number[]) => number[]} make computes the numbers from q
 */
export function slackOf(q, dof, make, coarsest = FINE) {
  const fine = q.units.map((u) => (u < coarsest ? u : 0));
  const here = make(q.values);
  const total = here.map(() => 0);
  const perPose = (here.length * dof) / q.values.length;
  for (let k = 0; k < dof; k++) {
    if (!fine.some((u, i) => u && i % dof === k)) continue;
    const there = make(q.values.map((x, i) => (i % dof === k ? x + NUDGE : x)));
    there.forEach((x, i) => {
      const u = fine[Math.floor(i / perPose) * dof + k];
      total[i] += (HALF * u * Math.abs(x - here[i])) / NUDGE;
    });
  }
  return total;
}
