// Lists mistakes in an arm's table, whatever is computed from it. The comments name where a mistake
// was seen, which is a slip of homework.md by its number, or work that was handed in.

import { combinations } from "../geometry/axis_gaps.js";
import { combineCauses, makeCause } from "./ranking.js";

/** @typedef {import("../geometry/arm.js").Arm} Arm */
/** @typedef {import("../geometry/arm.js").Row} Row */
/** @typedef {import("../geometry/chains.js").Chain} Chain */
/** @typedef {import("./ranking.js").Cause} Cause */
/**
 * A mistake in an arm's table or joint values, and the function that makes it.
 * @typedef {{ cause: Cause, change: (c: Chain) => Chain }} ChainMistake
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

/** @param {Cause} cause @returns {ChainMistake} */
const makeMistake = (cause, changeRow) => ({
  cause,
  change: (c) => ({ ...c, rows: c.rows.map((row, i) => ({ ...row, ...changeRow(row, i) })) }),
});

/** List lengths of similar arms or parts. @param {Arm} arm @returns {Generator<ChainMistake>} */
export function* listOtherLengths({ penless, alike = [], robots = [] }) {
  if (penless) {
    // handed in: the pen left out, and the pen taken away
    yield makeMistake(makeCause("table.pen"), (_, i) => ({ d: penless.rows[i].d }));
    const subtractPen = (row, i) => ({ d: 2 * penless.rows[i].d - row.d });
    yield makeMistake(makeCause("table.pen sign"), subtractPen);
  }
  for (const { name, other, rows } of alike)
    // slip 2
    yield makeMistake(makeCause("table.length", { name, other }), (_, i) => ({ a: rows[i].a }));
  for (const { name, rows, penless: shorter } of robots) {
    const takeLengths = (other) => (_, i) => ({ a: other[i].a, d: other[i].d });
    const cause = makeCause("table.robot", { name });
    yield makeMistake(cause, takeLengths(rows)); // slip 9
    const withoutPen = combineCauses(cause, makeCause("table.pen"));
    if (shorter) yield makeMistake(withoutPen, takeLengths(shorter));
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
        const cause = makeCause(`table.${column} exchanged`, { i: i + 1, j: j + 1 });
        yield makeMistake(cause, (_, k) => (k in lengths ? { [column]: lengths[k] } : {}));
      }
    }
  }
}

/** List mistakes in offsets and convention. @param {Arm} arm @returns {Generator<ChainMistake>} */
function* listTableWideMistakes({ rows }) {
  const hasOffset = (row) => row.kind === "revolute" && row.theta;
  if (rows.filter(hasOffset).length > 1)
    yield makeMistake(makeCause("table.offsets"), (row) => (hasOffset(row) ? { theta: 0 } : {}));
  // handed in: Craig's rows in the standard matrix
  const lower = (c) => ({ ...c, rows: lowerLinkColumns(c.rows) });
  yield { cause: makeCause("table.craig rows"), change: lower };
}

/** @param {Row} row @param {number} index @returns {ChainMistake[]} */
function listRowMistakes(row, index) {
  const rowField = { row: index + 1 };
  const makeRowMistake = (key, fields, entries) =>
    makeMistake(makeCause(key, fields), (_, i) => (i === index ? entries : {}));
  const mistakes = [];
  if (Math.abs(Math.sin(row.alpha)) > 1e-9)
    mistakes.push(makeRowMistake("table.twist", rowField, { alpha: -row.alpha }));
  if (row.alpha) mistakes.push(makeRowMistake("table.no twist", rowField, { alpha: 0 }));
  for (const column of ["a", "d"]) {
    if (!row[column]) continue;
    const fields = { column, ...rowField };
    mistakes.push(makeRowMistake("table.sign", fields, { [column]: -row[column] }));
    mistakes.push(makeRowMistake("table.missing", fields, { [column]: 0 }));
  }
  if (row.theta && row.kind === "revolute")
    mistakes.push(makeRowMistake("table.offset", rowField, { theta: 0 }));
  return mistakes;
}
