// What a reader types, or Python holds, taken as numbers.

import { joints } from "../geometry/kinematics.js";
import { RAD } from "../geometry/angles.js";
import { units } from "../digits.js";
import { isNumber, parse, plain, symbols, value } from "./formula.js";
import { cells } from "./grid.js";
import { withoutHeader } from "./heads.js";
import { ArmError, counted, listed, say, spelled } from "../sentences.js";

const JOINT = /^(q|th|theta|tht|thetha|t|phi|joint|j|x|d|u)(\d{1,2})$/;
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
 *   entries: Entry[] }} Typed
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
  return { known, said };
}

const noSymbols = (names) => {
  if (names.size)
    throw new ArmError(say("symbols for numbers", { names: [...names].sort().join(", ") }));
  return new Map();
};

/** @returns {Typed} */
export function numbers(mine, what, known = noSymbols, wanted = "numbers") {
  if (typeof mine === "string") return ofText(mine, what, known);
  const shape = shapeOf(mine);
  const leaves = [mine].flat(Infinity);
  if (shape.reduce((product, n) => product * n, 1) !== leaves.length) {
    throw new ArmError(say("ragged list", { what }));
  }
  const entries = leaves.map((leaf) => entryOf(leaf, what, wanted));
  const names = new Set();
  for (const { tree } of entries) symbols(tree, names);
  const found = known(names);
  const values = entries.map(({ tree }) =>
    tree[0] === "num" ? tree[1] : value(tree, (n) => found.get(n)),
  );
  if (!values.every(Number.isFinite)) throw new ArmError(say("not finite", { what, wanted }));
  const typed = entries.map(({ text }, i) => ofCell(text ?? spelled(values[i])));
  return { values, units: unitsOf(typed), shape, symbolic: names.size > 0, entries: typed };
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

// What stands before a value: a quoted name with a comma or colon, q_1 =, theta_{2}: or Joint 1:;
// before a list: Solution 1:, 1) or elbow up:; and behind a value the unit of torques and angles.
const NAMED = new RegExp(
  String.raw`^[ \t]*(?:(?:solution|answer|branch|case|set|lösung)[ \t]*\d+[ \t]*[:.)]?|\d+\))` +
    String.raw`(?=[ \t]*(?:$|\D))|^[ \t]*\p{L}[\p{L} ,+-]*:[ \t]*(?=[[(])` +
    String.raw`|['"][^'"]*['"]\s*[,:]\s*` +
    String.raw`|\\?(?<![\p{L}\p{N}_])(?:q|theta|th|θ|Θ|t|tau|τ|g|d|joint ?)` +
    String.raw`_?(?:\p{Nd}|[₀-₉]|\{\p{Nd}\})\s*(?:\([^()]*\)\s*)?[=:]\s*`,
  "gimu",
);
export const JOINT_NAMES = /^\\?(?:[qQd]|th|t[_\d{]|Theta|[θΘφ]|phi|joint)/; // one by one or all
const UNITS = new RegExp(
  String.raw`(?<=\d\.?|[\])}])(?:[ \t~]|\\[,;: ])*(?:\\(?:text|mathrm)\{\s*)?` +
    String.raw`(?:N\s*[·*⋅.]?\s*m{1,2}|N|rad(?:ians)?)(?:\s*\})?(?![\p{L}\p{N}_(])`,
  "gu",
);

// One value for each joint without the names before them: ('theta1', 0.3) is 0.3.
export function unnamed(mine) {
  if (typeof mine === "string") return mine.replace(NAMED, "").replace(UNITS, "").trim();
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

// A vector that NumPy prints over several lines; a sign that stands one upright.
const PRINTED = /^[^[\](){};,|&]*\[[^[\](){};,|&]*\]\s*$/;
const UPRIGHT = /(?<=[\])}])\s*(?:\^\s*(?:T|\\top|\{\s*(?:T|\\top)\s*\})|\.T|\.?')\s*;?\s*$/;

// The cells of a text; a vector is one however it is printed or stood upright.
export function cellsOf(text) {
  const bare = text.replace(UPRIGHT, "");
  const rows = withoutHeader(cells(bare));
  // which says that a matrix may not be
  if (bare !== text && rows.length > 1 && rows[0].length > 1) return cells(text);
  const even = rows.every((row) => row.length === rows[0].length);
  return PRINTED.test(bare) && !even ? [rows.flat()] : rows;
}

function ofText(text, what, known) {
  const rows = cellsOf(text);
  const widths = [...new Set(rows.map((row) => row.length))].sort((a, b) => a - b);
  if (widths.length > 1) {
    const row = rows.findIndex((one) => one.length < widths.at(-1));
    const told = { what, widths: widths.join(", "), row: row + 1, count: rows[row].length };
    throw new ArmError(say("ragged", told));
  }
  const texts = rows.flat().map(plain);
  const trees = texts.map((cell) =>
    isNumber(cell) ? ["num", Number(cell)] : parse(cell, `an entry of ${what}`),
  );
  const names = new Set();
  for (const tree of trees) symbols(tree, names);
  const found = known(names);
  const values = trees.map((tree) => value(tree, (name) => found.get(name)));
  const entries = texts.map(ofCell);
  const shown = trees.map((tree, i) =>
    entries[i].worth === 1 || entries[i].angle ? tree : ["num", values[i]],
  );
  const read = { values, units: unitsOf(entries), shape: [rows.length, widths[0]], trees: shown };
  return { ...read, symbolic: names.size > 0, entries };
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

// One joint vector, with its units.
export function pose(q, arm, angles = "rad") {
  const typed = numbers(unnamed(q), `${arm.name}: q`, undefined, eachJoint(arm));
  if (typed.values.length !== joints(arm).length)
    throw notPerJoint(`${arm.name}: q`, arm, typed.shape);
  return inRadians(typed, arm, angles);
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
  const factor = (i) => (angles === "deg" && turn(i) && !typed.entries[i].angle ? RAD : 1);
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
