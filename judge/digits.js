// What the digits of an answer promise: every entry is held to its own last place.

export const [RIGHT, SO_FAR, ROUNDED, WRONG] = ["right", "so far", "rounded", "wrong"];
export const RIGHT_BY_MAP = "right by map"; // a table of the same arm whose joints count otherwise

const HALF = 0.5; // units: the truth, rounded to the last place
const ONE_OFF = 1.5; // units: that, and one more in the last place
const COARSE = 0.1; // of the largest entry: one off in a larger place is another number, as 1e9
const FULL = 13; // significant digits from which a program never rounded
const NOISE = 1e-12; // arithmetic: below it a number is a program's zero, as 6.1e-17 for cos 90°
// of the largest entry, a thousandth at least: what pi with seven digits, or a long sum, is off by
const HAIR = 1e-6;
const FINE = 2e-3; // rad or m: a coarser place was meant as it stands: q = 0.3 is no 0.26
const NUDGE = 1e-6; // rad or m: a difference for a derivative
const NUMBER = /^[+-]?\s*(\d*)\.?(\d*)(?:[eE]([+-]?\d+))?$/;
const BARE = /^[+-]?\s*[01]\.?0?$/; // as programs print an exact 0 or 1

/**
 * Numbers, and what their last places are worth.
 * @typedef {{ values: number[], units: number[] }} Entries
 */

/**
 * Return the unit of the last place of each number as typed, and twice the slack of each formula;
 * 0 for all of an answer that shows every digit a computer has. A bare 0 or 1 has the answer's
 * finest place.
 * @param {string[]} texts @param {number[]} [slacks] of the formulas among them
 */
export function units(texts, slacks = []) {
  const found = texts.map(literal);
  if (found.some((one) => one?.digits >= FULL)) return texts.map(() => 0);
  const placed = found.flatMap((one, i) => {
    if (!one) return slacks[i] ? [2 * slacks[i]] : [];
    return !one.bare && one.size > NOISE ? [one.unit] : [];
  });
  const whole = found.every((one) => one?.bare) && found.some((one) => one.size);
  const finest = placed.length || whole ? Math.min(1, ...placed) : 0;
  const unit = (one, i) => (one ? (one.bare ? finest : one.unit) : 2 * (slacks[i] ?? 0));
  return found.map(unit);
}

// A plain number as typed; null for a formula.
function literal(text) {
  const trimmed = text.trim();
  const match = NUMBER.exec(trimmed);
  if (!match || !(match[1] || match[2])) return null;
  return {
    digits: (match[1] + match[2]).replace(/^0+/, "").length,
    unit: Number(`1e${Number(match[3] ?? 0) - match[2].length}`),
    size: Math.abs(Number(trimmed.replace(/\s/g, ""))),
    bare: BARE.test(trimmed),
  };
}

export const largest = (list) => list.reduce((top, x) => Math.max(top, Math.abs(x)), 1e-3);
const hairOf = (truth) => HAIR * largest(truth);
// An entry that shows its last place needs no more than arithmetic does.
const hair = (unit, top) => (unit ? NOISE : HAIR) * top;

const isShort = (x, expected) => Math.abs(x) <= Math.abs(expected) && x * expected >= 0;

/**
 * How entries agree with what they should be: "rounded" to their last places, all "cut" there, but
 * for "one off" in some last place, or not at all, "". `slack` is what each may be off besides.
 * @param {Entries} mine @param {number[]} truth @param {number[]} slack
 */
export function agreement({ values, units: places }, truth, slack) {
  const top = largest(truth);
  let [rounded, cut, oneOff] = [true, true, true];
  for (let i = 0; i < values.length; i++) {
    const [x, expected, unit] = [values[i], truth[i], places[i]];
    const off = Math.abs(x - expected) - hair(unit, top) - slack[i];
    if (off <= 0) continue;
    rounded &&= off <= HALF * unit;
    cut &&= off < unit && isShort(x, expected);
    oneOff &&= off <= ONE_OFF * Math.min(unit, COARSE * top);
    if (!rounded && !cut && !oneOff) return "";
  }
  return rounded ? "rounded" : cut ? "cut" : "one off";
}

export const isRight = (how) => how === "rounded" || how === "cut";
export const agrees = (mine, truth, slack = truth.map(() => 0)) =>
  isRight(agreement(mine, truth, slack));

// Which entries are wrong: by more than one in the last place, or, where none is, at all.
export function beyond({ values, units: places }, truth, slack) {
  const top = largest(truth);
  const past = (most) =>
    values.map((x, i) => {
      const room = hair(places[i], top) + slack[i] + most * places[i];
      return Math.abs(x - truth[i]) > room;
    });
  const wrong = past(ONE_OFF);
  return wrong.includes(true) ? wrong : past(HALF);
}

/**
 * Whether digits a hundred times finer would show that an answer is not `other` but `truth`.
 * @param {{ units: number[] }} mine @param {number[]} truth @param {number[]} other
 */
export function tellable({ units: places }, truth, other) {
  const least = 2 * hairOf(truth);
  return truth.some((x, i) => Math.abs(other[i] - x) > Math.max(places[i] / 100, least));
}

// How many different values, as a power of ten, the entries chosen could show.
export function room({ values: mine, units: places }, truth, slack, chosen) {
  const size = Math.max(largest(truth), largest(mine));
  const values = (i) => size / (places[i] + 2 * slack[i] + hairOf(truth));
  return chosen.reduce((sum, is, i) => (is ? sum + Math.max(0, Math.log10(values(i))) : sum), 0);
}

/**
 * What the unwritten digits of joint values, `dof` for each pose, change in each number that comes
 * of them.
 * @param {Entries} q @param {number} dof @param {(q: number[]) => number[]} make
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
