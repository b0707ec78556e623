// Lists mistakes in joint torques tau = g(q) - J^T F. They are in the load (table, q or masses), in
// the weight g, in the force J^T F, or in how torques are written down. The comments name where a
// mistake was seen, which is a slip of homework.md by its number, a section of it, or work that was
// handed in.

import * as chains from "../geometry/chains.js";
import { jointNumbers, movingRows } from "../geometry/kinematics.js";
import { splitIntoRows, subtractEach } from "../geometry/linear.js";
import { formatNumber, joinList } from "../sentences.js";
import { listTableMistakes } from "./chain.js";
import { listJacobianRecipes } from "./jacobian.js";
import { listConfigurationMistakes, makeMakersCause } from "./joints.js";
import { cacheResults, keep, makeCause } from "./ranking.js";

/** @typedef {import("../geometry/arm.js").Arm} Arm */
/** @typedef {import("../geometry/kinematics.js").Frame} Frame */
/**
 * An arm with masses under gravity, and a wrench for each of its configurations.
 * @typedef {object} Load
 * @property {import("../geometry/chains.js").Chain} c rows and joints, at no configuration yet
 * @property {number[][]} wrenches on the tool (N, N m)
 * @property {number[]} gravity vector (m/s²)
 * @property {number[]} masses of each row (kg)
 * @property {number[][]} centres of mass in the frame of each row (m)
 */
/**
 * A load at a configuration, with the frames and the wrench there.
 * @typedef {Load & { T: Frame[], F: number[] }} PlacedLoad
 */
/**
 * A mistake in torques, with the step of load, weight, force and writing that it changes.
 * @typedef {object} TorqueStep
 * @property {import("./ranking.js").Cause} cause
 * @property {(load: Load) => Load} [change]
 * @property {(at: PlacedLoad) => number[]} [weight]
 * @property {(at: PlacedLoad) => number[]} [force]
 * @property {(tau: number[]) => number[]} [write]
 */

const MASSLESS = [0, 0, 0, 0]; // the body of a row without masses
const multiply = (factor, list) => list.map((x) => factor * x);

/** @param {PlacedLoad} at */
const computeWeight = ({ c, T, masses, centres, gravity }) =>
  chains.computeTorquesOfMasses(c, T, masses, centres, gravity);
// Jacobians by their frames, which mistakes in forces and masses share.
const jacobians = new WeakMap();
/** @param {PlacedLoad} at */
function computeJacobian({ c, T }) {
  if (!jacobians.has(T)) jacobians.set(T, chains.flatJacobian(c, T));
  return jacobians.get(T);
}
/** @param {PlacedLoad} at */
const computeForce = (at) =>
  at.F.some(Boolean) ? chains.multiplyByTranspose(computeJacobian(at), at.F) : at.c.at.map(() => 0);

/** @param {Arm} arm @param {number[][]} wrenches @param {number[]} gravity @returns {Load} */
export function makeLoad(arm, wrenches, gravity) {
  const bodies = arm.rows.map(({ body }) => body ?? MASSLESS);
  const zeros = movingRows(arm).map(() => 0);
  return {
    c: chains.makeChain(arm, zeros),
    wrenches,
    gravity,
    masses: bodies.map(([mass]) => mass),
    centres: bodies.map(([, ...centre]) => centre),
  };
}

// Computes torques at some configurations. Mistakes share the cached frames, weights and forces.
class TorqueComputer {
  /** @param {Load} load @param {number} dof @param {number[]} q all joint values */
  constructor(load, dof, q) {
    const loads = splitIntoRows(q, dof).map((values) => ({
      ...load,
      c: { ...load.c, q: values, dof },
    }));
    const framesOf = cacheResults(chains.chainFrames);
    this.place = (changed, i) => ({ ...changed, T: framesOf(changed.c), F: load.wrenches[i] });
    this.loadsOf = cacheResults((change) => loads.map((load, i) => this.place(change(load), i)));
    const partsOf = (change) => cacheResults((part) => this.loadsOf(change).map(part));
    this.weightsOf = cacheResults(partsOf);
    this.forcesOf = cacheResults(partsOf);
  }

  /**
   * Compute the torques with some steps done wrong.
   * @param {Partial<TorqueStep>} steps @returns {number[]}
   */
  compute({ change = keep, weight = computeWeight, force = computeForce, write = keep }) {
    const forces = this.forcesOf(change)(force);
    return this.weightsOf(change)(weight).flatMap((g, i) => write(subtractEach(g, forces[i])));
  }
}

/**
 * Return a maker of torques. It takes the steps done wrong, and returns a function from the
 * joint values of all configurations to the torques there. Results at `q` are cached.
 * @param {Load} load
 * @param {number} dof
 * @param {number[]} q
 * @returns {(steps?: Partial<TorqueStep>) => (values: number[]) => number[]}
 */
export function makeTorqueMaker(load, dof, q) {
  const cached = new TorqueComputer(load, dof, q);
  return (steps = {}) =>
    (values) =>
      (values === q ? cached : new TorqueComputer(load, dof, values)).compute(steps);
}

/**
 * List the mistakes, commoner first.
 * @param {Arm} arm
 * @param {Load} load
 * @returns {TorqueStep[]}
 */
export const listTorqueSteps = (arm, load) => [
  ...listWeightMistakes(load),
  ...listForceMistakes(load),
  ...listWritingMistakes(arm),
  ...listBodyMistakes(arm, load),
  ...listChainMistakes(arm),
];

/** List mistakes in the table or q. @param {Arm} arm @returns {TorqueStep[]} */
function listChainMistakes(arm) {
  // Without the pen the last centre of mass stays where it is, so that its coordinates change.
  const centres = arm.penless?.rows.map(({ body }) => (body ?? MASSLESS).slice(1));
  return [...listConfigurationMistakes("tau.degrees", arm), ...listTableMistakes(arm)].map(
    ({ cause, change }) => {
      const changed = cacheResults(change);
      const withCentres = cause.keys[0] === "table.pen" ? { centres } : {};
      return { cause, change: (load) => ({ ...load, c: changed(load.c), ...withCentres }) };
    },
  );
}

/** @param {Arm} arm @returns {Generator<TorqueStep>} */
function* listWritingMistakes(arm) {
  const makeMistake = (key, write, fields = {}) => ({ cause: makeCause(key, fields), write });
  yield makeMistake("tau.all signs", (tau) => multiply(-1, tau)); // handed in
  yield makeMistake("tau.reversed order", (tau) => [...tau].reverse()); // handed in: tau_7 first
  const signs = arm.makerSigns; // as Pinocchio's model has them
  if (signs)
    yield {
      cause: makeMakersCause(arm, "tau.makers signs"),
      write: (tau) => tau.map((x, k) => signs[k] * x),
    };
  const joints = jointNumbers(arm);
  for (let i = 0; i < joints.length; i++)
    for (let j = i + 1; j < joints.length; j++) {
      if (joints.length === 3 && j === i + 2) continue; // the reversed order
      // handed in
      const exchange = (tau) => tau.map((x, k) => (k === i ? tau[j] : k === j ? tau[i] : x));
      yield makeMistake("tau.exchanged", exchange, { i: joints[i], j: joints[j] });
    }
}

// Compute for each joint the torque of its own link alone, without the links after it.
function computeOwnLinkTorques(at) {
  const alone = at.masses.map((_, i) => at.masses.map((mass, k) => (k === i ? mass : 0)));
  return at.c.at.map((row, k) => computeWeight({ ...at, masses: alone[row] })[k]);
}

/** @param {Load} load @returns {Generator<TorqueStep>} */
function* listWeightMistakes({ c }) {
  // slip 24
  yield { cause: makeCause("tau.weight sign"), weight: (at) => multiply(-1, computeWeight(at)) };
  yield { cause: makeCause("tau.weight missing"), weight: () => c.at.map(() => 0) }; // handed in
  yield { cause: makeCause("tau.own link"), weight: computeOwnLinkTorques }; // handed in
}

/** @param {Load} load @returns {Generator<TorqueStep>} */
function* listForceMistakes({ wrenches, c }) {
  if (!wrenches.some((F) => F.some(Boolean))) return;
  const withWrench = (change) => (at) =>
    chains.multiplyByTranspose(computeJacobian(at), change(at.F, at.T.at(-1)));
  const makeForceMistake = (key, change) => ({ cause: makeCause(key), force: withWrench(change) });
  yield makeForceMistake("tau.force sign", (F) => multiply(-1, F)); // section 4
  yield makeForceMistake("tau.force missing", (F) => multiply(0, F)); // half an answer
  yield makeForceMistake("tau.force in tool", (F, T) => chains.wrenchFromFrame(T, F)); // handed in
  const untransposed = (at) =>
    chains.multiplyByTranspose(chains.transpose(computeJacobian(at), [c.dof, 6]), at.F);
  if (c.dof === 6) yield { cause: makeCause("tau.J for J^T"), force: untransposed }; // handed in
  for (const { cause, recipe } of listJacobianRecipes(c)) {
    // Its linear rows are all 0: for a pure force it is as if the force were missing.
    if (cause.keys[0] === "J.rows of T") continue;
    yield { cause, force: ({ c: chain, T, F }) => chains.multiplyByTranspose(recipe(chain, T), F) };
  }
}

/** List mistakes in masses, centres and g. @param {Arm} arm @returns {Generator<TorqueStep>} */
function* listBodyMistakes(arm, load) {
  const makeBodyMistake = (key, change, fields = {}) => ({ cause: makeCause(key, fields), change });
  const g = Math.hypot(...load.gravity);
  const _here = formatNumber(g, 4);
  const withGravity = (value) => ({ gravity: load.gravity.map((x) => (x / g) * value) });
  for (const other of [9.8, 10]) {
    // slip 8; handed in
    const otherGravity = (at) => ({ ...at, ...withGravity(other) });
    if (g && Math.abs(g - other) > 1e-9)
      yield makeBodyMistake("tau.gravity", otherGravity, { g: other, _here });
  }
  yield* listMassMistakes(arm, load, makeBodyMistake);
  const paperCentres = (at) => ({ ...at, centres: arm.paper });
  if (arm.paper) yield makeBodyMistake("tau.paper centres", paperCentres); // slip 7
  if (arm.lumped) {
    const { report, links, gravity } = arm.lumped;
    // In a pair of mistakes, the links that are not lumped keep the masses of the first mistake.
    const isLumped = arm.lumped.bodies.map(([mass], k) => mass !== load.masses[k]);
    const lumpLinks = (at) => ({
      ...at,
      masses: at.masses.map((mass, k) => (isLumped[k] ? arm.lumped.bodies[k][0] : mass)),
      centres: at.centres.map((x, k) => (isLumped[k] ? arm.lumped.bodies[k].slice(1) : x)),
    });
    const fields = { _links: joinList(links), _report: report };
    yield makeBodyMistake("tau.lumped", lumpLinks, fields);
    const asReported = (at) => ({ ...lumpLinks(at), ...withGravity(gravity) });
    yield makeBodyMistake("tau.report", asReported, { ...fields, _g: gravity, _here });
  }
}

function* listMassMistakes(arm, load, makeBodyMistake) {
  const { masses } = load;
  const withMasses = (change) => (at) => ({ ...at, masses: at.masses.map(change) });
  // handed in: an index that is one off
  for (const [step, end] of [
    [1, 0],
    [1, masses[0]],
    [-1, 0],
  ]) {
    const moved = moveList(masses, step, end);
    yield makeBodyMistake(
      "tau.masses moved",
      withMasses((_, k) => moved[k]),
    );
  }
  const other = (arm.robots ?? []).find((robot) => robot.masses); // section 4
  if (other) {
    const otherMasses = withMasses((_, k) => other.masses[k]);
    yield makeBodyMistake("tau.robot", otherMasses, { name: other.name });
  }
  for (const [i, mass] of masses.entries()) {
    const link = i + 1;
    const missing = withMasses((x, k) => (k === i ? 0 : x));
    if (mass) yield makeBodyMistake("tau.mass missing", missing, { link });
    if (link === masses.length) continue;
    // handed in
    const exchanged = withMasses((_, k) => masses[k === i ? link : k === link ? i : k]);
    yield makeBodyMistake("tau.masses exchanged", exchanged, { i: link, j: link + 1 });
  }
}

// Move a list by `step` rows. Entry k + step takes the position of entry k, and `end` fills the
// gap.
const moveList = (list, step, end) => list.map((_, k) => list[k + step] ?? end);
