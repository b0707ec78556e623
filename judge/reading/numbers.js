// Reads the numbers of an answer, from a pasted text or from nested lists of Python.

import {
  fixedRows,
  movingRows,
  jointNumbers,
  revoluteFlags,
  jointNames,
} from "../geometry/kinematics.js";
import { RAD } from "../geometry/angles.js";
import { units } from "../digits.js";
import { findAnswer, NoFitError } from "./answers.js";
import { withoutOtherComments } from "./odd_texts.js";
import { OTHER_LIST } from "./owners.js";
import { endInDegrees, findOtherUnit, fitsJoint, readUnitBehind, readUnits } from "./units.js";
import {
  formulaSlack,
  isNumber,
  parse,
  plain,
  simple,
  symbols,
  symbolsIn,
  value,
} from "./formula.js";
import { orderByGivenNames } from "./ordering.js";
import { refuseOtherValues } from "./other_values.js";
import { ArmError, describeShape, joinList, formatMessage, formatNumber } from "../sentences.js";

/** @typedef {import("../geometry/arm.js").Arm} Arm */

const JOINT = /^(?:q|th|theta|t|phi|joint|j|x|d)(\d{1,2})$/;
const JOINT_SYMBOL = /^(?:q|th|theta)(\d{1,2})$/;
const MOST_SHOWN = 3; // values of a locked joint in a message
const SHORT = /^([cs])(?:theta|th|q)?((?:[+-]?\d)+)$/; // c12, s_theta1
const SCALED = /^(.*?)\*(1(?:\.0+)?e[+-]?\d+)$/;

/**
 * A number as typed. `worth` is the factor of its unit or of a power of ten. `hasUnit` is true if
 * it has a unit of lengths, forces or moments, and `angle` is true if it has a unit of angles or
 * pi. `slack` is the round-off of a formula with rounded decimals. `unitBehind` is the unit behind
 * the number in the text.
 * @typedef {{ text: string, worth: number, hasUnit?: boolean, angle: boolean,
 *   slack: number, unitBehind?: string }} Entry
 */
/**
 * Numbers as typed, row by row. `units` has the unit of the last decimal place of each number.
 * @typedef {{ values: number[], units: number[], shape: number[], symbolic: boolean,
 *   formulas: any[], hasJoints: boolean, entries: Entry[], taken: string[],
 *   hasRowNames?: boolean, splitsCommas?: boolean,
 *   statedUnits?: ReturnType<typeof readUnits>, tokens?: import("./owners.js").Token[] }} Typed
 *   `taken` has messages on how it was read. `formulas` are the trees of all entries, and
 *   `hasJoints` is true if a joint value occurs in them. `hasRowNames` is true if its rows were
 *   ordered by the names vx to wz. `statedUnits` are the units for several numbers, and `tokens`
 *   all numbers with their owners.
 */

/**
 * Return a function that looks up symbols of an arm at joint values.
 * @param {number[]} q
 * @param {[string, number][]} values of symbols that the arm does not have
 */
export function lookup(arm, q, values = []) {
  const known = (names) => lookUpNames([...names].sort(), arm, q, values);
  const constants = new Set([...(arm.values ?? []), ...values].map(([name]) => simple(name)));
  const isKnown = (symbol) => constants.has(symbol) || JOINT.test(symbol) || SHORT.test(symbol);
  known.has = (name) => isKnown(simple(name));
  known.isJoint = (name) => !constants.has(simple(name)) && isKnown(simple(name));
  return known;
}

const noSymbols = (names) => {
  if (names.size)
    throw new ArmError(
      formatMessage("symbols for numbers", { names: [...names].sort().join(", ") }),
    );
  return new Map();
};

const ANY = [{ rows: null, columns: null }];

/**
 * Read typed numbers or numbers from Python.
 * @param {any} mine a text, or nested lists @param {string} what their name in messages
 * @param {{ wants?: import("./answers.js").Want[], names?: RegExp, given?: number[][],
 *   which?: number | null, stated?: import("./ordering.js").StatedOrder }} [asked]
 * @returns {Typed}
 */
export function numbers(mine, what, known = noSymbols, wanted = undefined, asked = {}) {
  if (typeof mine === "string") return readText(mine, { what, known, wanted, ...asked });
  if (mine?.named) return numbers(orderByGivenNames(mine), what, known, wanted, asked);
  const shape = shapeOf(mine);
  const leaves = [mine].flat(Infinity);
  if (shape.reduce((product, n) => product * n, 1) !== leaves.length) {
    throw new ArmError(formatMessage("ragged list", { what }));
  }
  const read = leaves.map((leaf) => readLeaf(leaf, what, wanted ?? "numbers"));
  return { ...evaluateAll(read, known), shape, taken: [] };
}

/**
 * Evaluate the formulas of all entries.
 * @param {{ tree: any[], text: string }[]} read
 */
function evaluateAll(read, known) {
  const formulas = read.map(({ tree }) => tree);
  const names = new Set();
  for (const tree of formulas) symbols(tree, names);
  const meanings = known(names);
  const findValue = (name) => meanings.get(name);
  const entries = read.map(({ text, tree }) => readCell(text, formulaSlack(tree, findValue)));
  return {
    values: formulas.map((tree) => value(tree, findValue)),
    units: unitsOf(entries),
    formulas,
    entries,
    symbolic: names.size > 0,
    hasJoints: [...names].some((name) => known.isJoint?.(name)),
    meanings,
  };
}

/**
 * Read an entry of a list: a number, a formula as text, or a tree that Python made of a formula.
 * @returns {{ tree: any[], text: string }}
 * @throws {ArmError} for anything else; Python sends null for NaN and for an infinite number
 */
function readLeaf(leaf, what, wanted) {
  if (typeof leaf === "string") return { tree: parse(leaf, `an entry of ${what}`), text: leaf };
  if (leaf?.tree) return { tree: leaf.tree, text: "exact" };
  if (leaf?.odd) throw new ArmError(formatMessage("no numbers", { what, given: leaf.odd, wanted }));
  if (leaf === null) throw new ArmError(formatMessage("not finite", { what, wanted }));
  return { tree: ["num", leaf], text: String(leaf) };
}

// Return the shape of nested lists: [2, 3] for two lists of three numbers.
function shapeOf(list) {
  if (!Array.isArray(list)) return [];
  const inner = list.map(shapeOf);
  const even = inner.every((shape) => shape.join() === inner[0].join());
  return [list.length, ...(even ? (inner[0] ?? []) : [])];
}

// Return whether a cell is a number, or a formula with a known symbol.
function entryIn(known) {
  return (cell) => {
    if (isNumber(cell)) return true;
    const names = symbolsIn(cell);
    if (!names?.length) return names !== null && /\d|pi|π/.test(cell);
    return names.some((name) => known.has?.(name));
  };
}

/** @param {string} text @param {any} question @returns {Typed} */
function readText(text, { known, ...question }) {
  const unit = findOtherUnit(text);
  if (unit) throw new ArmError(formatMessage("other unit", { what: question.what, unit }));
  const answer = findAnswer(text, { wants: ANY, isEntry: entryIn(known), ...question });
  const read = answer.rows.flat().map((cell) => {
    const typed = plain(cell.text);
    const isFormula = !isNumber(typed);
    const tree = isFormula ? parse(typed, `an entry of ${question.what}`) : ["num", Number(typed)];
    return { tree, text: typed };
  });
  const evaluated = evaluateAll(read, known);
  const { entries, meanings } = evaluated;
  refuseOtherValues(text, meanings, known);
  const { taken, hasRowNames, splitsCommas, tokens } = answer;
  for (const { owner, index, to } of tokens)
    if (owner === "entry") entries[index].unitBehind = readUnitBehind(text, to);
  /** @param {import("./owners.js").Token} token */
  const isDegrees = ({ index }) => entries[index].worth === RAD;
  return {
    ...evaluated,
    shape: [answer.rows.length, answer.rows[0].length],
    taken,
    hasRowNames,
    splitsCommas,
    statedUnits: readUnits(withoutOtherComments(text, tokens), endInDegrees(tokens, isDegrees)),
    tokens,
  };
}

const IN_DEGREES = /^([-+]?[\d.]+) deg$/;
const NUMPY_NUMBER = /^float64 ?\(([^()]*)\)$/;

/**
 * Separate the number of a cell from its factor. "5*1e-3" is 5 times 0.001.
 * @param {string} typed @param {number} [slack] of a formula @returns {Entry}
 */
function readCell(typed, slack = 0) {
  const cell = typed.replace(NUMPY_NUMBER, "$1");
  const [, scaled, power] = SCALED.exec(cell) ?? [];
  if (scaled) {
    const worth = Number(power);
    // The factor of a unit is written as 1e-3, but MATLAB's heading as 1.0e-03.
    const hasUnit = !power.includes(".");
    return { text: scaled, worth, hasUnit, angle: false, slack: slack / worth };
  }
  const [, degrees] = IN_DEGREES.exec(cell) ?? [];
  if (degrees) return { text: degrees, worth: RAD, angle: true, slack: slack / RAD };
  return { text: cell, worth: 1, angle: /\b(?:deg|pi)\b/.test(cell), slack };
}

// Return the units of the last typed places, with those of formulas.
export function unitsOf(entries) {
  const [texts, slacks] = [entries.map(({ text }) => text), entries.map(({ slack }) => slack)];
  return units(texts, slacks).map((unit, i) => unit * entries[i].worth);
}

export const eachJoint = (arm) =>
  formatMessage("each joint", { joints: jointNames(arm).join(", ") });

// List the shapes of joint vectors, with a value for each moving joint or for each row of the arm.
export const jointShapes = (arm, many = true) =>
  [...new Set([movingRows(arm).length, arm.rows.length])].flatMap((columns) => [
    { rows: many ? null : 1, columns, by: "joint" },
    { rows: columns, columns: 1, by: "joint", turned: true },
    ...(many ? [{ rows: columns, columns: null }] : []),
  ]);

// List the rows of a target that is given as numbers, and the position of a given pose.
export function listGivenRows(target) {
  const rows = Array.isArray(target?.[0]) ? target : [target];
  const listed = rows.filter((row) => Array.isArray(row) && row.every(Number.isFinite));
  const isPose = listed.length > 2 && listed.every(({ length }) => length === 4);
  return isPose ? [...listed, listed.slice(0, 3).map((row) => row[3])] : listed;
}

/** Matches the names of joint values in a text. */
export const JOINT_NAMES = /^(?:q|th|θ|sol|position|ans$|s\d*$)/i; // position: of ROS

// Read a joint vector and its units, without the values of locked joints.
export function readConfiguration(q, arm, angles = "rad") {
  const wants = jointShapes(arm, false);
  const given = numbers(orderByGivenNames(q), `${arm.name}: q`, undefined, eachJoint(arm), {
    wants,
    names: JOINT_NAMES,
  });
  const typed = given.values.length === arm.rows.length ? ofMoving(given, arm) : given;
  if (typed.values.length !== movingRows(arm).length)
    throw notPerJoint(`${arm.name}: q`, arm, typed.shape);
  return inRadians(typed, arm, angles);
}

// Drop the values of locked joints. The values are those of all rows of the arm, configuration
// after configuration.
export function ofMoving(typed, arm) {
  const moving = movingRows(arm);
  if (moving.length === arm.rows.length) return typed;
  const kept = (list) => list.filter((_, i) => moving.includes(i % arm.rows.length));
  const [values, units, entries] = [typed.values, typed.units, typed.entries].map(kept);
  const shape = [...typed.shape.slice(0, -1), moving.length];
  const locked = [noteLockedValues(arm, typed.values)];
  return { ...typed, values, units, entries, shape, locked };
}

/**
 * Return whether rows of joint values have columns for locked joints, whose values are constant.
 * @param {number[][]} rows @param {Arm} arm
 */
export function hasLockedColumns(rows, arm) {
  const locked = fixedRows(arm);
  const isConstant = (i) => rows.every((row) => row[i] === rows[0][i]);
  return locked.length > 0 && rows[0].length === arm.rows.length && locked.every(isConstant);
}

/**
 * Write the message that the values of locked joints are not judged.
 * @param {Arm} arm @param {number[]} values for each configuration, one for each row
 */
export function noteLockedValues({ rows }, values) {
  const locked = fixedRows({ rows });
  const theirs = values.filter((_, k) => locked.includes(k % rows.length));
  const shown = [...new Set(theirs.map((x) => formatNumber(x, 6)))];
  return formatMessage("taken: locked", {
    joints: joinList(locked.map((i) => String(i + 1))),
    values: [...shown.slice(0, MOST_SHOWN), ...(shown.length > MOST_SHOWN ? ["…"] : [])].join(", "),
  });
}

// Make the error for too few or too many values.
export function notPerJoint(what, arm, shape) {
  return new NoFitError(
    formatMessage("pose shape", { what, given: describeShape(shape), wanted: eachJoint(arm) }),
  );
}

/**
 * Raise an error for a value whose unit cannot be that of its joint.
 * @param {Entry[]} entries one for each moving joint, configuration after configuration
 * @param {Arm} arm @param {string} what the answer @param {boolean} isTorque
 */
export function refuseMisfitUnits(entries, arm, what, isTorque) {
  const turning = revoluteFlags(arm);
  const kinds = entries.map((_, i) => ({ turns: turning[i % turning.length], isTorque }));
  const misfit = entries.findIndex(({ unitBehind = "" }, i) => !fitsJoint(unitBehind, kinds[i]));
  if (misfit < 0) return;
  const joint = jointNumbers(arm)[misfit % turning.length];
  const { text, unitBehind: unit } = entries[misfit];
  throw new ArmError(formatMessage("misfit unit", { what, joint, text: `${text} ${unit}` }));
}

/**
 * Return the factor to m of a length. It is 1 for a length with a unit, which is in m already.
 * @param {Typed} typed @param {number} i
 */
export const lengthFactor = ({ statedUnits, entries }, i) =>
  statedUnits?.lengths && !entries[i].hasUnit && !entries[i].unitBehind ? statedUnits.lengths : 1;

// Convert joint values to SI, row by row. The units of the last decimal places are found separately
// for angles and lengths, since metres need more decimals. Angles with a unit are in rad already.
export function inRadians(typed, arm, angles) {
  const turns = revoluteFlags(arm);
  const turn = (i) => turns[i % turns.length];
  const units = [];
  for (const kind of [true, false]) {
    const places = [...typed.entries.keys()].filter((i) => turn(i) === kind);
    const kindUnits = unitsOf(places.map((i) => typed.entries[i]));
    places.forEach((i, k) => (units[i] = kindUnits[k]));
  }
  const unit = typed.statedUnits?.angles ?? angles;
  const factor = (i) => {
    if (!turn(i)) return lengthFactor(typed, i);
    return unit === "deg" && !typed.entries[i].angle ? RAD : 1;
  };
  return {
    ...typed,
    values: typed.values.map((x, i) => x * factor(i)),
    units: units.map((x, i) => x * factor(i)),
  };
}

/**
 * Look up the names of joint values, of lengths, and of cosines and sines such as c_12.
 * @returns {Map<string, number>}
 */
function lookUpNames(names, arm, q, constants) {
  const lengths = [...(arm.values ?? []), ...constants];
  const values = new Map(lengths.map(([name, number]) => [simple(name), number]));
  const joints = new Map(jointNumbers(arm).map((i, k) => [i, q[k]]));
  return new Map(
    names.map((name) => {
      const x = values.get(simple(name)) ?? evaluateJoints(simple(name), joints);
      if (Number.isFinite(x)) return [name, x];
      const [, joint] = JOINT_SYMBOL.exec(simple(name)) ?? [];
      if (joint === "0")
        throw new ArmError(
          formatMessage("joint zero", { arm: arm.name, name, first: name.replace("0", "1") }),
        );
      const known = [...jointNames(arm), ...(arm.values ?? []).map(([symbol]) => symbol)].join(
        ", ",
      );
      if (arm.rows[0].kind === "fixed" && joint)
        throw new ArmError(formatMessage("unknown joint", { arm: arm.name, name, known }));
      throw new ArmError(formatMessage("unknown symbol", { arm: arm.name, name, known }), [
        { field: "values", value: name },
      ]);
    }),
  );
}

// Evaluate the name of a joint value, or of a cosine or sine such as c12. Else return undefined.
function evaluateJoints(symbol, q) {
  const [, joint] = JOINT.exec(symbol) ?? [];
  if (joint) return q.get(Number(joint));
  const [, kind, terms] = SHORT.exec(symbol) ?? [];
  if (!kind) return undefined;
  const sum = [...terms.matchAll(/(-?)(\d)/g)].reduce(
    (total, [, minus, i]) => total + (minus ? -1 : 1) * q.get(Number(i)),
    0,
  );
  return kind === "c" ? Math.cos(sum) : Math.sin(sum);
}

/**
 * Refuse numbers of a wrong shape if the text has a second list, which may be the answer.
 * @param {Typed} typed @param {string} what the answer @param {string} wanted its shape
 * @throws {ArmError}
 */
export function refuseOtherLists({ tokens = [], shape }, what, wanted) {
  if (!tokens.some(({ reason }) => reason === OTHER_LIST)) return;
  throw new ArmError(formatMessage("shape beside", { what, shape: shape.join("x"), wanted }));
}
