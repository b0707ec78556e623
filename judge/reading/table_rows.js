// Reads a row of a table, which is its numbers and the joint that moves in it.

import { RAD } from "../geometry/angles.js";
import { parse, plain, simple, symbols, symbolsIn, value } from "./formula.js";
import { LENGTH_UNIT, LENGTH_UNITS } from "./units.js";
import { ArmError, formatMessage, formatNumber } from "../sentences.js";

/** @typedef {import("./table.js").TypedRow} TypedRow */

export const ENTRIES = ["a", "alpha", "d", "theta"];

// Names of joints' variables.
const JOINT = /^(?:q|th|theta|t|phi)\d+$/;

// A cell for a joint's variable without its name: q, theta, ?, *.
export const VARIABLE = /^(?:var(?:iab(?:le|el))?|[-*?qd]|th(?:eta)?)\*?$/i;

const LOCKED = /\s*\(locked[^()]*\)\s*$/i;

// Trim a cell: drop the name it is assigned to, a note behind it and a star.
export const trimEntry = (cell) =>
  cell
    .replace(/^['"]|['"]$/g, "")
    .replace(/^[^=]*=\s*/, "")
    .replace(LOCKED, (note, at, all) => (isVariable(all.slice(0, at)) ? note : ""))
    .replace(/(?<=.)\^?\{?\*+\}?(?=\s*(?:[-+]|$))/g, "")
    .trim();

export function isVariable(text) {
  const bare = plain(text);
  if (VARIABLE.test(bare)) return true;
  return symbolsIn(bare)?.some((name) => JOINT.test(simple(name))) ?? false;
}

/**
 * Read one row.
 * @param {number} i its number, from 1
 * @param {Record<string, string>} entries its cells by the name of their column
 * @param {Map<string, number>} known symbols that have numbers
 * @returns {TypedRow}
 */
export function readRow(i, entries, known) {
  const texts = mapEntries((name) =>
    (LENGTHS.has(name) ? convertToMetres(entries[name]) : entries[name]).trim(),
  );
  const dashes = fillDashes(texts);
  const trees = mapEntries((name) =>
    parseEntry(dashes[name].replace(IN_METRES, ""), name, i, known),
  );
  const isFree = (one) => !known.has(simple(one));
  const free = mapEntries((name) => [...symbols(trees[name])].filter(isFree).sort());
  const mover = free.theta.length ? "theta" : free.d.length ? "d" : null;
  const joint = findVariable(i, free, mover);
  const at = (name, x) =>
    value(trees[name], (one) => (free[name].includes(one) ? x : known.get(simple(one))));
  const numbers = mapEntries((name) => at(name, 0));
  const backwards = mover !== null && findDirection(at(mover, 1) - numbers[mover], i, mover) < 0;
  const hasOwnUnit = (name) => /\b(?:pi|deg|rad)\b/.test(plain(entries[name]));
  return {
    kind: mover === null ? "unknown" : KIND[mover],
    numbers,
    texts,
    backwards,
    joint,
    radians: new Set(ENTRIES.filter(hasOwnUnit)),
    metres: new Set(ENTRIES.filter((name) => IN_METRES.test(texts[name]))),
    trees,
  };
}

const LENGTHS = new Set(["a", "d"]);
const IN_METRES = / m$/;
const MEASURED = new RegExp(String.raw`^([-+−]?)\s*(\d*\.?\d*)(?:\*1e-(\d)|\s*(${LENGTH_UNIT}))$`);

// Write a length with a unit in metres, digit for digit: 612.7 mm is 0.6127 m.
function convertToMetres(text) {
  const [, sign, x, power, unit] = MEASURED.exec(text.trim()) ?? [];
  if (!x) return text;
  const shift = Number(power ?? Math.round(-Math.log10(LENGTH_UNITS[unit])));
  const places = (x.split(".")[1] ?? "").length + shift;
  return `${sign}${(Number(x) / 10 ** shift).toFixed(places)} m`;
}

const isDash = (text) => ["-", "–", "—"].includes(text);

// Replace a dash by 0, or by the joint's variable if its row names none.
function fillDashes(texts) {
  const { a, alpha, d, theta } = texts;
  const zero = (text) => (isDash(text) ? "0" : text);
  return {
    a: zero(a),
    alpha: zero(alpha),
    d: isDash(d) && isVariable(theta) ? "0" : d,
    theta: isVariable(zero(d)) ? zero(theta) : theta,
  };
}

const KIND = { theta: "revolute", d: "prismatic" };
const mapEntries = (make) => Object.fromEntries(ENTRIES.map((name) => [name, make(name)]));

// Parse a cell; a mark for the variable, such as a star, stands for the joint's own variable.
function parseEntry(cell, name, i, known) {
  const text = plain(cell);
  const moves = name === "theta" || name === "d";
  const free = moves && VARIABLE.test(text) && !known.has(simple(text));
  return parse(free ? `q_${i}` : text, `${name} in row ${i}`);
}

// Return a variable with its number; null if it has none.
function parseVariable(name) {
  const [number] = /\d+/.exec(name ?? "") ?? [];
  return number === undefined ? null : { name, number: Number(number) };
}

// A symbol that may be a joint's variable: l0 for 10 is none.
const MOVING = /^(?:[dqstx]|phi)/i;

// Find the joint's variable; refuse a row that holds another symbol.
function findVariable(i, free, mover) {
  const moving = mover === null ? [] : free[mover];
  const joint = moving.find((one) => /^[qt]/.test(one)) ?? moving[0];
  const isStray = (name) => (one) => name !== mover || one !== joint || !MOVING.test(one);
  const [stray] = ENTRIES.flatMap((name) => free[name].filter(isStray(name)));
  if (stray === undefined) return parseVariable(joint);
  throw new ArmError(formatMessage("row symbol", { row: i, name: stray }), [
    { field: "values", value: stray },
  ]);
}

// Return the sign with which a row follows its joint; refuse a row that scales the joint.
function findDirection(rate, row, name) {
  const far = (from) => Math.abs(Math.abs(rate) - from) > 1e-6;
  if (far(1) && far(RAD))
    throw new ArmError(formatMessage("row slope", { row, name, rate: formatNumber(rate) }));
  return rate > 0 ? 1 : -1;
}
