// Reads the text of a field, such as "250 mm" or "pi/2", as a value in SI. The module finds the
// unit by scaling: it evaluates the formula with each unit 1, 2 and 3 times as large. A length
// grows in proportion, a bare number stays, and an area grows with the square. A bare number beside
// a number in the field's usual unit has that unit, too. In an angle, pi counts as radians unless
// "rad" is typed.

import { RAD } from "../geometry/angles.js";
import { ArmError, tryOrNull } from "../sentences.js";
import { isFunction, parse, plain, value } from "./formula.js";
import { LENGTH_UNITS } from "./units.js";

const LONGEST = 200; // characters

/** The units of each quantity in SI, the unit of a bare number, and the largest value. */
const QUANTITIES = {
  angle: {
    units: { deg: RAD, rad: 1 },
    most: 1000,
    of: "an angle",
    such: "90°, pi/2 or 1.571 rad",
  },
  length: {
    units: LENGTH_UNITS,
    bare: "m",
    most: 100,
    of: "a length",
    such: "metres, as 0.333",
  },
  force: { units: { N: 1, kN: 1000 }, bare: "N", most: 1e5, of: "a force", such: "newtons, as −5" },
  moment: {
    units: { Nm: 1, Nmm: 0.001 },
    bare: "Nm",
    most: 1e5,
    of: "a moment",
    such: "newton metres, as 0.5",
  },
};
const UNITS = new Set(Object.values(QUANTITIES).flatMap(({ units }) => Object.keys(units)));
const ANGLES = ["radians", "deg2rad", "asin", "acos", "atan"];
const MOMENT = /\bN\s*\*?\s*(m{1,2})\b/g;
const DECIMAL_COMMA = /^([^,]*),(\d[^,]*)$/;
// A name beside a name or before a bracket would be a product, but is likely a typing error.
const BESIDE = /([A-Za-z_]\w*)\s*(\(|\s(?=[A-Za-z_]))/g;

class Refused extends Error {}

/** @returns {never} */
function refuse(reason = "") {
  throw new Refused(reason);
}

// Parse an entry with a decimal point or a decimal comma.
/** @param {string} typed */
function parseEntry(typed) {
  const pointed = typed.includes(".") ? typed : typed.trim().replace(DECIMAL_COMMA, "$1.$2");
  const text = plain(pointed).replace(MOMENT, "N$1");
  for (const [, name, next] of text.matchAll(BESIDE))
    if (name !== "pi" && !(next === "(" && isFunction(name))) refuse();
  return tryOrNull(() => parse(text)) ?? refuse();
}

// Return whether a tree is a product with a unit, as 5 mm.
const hasUnit = ([kind, , second]) => kind === "*" && UNITS.has(second[1]);
const operandsOf = ([, ...operands]) => operands.filter(Array.isArray);

// List the units of a tree, each behind a factor, and its other names, but not those in a function.
/** @returns {{ units: string[], names: string[] }} */
function namesIn(tree) {
  const [kind, first, second] = tree;
  if (kind === "call") return { units: [], names: [] };
  if (kind === "name") return { units: [], names: [first] };
  const operands = (hasUnit(tree) ? [first] : operandsOf(tree)).map(namesIn);
  return {
    units: [...operands.flatMap(({ units }) => units), ...(hasUnit(tree) ? [second[1]] : [])],
    names: operands.flatMap(({ names }) => names),
  };
}

/**
 * Evaluate a tree with scaled values of pi, of the units and of angles from functions.
 * @param {any[]} tree @param {Record<string, number>} sizes the values of pi and the units
 * @param {number} turn the factor of angles from functions such as atan
 */
function evaluateWith(tree, sizes, turn) {
  const [kind, first, second] = tree;
  if (kind === "name") return sizes[first];
  if (kind === "num" || kind === "^") return value(tree, () => refuse());
  if (kind === "call") return value(tree, () => refuse()) * (ANGLES.includes(first) ? turn : 1);
  const operands = kind === "neg" ? [first] : [first, second];
  const numbers = operands.map((part) => ["num", evaluateWith(part, sizes, turn)]);
  return value([kind, ...numbers], () => refuse());
}

const ROUND_OFF = 1e-9; // relative to the value

/**
 * Evaluate a tree without symbols in SI units.
 * @param {any[]} tree @param {Record<string, number>} units @param {string | null} bare
 *   the unit of bare numbers
 */
function inSI(tree, units, bare) {
  const typed = namesIn(tree);
  const isAngle = "rad" in units;
  const hasTurns = isAngle && typed.names.includes("pi") && !typed.units.includes("rad");
  const [once, twice, thrice] = [1, 2, 3].map((scale) => {
    const sizes = Object.fromEntries(Object.entries(units).map(([name, x]) => [name, x * scale]));
    const pi = Math.PI * (hasTurns ? scale : 1);
    return evaluateWith(tree, { ...sizes, pi }, isAngle ? scale : 1);
  });
  const isZero = (x) => Math.abs(x) <= ROUND_OFF * Math.max(Math.abs(once), Math.abs(twice));
  if (!isZero(thrice - 2 * twice + once)) refuse("has two units");
  const [measured, rest] = [twice - once, 2 * once - twice];
  if (isZero(rest)) return once;
  if (isZero(measured)) return once * units[bare];
  if (hasTurns || typed.units.some((unit) => unit !== bare))
    refuse("mixes numbers with and without a unit; say the unit of each");
  return rest * units[bare] + measured;
}

// Write a tree as text, with its units converted to SI.
function textOf(tree) {
  const [kind, first, second] = tree;
  if (kind === "num" || kind === "name") return String(first);
  if (kind === "call" || kind === "^") return String(value(tree, () => refuse()));
  if (kind === "neg") return `-${bracketed(textOf(first))}`;
  if (hasUnit(tree)) return withUnit(textOf(first), second[1]);
  if ("+-".includes(kind)) return `${textOf(first)} ${kind} ${bracketed(textOf(second))}`;
  return `${bracketed(textOf(first))}${kind}${bracketed(textOf(second), true)}`;
}

// Write a number with a unit in SI. A multiple of 15° is written as a fraction of pi, which is
// exact.
function withUnit(text, unit) {
  const twelfths = Number(text) / 15;
  if (unit === "deg" && Number.isInteger(twelfths)) {
    const common = [12, 6, 4, 3, 2, 1].find((n) => twelfths % n === 0);
    const [numerator, denominator] = [twelfths / common, 12 / common];
    const sign = numerator < 0 ? "-" : "";
    const pis = Math.abs(numerator) === 1 ? `${sign}pi` : `${numerator}*pi`;
    return denominator === 1 ? pis : `${pis}/${denominator}`;
  }
  const factor = { deg: "*pi/180", cm: "/100", mm: "/1000" }[unit] ?? "";
  return `${bracketed(text)}${factor}`;
}

const bracketed = (text, last = false) =>
  (last ? /[-+*/ ]/ : /[-+ ]/).test(text) ? `(${text})` : text;

// Parse a typed text. Refuse a unit that is not in `units`.
/** @param {string} typed @param {Record<string, number>} units */
function treeOf(typed, units) {
  const tree = parseEntry(typed);
  const other = namesIn(tree).units.find((unit) => !(unit in units));
  if (other) refuse(`has the unit ${other === "deg" ? "°" : other}`);
  return tree;
}

/**
 * Read a typed entry as a value in SI, or as an error message.
 * @param {string} typed
 * @param {keyof typeof QUANTITIES} kind
 * @param {string} [unit] the unit of bare numbers: deg or rad for an angle
 * @returns {{ value: number, error?: undefined } | { error: string, value?: undefined }}
 */
export function readEntry(typed, kind, unit = "") {
  const { units, bare: usual, most, of, such } = /** @type {any} */ (QUANTITIES[kind]);
  const bare = unit in units ? unit : (usual ?? "rad");
  const shown = `“${typed.trim()}”`;
  if (!typed.trim()) return { error: "is empty; write 0 for none" };
  if (typed.length > LONGEST)
    return { error: `has ${typed.length} characters; ${LONGEST} are the most` };
  try {
    const tree = treeOf(typed, units);
    if (namesIn(tree).names.some((name) => name !== "pi")) refuse();
    const si = inSI(tree, units, bare);
    if (Math.abs(si) > most) return { error: `${shown} is too large for ${of} here` };
    return { value: si + 0 };
  } catch (fault) {
    return { error: `${shown} ${describeFault(fault, { of, such })}` };
  }
}

// Describe why an entry was refused. Errors that are no refusals are thrown again.
function describeFault(fault, { of, such }) {
  if (fault instanceof ArmError) return "divides by zero or is too large";
  if (!(fault instanceof Refused)) throw fault;
  return fault.message
    ? `${fault.message}; ${of} is asked for: ${such}`
    : `is no number; write ${such}`;
}

/**
 * Write an entry of an arm's table in plain characters, with its units converted to SI.
 *
 * A number beside a symbol needs no unit. `fault` is the reason why the text is no entry, or empty
 * if no reason is known.
 * @param {string} typed
 * @param {(keyof typeof QUANTITIES)[]} kinds the quantities that the entry may be
 * @returns {{ text: string } | { fault: string }}
 */
export function formulaOf(typed, kinds) {
  const units = Object.assign({}, ...kinds.map((kind) => QUANTITIES[kind].units));
  try {
    const tree = treeOf(typed, units);
    if (namesIn(tree).names.every((name) => name === "pi")) inSI(tree, units, null);
    return { text: textOf(tree) };
  } catch (fault) {
    if (fault instanceof Refused || fault instanceof ArmError)
      return { fault: fault instanceof Refused ? fault.message : "" };
    throw fault;
  }
}

// Return whether a text may be the beginning of an entry: no error is shown while a reader types.
export const unfinished = (typed) => /[-+*/(.,eE−–πp]\s*$/.test(typed) || /^[\s\d.,]*$/.test(typed);
