// What mistakes make of a right Jacobian: in the table or q (before), in the recipe, and in how it
// is written down (after).

import { DEG, RAD } from "../geometry/angles.js";
import * as chains from "../geometry/chains.js";
import { numbered } from "../reading/numbers.js";
import { cause } from "./ranking.js";

const MILLIMETRES = 10; // a slide this long is in no metres
const WRITING = [
  "J.halves",
  "J.millimetres",
  "J.per degree",
  "J.all signs",
  "J.cross",
  "J.frame",
  "J.angular zero",
  "J.transposed",
];

/** @typedef {import("./ranking.js").Cause} Cause */
/** @typedef {{ right: number[], causes: Cause[], made: number[][] }} Catalogue */

// An arm at a pose, with its rows in the axes of one frame: what the catalogues are made from.
export function setting(arm, q, frame) {
  const here = chains.chain(arm, q);
  const T = chains.framesOf(here);
  const right = chains.columns(here, T);
  const seen = (J) => (frame ? chains.seenIn(J, T[frame]) : J);
  const unseen = (J) => (frame ? chains.seenFrom(J, T[frame]) : J);
  const befores = [...recipes(here), ...inUnits(here), ...inTables(arm, here)];
  const at = { arm, frame, here, T, right, seen, unseen, befores, afters: [] };
  at.afters = [...writings(at)];
  return at;
}

/** @returns {Catalogue} */
export function singles(at) {
  const made = [
    ...at.befores.map(([, J]) => at.seen(J)),
    ...at.afters.map(([, after]) => after(at.right)),
  ];
  return {
    right: at.seen(at.right),
    causes: [...at.befores, ...at.afters].map(([one]) => one),
    made,
  };
}

/**
 * Every pair of a mistake before and one in the writing; of two in the writing; and of a table with
 * a recipe.
 * @returns {Generator<[Cause[], number[]]>}
 */
export function* pairs(at) {
  for (const [second, after] of at.afters) {
    for (const [first, J] of at.befores) yield [[first, second], after(J)];
  }
  const written = at.afters.filter(([one]) => WRITING.includes(one.keys[0]));
  for (const [i, [first, one]] of written.entries()) {
    for (const [second, two] of written.slice(i + 1)) {
      yield [[first, second], one(at.unseen(two(at.right)))];
      yield [[first, second], two(at.unseen(one(at.right)))];
    }
  }
  const wrong = [...otherUnits(at.here), ...wrongTables(at.arm, at.here)];
  const all = wrong.map(([, other]) => [...recipes(other)]);
  for (const second of all[0].keys()) {
    for (const [k, [first]] of wrong.entries()) {
      yield [[first, all[k][second][0]], at.seen(all[k][second][1])];
    }
  }
}

// The recipe

// The Jacobian with one step of its recipe done otherwise, in base axes.
export function* recipes(c) {
  const T = chains.framesOf(c);
  const late = c.at.map((i) => i + 1);
  const [right, oneLate] = [
    chains.columns(c, T),
    chains.columns(c, T, { axis: late, origin: late }),
  ];
  yield [cause("J.z_i angular"), chains.halves(right, oneLate)];
  yield [cause("J.one frame late"), oneLate];
  yield [cause("J.z_i"), chains.columns(c, T, { axis: late })];
  if (c.at.some((i, k) => i !== k)) {
    const count = c.at.map((_, k) => k);
    yield [
      cause("J.z counted on angular"),
      chains.halves(right, chains.columns(c, T, { axis: count })),
    ];
    yield [cause("J.z counted on"), chains.columns(c, T, { axis: count, origin: count })];
  }
  yield [cause("J.origin late"), chains.columns(c, T, { origin: late })];
  yield [cause("J.lever tip"), chains.columns(c, T, { lever: "tip" })];
  yield [cause("J.lever origin"), chains.columns(c, T, { lever: "o" })];
  yield [cause("J.lever link"), chains.columns(c, T, { lever: "link" })];
  yield [cause("J.rows of T"), chains.columns(c, chains.rowsRead(T))];
  if (c.turns.includes(false))
    yield [cause("J.slide turns"), chains.columns(c, T, { slides: false })];
  for (let k = 0; k < T.length - 1; k++)
    yield [cause("J.point", { k }), chains.columns(c, T, { point: k })];
}

// q taken in degrees, and in radians where degrees were meant; and its slides in millimetres, or in
// metres where they are so long.
function otherUnits(c) {
  const changed = (key, turns, change) => [
    cause(key),
    { ...c, q: c.q.map((x, k) => (c.turns[k] === turns ? change(x) : x)) },
  ];
  const found = [(x) => x * RAD, (x) => x * DEG].map((change) =>
    changed("J.degrees", true, change),
  );
  if (c.turns.every(Boolean)) return found;
  const factor = c.q.some((x, k) => !c.turns[k] && Math.abs(x) > MILLIMETRES) ? 1e-3 : 1e3;
  return [...found, changed("ik.slide in millimetres", false, (x) => factor * x)];
}

const jacobian = (c) => chains.columns(c, chains.framesOf(c));
const inUnits = (c) => otherUnits(c).map(([one, other]) => [one, jacobian(other)]);

// The table

const inTables = (arm, c) => wrongTables(arm, c).map(([one, other]) => [one, jacobian(other)]);

// Usual mistakes in a table's numbers, whatever it is used for.
export function wrongTables(arm, c) {
  const found = [];
  const put = (key, fields, change) =>
    found.push([
      cause(key, fields),
      { ...c, rows: c.rows.map((row, i) => ({ ...row, ...change(row, i) })) },
    ]);
  if (arm.penless) put("table.pen", {}, (_, i) => ({ d: arm.penless.rows[i].d }));
  for (const { name, other, rows } of arm.alike ?? []) {
    put("table.length", { name, other }, (_, i) => ({ a: rows[i].a }));
  }
  for (const { name, rows } of arm.robots ?? [])
    put("table.robot", { name }, (_, i) => ({ a: rows[i].a, d: rows[i].d }));
  put("table.offsets", {}, (row) => (row.kind === "revolute" ? { theta: 0 } : {}));
  put("table.twists", {}, (row) => ({ alpha: -row.alpha }));
  c.rows.forEach((row, k) => {
    const one = (key, fields, entries) => put(key, fields, (_, i) => (i === k ? entries : {}));
    const at = { row: k + 1 };
    if (Math.abs(Math.sin(row.alpha)) > 1e-9) {
      one("table.twist", at, { alpha: -row.alpha });
      one("table.no twist", at, { alpha: 0 });
    }
    for (const column of ["a", "d"]) {
      if (!row[column]) continue;
      one("table.sign", { column, ...at }, { [column]: -row[column] });
      one("table.missing", { column, ...at }, { [column]: 0 });
    }
    if (row.theta) one("table.offset", at, { theta: 0 });
  });
  return found;
}

// The writing: each a function of a Jacobian in base axes to the declared frame's.

function* writings(at) {
  yield* entriesChanged(at);
  yield* columnsMoved(at);
  yield* framesMistaken(at);
}

// Each entry changed by its row and column.
function* entriesChanged({ arm, here: { dof, turns }, seen }) {
  const after = (change) => (J) => seen(J.map((x, i) => change(x, Math.floor(i / dof), i % dof)));
  const half = (v, w) => after((x, i) => x * (i < 3 ? v : w));
  const joint = numbered(arm);
  yield [cause("J.halves"), (J) => halvesExchanged(seen(J))];
  yield [cause("J.cross"), after((x, i, k) => (turns[k] && i < 3 ? -x : x))];
  yield [cause("J.all signs"), half(-1, -1)];
  yield [cause("J.angular sign"), half(1, -1)];
  yield [cause("J.millimetres"), half(1000, 1)];
  yield [cause("J.centimetres"), half(100, 1)];
  yield [cause("J.angular zero"), half(1, 0)];
  yield [cause("J.linear zero"), half(0, 1)];
  yield [cause("J.per degree"), after((x, _, k) => (turns[k] ? x * RAD : x))];
  yield [cause("J.per degree"), after((x, _, k) => (turns[k] ? x / RAD : x))];
  if (dof === 6) yield [cause("J.transposed"), (J) => chains.transposed(seen(J), [6, 6])];
  for (let one = 0; one < dof; one++) {
    yield [cause("J.column sign", { i: joint[one] }), after((x, _, k) => (k === one ? -x : x))];
  }
}

function* columnsMoved({ arm, here: { dof }, seen }) {
  const order = (from) => (J) => seen(J.map((_, i) => J[i - (i % dof) + from(i % dof)]));
  const joint = numbered(arm);
  yield [cause("J.reversed order"), order((k) => dof - 1 - k)];
  for (let i = 0; i < dof; i++) {
    for (let j = i + 1; j < dof; j++) {
      const exchanged = order((k) => (k === i ? j : k === j ? i : k));
      yield [cause("J.columns exchanged", { i: joint[i], j: joint[j] }), exchanged];
    }
  }
}

function* framesMistaken({ T, seen, frame }) {
  const last = T.length - 1;
  const frames = [last, ...T.keys()].filter((k, i) => (k !== last || !i) && k !== frame);
  for (const k of frames) {
    const fields = { k, _name: frameName(k), _wanted: frameName(frame) };
    yield [cause("J.frame", fields), (J) => chains.seenIn(J, T[k])];
    yield [
      cause("J.frame angular", fields),
      (J) => chains.halves(seen(J), chains.seenIn(J, T[k], [1])),
    ];
    yield [
      cause("J.frame linear", fields),
      (J) => chains.halves(chains.seenIn(J, T[k], [0]), seen(J)),
    ];
  }
  const back = frame || last;
  yield [cause("J.frame turned back", { _k: back }), (J) => chains.seenFrom(J, T[back])];
}

const halvesExchanged = (J) => [...J.slice(J.length / 2), ...J.slice(0, J.length / 2)];
const frameName = (k) => (k ? `frame ${k}` : "the base");
