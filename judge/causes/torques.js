// The slips that are known in torques tau = g(q) - J^T F: in the table, q or the masses (`change`),
// in the weight, in the force, and in how they are written down (`write`). Behind each, where it
// was seen: a slip's number in homework.md, a chapter, or work that was handed in.

import * as chains from "../geometry/chains.js";
import { movingRows } from "../geometry/kinematics.js";
import { subtractEach } from "../geometry/linear.js";
import { rowsOf } from "../reading/numbers.js";
import { makerJointSigns, poseMistakes, tableMistakes } from "./tables.js";
import { combineCauses, makeCause } from "./ranking.js";

/**
 * An arm with masses under gravity (m/s^2, a vector) and a wrench for each of its poses.
 * @typedef {object} Load
 * @property {import("../geometry/chains.js").Chain} c rows and joints, at no pose yet
 * @property {number[][]} wrenches
 * @property {number[]} gravity
 * @property {number[]} masses of each row
 * @property {number[][]} centres
 */
/**
 * An arm with masses at one pose: its frames and its Jacobian.
 * @typedef {Load & { T: any[], J: number[], F: number[] }} Pose
 */
/**
 * One mistake: each of its steps is there if it is done otherwise.
 * @typedef {{ cause: import("./ranking.js").Cause, change?: (load: Load) => Load, weight?: (at:
 *   Pose) => number[], force?: (at: Pose) => number[], write?: (tau: number[]) => number[] }} Step
 */

const same = (x) => x;
const times = (factor, list) => list.map((x) => factor * x);

const weightOf = ({ c, T, masses, centres, gravity }) =>
  chains.gravityTorques(c, T, masses, centres, gravity);
const forceOf = ({ J, F }) => chains.wrenchTorques(J, F);

/** @returns {Load} */
export function makeLoad(arm, wrenches, gravity) {
  const bodies = arm.rows.map((row) => row.body);
  const [masses, centres] = [bodies.map(([mass]) => mass), bodies.map(([, ...centre]) => centre)];
  return {
    c: chains.makeChain(
      arm,
      movingRows(arm).map(() => 0),
    ),
    wrenches,
    gravity,
    masses,
    centres,
  };
}

// Torques at the poses of a list of joint values, by steps some of which are wrong.
export const makeTorques =
  (load, dof, { change = same, weight = weightOf, force = forceOf, write = same } = {}) =>
  (q) =>
    rowsOf(q, dof).flatMap((one, i) => {
      const at = atPose(change({ ...load, c: { ...load.c, q: one, dof } }), load.wrenches[i]);
      return write(subtractEach(weight(at), force(at)));
    });

function atPose(load, F) {
  const T = chains.chainFrames(load.c);
  return { ...load, T, J: chains.flatJacobian(load.c, T), F };
}

/** @returns {Step[]} */
export const listTorqueSteps = (arm, load) => [
  ...bodies(arm, load),
  ...chainsOf(arm),
  ...weights(load),
  ...forces(load),
  ...writings(arm),
];

// Slips in the table or q; without the pen the last centre of mass stays where it is, so that its
// coordinates change.
/** @returns {Step[]} */
function chainsOf(arm) {
  const tables = tableMistakes(arm).filter(
    ([
      {
        keys: [key],
      },
    ]) => key !== "table.locked row",
  );
  const centres = arm.penless?.rows.map((row) => row.body?.slice(1));
  return [...poseMistakes("tau.degrees", arm), ...tables].map(([one, change]) => ({
    cause: one,
    change: (load) => ({
      ...load,
      c: change(load.c),
      centres: one.keys[0] === "table.pen" ? centres : load.centres,
    }),
  }));
}

/** One slip each. @returns {(import("./ranking.js").Mistake & { steps: any })[]} */
export const singleMistakes = (load, dof, all) =>
  all.map((one) => ({ cause: one.cause, steps: one, make: makeTorques(load, dof, one) }));

/**
 * Two slips in different steps, or two changes.
 * @returns {Generator<import("./ranking.js").Mistake & { steps: any }>}
 */
export function* mistakePairs(load, dof, all) {
  for (const [n, first] of all.entries()) {
    for (const second of all.slice(n + 1)) {
      if (["weight", "force", "write"].some((step) => first[step] && second[step])) continue;
      const [one, other] = [first, second].map(({ change: its = same }) => its);
      const change = (at) => other(one(at));
      const two = { ...first, ...second, change };
      yield {
        cause: combineCauses(first.cause, second.cause),
        steps: two,
        make: makeTorques(load, dof, two),
      };
    }
  }
}

/** @returns {Generator<Step>} */
function* writings(arm) {
  yield { cause: makeCause("tau.all signs"), write: (tau) => times(-1, tau) }; // handed in
  // tau_7 first
  yield { cause: makeCause("tau.reversed order"), write: (tau) => [...tau].reverse() };
  const signs = makerJointSigns(arm); // as Pinocchio's model has them
  if (signs)
    yield { cause: makeCause("tau.makers signs"), write: (tau) => tau.map((x, k) => signs[k] * x) };
}

// What each joint's own link weighs, without those behind it.
function ownLinks(at) {
  const alone = at.masses.map((_, i) => at.masses.map((mass, k) => (k === i ? mass : 0)));
  return at.c.at.map((row, k) => weightOf({ ...at, masses: alone[row] })[k]);
}

/** @returns {Generator<Step>} */
function* weights({ c }) {
  yield { cause: makeCause("tau.own link"), weight: ownLinks }; // handed in
  yield { cause: makeCause("tau.weight missing"), weight: () => c.at.map(() => 0) }; // handed in
  yield { cause: makeCause("tau.weight sign"), weight: (at) => times(-1, weightOf(at)) }; // slip 24
}

/** @returns {Generator<Step>} */
function* forces({ wrenches, c: { dof } }) {
  if (!wrenches.some((F) => F.some(Boolean))) return;
  const by = (change) => (at) => chains.wrenchTorques(at.J, change(at.F, at.T.at(-1)));
  yield { cause: makeCause("tau.force sign"), force: by((F) => times(-1, F)) }; // section 4
  yield { cause: makeCause("tau.force missing"), force: by((F) => times(0, F)) }; // half an answer
  const tool = by((F, T) => chains.wrenchFromFrame(T, F));
  yield { cause: makeCause("tau.force in tool"), force: tool }; // handed in
  const across = ({ J, F, c }) => chains.wrenchTorques(chains.transpose(J, [c.dof, 6]), F);
  if (dof === 6) yield { cause: makeCause("tau.J for J^T"), force: across }; // handed in
  const late = ({ at }) => at.map((row) => row + 1);
  const recipe =
    (options) =>
    ({ c, T, F }) =>
      chains.wrenchTorques(chains.flatJacobian(c, T, options(c)), F);
  yield { cause: makeCause("J.z_i"), force: recipe((c) => ({ axis: late(c) })) }; // slip 19
  // handed in
  yield { cause: makeCause("J.origin late"), force: recipe((c) => ({ origin: late(c) })) };
  const frame = recipe((c) => ({ axis: late(c), origin: late(c) }));
  yield { cause: makeCause("J.one frame late"), force: frame }; // handed in
}

/** Masses, centres and g. @returns {Generator<Step>} */
function* bodies(arm, load) {
  const put = (key, change, fields = {}) => ({ cause: makeCause(key, fields), change });
  const g = Math.hypot(...load.gravity);
  const under = (other) => ({ gravity: times(other / (g || 1), load.gravity) });
  for (const other of [9.8, 10]) {
    // slip 8; handed in
    if (g && Math.abs(g - other) > 1e-9)
      yield put("tau.gravity", (at) => ({ ...at, ...under(other) }), { g: other });
  }
  yield* masses(arm, load, put);
  yield* centres(arm, load, put);
  if (arm.rows.length === 7 && arm.rows[2].d) {
    // the Panda report's model
    yield put("tau.lumped", lumped);
    yield put("tau.report", (at) => ({ ...lumped(at), ...under(9.8) }));
  }
}

function* masses(arm, { masses: all }, put) {
  const by = (change) => (at) => ({ ...at, masses: at.masses.map(change) });
  yield put(
    "tau.grams",
    by((mass) => 1000 * mass),
  ); // handed in
  for (const step of [1, -1]) {
    const moved = by((_, k) => all[k + step] ?? 0); // handed in
    yield put("tau.masses moved", moved);
  }
  const other = (arm.robots ?? []).find((one) => one.masses);
  if (other)
    yield put(
      "tau.robot",
      by((_, k) => other.masses[k]),
      { name: other.name },
    ); // section 4
  for (const i of all.keys()) {
    const link = i + 1;
    if (all[i])
      yield put(
        "tau.mass missing",
        by((mass, k) => (k === i ? 0 : mass)),
        { link },
      );
    if (link === all.length) continue;
    const exchanged = by((_, k) => all[k === i ? link : k === link ? i : k]); // handed in
    yield put("tau.masses exchanged", exchanged, { i: link, j: link + 1 });
  }
}

function* centres(arm, { centres: all }, put) {
  const set = (key, list, fields = {}) => put(key, (at) => ({ ...at, centres: list }), fields);
  if (arm.paper) yield set("tau.paper centres", arm.paper); // slip 7
  yield set(
    "tau.centres at origins",
    all.map(() => [0, 0, 0]),
  ); // handed in
  for (const { name, other, rows } of arm.alike ?? []) {
    // handed in: a centre in the paper's frame less the other length
    const shifted = all.map(([x, y, z], i) => [x + arm.rows[i].a - rows[i].a, y, z]);
    yield set("tau.centres other length", shifted, { name, other });
  }
}

// Links 2 and 3 as one uniform bar up the upper arm, which the report has so.
function lumped(load) {
  const half = load.c.rows[2].d / 2;
  const [, second, third] = load.masses;
  return {
    ...load,
    masses: load.masses.map((mass, i) => [mass, second + third, 0][i] ?? mass),
    centres: load.centres.map((centre, i) => (i === 1 ? [0, 0, half] : centre)),
  };
}
