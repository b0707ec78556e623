// One entry of a field or of an arm's table: a number or a short formula, perhaps with its unit. A
// unit after the last of several bare terms is the unit of all of them, where it is the one that
// they would have had; otherwise each term says its own. In an angle pi counts as radians.

import { RAD } from "../geometry/angles.js";
import { ArmError } from "../sentences.js";
import { isFunction, parse, plain, value } from "./formula.js";

const LONGEST = 200; // characters

/** What a quantity's units are worth in SI, what a bare number means, and how much is too much. */
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
function treeOf(typed) {
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

// What a part of a formula comes to: its value, and whether that is in SI by a unit of its own. A
// symbol fits both.
/**
 * @typedef {{ value: number, unit: boolean, pi?: boolean, free?: boolean, text: string }} Part
 *   `text` in plain signs, its units turned into SI
 * @typedef {{ units: Record<string, number>, angle: boolean, bare: string | null,
 *   known: (name: string) => number | undefined }} Field
 */

/** @param {any[]} tree @param {Field} field @returns {Part} */
function partOf(tree, field) {
  const [kind, first, second] = tree;
  if (kind === "num") return counted(first);
  if (kind === "name") return named(first, field);
  if (kind === "neg") {
    const inner = partOf(first, field);
    return { ...inner, value: -inner.value, text: `-${bracketed(inner.text)}` };
  }
  if (kind === "call" || kind === "^") return called(tree, field);
  if (kind === "*" && second[0] === "name" && UNITS.has(second[1]))
    return measured(first, second[1], field);
  if (kind === "+" || kind === "-") return summed(tree, field);
  return multiplied(tree, field);
}

/** @param {number} x @returns {Part} */
function counted(x) {
  if (!Number.isFinite(x)) refuse();
  return { value: x, unit: false, text: String(x) };
}

/** @param {string} name @param {Field} field @returns {Part} */
function named(name, { angle, known }) {
  if (name === "pi") return { value: Math.PI, unit: angle, pi: angle, text: "pi" };
  const found = known(name);
  if (found === undefined) refuse();
  return { value: found, unit: false, free: true, text: name };
}

// A function or a power of numbers alone.
/** @param {any[]} tree @param {Field} field @returns {Part} */
function called(tree, field) {
  const found = value(tree, () => refuse());
  return { value: found, unit: field.angle && ANGLES.includes(tree[1]), text: String(found) };
}

/** @param {any[]} tree @param {string} name @param {Field} field @returns {Part} */
function measured(tree, name, field) {
  if (!(name in field.units)) refuse(`has the unit ${name === "deg" ? "°" : name}`);
  const part = partOf(tree, field);
  if (part.unit && !(part.pi && name === "rad")) refuse("has two units");
  const worth = field.units[name];
  return { value: part.value * worth, unit: true, text: inSI(part.text, name) };
}

// A text in SI: whole multiples of 15° as a share of pi, which stays exact.
function inSI(text, name) {
  const twelfths = Number(text) / 15;
  if (name === "deg" && Number.isInteger(twelfths) && twelfths) {
    const common = [12, 6, 4, 3, 2, 1].find((n) => twelfths % n === 0);
    const [over, under] = [twelfths / common, 12 / common];
    const top = Math.abs(over) === 1 ? `${over < 0 ? "-" : ""}pi` : `${over}*pi`;
    return under === 1 ? top : `${top}/${under}`;
  }
  const factor = { deg: "*pi/180", cm: "/100", mm: "/1000" }[name] ?? "";
  return factor ? `${bracketed(text)}${factor}` : text;
}

/** @param {any[]} tree @param {Field} field @returns {Part} */
function summed([sign, first, second], field) {
  const [left, right] = [partOf(first, field), partOf(second, field)];
  const both = {
    text: `${left.text} ${sign} ${sign === "-" ? bracketed(right.text) : right.text}`,
  };
  const add = (x, y) => (sign === "+" ? x + y : x - y);
  const [l, r] = [left, right].map(({ unit, free, value: x }) => unit || free || x === 0);
  if (l === r || left.free || right.free) {
    const unit = (left.unit || right.unit) && l && r;
    return { value: add(left.value, right.value), unit, free: left.free || right.free, ...both };
  }
  // The unit that stands last is that of all, if a bare number would have it.
  const worth = field.units[field.bare];
  const last = worth !== undefined && second[0] === "*" && second[2][1] === field.bare;
  if (!last) refuse("mixes numbers with and without a unit; say the unit of each");
  const scaled = inSI(left.text, field.bare);
  return {
    value: add(left.value * worth, right.value),
    unit: true,
    text: `${scaled} ${sign} ${right.text}`,
  };
}

/** @param {any[]} tree @param {Field} field @returns {Part} */
function multiplied([sign, first, second], field) {
  const [left, right] = [partOf(first, field), partOf(second, field)];
  const turns = right.pi && (sign === "/" || left.pi); // pi is a number there, and no unit
  if (right.unit && !turns) {
    if (sign === "/") refuse("divides by a number with a unit");
    if (left.unit) refuse("multiplies two units");
  }
  return {
    value: value([sign, ["num", left.value], ["num", right.value]], () => undefined),
    unit: left.unit || (right.unit && !turns),
    pi: left.pi || right.pi,
    free: left.free || right.free,
    text: `${bracketed(left.text)}${sign}${bracketed(right.text, true)}`,
  };
}

const bracketed = (text, last = false) =>
  (last ? /[-+*/ ]/ : /[-+ ]/).test(text.replace(/e[-+]\d/g, "")) ? `(${text})` : text;

/**
 * What a reader typed, as { value } in SI, or { error } in words.
 * @param {string} typed
 * @param {keyof typeof QUANTITIES} kind
 * @param {string} [unit] what a bare number is in: deg or rad for an angle
 * @returns {{ value: number, error?: undefined } | { error: string, value?: undefined }}
 */
export function readEntry(typed, kind, unit) {
  const quantity = QUANTITIES[kind];
  const bare = unit && unit in quantity.units ? unit : (quantity.bare ?? "rad");
  const shown = `“${typed.trim().slice(0, 40)}${typed.trim().length > 40 ? "…" : ""}”`;
  if (!typed.trim()) return { error: "is empty; write 0 for none" };
  if (typed.length > LONGEST)
    return { error: `has ${typed.length} characters; ${LONGEST} are the most` };
  try {
    const field = { units: quantity.units, angle: kind === "angle", bare, known: () => undefined };
    const part = partOf(treeOf(typed), field);
    const si = part.unit ? part.value : part.value * quantity.units[bare];
    if (!Number.isFinite(si)) return { error: `${shown} divides by zero or is too large` };
    if (Math.abs(si) > quantity.most)
      return { error: `${shown} is too large for ${quantity.of} here` };
    return { value: si + 0 };
  } catch (fault) {
    return { error: `${shown} ${told(fault, quantity)}` };
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
 * where there is more to say than that.
 * @param {string} typed
 * @param {(keyof typeof QUANTITIES)[]} kinds what it may be
 * @returns {{ text: string } | { fault: string }}
 */
export function formulaOf(typed, kinds) {
  const units = Object.assign({}, ...kinds.map((kind) => QUANTITIES[kind].units));
  const field = { units, angle: kinds.includes("angle"), bare: null, known: () => 1 };
  try {
    if (typed.length > LONGEST) refuse();
    return { text: partOf(treeOf(typed), field).text };
  } catch (fault) {
    if (fault instanceof Refused || fault instanceof ArmError)
      return { fault: fault instanceof Refused ? fault.message : "" };
    throw fault;
  }
}

// Whether what is typed so far may still become an entry: no error is said while a reader is in the
// middle of one.
export const unfinished = (typed) =>
  /^\s*$|[-+*/(.,eE−–πp]\s*$/.test(typed) || /^[\s\d.,]*$/.test(typed);
