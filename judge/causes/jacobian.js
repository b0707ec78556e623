// Lists mistakes in a Jacobian. They are in its table or q (`change`), in the recipe (`recipe`), or
// in how it is written down (`write`). The comments name where a mistake was seen, which is a slip
// of homework.md by its number, a chapter, or work that was handed in.

import { jointNumbers } from "../geometry/kinematics.js";
import * as chains from "../geometry/chains.js";
import { listTableMistakes } from "./chain.js";
import { listConfigurationMistakes } from "./joints.js";
import { cacheResults, keep, makeCause } from "./ranking.js";

/** @typedef {import("../geometry/arm.js").Arm} Arm */
/** @typedef {import("../geometry/chains.js").Chain} Chain */
/** @typedef {import("../geometry/kinematics.js").Frame} Frame */
/** @typedef {import("./ranking.js").Cause} Cause */
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

// Build the Jacobian to which mistakes in writing it down are applied. The last result is cached,
// since many such mistakes are tried.
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

/** List the mistakes. @param {Arm} arm @param {number[]} q @returns {JacobianStep[]} */
export function listJacobianSteps(arm, q, frame) {
  const c = chains.makeChain(arm, q);
  return [
    ...listConfigurationMistakes("J.degrees", arm),
    ...listTableMistakes(arm),
    ...listJacobianRecipes(c),
    ...listWritingMistakes(arm, c, frame),
  ];
}

/**
 * List the recipes with a wrong step. The judges of Jacobians, torques and trajectories use this
 * list.
 * @param {Chain} c @returns {Generator<{ cause: Cause, recipe: Recipe }>}
 */
export function* listJacobianRecipes(c) {
  const makeMistake = (key, recipe, fields = {}) => ({ cause: makeCause(key, fields), recipe });
  const withOptions = (key, options, fields = {}) =>
    makeMistake(key, (chain, T) => chains.flatJacobian(chain, T, options(chain)), fields);
  const withAngularOptions = (key, options) =>
    makeMistake(key, (chain, T) =>
      chains.joinHalves(
        chains.flatJacobian(chain, T),
        chains.flatJacobian(chain, T, options(chain)),
      ),
    );
  const next = ({ at }) => at.map((i) => i + 1); // the frame after each joint's
  yield withAngularOptions("J.z_i angular", (chain) => ({ axis: next(chain) })); // slip 19
  yield withAngularOptions("J.z_0 angular", ({ at }) => ({ axis: at.map(() => 0) })); // handed in
  // handed in
  yield withOptions("J.one frame late", (chain) => ({ axis: next(chain), origin: next(chain) }));
  yield withOptions("J.z_i", (chain) => ({ axis: next(chain) })); // slip 19, in both halves
  yield withOptions("J.origin late", (chain) => ({ origin: next(chain) })); // handed in
  yield withOptions("J.lever tip", () => ({ subtracted: false })); // handed in
  yield withOptions("J.no cross", () => ({ crossed: false })); // handed in
  const wrist = ({ rows }) => rows.length - 1; // handed in: the wrist's centre for the tip
  yield withOptions("J.point", (chain) => ({ point: wrist(chain) }), { k: wrist(c) });
  // Modern Robotics: the velocity of the point of the tool that is at the base's origin
  yield withOptions("J.space", () => ({ point: 0 }));
  const fromRows = (chain, T) => chains.flatJacobian(chain, chains.swapRowsForColumns(T));
  yield makeMistake("J.rows of T", fromRows); // slip 4
  // handed in: z_2 over z_2
  if (c.turns.includes(false))
    yield withAngularOptions("J.slide angular", () => ({ slides: false }));
  yield* listWrongDeletions(c);
}

/**
 * List Jacobians of an arm with a locked joint that lack the column of another joint.
 * @param {Chain} c @returns {Generator<{ cause: Cause, recipe: Recipe }>}
 */
function* listWrongDeletions(c) {
  const allRows = c.rows.map((_, i) => i);
  for (const row of c.at.length < allRows.length ? c.at : []) {
    const at = allRows.filter((i) => i !== row); // handed in: column 4 deleted for column 3
    if (at.length !== c.dof) break;
    const recipe = (chain, T) =>
      chains.flatJacobian({ ...chain, at, turns: at.map(() => true) }, T);
    yield { cause: makeCause("J.wrong column deleted", { column: row + 1 }), recipe };
  }
}

/**
 * List mistakes in writing down a Jacobian that is in the axes of the declared frame.
 * @param {Arm} arm @returns {Generator<{ cause: Cause, write: Writing }>}
 */
function* listWritingMistakes(arm, { dof, turns }, frame) {
  const changeEntries = (change) => (J) => J.map((x, i) => change(x, Math.floor(i / dof), i % dof));
  const scaleHalves = (v, w) => changeEntries((x, i) => x * (i < 3 ? v : w));
  const reorderColumns = (from) => (J) => J.map((_, i) => J[i - (i % dof) + from(i % dof)]);
  const reorderRows = (from) => (J) =>
    J.map((_, i) => J[from(Math.floor(i / dof)) * dof + (i % dof)]);
  const makeMistake = (key, write, fields = {}) => ({ cause: makeCause(key, fields), write });
  yield makeMistake(
    "J.halves",
    reorderRows((i) => (i + 3) % 6),
  ); // conventions: (omega, v)
  // handed in
  yield makeMistake(
    "J.cross",
    changeEntries((x, i, k) => (turns[k] && i < 3 ? -x : x)),
  );
  yield makeMistake("J.all signs", scaleHalves(-1, -1)); // handed in
  // slip 26: millimetres in a report in metres; the column of a slide has no unit
  const inMillimetres = changeEntries((x, i, k) => (turns[k] && i < 3 ? 1e3 * x : x));
  yield makeMistake("J.millimetres", inMillimetres);
  if (turns.includes(false)) yield makeMistake("J.millimetres", scaleHalves(1000, 1));
  // half an answer, as a course marks it
  yield makeMistake("J.angular zero", scaleHalves(1, 0));
  yield makeMistake("J.linear zero", scaleHalves(0, 1));
  if (dof === 6) yield makeMistake("J.transposed", (J) => chains.transpose(J, [6, 6])); // handed in
  // joints named q6 ... q1
  yield makeMistake(
    "J.reversed order",
    reorderColumns((k) => dof - 1 - k),
  );
  yield* listFrameMistakes(arm, frame);
  const joint = jointNumbers(arm); // handed in: two joints exchanged
  for (let i = 0; i < dof; i++) {
    for (let j = i + 1; j < dof; j++) {
      const exchanged = reorderColumns((k) => (k === i ? j : k === j ? i : k));
      yield makeMistake("J.columns exchanged", exchanged, { i: joint[i], j: joint[j] });
    }
    for (const j of [i - 1, i + 1].filter((n) => n in joint)) {
      const copied = reorderColumns((k) => (k === i ? j : k)); // handed in
      yield makeMistake("J.column of", copied, { joint: joint[j], i: joint[i] });
    }
  }
}

/**
 * List the same Jacobian in the axes of the wrong frame, the tool's or the base's.
 * @param {Arm} arm @returns {Generator<{ cause: Cause, write: Writing }>}
 */
function* listFrameMistakes({ rows }, frame) {
  const last = rows.length;
  const toBase = (J, T) => (frame ? chains.rotateFromFrame(J, T[frame]) : J);
  for (const k of [last, 0].filter((k) => k !== frame)) {
    const fields = { k, _name: describeFrame(k), _wanted: describeFrame(frame) };
    const write = (J, T) => chains.rotateIntoFrame(toBase(J, T), k ? T.at(-1) : T[0]);
    yield { cause: makeCause("J.frame", fields), write }; // handed in
  }
}

const describeFrame = (k) => (k ? `frame ${k}` : "the base");
