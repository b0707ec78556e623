// Lists mistakes in a Jacobian. They are in its table or q (`change`), in the recipe (`recipe`), or
// in how it is written down (`write`). The comments name where a mistake was seen, which is a slip
// of homework.md by its number, a chapter, or work that was handed in.

import { jointNumbers } from "../geometry/kinematics.js";
import * as chains from "../geometry/chains.js";
import { listConfigurationMistakes, listTableMistakes } from "./chain.js";
import { cacheResults, makeCause } from "./ranking.js";

/** @typedef {import("../geometry/arm.js").Arm} Arm */
/** @typedef {import("../geometry/chains.js").Chain} Chain */
/** @typedef {import("../geometry/kinematics.js").Frame} Frame */
/** @typedef {import("./ranking.js").Cause} Cause */
/** @typedef {import("./ranking.js").Mistake} Mistake */
/** @typedef {(c: Chain, T: Frame[]) => number[]} Recipe makes a Jacobian of a chain */
/** @typedef {(J: number[], T: Frame[]) => number[]} Writing changes a finished Jacobian */
/**
 * A mistake in a Jacobian, with the step that it changes.
 * @typedef {{ cause: Cause, change?: (c: Chain) => Chain, recipe?: Recipe, write?: Writing }}
 *   JacobianStep
 */

/**
 * Return a maker of Jacobians. It takes the step done wrong, and returns a function from q to the
 * Jacobian there.
 * @param {Arm} arm
 * @param {number} frame whose axes the rows are in; 0 is the base
 * @returns {(step?: Partial<JacobianStep>) => (q: number[]) => number[]}
 */
export function makeJacobianMaker(arm, frame) {
  const buildersOf = cacheResults((change) =>
    cacheResults((recipe) => buildBy(arm, frame, change, recipe)),
  );
  return ({ change = keep, recipe = chains.flatJacobian, write = keep } = {}) => {
    const build = buildersOf(change)(recipe);
    return (q) => {
      const { J, T } = build(q);
      return write(J, T);
    };
  };
}

// Build the Jacobian before it is written down. The last one is kept, since many writings are tried
// on it.
function buildBy(arm, frame, change, recipe) {
  let [lastQ, lastResult] = [null, null];
  return (q) => {
    if (q === lastQ) return lastResult;
    const c = change(chains.makeChain(arm, q));
    const T = chains.chainFrames(c);
    const J = recipe(c, T);
    [lastQ, lastResult] = [
      q,
      { J: frame ? chains.rotateIntoFrame(J, T[frame] ?? T.at(-1)) : J, T },
    ];
    return lastResult;
  };
}

const keep = (x, ..._) => x;

/** List the mistakes. @param {Arm} arm @param {number[]} q @returns {JacobianStep[]} */
export function listJacobianSteps(arm, q, frame) {
  const c = chains.makeChain(arm, q);
  const changes = [...listConfigurationMistakes("J.degrees", arm), ...listTableMistakes(arm)];
  return [
    ...changes.map(([cause, change]) => ({ cause, change })),
    ...Array.from(listJacobianRecipes(c), ([cause, recipe]) => ({ cause, recipe })),
    ...Array.from(listWritingMistakes(arm, c, frame), ([cause, write]) => ({ cause, write })),
  ];
}

/**
 * List the recipes with a wrong step. The judges of Jacobians, torques and trajectories use this
 * list.
 * @param {Chain} c @returns {Generator<[Cause, Recipe]>}
 */
export function* listJacobianRecipes(c) {
  const withOptions = (options) => (chain, T) => chains.flatJacobian(chain, T, options(chain));
  const withAngularOptions = (options) => (chain, T) =>
    chains.joinHalves(chains.flatJacobian(chain, T), chains.flatJacobian(chain, T, options(chain)));
  const listNextFrames = ({ at }) => at.map((i) => i + 1);
  yield [
    makeCause("J.z_i angular"),
    withAngularOptions((chain) => ({ axis: listNextFrames(chain) })),
  ]; // slip 19
  // handed in
  yield [makeCause("J.z_0 angular"), withAngularOptions(({ at }) => ({ axis: at.map(() => 0) }))];
  // handed in
  yield [
    makeCause("J.one frame late"),
    withOptions((chain) => ({ axis: listNextFrames(chain), origin: listNextFrames(chain) })),
  ];
  // slip 19, in both halves
  yield [makeCause("J.z_i"), withOptions((chain) => ({ axis: listNextFrames(chain) }))];
  // handed in
  yield [makeCause("J.origin late"), withOptions((chain) => ({ origin: listNextFrames(chain) }))];
  yield [makeCause("J.lever tip"), withOptions(() => ({ subtracted: false }))]; // handed in
  yield [makeCause("J.no cross"), withOptions(() => ({ crossed: false }))]; // handed in
  const wrist = ({ rows }) => rows.length - 1; // handed in: the wrist's centre for the tip
  yield [makeCause("J.point", { k: wrist(c) }), withOptions((chain) => ({ point: wrist(chain) }))];
  // Modern Robotics: the velocity of the point of the tool that is at the base's origin
  yield [makeCause("J.space"), withOptions(() => ({ point: 0 }))];
  const fromRows = (chain, T) => chains.flatJacobian(chain, chains.swapRowsForColumns(T)); // slip 4
  yield [makeCause("J.rows of T"), fromRows];
  // handed in: z_2 over z_2
  if (c.turns.includes(false))
    yield [makeCause("J.slide angular"), withAngularOptions(() => ({ slides: false }))];
  yield* listWrongDeletions(c);
}

/**
 * List Jacobians of an arm with a locked joint that lack the column of another joint.
 * @param {Chain} c @returns {Generator<[Cause, Recipe]>}
 */
function* listWrongDeletions(c) {
  const allRows = c.rows.map((_, i) => i);
  for (const row of c.at.length < allRows.length ? c.at : []) {
    const at = allRows.filter((i) => i !== row); // handed in: column 4 deleted for column 3
    if (at.length !== c.dof) break;
    const without = (chain, T) =>
      chains.flatJacobian({ ...chain, at, turns: at.map(() => true) }, T);
    yield [makeCause("J.wrong column deleted", { column: row + 1 }), without];
  }
}

/**
 * List mistakes in writing down a Jacobian that is in the axes of the declared frame.
 * @param {Arm} arm @returns {Generator<[Cause, Writing]>}
 */
function* listWritingMistakes(arm, { dof, turns }, frame) {
  const changeEntries = (change) => (J) => J.map((x, i) => change(x, Math.floor(i / dof), i % dof));
  const scaleHalves = (v, w) => changeEntries((x, i) => x * (i < 3 ? v : w));
  const reorderColumns = (from) => (J) => J.map((_, i) => J[i - (i % dof) + from(i % dof)]);
  const reorderRows = (from) => (J) =>
    J.map((_, i) => J[from(Math.floor(i / dof)) * dof + (i % dof)]);
  yield [makeCause("J.halves"), reorderRows((i) => (i + 3) % 6)]; // conventions: (omega, v)
  // handed in
  yield [makeCause("J.cross"), changeEntries((x, i, k) => (turns[k] && i < 3 ? -x : x))];
  yield [makeCause("J.all signs"), scaleHalves(-1, -1)]; // handed in
  // slip 26: millimetres in a report in metres; the column of a slide has no unit
  yield [makeCause("J.millimetres"), changeEntries((x, i, k) => (turns[k] && i < 3 ? 1e3 * x : x))];
  if (turns.includes(false)) yield [makeCause("J.millimetres"), scaleHalves(1000, 1)];
  // half an answer, as a course marks it
  yield [makeCause("J.angular zero"), scaleHalves(1, 0)];
  yield [makeCause("J.linear zero"), scaleHalves(0, 1)];
  if (dof === 6) yield [makeCause("J.transposed"), (J) => chains.transpose(J, [6, 6])]; // handed in
  // joints named q6 ... q1
  yield [makeCause("J.reversed order"), reorderColumns((k) => dof - 1 - k)];
  yield* listFrameMistakes(arm, frame);
  const joint = jointNumbers(arm); // handed in: two joints exchanged
  for (let i = 0; i < dof; i++) {
    for (let j = i + 1; j < dof; j++) {
      const exchanged = reorderColumns((k) => (k === i ? j : k === j ? i : k));
      yield [makeCause("J.columns exchanged", { i: joint[i], j: joint[j] }), exchanged];
    }
    for (const j of [i - 1, i + 1].filter((n) => n in joint)) {
      const copied = reorderColumns((k) => (k === i ? j : k)); // handed in
      yield [makeCause("J.column of", { joint: joint[j], i: joint[i] }), copied];
    }
  }
}

/**
 * List the same Jacobian in the axes of the wrong frame, the tool's or the base's.
 * @param {Arm} arm @returns {Generator<[Cause, Writing]>}
 */
function* listFrameMistakes({ rows }, frame) {
  const last = rows.length;
  const toBase = (J, T) => (frame ? chains.rotateFromFrame(J, T[frame]) : J);
  for (const k of [last, 0].filter((k) => k !== frame)) {
    const fields = { k, _name: describeFrame(k), _wanted: describeFrame(frame) };
    const rotated = (J, T) => chains.rotateIntoFrame(toBase(J, T), k ? T.at(-1) : T[0]);
    yield [makeCause("J.frame", fields), rotated]; // handed in
  }
}

const describeFrame = (k) => (k ? `frame ${k}` : "the base");
