// What a reader types, or Python holds, taken as numbers.

import { joints } from "../geometry/kinematics.js";
import { RAD } from "../geometry/angles.js";
import { units } from "../digits.js";
import { unitsSaid } from "./context.js";
import { find } from "./find.js";
import { isNumber, parse, plain, symbols, value } from "./formula.js";
import { ArmError, counted, listed, say, size, spelled } from "../sentences.js";

const JOINT = /^(q|th|theta|tht|thetha|t|phi|joint|j|x|d|u)(\d{1,2})$/;
const SHOWN = 3; // so many values of a locked joint are shown back
const SHORT = /^([cs])((?:[+-]?\d)+)$/i;
const SCALED = /^(.*?)\*(1(?:\.0+)?e[+-]?\d+)$/;

/**
 * A number as typed, what one of it is worth where a unit or power of ten stands with it, and
 * whether it says itself that it is an angle.
 * @typedef {{ text: string, worth: number, angle: boolean }} Entry
 */
/**
 * Numbers as they were handed in, row by row, with the unit of each one's last place; of a text the
 * formulas too.
 * @typedef {{ values: number[], units: number[], shape: number[], symbolic: boolean, trees?: any[],
 *   entries: Entry[], said: string[], left: string[],
 *   says?: ReturnType<typeof unitsSaid> }} Typed
 *   `said` is how a text was read, `left` its other lines, `says` the units that they name
 */

// An arm that can be judged is the explorer's, with its symbols: values [[name, number]], and the
// tables with other lengths that mistakes would give (see helpers/explorer/judge.py).
export const numbered = (arm) => joints(arm).map((i) => i + 1);
export const turning = (arm) => joints(arm).map((i) => arm.rows[i].kind === "revolute");
export const variables = (arm) => numbered(arm).map((i) => `q_${i}`);

/**
 * Looks symbols up for one arm at one pose, and remembers what it had to say about them.
 * @param {number[]} q
 * @param {[string, number][]} values of symbols that the arm does not have
 * @returns {{ known: (names: Set<string>) => Map<string, number>, said: string[] }}
 */
export function lookup(arm, q, values = []) {
  const said = [];
  const known = (names) => {
    const [found, words] = meanings([...names].sort(), arm, q, values);
    for (const one of words) if (!said.includes(one)) said.push(one);
    return found;
  };
  const own = new Set([...(arm.values ?? []), ...values].map(([name]) => simple(name)));
  known.has = (name) => own.has(simple(name)) || indices(name) !== null;
  return { known, said };
}

const noSymbols = (names) => {
  if (names.size)
    throw new ArmError(say("symbols for numbers", { names: [...names].sort().join(", ") }));
  return new Map();
};

const ANY = [{ rows: null, columns: null }];

/**
 * `asked` is the shapes that are wanted of a text, the answer's names, and what the question holds
 * itself.
 * @param {any} mine @param {string} what
 * @param {{ wants?: import("./find.js").Want[], names?: RegExp, given?: number[][],
 *   which?: number | null }} [asked]
 * @returns {Typed}
 */
export function numbers(mine, what, known = noSymbols, wanted = undefined, asked = {}) {
  if (typeof mine === "string") return ofText(mine, { what, known, wanted, ...asked });
  const shape = shapeOf(mine);
  const leaves = [mine].flat(Infinity);
  if (shape.reduce((product, n) => product * n, 1) !== leaves.length) {
    throw new ArmError(say("ragged list", { what }));
  }
  const entries = leaves.map((leaf) => entryOf(leaf, what, wanted ?? "numbers"));
  const names = new Set();
  for (const { tree } of entries) symbols(tree, names);
  const found = known(names);
  const values = entries.map(({ tree }) =>
    tree[0] === "num" ? tree[1] : value(tree, (n) => found.get(n)),
  );
  if (!values.every(Number.isFinite))
    throw new ArmError(say("not finite", { what, wanted: wanted ?? "numbers" }));
  const typed = entries.map(({ text }, i) => ofCell(text ?? spelled(values[i])));
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
  if (leaf?.odd) throw new ArmError(say("no numbers", { what, given: leaf.odd, wanted }));
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

// Whether a cell is a number, or a formula of symbols that are known.
function entryIn(known) {
  return (cell) => {
    if (isNumber(cell)) return true;
    if (/[~≈]/.test(cell)) return false;
    try {
      const tree = parse(cell);
      const names = [...symbols(tree)];
      if (!names.length) return /\d|pi|π/.test(cell);
      const meant = names.filter((name) => known.has?.(name)).length;
      return meant === names.length || (meant > 0 && /\W/.test(cell));
    } catch (error) {
      if (error instanceof ArmError) return false;
      throw error;
    }
  };
}

/** @param {string} text @param {any} question @returns {Typed} */
function ofText(text, { known, ...question }) {
  const found = find(text, { wants: ANY, isEntry: entryIn(known), ...question });
  const texts = found.rows.flat().map(plain);
  const trees = texts.map((cell) =>
    isNumber(cell) ? ["num", Number(cell)] : parse(cell, `an entry of ${question.what}`),
  );
  const used = new Set();
  for (const tree of trees) symbols(tree, used);
  const meant = known(used);
  const values = trees.map((tree) => value(tree, (name) => meant.get(name)));
  const entries = texts.map(ofCell);
  const shown = trees.map((tree, i) =>
    entries[i].worth === 1 || entries[i].angle ? tree : ["num", values[i]],
  );
  const shape = [found.rows.length, found.rows[0].length];
  const { said, left } = found;
  const read = { values, units: unitsOf(entries), shape, trees: shown, symbolic: used.size > 0 };
  return { ...read, entries, said, left, says: unitsSaid(text) };
}

const IN_DEGREES = /^([-+]?[\d.]+) ?\*? ?deg$/;

// A number without the power of ten that MATLAB's heading gave it, or its sign of degrees.
/** @returns {Entry} */
function ofCell(cell) {
  const [, scaled, power] = SCALED.exec(cell) ?? [];
  if (scaled) return { text: scaled, worth: Number(power), angle: false };
  const turned = IN_DEGREES.exec(cell);
  if (turned) return { text: turned[1], worth: RAD, angle: true };
  return { text: cell, worth: 1, angle: /\b(?:deg|pi)\b/.test(cell) };
}

const unitsOf = (entries) =>
  units(entries.map(({ text }) => text)).map((u, i) => u * entries[i].worth);

export const eachJoint = (arm) => say("each joint", { joints: variables(arm).join(", ") });

// The shapes of one value for each joint, and of any number of such rows; the moving joints' first,
// then those of all.
export const jointShapes = (arm, many = true) =>
  [...new Set([joints(arm).length, arm.rows.length])].flatMap((columns) => [
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
  if (typed.values.length !== joints(arm).length)
    throw notPerJoint(`${arm.name}: q`, arm, typed.shape);
  return inRadians(typed, arm, angles);
}

// One value for each row of an arm, pose after pose, without those of its locked joints.
export function ofMoving(typed, arm) {
  const moving = joints(arm);
  if (moving.length === arm.rows.length) return typed;
  const kept = (list) => list.filter((_, i) => moving.includes(i % arm.rows.length));
  const [values, units, entries] = [typed.values, typed.units, typed.entries].map(kept);
  const shape = typed.shape.map((n) => (n === arm.rows.length ? moving.length : n));
  const locked = [setAside(arm, typed.values)];
  return { ...typed, values, units, entries, shape, locked };
}

/**
 * A word on the locked joints, whose values are not judged.
 * @param {any} arm @param {number[]} values one for each row of the arm, pose after pose
 */
export function setAside({ rows }, values) {
  const locked = rows.flatMap(({ kind }, i) => (kind === "fixed" ? [i] : []));
  const theirs = values.filter((_, k) => locked.includes(k % rows.length));
  const shown = [...new Set(theirs.map((x) => size(x, 6)))];
  return say("taken: locked", {
    joints: listed(locked.map((i) => String(i + 1))),
    values: [...shown.slice(0, SHOWN), ...(shown.length > SHOWN ? ["…"] : [])].join(", "),
  });
}

// An error where values are too few or too many.
export function notPerJoint(what, arm, shape) {
  const words = say("pose shape", { what, given: counted(shape), wanted: eachJoint(arm) });
  return new ArmError(words + tooMany(arm, shape.at(-1)));
}

// A list of numbers as rows.
export const rowsOf = (flat, width) =>
  Array.from({ length: flat.length / width }, (_, i) => flat.slice(i * width, (i + 1) * width));

// A word on joints that are locked, where so many values were given that these have some too.
function tooMany(arm, width) {
  const locked = arm.rows.flatMap(({ kind }, i) => (kind === "fixed" ? [`q_${i + 1}`] : []));
  return locked.length && width === arm.rows.length
    ? say("leave out", { joints: listed(locked) })
    : "";
}

// Joint values, row by row, in SI. Angles and slides have decimals of their own, for metres need
// more; an angle with a unit is in that.
export function inRadians(typed, arm, angles) {
  const turns = turning(arm);
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
  const factors = turning(arm).map((turns) => (turns ? RAD : 1));
  const scaled = (list) => list.map((x, k) => x * factors[k]);
  return rows.map((row) => ({ ...row, values: scaled(row.values), units: scaled(row.units) }));
}

// Names

// A name without underscores, braces, primes and (t), in lower case.
const simple = (name) =>
  plain(name)
    .replace(/\(t\)|[_{}'*^\\\s]/g, "")
    .toLowerCase();

/** @returns {[Map<string, number>, string[]]} */
function meanings(names, arm, q, own) {
  // one name once, where it first stood, as in Python
  const all = new Map([...(arm.values ?? []), ...own]);
  const values = new Map([...all].map(([name, number]) => [simple(name), number]));
  const found = new Map(
    names.filter((n) => values.has(simple(n))).map((n) => [n, values.get(simple(n))]),
  );
  const used = new Map(names.filter((n) => !found.has(n)).map((n) => [n, indices(n)]));
  const [order, said] = orderOf([...new Set([...used.values()].flatMap((i) => i ?? []))], arm);
  for (const [name, numbers] of used) {
    const at = (numbers ?? []).map((i) => order.get(i));
    if (!at.length || at.includes(undefined)) {
      const known = [...variables(arm), ...(arm.values ?? []).map(([one]) => one)].join(", ");
      throw new ArmError(say("unknown symbol", { arm: arm.name, name, known }), [
        { field: "values", value: name },
      ]);
    }
    found.set(
      name,
      angleOrShort(
        simple(name),
        at.map((k) => q[k]),
      ),
    );
  }
  return [found, said];
}

function indices(name) {
  const word = simple(name);
  const joint = JOINT.exec(word);
  if (joint) return [Number(joint[2])];
  const short = SHORT.exec(word);
  return short ? [...short[2].matchAll(/\d/g)].map(Number) : null;
}

// The position of each joint number: by row, or counted on past what does not move.
/** @returns {[Map<number, number>, string[]]} */
function orderOf(used, arm) {
  const list = numbered(arm);
  const byRow = new Map(list.map((i, k) => [i, k]));
  const within = (from) => used.every((i) => i >= from && i < from + list.length);
  if (used.every((i) => byRow.has(i))) return [byRow, []];
  const counted = (from) => new Map(list.map((_, k) => [k + from, k]));
  if (within(1)) return [counted(1), [say("taken: counted on", { joints: list.join(", ") })]];
  if (within(0)) return [counted(0), [say("taken: from zero", { joints: list.join(", ") })]];
  return [byRow, []];
}

function angleOrShort(name, q) {
  const match = SHORT.exec(name);
  if (!match) return q[0];
  const signs = [...match[2].matchAll(/([+-]?)\d/g)].map(([, sign]) => (sign === "-" ? -1 : 1));
  const total = q.reduce((sum, x, i) => sum + signs[i] * x, 0);
  return name[0] === "c" ? Math.cos(total) : Math.sin(total);
}
