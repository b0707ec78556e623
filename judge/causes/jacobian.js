// The slips that are known in a Jacobian: in the table or q it is made from (`change`), in the
// recipe (`recipe`), and in how it is written down (`write`). Behind each, where it was seen: a
// slip's number in homework.md, a chapter, or work that was handed in.

import { jointNumbers } from "../geometry/kinematics.js";
import { RAD } from "../geometry/angles.js";
import * as chains from "../geometry/chains.js";
import { poseMistakes, tableMistakes } from "./tables.js";
import { combineCauses, makeCause } from "./ranking.js";

/** @typedef {import("./ranking.js").Cause} Cause */
/** @typedef {import("../geometry/chains.js").Chain} Chain */
/**
 * One mistake: each of its steps is there if it is done otherwise.
 * @typedef {{ cause: Cause, change?: (c: Chain) => Chain, recipe?: (c: Chain, T: any[]) =>
 *   number[], write?: (J: number[], T: any[]) => number[] }} Step
 */

// A Jacobian with its rows in the axes of one frame, of any q, by steps some of which are wrong.
export const makeJacobian =
  (arm, frame, step = {}, built = builtBy(arm, frame, step)) =>
  (q) => {
    const { J, T } = built(q);
    return (step.write ?? same)(J, T);
  };

// What a step's table and recipe make of q, before it is written down; the last is kept, since
// many a writing is tried of it.
function builtBy(arm, frame, { change = same, recipe = chains.flatJacobian }) {
  let [last, made] = [null, null];
  return (q) => {
    if (q === last) return made;
    const c = change(chains.makeChain(arm, q));
    const T = chains.chainFrames(c);
    const J = recipe(c, T);
    [last, made] = [q, { J: frame ? chains.rotateIntoFrame(J, T[frame] ?? T.at(-1)) : J, T }];
    return made;
  };
}

const same = (x, ..._) => x;

/** @returns {Step[]} */
export function listJacobianSteps(arm, q, frame) {
  const c = chains.makeChain(arm, q);
  const changes = [...poseMistakes("J.degrees", arm), ...tableMistakes(arm)];
  return [
    ...changes.map(([one, change]) => ({ cause: one, change })),
    ...Array.from(jacobianRecipes(c), ([one, recipe]) => ({ cause: one, recipe })),
    ...Array.from(writings(arm, c, frame), ([one, write]) => ({ cause: one, write })),
  ];
}

/** One slip each. @returns {import("./ranking.js").Mistake[]} */
export const singleMistakes = (arm, frame, all) =>
  all.map((one) => ({ cause: one.cause, make: makeJacobian(arm, frame, one) }));

/**
 * One column that is another joint's: the column beside it, copied.
 * @returns {Generator<import("./ranking.js").Mistake>}
 */
export function* copiedColumns(arm, frame) {
  const right = makeJacobian(arm, frame);
  const joint = jointNumbers(arm);
  for (const k of joint.keys())
    for (const n of [k - 1, k + 1].filter((one) => one in joint)) {
      const make = (q) => {
        const J = right(q);
        return J.map((x, i) => (i % joint.length === k ? J[i - k + n] : x));
      };
      yield { cause: makeCause("J.column of", { joint: joint[n], i: joint[k] }), make };
    }
}

/**
 * Two slips, of which no more than one is in the recipe.
 * @returns {Generator<import("./ranking.js").Mistake>}
 */
export function* mistakePairs(arm, frame, all) {
  for (const [n, first] of all.entries()) {
    const built = builtBy(arm, frame, first);
    for (const second of all.slice(n + 1)) {
      const two = joined(first, second);
      if (!two) continue;
      const make = makeJacobian(arm, frame, two, second.write ? built : undefined);
      yield { cause: combineCauses(first.cause, second.cause), make };
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
export function* jacobianRecipes(c) {
  const by = (options) => (c1, T) => chains.flatJacobian(c1, T, options(c1));
  const angular = (options) => (c1, T) =>
    chains.joinHalves(chains.flatJacobian(c1, T), chains.flatJacobian(c1, T, options(c1)));
  const late = ({ at }) => at.map((i) => i + 1);
  yield [makeCause("J.z_i angular"), angular((c1) => ({ axis: late(c1) }))]; // slip 19
  yield [makeCause("J.z_0 angular"), angular(({ at }) => ({ axis: at.map(() => 0) }))]; // handed in
  // handed in
  yield [makeCause("J.one frame late"), by((c1) => ({ axis: late(c1), origin: late(c1) }))];
  yield [makeCause("J.z_i"), by((c1) => ({ axis: late(c1) }))]; // slip 19, in both halves
  yield [makeCause("J.origin late"), by((c1) => ({ origin: late(c1) }))]; // handed in
  yield [makeCause("J.lever tip"), by(() => ({ subtracted: false }))]; // handed in
  yield [makeCause("J.no cross"), by(() => ({ crossed: false }))]; // handed in
  const wrist = ({ rows }) => rows.length - 1; // handed in: the wrist's centre for the tip
  yield [makeCause("J.point", { k: wrist(c) }), by((c1) => ({ point: wrist(c1) }))];
  yield [
    makeCause("J.rows of T"),
    (c1, T) => chains.flatJacobian(c1, chains.swapRowsForColumns(T)),
  ]; // slip 4
  if (c.turns.includes(false)) {
    // handed in: z_2 x ... over z_2, and z_2 over z_2
    yield [makeCause("J.slide turns"), by(() => ({ slides: false }))];
    yield [makeCause("J.slide angular"), angular(() => ({ slides: false }))];
  }
  const every = c.rows.map((_, i) => i);
  for (const row of c.at.length < every.length ? c.at : []) {
    const at = every.filter((i) => i !== row); // handed in: column 4 deleted for column 3
    if (at.length !== c.dof) break;
    const without = (c1, T) => chains.flatJacobian({ ...c1, at, turns: at.map(() => true) }, T);
    yield [makeCause("J.wrong column deleted", { column: row + 1 }), without];
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
  yield [makeCause("J.halves"), rows((i) => (i + 3) % 6)]; // conventions: (omega, v)
  yield [makeCause("J.wx and wy"), rows((i) => [0, 1, 2, 4, 3, 5][i])]; // handed in
  yield [makeCause("J.cross"), each((x, i, k) => (turns[k] && i < 3 ? -x : x))]; // handed in
  yield [makeCause("J.all signs"), blocks(-1, -1)]; // handed in
  yield [makeCause("J.angular sign"), blocks(1, -1)]; // handed in
  yield [makeCause("J.millimetres"), blocks(1000, 1)]; // slip 26: millimetres in a report in metres
  yield [makeCause("J.angular zero"), blocks(1, 0)]; // half an answer
  yield [makeCause("J.linear zero"), blocks(0, 1)];
  yield [makeCause("J.per degree"), each((x, _, k) => (turns[k] ? x * RAD : x))]; // handed in
  if (dof === 6) yield [makeCause("J.transposed"), (J) => chains.transpose(J, [6, 6])]; // handed in
  yield [makeCause("J.reversed order"), order((k) => dof - 1 - k)]; // joints named q6 ... q1
  yield* framesMistaken(arm, frame);
  const joint = jointNumbers(arm); // handed in: two joints exchanged
  for (let i = 0; i < dof; i++) {
    for (let j = i + 1; j < dof; j++) {
      const exchanged = order((k) => (k === i ? j : k === j ? i : k));
      yield [makeCause("J.columns exchanged", { i: joint[i], j: joint[j] }), exchanged];
    }
  }
}

/**
 * Rows in the axes of another frame, the tool's or the base's.
 * @returns {Generator<[Cause, (J: number[], T: any[]) => number[]]>}
 */
function* framesMistaken({ rows }, frame) {
  const last = rows.length;
  const based = (J, T) => (frame ? chains.rotateFromFrame(J, T[frame]) : J);
  for (const k of [last, 0].filter((one) => one !== frame)) {
    const fields = { k, _name: frameName(k), _wanted: frameName(frame) };
    const seen = (J, T) => chains.rotateIntoFrame(based(J, T), k ? T.at(-1) : T[0]);
    yield [makeCause("J.frame", fields), seen]; // handed in
  }
}

const frameName = (k) => (k ? `frame ${k}` : "the base");
