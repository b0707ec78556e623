// What a reader types, or Python holds, taken as numbers.

import { joints } from "../geometry/kinematics.js";
import { RAD } from "../geometry/angles.js";
import { units } from "../digits.js";
import { isNumber, parse, plain, symbols, value } from "./formula.js";
import { cells } from "./grid.js";
import { withoutHeader } from "./heads.js";
import { ArmError, say, spelled, tuple } from "../sentences.js";

const JOINT = /^(q|th|theta|tht|thetha|t|phi|joint|j|x|d|u)(\d{1,2})$/;
const SHORT = /^([cs])((?:[+-]?\d)+)$/i;
const SCALED = /^(.*?)\*(1(?:\.0+)?e[+-]?\d+)$/;

/**
 * Numbers as they were handed in, row by row, with the unit of each one's last place; of a text the
 * formulas too.
 * @typedef {{ values: number[], units: number[], shape: number[], symbolic: boolean, trees?: any[]
 *   }} Typed
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
  const steps = units(entries.map(({ text }, i) => text ?? spelled(values[i])));
  return { values, units: steps, shape, symbolic: names.size > 0 };
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

// A name before a value: a quoted one with a comma or colon, or q_1 = and theta_{2}:.
const NAMED = new RegExp(
  String.raw`['"][^'"]*['"]\s*[,:]\s*` +
    String.raw`|\\?(?<![\p{L}\p{N}_])(?:q|theta|th|θ|t|tau|τ)_?(?:\p{Nd}|\{\p{Nd}\})\s*[=:]\s*`,
  "giu",
);

// One value for each joint without the names before them: ('theta1', 0.3) is 0.3.
export function unnamed(mine) {
  if (typeof mine === "string") return mine.replace(NAMED, "");
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
function cellsOf(text) {
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
  const scaled = texts.map(scaling);
  const steps = units(scaled.map(([first]) => first)).map((u, i) => u * scaled[i][1]);
  const shown = trees.map((tree, i) => (scaled[i][1] === 1 ? tree : ["num", values[i]]));
  return {
    values,
    units: steps,
    shape: [rows.length, widths[0]],
    symbolic: names.size > 0,
    trees: shown,
  };
}

// A number and the power of ten that MATLAB's heading gave it.
function scaling(cell) {
  const match = SCALED.exec(cell);
  return match ? [match[1], Number(match[2])] : [cell, 1];
}

export const eachJoint = (arm) => `one value for each of ${variables(arm).join(", ")}`;

// One joint vector, with its units.
export function pose(q, arm, angles = "rad") {
  const typed = numbers(unnamed(q), `${arm.name}: q`, undefined, eachJoint(arm));
  const column = typed.shape.length === 2 && typed.shape[1] === 1;
  const flat = column || typeof q === "string" ? [typed.values.length] : typed.shape;
  const dof = joints(arm).length;
  if (flat.length !== 1 || flat[0] !== dof)
    throw new ArmError(poseFault(arm, flat, `one pose, (${dof},)`));
  return inRadians(typed, arm, angles);
}

export function poseFault(arm, shape, wanted) {
  const given = tuple(shape);
  return `${arm.name}: q has shape ${given}; expected ${wanted}, ${eachJoint(arm)}`;
}

export function inRadians(typed, arm, angles) {
  const turns = turning(arm);
  const factor = (i) => (angles === "deg" && turns[i % turns.length] ? RAD : 1);
  return {
    ...typed,
    values: typed.values.map((x, i) => x * factor(i)),
    units: typed.units.map((u, i) => u * factor(i)),
  };
}

// Joint vectors that were typed in degrees, each with its units. Where some joints slide, those
// that turn have decimals of their own, for metres need more.
export function rowsInRadians(rows, arm) {
  const turns = turning(arm);
  const mixed = turns.some(Boolean) && !turns.every(Boolean);
  const own = mixed
    ? units(rows.flatMap(({ values }) => values.filter((_, k) => turns[k])).map(spelled))
    : [];
  let at = 0;
  const widened = (u, k) => {
    if (!mixed || !turns[k]) return u;
    const mine = own[at++];
    return u > 0 ? Math.max(mine, u) : u;
  };
  return rows.map((row) => inRadians({ ...row, units: row.units.map(widened) }, arm, "deg"));
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
