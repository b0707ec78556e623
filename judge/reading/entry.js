// One entry of a field or of an arm's table: a number or a short formula, perhaps with its unit. A
// unit has a size s: what has one grows with it, what has none does not, and what is s² has two. A
// bare number beside one with the unit that it would have had has that, too. In an angle pi counts
// as radians, unless rad is said.

import { RAD } from "../geometry/angles.js";
import { ArmError } from "../sentences.js";
import { isFunction, parse, plain, value } from "./formula.js";

const LONGEST = 200; // characters

/** For each quantity: its units in SI, the unit of a bare number, and the largest value. */
const QUANTITIES = {
  angle: {
    units: { deg: RAD, rad: 1 },
    most: 1000,
    of: "an angle",
    such: "90°, pi/2 or 1.571 rad",
  },
  length: {
    units: { m: 1, cm: 0.01, mm: 0.001 },
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
const MOMENT = /\bN\s*[*·⋅]?\s*(m{1,2})\b/g;
const COMMA = /^([^,]*\d|[^,\d]*),(\d+[^,]*)$/;
// A name beside another or before a bracket is a product that may be a slip of the finger.
const BESIDE = /([A-Za-z_]\w*)\s*(\(|\s(?=[A-Za-z_]))/g;

class Refused extends Error {}

function refuse(words = "") {
  throw new Refused(words);
}

/** @param {string} typed */
function parsed(typed) {
  const pointed = typed.includes(".") ? typed : typed.trim().replace(COMMA, "$1.$2");
  const text = plain(pointed).replace(MOMENT, "N$1");
  for (const [, name, next] of text.matchAll(BESIDE))
    if (name !== "pi" && !(next === "(" && isFunction(name))) refuse();
  try {
    return parse(text);
  } catch (error) {
    if (error instanceof ArmError) refuse();
    throw error;
  }
}

const isUnit = ([kind, name]) => kind === "name" && UNITS.has(name);
const parts = ([, ...of]) => of.filter(Array.isArray);

// The units of a tree, each behind a factor, and its other names; none in a function or a power.
/** @returns {{ units: string[], names: string[] }} */
function namesIn(tree) {
  const [kind, first, second] = tree;
  if (kind === "call" || kind === "^") return { units: [], names: [] };
  if (kind === "name") return { units: [], names: [first] };
  const measured = kind === "*" && isUnit(second);
  const found = (measured ? [first] : parts(tree)).map(namesIn);
  return {
    units: [...found.flatMap(({ units }) => units), ...(measured ? [second[1]] : [])],
    names: found.flatMap(({ names }) => names),
  };
}

// The value of a tree for what pi and the units are worth, and an angle that a function gives.
/** @param {any[]} tree @param {Record<string, number>} worth @param {number} turn */
function valueFor(tree, worth, turn) {
  const [kind, first, second] = tree;
  const at = (part) => (isUnit(part) ? worth[part[1]] : valueFor(part, worth, turn));
  if (kind === "name") return worth[first];
  if (kind === "num" || kind === "^") return value(tree, () => refuse());
  if (kind === "call") return value(tree, () => refuse()) * (ANGLES.includes(first) ? turn : 1);
  const numbers = (kind === "neg" ? [first] : [first, second]).map((part) => ["num", at(part)]);
  return value([kind, ...numbers], () => refuse());
}

const HAIR = 1e-9; // of the whole: less is what arithmetic leaves of none

/**
 * Compute the value of a tree without symbols in SI, its bare numbers in units of `bare`, where
 * that is said.
 * @param {any[]} tree @param {Record<string, number>} units @param {string | null} bare
 */
function inSI(tree, units, bare) {
  const named = namesIn(tree);
  const angle = "rad" in units;
  const turns = angle && named.names.includes("pi") && !named.units.includes("rad");
  const [one, two, three] = [1, 2, 3].map((s) => {
    const worth = Object.fromEntries(Object.entries(units).map(([name, x]) => [name, x * s]));
    return valueFor(tree, { ...worth, pi: Math.PI * (turns ? s : 1) }, angle ? s : 1);
  });
  const near = (x) => Math.abs(x) <= HAIR * Math.max(Math.abs(one), Math.abs(two));
  if (!near(three - 2 * two + one)) refuse("has two units");
  const [measured, rest] = [two - one, 2 * one - two];
  if (near(rest)) return one;
  if (near(measured)) return one * (bare ? units[bare] : 1);
  if (turns || named.units.some((unit) => unit !== bare))
    refuse("mixes numbers with and without a unit; say the unit of each");
  return rest * units[bare] + measured;
}

// A tree as text, its units turned into SI.
function textOf(tree) {
  const [kind, first, second] = tree;
  if (kind === "num" || kind === "name") return String(first);
  if (kind === "call" || kind === "^") return String(value(tree, () => refuse()));
  if (kind === "neg") return `-${bracketed(textOf(first))}`;
  if (kind === "*" && isUnit(second)) return withUnit(textOf(first), second[1]);
  if (kind === "+") return `${textOf(first)} + ${textOf(second)}`;
  if (kind === "-") return `${textOf(first)} - ${bracketed(textOf(second))}`;
  return `${bracketed(textOf(first))}${kind}${bracketed(textOf(second), true)}`;
}

// Whole multiples of 15° as a share of pi, which stays exact.
function withUnit(text, unit) {
  const twelfths = Number(text) / 15;
  if (unit === "deg" && Number.isInteger(twelfths) && twelfths) {
    const common = [12, 6, 4, 3, 2, 1].find((n) => twelfths % n === 0);
    const [over, under] = [twelfths / common, 12 / common];
    const top = Math.abs(over) === 1 ? `${over < 0 ? "-" : ""}pi` : `${over}*pi`;
    return under === 1 ? top : `${top}/${under}`;
  }
  const factor = { deg: "*pi/180", cm: "/100", mm: "/1000" }[unit] ?? "";
  return factor ? `${bracketed(text)}${factor}` : text;
}

const bracketed = (text, last = false) =>
  (last ? /[-+*/ ]/ : /[-+ ]/).test(text.replace(/e[-+]\d/g, "")) ? `(${text})` : text;

// The tree of what is typed, whose units are of a quantity asked for.
/** @param {string} typed @param {Record<string, number>} units */
function treeOf(typed, units) {
  if (typed.length > LONGEST) refuse();
  const tree = parsed(typed);
  const other = namesIn(tree).units.find((unit) => !(unit in units));
  if (other) refuse(`has the unit ${other === "deg" ? "°" : other}`);
  return tree;
}

/**
 * Read what a reader typed as { value } in SI, or { error } in words.
 * @param {string} typed
 * @param {keyof typeof QUANTITIES} kind
 * @param {string} [unit] what a bare number is in: deg or rad for an angle
 * @returns {{ value: number, error?: undefined } | { error: string, value?: undefined }}
 */
export function readEntry(typed, kind, unit) {
  const { units, bare: usual, most, of, such } = /** @type {any} */ (QUANTITIES[kind]);
  const bare = unit && unit in units ? unit : (usual ?? "rad");
  const shown = `“${typed.trim().slice(0, 40)}${typed.trim().length > 40 ? "…" : ""}”`;
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
    return { error: `${shown} ${told(fault, { of, such })}` };
  }
}

function told(fault, { of, such }) {
  if (fault instanceof ArmError) return "divides by zero or is too large";
  if (!(fault instanceof Refused)) throw fault;
  return fault.message
    ? `${fault.message}; ${of} is asked for: ${such}`
    : `is no number; write ${such}`;
}

/**
 * An entry of an arm's table in plain signs, its units turned into SI; or why it is none, in words
 * where there is more to say than that. Beside a symbol a number may be bare.
 * @param {string} typed
 * @param {(keyof typeof QUANTITIES)[]} kinds what it may be
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

// Return whether what is typed so far may still become an entry: no error is said while a reader is
// in the middle of one.
export const unfinished = (typed) =>
  /^\s*$|[-+*/(.,eE−–πp]\s*$/.test(typed) || /^[\s\d.,]*$/.test(typed);
