// Why a table is another arm: every reading with up to two slips undone, and the entries that it
// leaves wrong. The fewest slips win, a wrong entry being one.

import { angleBetween, compared, side } from "../geometry/axes.js";
import { ANGLE, angular, squared, variableOf } from "../geometry/rows.js";
import { ENTRIES } from "../reading/table_rows.js";
import * as usual from "./table.js";

/** @typedef {import("../geometry/axes.js").Numbers} Numbers */
/** @typedef {import("./ranking.js").Cause} Cause */

/**
 * One reading of what was meant: its causes, the rows, the arm they are held against, and the
 * entries that differ, as row and column; null where the rows do not correspond.
 * @typedef {{ cause: Cause | null, rows: Numbers[], reference: Numbers[],
 *   entries: [number, string][] | null }} Try
 */

const FEW = 3; // entries: more of them are no slips, but another table

/**
 * The readings with the fewest slips, several where they leave nothing; none where each needs many.
 * @returns {Try[]}
 */
export function fewestSlips(rows, reference, wanted, modified, length) {
  const all = tries(rows, reference, wanted, modified, length).filter(
    (t) => t.entries && t.entries.length <= FEW && (t.cause || t.entries.length),
  );
  const fewest = Math.min(...all.map(slipsOf));
  const best = all.filter((t) => slipsOf(t) === fewest);
  const whole = best.filter((t) => !t.entries.length);
  return whole.length ? whole : best.slice(0, 1);
}

/** @param {Try} t */
export const slipsOf = (t) => (t.cause?.keys.length ?? 0) + (t.entries?.length ?? 0);

/** @returns {Try[]} */
function tries(rows, reference, wanted, modified, length) {
  const others = [
    [null, wanted],
    ...usual.references(reference).map(([why, arm]) => [why, squared(arm)]),
  ];
  const mends = [[null, (read) => read], ...usual.structures(rows.length, modified)];
  const found = usual.units(rows, wanted).flatMap(([unit, read]) =>
    others.flatMap(([other, arm]) =>
      mends.map(([mistake, mend]) => {
        const mended = squared(mend(read));
        const causes = [unit, other, mistake].filter(Boolean);
        const local = isLocal(mistake);
        const off = differing(mended, arm, length);
        const entries = !local && sameAxes(mended, arm, length) ? [] : off;
        return { causes, rows: mended, reference: arm, entries, local };
      }),
    ),
  );
  return found
    .filter(({ causes, entries, local }) => causes.length < 3 && !(local && entries?.length))
    .map(({ causes, ...t }) => ({ ...t, cause: causes.reduce(usual.joined, null) }));
}

// Whether rows in other frames describe one arm.
const sameAxes = (rows, wanted, length) =>
  !compared(side(rows), side(wanted), length, ANGLE).differences.length;

// Whether a mistake is one of a few rows: it must explain everything.
const isLocal = (mistake) => [usual.EXCHANGED, usual.IN_ROW].includes(mistake?.keys[0]);

/** @returns {[number, string][] | null} */
function differing(rows, wanted, length) {
  const alike =
    rows.length === wanted.length && rows.every(({ kind }, k) => kind === wanted[k].kind);
  if (!alike) return null;
  return rows.flatMap((row, k) =>
    ENTRIES.filter((column) => {
      const [x, y] = [row[column], wanted[k][column]];
      const free = column === variableOf(row.kind);
      return !free && (angular(column) ? angleBetween(x, y) > ANGLE : Math.abs(x - y) > length);
    }).map((column) => /** @type {[number, string]} */ ([k, column])),
  );
}
