// Chooses configurations at which formulas are compared. At zeros and right angles a wrong term may
// vanish; at these it does not.

import { jacobianColumns, linkFrames, movingRows } from "./kinematics.js";
import { decomposeSingular } from "./linear.js";
import { movableRows, pick } from "./task_rows.js";

/** @typedef {import("./arm.js").Rows} Rows */

const COUNT = 5;
const TRIED = 20; // the configurations farthest from singular ones are taken
const [SMALLEST, LARGEST] = [0.2, 1.5]; // rad or m
const SEED = 19;

// Return a generator of random numbers from 0 to 1 (mulberry32), the same in each engine.
function makeRandom(seed) {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 4294967296;
  };
}

/** @type {WeakMap<object, number[][]>} */
const configurationsByTable = new WeakMap();

/**
 * Return five configurations of an arm from a fixed seed, away from singular ones. Their joint
 * values have two decimals.
 * @param {Rows} arm
 * @returns {number[][]}
 */
export function listGeneralConfigurations(arm) {
  const known = configurationsByTable.get(arm.rows);
  if (known) return known;
  const random = makeRandom(SEED);
  const draw = () => {
    const size = SMALLEST + (LARGEST - SMALLEST) * random();
    return (Math.round(100 * size) / 100) * (random() < 0.5 ? -1 : 1);
  };
  const tried = Array.from({ length: TRIED }, () => movingRows(arm).map(draw));
  const sorted = tried
    .map((q) => ({ q, smallest: findSmallestSingularValue(arm, q) }))
    .sort((first, second) => second.smallest - first.smallest);
  const chosen = sorted.slice(0, COUNT).map(({ q }) => q);
  configurationsByTable.set(arm.rows, chosen);
  return chosen;
}

// Return the smallest singular value of the Jacobian that is not 0 at every configuration.
function findSmallestSingularValue(arm, q) {
  const rows = movableRows(arm);
  const columns = jacobianColumns(arm, linkFrames(arm, q)).map((column) => pick(column, rows));
  const { values } = decomposeSingular(columns, rows.length);
  return values[Math.min(rows.length, columns.length) - 1] ?? 0;
}
