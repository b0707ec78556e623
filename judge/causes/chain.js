// Lists mistakes in an arm's table and in its joint values, whatever is computed from them. Each is
// a function that changes a chain. The comments name where a mistake was seen, which is a slip of
// homework.md by its number, or work that was handed in.

import { DEG, RAD } from "../geometry/angles.js";
import { jointNames, movingRows, revoluteFlags } from "../geometry/kinematics.js";
import { combinations } from "../geometry/axis_gaps.js";
import { makeMakersCause } from "./joints.js";
import { combineCauses, makeCause } from "./ranking.js";

/** @typedef {import("../geometry/arm.js").Arm} Arm */
/** @typedef {import("../geometry/arm.js").Row} Row */
/** @typedef {import("../geometry/chains.js").Chain} Chain */
/** @typedef {import("./ranking.js").Cause} Cause */
/**
 * The cause of a mistake, and the function that changes a chain by it.
 * @typedef {[Cause, (c: Chain) => Chain]} ChainMistake
 */

/** List the usual mistakes in a table's numbers. @param {Arm} arm @returns {ChainMistake[]} */
export const listTableMistakes = (arm) => [
  ...listOtherLengths(arm),
  ...listExchangedLengths(arm),
  ...listTableWideMistakes(arm),
  ...arm.rows.flatMap(listRowMistakes),
];

/** Move a and alpha down by a row. @template {Row} T @param {T[]} rows */
export const lowerLinkColumns = (rows) =>
  rows.map((row, k) => ({ ...row, a: rows[k - 1]?.a ?? 0, alpha: rows[k - 1]?.alpha ?? 0 }));

const changeRows = (change) => (c) => ({
  ...c,
  rows: c.rows.map((row, i) => ({ ...row, ...change(row, i) })),
});

/** List lengths of similar arms or parts. @param {Arm} arm @returns {Generator<ChainMistake>} */
export function* listOtherLengths({ penless, alike = [], robots = [] }) {
  if (penless) {
    // handed in: the pen left out, and the pen taken away
    yield [makeCause("table.pen"), changeRows((_, i) => ({ d: penless.rows[i].d }))];
    const subtractPen = changeRows((row, i) => ({ d: 2 * penless.rows[i].d - row.d }));
    yield [makeCause("table.pen sign"), subtractPen];
  }
  for (const { name, other, rows } of alike)
    // slip 2
    yield [makeCause("table.length", { name, other }), changeRows((_, i) => ({ a: rows[i].a }))];
  for (const { name, rows, penless: shorter } of robots) {
    const takeLengths = (other) => changeRows((_, i) => ({ a: other[i].a, d: other[i].d }));
    const cause = makeCause("table.robot", { name });
    yield [cause, takeLengths(rows)]; // slip 9
    if (shorter) yield [combineCauses(cause, makeCause("table.pen")), takeLengths(shorter)];
  }
}

/**
 * List two lengths of a column exchanged, with each row's sign kept or exchanged. Handed in.
 * @param {Arm} arm @returns {Generator<ChainMistake>}
 */
export function* listExchangedLengths({ rows }) {
  for (const column of ["a", "d"]) {
    const links = rows.flatMap((row, i) => (row[column] ? [i] : []));
    for (const [i, j] of combinations(links, 2)) {
      const [first, second] = [rows[i][column], rows[j][column]];
      if (Math.abs(first) === Math.abs(second)) continue;
      const signs = first * second < 0 ? [-1, 1] : [1];
      for (const sign of signs) {
        const lengths = { [i]: sign * second, [j]: sign * first };
        const exchange = changeRows((_, k) => (k in lengths ? { [column]: lengths[k] } : {}));
        yield [makeCause(`table.${column} exchanged`, { i: i + 1, j: j + 1 }), exchange];
      }
    }
  }
}

/** List mistakes in offsets and convention. @param {Arm} arm @returns {Generator<ChainMistake>} */
function* listTableWideMistakes({ rows }) {
  const hasOffset = (row) => row.kind === "revolute" && row.theta;
  if (rows.filter(hasOffset).length > 1)
    yield [makeCause("table.offsets"), changeRows((row) => (hasOffset(row) ? { theta: 0 } : {}))];
  // handed in: Craig's rows in the standard matrix
  yield [makeCause("table.craig rows"), (c) => ({ ...c, rows: lowerLinkColumns(c.rows) })];
}

/** @param {Row} row @param {number} index @returns {ChainMistake[]} */
function listRowMistakes(row, index) {
  const rowField = { row: index + 1 };
  const makeRowMistake = (key, fields, entries) => [
    makeCause(key, fields),
    changeRows((_, i) => (i === index ? entries : {})),
  ];
  const mistakes = [];
  if (Math.abs(Math.sin(row.alpha)) > 1e-9)
    mistakes.push(makeRowMistake("table.twist", rowField, { alpha: -row.alpha }));
  if (row.alpha) mistakes.push(makeRowMistake("table.no twist", rowField, { alpha: 0 }));
  for (const column of ["a", "d"]) {
    if (!row[column]) continue;
    mistakes.push(
      makeRowMistake("table.sign", { column, ...rowField }, { [column]: -row[column] }),
    );
    mistakes.push(makeRowMistake("table.missing", { column, ...rowField }, { [column]: 0 }));
  }
  if (row.theta && row.kind === "revolute")
    mistakes.push(makeRowMistake("table.offset", rowField, { theta: 0 }));
  return mistakes;
}

// Return for each joint whether it turns about an axis parallel to that of the joint before it.
function listParallelJoints(arm) {
  const rows = movingRows(arm);
  const isRevolute = revoluteFlags(arm);
  const isStraight = (k) => rows[k] === rows[k - 1] + 1 && !arm.rows[rows[k - 1]].alpha;
  return rows.map((_, k) => k > 0 && isRevolute[k] && isRevolute[k - 1] && isStraight(k));
}

/**
 * List mistakes in the joint values. All joints may be in degrees for radians or the reverse, or
 * have the maker's signs. A single joint may have the wrong sign, or be in degrees or in
 * millimetres. All were handed in.
 * @param {string} degreesKey of the message on degrees
 * @param {Arm} arm
 * @returns {ChainMistake[]}
 */
export function listConfigurationMistakes(degreesKey, arm) {
  const isRevolute = revoluteFlags(arm);
  const changeJoints = (change) => (c) => ({ ...c, q: c.q.map(change) });
  /** @type {ChainMistake[]} */
  const mistakes = [RAD, DEG].map((factor) => [
    makeCause(degreesKey),
    changeJoints((x, k) => (isRevolute[k] ? x * factor : x)),
  ]);
  const isSummed = listParallelJoints(arm);
  if (isSummed.includes(true))
    // handed in: s_2 for s_12
    mistakes.push([
      makeCause("J.not summed"),
      (c) => ({ ...c, q: c.q.map((x, k) => (isSummed[k] ? x - c.q[k - 1] : x)) }),
    ]);
  const signs = arm.makerSigns;
  if (signs) mistakes.push([makeMakersCause(arm), changeJoints((x, k) => signs[k] * x)]);
  for (const [k, joint] of jointNames(arm).entries()) {
    const change = (factor) => changeJoints((x, i) => (i === k ? factor * x : x));
    mistakes.push([makeCause("ik.sign", { joint }), change(-1)]);
    const [key, factor] = isRevolute[k]
      ? ["ik.joint degrees", DEG]
      : ["ik.joint millimetres", 1000];
    mistakes.push([makeCause(key, { joint }), change(factor)]);
  }
  return mistakes;
}
