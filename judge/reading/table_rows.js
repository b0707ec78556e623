// Reads the four entries of a row, such as 0, pi/2, 0.333 and q_1 + pi, and finds its joint.

import { RAD } from "../geometry/angles.js";
import { parse, plain, simple, symbols, symbolsIn, value } from "./formula.js";
import { LENGTH_UNIT, LENGTH_UNITS } from "./units.js";
import { ArmError, formatMessage, formatNumber } from "../sentences.js";

/** @typedef {import("./table.js").TypedRow} TypedRow */

export const ENTRIES = ["a", "alpha", "d", "theta"];

// Names of joint variables, without "_".
const JOINT = /^(?:q|th|theta|t|phi)\d+$/;

// A mark in place of the joint variable, such as q, theta, ? and *.
export const VARIABLE = /^(?:var(?:iab(?:le|el))?|[-*?qd]|th(?:eta)?)\*?$/i;

const LOCKED = /\s*\(locked[^()]*\)\s*$/i;

// Trim a cell: "d_1 = 0.5" becomes "0.5", and "q2*" becomes "q2".
export const trimEntry = (cell) =>
  cell
    .replace(/^['"]|['"]$/g, "")
    .replace(/^[^=]*=\s*/, "")
    .replace(LOCKED, (note, at, all) => (isVariable(all.slice(0, at)) ? note : ""))
    .replace(/(?<=.)\^?\{?\*+\}?(?=\s*(?:[-+]|$))/g, "")
    .trim();

// Return whether a cell holds a joint variable or a mark in its place.
export function isVariable(text) {
  const bare = plain(text);
  if (VARIABLE.test(bare)) return true;
  return symbolsIn(bare)?.some((name) => JOINT.test(simple(name))) ?? false;
}

/**
 * Read the cells of a row.
 * @param {number} i the number of the row, from 1
 * @param {Record<string, string>} entries the cells by the names of their columns
 * @param {Map<string, number>} known the values of symbols
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
  const isFree = (symbol) => !known.has(simple(symbol));
  const free = mapEntries((name) => [...symbols(trees[name])].filter(isFree).sort());
  const mover = free.theta.length ? "theta" : free.d.length ? "d" : null;
  const joint = findVariable(i, free, mover, texts.theta);
  const evaluateAt = (name, x) =>
    value(trees[name], (symbol) => (free[name].includes(symbol) ? x : known.get(simple(symbol))));
  const numbers = mapEntries((name) => evaluateAt(name, 0));
  const backwards =
    mover !== null && findDirection(evaluateAt(mover, 1) - numbers[mover], i, mover) < 0;
  const findMetres = (name) =>
    findSymbolPart((scale) =>
      value(trees[name], (symbol) =>
        free[name].includes(symbol) ? 0 : scale * known.get(simple(symbol)),
      ),
    );
  const hasOwnUnit = (name) => /\b(?:pi|deg|rad)\b/.test(plain(entries[name]));
  return {
    kind: mover === null ? "unknown" : KIND[mover],
    numbers,
    symbolMetres: { a: findMetres("a"), d: findMetres("d") },
    texts,
    backwards,
    joint,
    radians: new Set(ENTRIES.filter(hasOwnUnit)),
    metres: new Set(ENTRIES.filter((name) => IN_METRES.test(texts[name]))),
    trees,
  };
}

const LONGEST = 10; // m; a longer symbol was converted by the student, as 1000*d_7

/**
 * Return the part of a length that comes from symbols, in m. The numbers in "d_7 + 100" have the
 * table's unit, but a symbol has its value. Return 0 if the length is no sum of symbols and
 * numbers.
 * @param {(scale: number) => number} evaluate the length with scaled values of its symbols
 */
function findSymbolPart(evaluate) {
  const [none, once, twice] = [0, 1, 2].map(evaluate);
  const isSum = Math.abs(twice - 2 * once + none) <= 1e-9 * Math.max(1, Math.abs(twice));
  return isSum && Math.abs(once - none) < LONGEST ? once - none : 0;
}

const LENGTHS = new Set(["a", "d"]);
const IN_METRES = / m$/;
const MEASURED = new RegExp(String.raw`^([-+−]?)\s*(\d*\.?\d*)(?:\*1e-(\d)|\s*(${LENGTH_UNIT}))$`);

// Write a length with a unit in metres without losing typed digits: "612.70 mm" is "0.61270 m". In
// a sum each length must have a unit.
function convertToMetres(text) {
  const terms = text.trim().match(/[-+−]?[^-+−]+/g) ?? [];
  if (terms.length > 1 && !text.includes("e-")) {
    const lengths = terms.map(convertToMetres);
    if (!lengths.every((length) => IN_METRES.test(length))) return text;
    return `${lengths.map((length) => length.replace(IN_METRES, "")).join("")} m`;
  }
  const [, sign, x, power, unit] = MEASURED.exec(text.trim()) ?? [];
  if (!x) return text;
  const shift = Number(power ?? Math.round(-Math.log10(LENGTH_UNITS[unit])));
  const places = (x.split(".")[1] ?? "").length + shift;
  return `${sign}${(Number(x) / 10 ** shift).toFixed(places)} m`;
}

const isDash = (text) => ["-", "–", "—"].includes(text);

// Replace dashes by 0. A dash below theta, or else below d, stays if the row has no joint variable:
// it is a mark in place of the variable.
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

// Parse a cell. A mark such as * in row 2 becomes q_2.
function parseEntry(cell, name, i, known) {
  const text = plain(cell);
  const mayMove = name === "theta" || name === "d";
  const isMark = mayMove && VARIABLE.test(text) && !known.has(simple(text));
  return parse(isMark ? `q_${i}` : text, `${name} in row ${i}`);
}

// Return a variable with its number, or null if its name has no number.
function parseVariable(name) {
  const [number] = /\d+/.exec(name ?? "") ?? [];
  return number === undefined ? null : { name, number: Number(number) };
}

// The first letter of a symbol that may be a joint variable. A mistyped 10, "l0", is none.
const MOVING = /^(?:[dqstx]|phi)/i;
const COUNTED = /^[A-Za-z]+[[(]\d{1,2}[\])]/;

// Find the joint variable of a row. Refuse a row with any further symbol. Below theta any name with
// an index in brackets is a variable: jA(1).
function findVariable(i, free, mover, theta) {
  const moving = mover === null ? [] : free[mover];
  const joint = moving.find((symbol) => /^[qt]/.test(symbol)) ?? moving[0];
  const mayMove = (symbol) => MOVING.test(symbol) || (mover === "theta" && COUNTED.test(theta));
  const isStray = (name) => (symbol) => name !== mover || symbol !== joint || !mayMove(symbol);
  const [stray] = ENTRIES.flatMap((name) => free[name].filter(isStray(name)));
  if (stray === undefined) return parseVariable(joint);
  throw new ArmError(formatMessage("row symbol", { row: i, name: stray }), [
    { field: "values", value: stray },
  ]);
}

// Return the sign of the joint variable in its row. Refuse a factor, as in 2 q_1.
function findDirection(rate, row, name) {
  const differsFrom = (size) => Math.abs(Math.abs(rate) - size) > 1e-6;
  if (differsFrom(1) && differsFrom(RAD))
    throw new ArmError(formatMessage("row slope", { row, name, rate: formatNumber(rate) }));
  return rate > 0 ? 1 : -1;
}
