// The slips that are known in a Jacobian: in the table or q it is made from (`change`), in the
// recipe (`recipe`), and in how it is written down (`write`). Behind each, where it was seen: a
// slip's number in homework.md, a chapter, or work that was handed in.

import { numbered } from "../geometry/kinematics.js";
import { RAD } from "../geometry/angles.js";
import * as chains from "../geometry/chains.js";
import { otherPoses, wrongTables } from "./tables.js";
import { both, cause } from "./ranking.js";

/** @typedef {import("./ranking.js").Cause} Cause */
/** @typedef {import("../geometry/chains.js").Chain} Chain */
/**
 * One mistake: each of its steps is there if it is done otherwise.
 * @typedef {{ cause: Cause, change?: (c: Chain) => Chain, recipe?: (c: Chain, T: any[]) =>
 *   number[], write?: (J: number[], T: any[]) => number[] }} Step
 */

// A Jacobian with its rows in the axes of one frame, of any q, by steps some of which are wrong.
export const jacobianOf =
  (arm, frame, step = {}, built = builtBy(arm, frame, step)) =>
  (q) => {
    const { J, T } = built(q);
    return (step.write ?? same)(J, T);
  };

// What a step's table and recipe make of q, before it is written down; the last is kept, since
// many a writing is tried of it.
function builtBy(arm, frame, { change = same, recipe = chains.columns }) {
  let [last, made] = [null, null];
  return (q) => {
    if (q === last) return made;
    const c = change(chains.chain(arm, q));
    const T = chains.framesOf(c);
    const J = recipe(c, T);
    [last, made] = [q, { J: frame ? chains.seenIn(J, T[frame] ?? T.at(-1)) : J, T }];
    return made;
  };
}

const same = (x, ..._) => x;

/** @returns {Step[]} */
export function steps(arm, q, frame) {
  const c = chains.chain(arm, q);
  const changes = [...otherPoses("J.degrees", arm), ...wrongTables(arm)];
  return [
    ...changes.map(([one, change]) => ({ cause: one, change })),
    ...Array.from(recipes(c), ([one, recipe]) => ({ cause: one, recipe })),
    ...Array.from(writings(arm, c, frame), ([one, write]) => ({ cause: one, write })),
  ];
}

/** One slip each. @returns {import("./ranking.js").Slip[]} */
export const single = (arm, frame, all) =>
  all.map((one) => ({ cause: one.cause, make: jacobianOf(arm, frame, one) }));

/**
 * One column that is another joint's: the column beside it, copied.
 * @returns {Generator<import("./ranking.js").Slip>}
 */
export function* copies(arm, frame) {
  const right = jacobianOf(arm, frame);
  const joint = numbered(arm);
  for (const k of joint.keys())
    for (const n of [k - 1, k + 1].filter((one) => one in joint)) {
      const make = (q) => {
        const J = right(q);
        return J.map((x, i) => (i % joint.length === k ? J[i - k + n] : x));
      };
      yield { cause: cause("J.column of", { joint: joint[n], i: joint[k] }), make };
    }
}

/**
 * Two slips, of which no more than one is in the recipe.
 * @returns {Generator<import("./ranking.js").Slip>}
 */
export function* pairs(arm, frame, all) {
  for (const [n, first] of all.entries()) {
    const built = builtBy(arm, frame, first);
    for (const second of all.slice(n + 1)) {
      const two = joined(first, second);
      if (!two) continue;
      const make = jacobianOf(arm, frame, two, second.write ? built : undefined);
      yield { cause: both(first.cause, second.cause), make };
    }
  }
}

function joined(first, second) {
  if (first.recipe && second.recipe) return null;
  return {
    ...first,
    ...second,
    change: after(first.change, second.change),
    write: after(first.write, second.write),
  };
}

const after = (one, two) => (one && two ? (x, T) => two(one(x, T), T) : (one ?? two));

/**
 * The recipe, with one step done otherwise.
 * @returns {Generator<[Cause, (c: Chain, T: any[]) => number[]]>}
 */
export function* recipes(c) {
  const by = (options) => (c1, T) => chains.columns(c1, T, options(c1));
  const angular = (options) => (c1, T) =>
    chains.halves(chains.columns(c1, T), chains.columns(c1, T, options(c1)));
  const late = ({ at }) => at.map((i) => i + 1);
  yield [cause("J.z_i angular"), angular((c1) => ({ axis: late(c1) }))]; // slip 19
  yield [cause("J.z_0 angular"), angular(({ at }) => ({ axis: at.map(() => 0) }))]; // handed in
  // handed in
  yield [cause("J.one frame late"), by((c1) => ({ axis: late(c1), origin: late(c1) }))];
  yield [cause("J.z_i"), by((c1) => ({ axis: late(c1) }))]; // slip 19, in both halves
  yield [cause("J.origin late"), by((c1) => ({ origin: late(c1) }))]; // handed in
  yield [cause("J.lever tip"), by(() => ({ subtracted: false }))]; // handed in
  yield [cause("J.no cross"), by(() => ({ crossed: false }))]; // handed in
  const wrist = ({ rows }) => rows.length - 1; // handed in: the wrist's centre for the tip
  yield [cause("J.point", { k: wrist(c) }), by((c1) => ({ point: wrist(c1) }))];
  yield [cause("J.rows of T"), (c1, T) => chains.columns(c1, chains.rowsRead(T))]; // slip 4
  if (c.turns.includes(false)) {
    // handed in: z_2 x ... over z_2, and z_2 over z_2
    yield [cause("J.slide turns"), by(() => ({ slides: false }))];
    yield [cause("J.slide angular"), angular(() => ({ slides: false }))];
  }
  const every = c.rows.map((_, i) => i);
  for (const row of c.at.length < every.length ? c.at : []) {
    const at = every.filter((i) => i !== row); // handed in: column 4 deleted for column 3
    if (at.length !== c.dof) break;
    const without = (c1, T) => chains.columns({ ...c1, at, turns: at.map(() => true) }, T);
    yield [cause("J.wrong column deleted", { column: row + 1 }), without];
  }
}

/**
 * The writing: functions of a Jacobian in the axes of the declared frame.
 * @returns {Generator<[Cause, (J: number[], T: any[]) => number[]]>}
 */
function* writings(arm, { dof, turns }, frame) {
  const each = (change) => (J) => J.map((x, i) => change(x, Math.floor(i / dof), i % dof));
  const blocks = (v, w) => each((x, i) => x * (i < 3 ? v : w));
  const order = (from) => (J) => J.map((_, i) => J[i - (i % dof) + from(i % dof)]);
  const rows = (from) => (J) => J.map((_, i) => J[from(Math.floor(i / dof)) * dof + (i % dof)]);
  yield [cause("J.halves"), rows((i) => (i + 3) % 6)]; // conventions: (omega, v)
  yield [cause("J.wx and wy"), rows((i) => [0, 1, 2, 4, 3, 5][i])]; // handed in
  yield [cause("J.cross"), each((x, i, k) => (turns[k] && i < 3 ? -x : x))]; // handed in
  yield [cause("J.all signs"), blocks(-1, -1)]; // handed in
  yield [cause("J.angular sign"), blocks(1, -1)]; // handed in
  yield [cause("J.millimetres"), blocks(1000, 1)]; // slip 26: millimetres in a report in metres
  yield [cause("J.angular zero"), blocks(1, 0)]; // half an answer
  yield [cause("J.linear zero"), blocks(0, 1)];
  yield [cause("J.per degree"), each((x, _, k) => (turns[k] ? x * RAD : x))]; // handed in
  if (dof === 6) yield [cause("J.transposed"), (J) => chains.transposed(J, [6, 6])]; // handed in
  yield [cause("J.reversed order"), order((k) => dof - 1 - k)]; // joints named q6 ... q1
  yield* framesMistaken(arm, frame);
  const joint = numbered(arm); // handed in: two joints exchanged
  for (let i = 0; i < dof; i++) {
    for (let j = i + 1; j < dof; j++) {
      const exchanged = order((k) => (k === i ? j : k === j ? i : k));
      yield [cause("J.columns exchanged", { i: joint[i], j: joint[j] }), exchanged];
    }
  }
}

/**
 * Rows in the axes of another frame, the tool's or the base's.
 * @returns {Generator<[Cause, (J: number[], T: any[]) => number[]]>}
 */
function* framesMistaken({ rows }, frame) {
  const last = rows.length;
  const based = (J, T) => (frame ? chains.seenFrom(J, T[frame]) : J);
  for (const k of [last, 0].filter((one) => one !== frame)) {
    const fields = { k, _name: frameName(k), _wanted: frameName(frame) };
    const seen = (J, T) => chains.seenIn(based(J, T), k ? T.at(-1) : T[0]);
    yield [cause("J.frame", fields), seen]; // handed in
  }
}

const frameName = (k) => (k ? `frame ${k}` : "the base");
