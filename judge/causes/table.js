// Why a table is another arm: every reading with up to two slips undone, and the entries that it
// leaves wrong. The fewest slips win, a wrong entry being one.

import { angleDistance, compareAxes, describeAxes } from "../geometry/axes.js";
import { ANGLE_TOLERANCE, isAngleColumn, snapRows, jointColumn } from "../geometry/rows.js";
import { combinations } from "../geometry/walk.js";
import { convertFromCraig } from "../reading/table_conversion.js";
import { ENTRIES } from "../reading/table_rows.js";
import { combineCauses, makeCause } from "./ranking.js";

/** @typedef {import("../geometry/arm.js").TableRow} TableRow */
/** @typedef {import("./ranking.js").Cause} Cause */

/** @typedef {import("../geometry/axes.js").Difference} Difference */

/**
 * One reading of what was meant: its causes, the rows, the arm they are held against, and what that
 * leaves: the entries that differ, as row and column, or else the axes.
 * @typedef {{ cause: Cause | null, rows: TableRow[], reference: TableRow[],
 *   left: ([number, string] | Difference)[] }} Try
 */

const FEW = 3; // entries: more of them are no slips, but another table

/**
 * The readings with the fewest slips, several where they leave nothing; else one, and rather one
 * that leaves entries.
 * @returns {Try[]}
 */
export function findFewestMistakes(rows, reference, wanted, modified, length) {
  const all = tries(rows, reference, wanted, modified, length);
  const fewest = Math.min(...all.map(slipsOf));
  const best = all.filter((t) => slipsOf(t) === fewest);
  const whole = best.filter(({ left }) => !left.length);
  if (whole.length) return whole;
  return [best.find(({ left }) => Array.isArray(left[0])) ?? best[0]];
}

/** @param {Try} t */
const slipsOf = ({ cause: why, left }) => (why?.keys.length ?? 0) + left.length;

/** @returns {Try[]} */
function tries(rows, reference, wanted, modified, length) {
  const others = references(reference).map(([why, arm]) => [why, snapRows(arm)]);
  return [[null, wanted], ...others].flatMap(([other, arm]) =>
    mends(rows.length, modified).flatMap(([mistake, mend, local]) => {
      const why = other && mistake ? combineCauses(other, mistake) : (other ?? mistake);
      const mended = snapRows(mend(rows));
      const off = entriesOff(mended, arm, length);
      const left = local ? off : fewerOff(off, axesOff(mended, arm, length), why);
      if (!left || why?.keys.length > 2 || (local && left.length)) return [];
      return [{ cause: why, rows: mended, reference: arm, left }];
    }),
  );
}

// Return the differences that a reading leaves: the entries, where they are few and no more than
// the axes; else the axes, of which beside a cause there is one. Null where that is too much.
function fewerOff(entries, axes, why) {
  const few = entries && entries.length <= FEW;
  if (few && axes.length && entries.length <= axes.length) return entries;
  if (!why || axes.length < 2) return axes;
  return few ? entries : null;
}

// The axes that differ, in whatever frames the rows are.
const axesOff = (rows, wanted, length) =>
  compareAxes(describeAxes(rows), describeAxes(wanted), length, ANGLE_TOLERANCE).differences;

/** @returns {[number, string][] | null} null where rows do not correspond */
function entriesOff(rows, wanted, length) {
  const alike =
    rows.length === wanted.length && rows.every(({ kind }, k) => kind === wanted[k].kind);
  if (!alike) return null;
  return rows.flatMap((row, k) =>
    ENTRIES.filter((column) => {
      const [x, y] = [row[column], wanted[k][column]];
      const free = column === jointColumn(row.kind);
      return (
        !free &&
        (isAngleColumn(column) ? angleDistance(x, y) > ANGLE_TOLERANCE : Math.abs(x - y) > length)
      );
    }).map((column) => /** @type {[number, string]} */ ([k, column])),
  );
}

const swap = (one, other) => (row) => ({ ...row, [one]: row[other], [other]: row[one] });

// Mistakes in the arrangement, undone: columns, convention (where it is not the modified one) and,
// which must explain everything, rows. All handed in.
/** @returns {[Cause | null, (rows: TableRow[]) => TableRow[], boolean?][]} */
function mends(count, modified) {
  const rows = [...Array(count).keys()];
  return [
    [null, (read) => read],
    [makeCause("table.alpha and theta"), (read) => read.map(swap("alpha", "theta"))],
    [makeCause("table.a and d"), (read) => read.map(swap("a", "d"))],
    ...(modified ? [] : [/** @type {any} */ ([makeCause("table.craig"), convertFromCraig])]),
    [makeCause("table.into craig"), toCraig],
    ...rows.map((k) => aAndDOf(k)),
    ...combinations(rows, 2).map(([i, j]) => exchanged(i, j)),
  ];
}

// The lengths of one row.
/** @returns {[Cause, (rows: TableRow[]) => TableRow[], boolean]} */
const aAndDOf = (k) => [
  makeCause("table.a and d in row", { row: k + 1 }),
  (rows) => rows.map((r, i) => (i === k && r.kind !== "prismatic" ? swap("a", "d")(r) : r)),
  true,
];

/** @returns {[Cause, (rows: TableRow[]) => TableRow[], boolean]} */
const exchanged = (i, j) => [
  makeCause("table.rows exchanged", { i: i + 1, j: j + 1 }),
  (rows) => rows.map((row, k) => (k === i ? rows[j] : k === j ? rows[i] : row)),
  true,
];

// a and alpha stand one row too high.
const toCraig = (rows) =>
  rows.map((row, k) => ({ ...row, a: rows[k - 1]?.a ?? 0, alpha: rows[k - 1]?.alpha ?? 0 }));

// Other arms that a student may have described: without the pen, one length taken for another, or
// another robot of a like name.
/** @returns {[Cause, TableRow[]][]} */
const references = (arm) => [
  ...(arm.penless ? [[makeCause("table.pen"), arm.penless.rows]] : []),
  ...(arm.alike ?? []).map(({ name, other, rows }) => [
    makeCause("table.length", { name, other }),
    rows,
  ]),
  ...(arm.robots ?? []).flatMap(({ name, rows, penless }) => {
    const why = makeCause("table.robot", { name });
    return penless
      ? [
          [why, rows],
          [combineCauses(why, makeCause("table.pen")), penless],
        ]
      : [[why, rows]];
  }),
];
