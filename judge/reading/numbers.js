// Reads the numbers that a reader types, or that Python holds.

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
import { unitsSaid } from "./labels.js";
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
import { ArmError, describeShape, joinList, formatMessage, formatNumber } from "../sentences.js";

/** @typedef {import("../geometry/arm.js").Arm} Arm */

const JOINT = /^(?:q|th|theta|t|phi|joint|j|x|d)(\d{1,2})$/;
const JOINT_SYMBOL = /^(?:q|th|theta)\d{1,2}$/;
const FIRST = /^(?:q|th|theta)0$/; // of joints counted from 0
const SHOWN = 3; // so many values of a locked joint are shown back
const SHORT = /^([cs])((?:[+-]?\d)+)$/;
const SCALED = /^(.*?)\*(1(?:\.0+)?e[+-]?\d+)$/;

/**
 * A number as typed; what one of it is worth where a unit or power of ten stands with it; whether
 * it says itself that it is an angle; for a formula, how far its decimals leave its value open.
 * @typedef {{ text: string, worth: number, angle: boolean, slack: number }} Entry
 */
/**
 * Numbers as they were handed in, row by row, with the unit of each one's last place; of a text the
 * formulas too.
 * @typedef {{ values: number[], units: number[], shape: number[], symbolic: boolean, trees?: any[],
 *   entries: Entry[], said: string[], left: string[],
 *   says?: ReturnType<typeof unitsSaid>, tokens?: import("./owners.js").Token[] }} Typed
 *   `said` is how a text was read, `left` its other lines, `says` the units that they name,
 *   `tokens` every number of the text with its owner
 */

/**
 * Looks symbols up for one arm at one pose.
 * @param {number[]} q
 * @param {[string, number][]} values of symbols that the arm does not have
 */
export function lookup(arm, q, values = []) {
  const known = (names) => meanings([...names].sort(), arm, q, values);
  const own = new Set([...(arm.values ?? []), ...values].map(([name]) => simple(name)));
  const isMeant = (word) => own.has(word) || JOINT.test(word) || SHORT.test(word);
  known.has = (name) => isMeant(simple(name));
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
 * `asked` is the shapes that are wanted of a text, the answer's names, and what the question holds
 * itself.
 * @param {any} mine @param {string} what
 * @param {{ wants?: import("./answers.js").Want[], names?: RegExp, given?: number[][],
 *   which?: number | null }} [asked]
 * @returns {Typed}
 */
export function numbers(mine, what, known = noSymbols, wanted = undefined, asked = {}) {
  if (typeof mine === "string") return ofText(mine, { what, known, wanted, ...asked });
  const shape = shapeOf(mine);
  const leaves = [mine].flat(Infinity);
  if (shape.reduce((product, n) => product * n, 1) !== leaves.length) {
    throw new ArmError(formatMessage("ragged list", { what }));
  }
  const entries = leaves.map((leaf) => entryOf(leaf, what, wanted ?? "numbers"));
  const names = new Set();
  for (const { tree } of entries) symbols(tree, names);
  const found = known(names);
  const values = entries.map(({ tree }) =>
    tree[0] === "num" ? tree[1] : value(tree, (n) => found.get(n)),
  );
  if (!values.every(Number.isFinite))
    throw new ArmError(formatMessage("not finite", { what, wanted: wanted ?? "numbers" }));
  const typed = entries.map(({ text, tree }, i) => {
    if (text === undefined) return ofCell(String(values[i]));
    return ofCell(
      text,
      formulaSlack(tree, (name) => found.get(name)),
    );
  });
  const symbolic = names.size > 0;
  return { values, units: unitsOf(typed), shape, symbolic, entries: typed, said: [], left: [] };
}

/**
 * An entry of a list: a number, a formula as text, or what Python made of one that it held, a tree;
 * an error in words for anything else.
 * @returns {{ tree: any[], text?: string }}
 */
function entryOf(leaf, what, wanted) {
  if (typeof leaf === "string") return { tree: parse(leaf, `an entry of ${what}`), text: leaf };
  if (leaf?.tree) return { tree: leaf.tree, text: "exact" };
  if (leaf?.odd) throw new ArmError(formatMessage("no numbers", { what, given: leaf.odd, wanted }));
  return { tree: ["num", leaf ?? NaN] };
}

// One value for each joint without the names before them: ('theta1', 0.3) is 0.3.
export function unnamed(mine) {
  if (!Array.isArray(mine)) return mine;
  if (mine.length === 2 && typeof mine[0] === "string" && typeof mine[1] !== "string") {
    return unnamed(mine[1]);
  }
  return mine.map(unnamed);
}

// The shape of nested lists; that of lists of different lengths ends with them.
function shapeOf(list) {
  if (!Array.isArray(list)) return [];
  const inner = list.map(shapeOf);
  const even = inner.every((shape) => shape.join() === inner[0].join());
  return [list.length, ...(even ? (inner[0] ?? []) : [])];
}

// Return whether a cell is a number, or a formula of symbols that are known.
function entryIn(known) {
  return (cell) => {
    if (isNumber(cell)) return true;
    const names = symbolsIn(cell);
    if (!names?.length) return names !== null && /\d|pi|π/.test(cell);
    const meant = names.filter((name) => known.has?.(name)).length;
    return meant === names.length || (meant > 0 && /\W/.test(cell));
  };
}

/** @param {string} text @param {any} question @returns {Typed} */
function ofText(text, { known, ...question }) {
  const found = findAnswer(text, { wants: ANY, isEntry: entryIn(known), ...question });
  const texts = found.rows.flat().map((cell) => plain(cell.text));
  const trees = texts.map((cell) =>
    isNumber(cell) ? ["num", Number(cell)] : parse(cell, `an entry of ${question.what}`),
  );
  const used = new Set();
  for (const tree of trees) symbols(tree, used);
  const meant = known(used);
  const values = trees.map((tree) => value(tree, (name) => meant.get(name)));
  const entries = texts.map((cell, i) =>
    ofCell(cell, isNumber(cell) ? 0 : formulaSlack(trees[i], (name) => meant.get(name))),
  );
  const shown = trees.map((tree, i) =>
    entries[i].worth === 1 || entries[i].angle ? tree : ["num", values[i]],
  );
  const shape = [found.rows.length, found.rows[0].length];
  const { said, left } = found;
  const read = { values, units: unitsOf(entries), shape, trees: shown, symbolic: used.size > 0 };
  return { ...read, entries, said, left, says: unitsSaid(text), tokens: found.tokens };
}

const IN_DEGREES = /^([-+]?[\d.]+) deg$/;
const NUMPY_NUMBER = /^float64 ?\(([^()]*)\)$/;

/**
 * Part a cell into the number typed and what one of it is worth: the power of ten of MATLAB's
 * heading, or a degree.
 * @param {string} typed @param {number} [slack] of a formula @returns {Entry}
 */
function ofCell(typed, slack = 0) {
  const cell = typed.replace(NUMPY_NUMBER, "$1");
  const [, scaled, power] = SCALED.exec(cell) ?? [];
  if (scaled) {
    const worth = Number(power);
    return { text: scaled, worth, angle: false, slack: slack / worth };
  }
  const [, degrees] = IN_DEGREES.exec(cell) ?? [];
  if (degrees) return { text: degrees, worth: RAD, angle: true, slack: slack / RAD };
  return { text: cell, worth: 1, angle: /\b(?:deg|pi)\b/.test(cell), slack };
}

function unitsOf(entries) {
  const [texts, slacks] = [entries.map(({ text }) => text), entries.map(({ slack }) => slack)];
  return units(texts, slacks).map((unit, i) => unit * entries[i].worth);
}

export const eachJoint = (arm) =>
  formatMessage("each joint", { joints: jointNames(arm).join(", ") });

// The shapes of one value for each joint, and of any number of such rows; the moving joints' first,
// then those of all.
export const jointShapes = (arm, many = true) =>
  [...new Set([movingRows(arm).length, arm.rows.length])].flatMap((columns) => [
    { rows: many ? null : 1, columns, by: "joint" },
    { rows: columns, columns: 1, by: "joint", turned: true },
    ...(many ? [{ rows: columns, columns: null }] : []),
  ]);

// The rows of numbers that a target is; none of a text.
export function rowsGiven(target) {
  const rows = Array.isArray(target?.[0]) ? target : [target];
  return rows.filter((row) => Array.isArray(row) && row.every(Number.isFinite));
}

// One joint vector, with its units; what is told of locked joints is left out.
export function pose(q, arm, angles = "rad") {
  const wants = jointShapes(arm, false);
  const given = numbers(unnamed(q), `${arm.name}: q`, undefined, eachJoint(arm), { wants });
  const typed = given.values.length === arm.rows.length ? ofMoving(given, arm) : given;
  if (typed.values.length !== movingRows(arm).length)
    throw notPerJoint(`${arm.name}: q`, arm, typed.shape);
  return inRadians(typed, arm, angles);
}

// One value for each row of an arm, pose after pose, without those of its locked joints.
export function ofMoving(typed, arm) {
  const moving = movingRows(arm);
  if (moving.length === arm.rows.length) return typed;
  const kept = (list) => list.filter((_, i) => moving.includes(i % arm.rows.length));
  const [values, units, entries] = [typed.values, typed.units, typed.entries].map(kept);
  const shape = typed.shape.map((n) => (n === arm.rows.length ? moving.length : n));
  const locked = [setAside(arm, typed.values)];
  return { ...typed, values, units, entries, shape, locked };
}

/**
 * A word on the locked joints, whose values are not judged.
 * @param {Arm} arm @param {number[]} values one for each row of the arm, pose after pose
 */
export function setAside({ rows }, values) {
  const locked = fixedRows({ rows });
  const theirs = values.filter((_, k) => locked.includes(k % rows.length));
  const shown = [...new Set(theirs.map((x) => formatNumber(x, 6)))];
  return formatMessage("taken: locked", {
    joints: joinList(locked.map((i) => String(i + 1))),
    values: [...shown.slice(0, SHOWN), ...(shown.length > SHOWN ? ["…"] : [])].join(", "),
  });
}

// An error where values are too few or too many.
export function notPerJoint(what, arm, shape) {
  const words = formatMessage("pose shape", {
    what,
    given: describeShape(shape),
    wanted: eachJoint(arm),
  });
  return new NoFitError(words + tooMany(arm, shape.at(-1)));
}

// A list of numbers as rows.
export const rowsOf = (flat, width) =>
  Array.from({ length: flat.length / width }, (_, i) => flat.slice(i * width, (i + 1) * width));

// A word on joints that are locked, where so many values were given that these have some too.
function tooMany(arm, width) {
  const locked = arm.rows.flatMap(({ kind }, i) => (kind === "fixed" ? [`q_${i + 1}`] : []));
  return locked.length && width === arm.rows.length
    ? formatMessage("leave out", { joints: joinList(locked) })
    : "";
}

// Joint values, row by row, in SI. Angles and slides have decimals of their own, for metres need
// more; an angle with a unit is in that.
export function inRadians(typed, arm, angles) {
  const turns = revoluteFlags(arm);
  const turn = (i) => turns[i % turns.length];
  const mixed = turns.includes(true) && turns.includes(false);
  const [angular, linear] = [true, false].map((kind) =>
    mixed ? unitsOf(typed.entries.filter((_, i) => turn(i) === kind)) : [],
  );
  const own = (i) => (mixed ? (turn(i) ? angular : linear).shift() : typed.units[i]);
  const unit = typed.says?.angles ?? angles;
  const factor = (i) => (unit === "deg" && turn(i) && !typed.entries[i].angle ? RAD : 1);
  return {
    ...typed,
    values: typed.values.map((x, i) => x * factor(i)),
    units: typed.units.map((_, i) => own(i) * factor(i)),
  };
}

// Joint vectors that were taken as radians, as degrees.
export function asDegrees(rows, arm) {
  const factors = revoluteFlags(arm).map((turns) => (turns ? RAD : 1));
  const scaled = (list) => list.map((x, k) => x * factors[k]);
  return rows.map((row) => ({ ...row, values: scaled(row.values), units: scaled(row.units) }));
}

// Names

// A joint's value, a length, or the cosine or sine of a sum of joints, by its name.
/** @returns {Map<string, number>} */
function meanings(names, arm, q, own) {
  const lengths = [...(arm.values ?? []), ...own];
  const values = new Map(lengths.map(([name, number]) => [simple(name), number]));
  const joints = new Map(jointNumbers(arm).map((i, k) => [i, q[k]]));
  return new Map(
    names.map((name) => {
      const found = values.get(simple(name)) ?? ofJoints(simple(name), joints);
      if (Number.isFinite(found)) return [name, found];
      if (FIRST.test(simple(name)))
        throw new ArmError(
          formatMessage("joint zero", { arm: arm.name, name, first: name.replace("0", "1") }),
        );
      const known = [...jointNames(arm), ...(arm.values ?? []).map(([one]) => one)].join(", ");
      if (arm.rows[0].kind === "fixed" && JOINT_SYMBOL.test(simple(name)))
        throw new ArmError(formatMessage("unknown joint", { arm: arm.name, name, known }));
      throw new ArmError(formatMessage("unknown symbol", { arm: arm.name, name, known }), [
        { field: "values", value: name },
      ]);
    }),
  );
}

function ofJoints(word, q) {
  const [, joint] = JOINT.exec(word) ?? [];
  if (joint) return q.get(Number(joint));
  const [, kind, terms] = SHORT.exec(word) ?? [];
  if (!kind) return undefined;
  const sum = [...terms.matchAll(/(-?)(\d)/g)].reduce(
    (total, [, minus, i]) => total + (minus ? -1 : 1) * q.get(Number(i)),
    0,
  );
  return kind === "c" ? Math.cos(sum) : Math.sin(sum);
}
