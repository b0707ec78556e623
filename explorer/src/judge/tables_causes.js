// What students make of a right table, undone, the port of helpers/checks/tables_causes.py: each mend changes the rows
// as typed into what was meant.

import { combinations } from "../axes.js";
import { both, cause } from "./ranking.js";
import { fromCraig } from "./table_reading.js";

const RAD = Math.PI / 180;

/** @typedef {import("../axes.js").Numbers} Numbers */
/** @typedef {import("./ranking.js").Cause} Cause */
/** @typedef {(rows: Numbers[]) => Numbers[]} Mend */

/** @returns {Cause | null} */
export const joined = (first, second) => (first && second ? both(first, second) : (first ?? second));

// The readings of the numbers that their sizes allow: lengths in m, cm or mm, angles in radians or degrees.
/** @returns {[Cause | null, Numbers[]][]} */
export function units(rows, reference) {
  const size = (table) => table.reduce((sum, r) => sum + (Math.abs(r.a) + Math.abs(r.d)), 0) || 1;
  const [total, wanted] = [size(rows), size(reference)];
  const near = (factor) => 0.2 < (total * factor) / wanted && (total * factor) / wanted < 5;
  /** @type {[Cause | null, number][]} */
  const lengths = [[null, 1]];
  if (near(1e-3)) lengths.push([cause("table.millimetres"), 1e-3]);
  if (near(1e-2)) lengths.push([cause("table.centimetres"), 1e-2]);
  /** @type {[Cause | null, number, number][]} */
  const angles = [[null, 1, 1]];
  if (rows.some((r) => Math.abs(r.alpha) > 6.4 || Math.abs(r.theta) > 6.4))
    angles.push([cause("table.degrees"), RAD, RAD], [cause("table.twists in degrees"), RAD, 1]);
  return lengths.flatMap(([first, f]) =>
    angles.map(([second, t, o]) => {
      const read = rows.map((r) => ({
        ...r,
        a: r.a * f,
        d: r.d * f,
        alpha: r.alpha * t,
        theta: r.theta * o,
      }));
      return /** @type {[Cause | null, Numbers[]]} */ ([joined(first, second), read]);
    }),
  );
}

const swap = (one, other) => (rows) => rows.map((r) => ({ ...r, [one]: r[other], [other]: r[one] }));

// Mistakes in the arrangement: columns, rows, convention.
/** @returns {[Cause, Mend][]} */
export function structures(count) {
  const places = combinations([...Array(count).keys()], 2);
  return [
    [cause("table.alpha and theta"), swap("alpha", "theta")],
    [cause("table.a and d"), swap("a", "d")],
    [cause("table.craig"), fromCraig],
    [cause("table.d and theta"), swap("d", "theta")],
    [cause("table.a and alpha"), swap("a", "alpha")],
    [cause("table.twists"), (rows) => rows.map((r) => ({ ...r, alpha: -r.alpha }))],
    [cause("table.rows reversed"), (rows) => [...rows].reverse()],
    [cause("table.into craig"), toCraig],
    ...places.map(([i, j]) => [cause(EXCHANGED, { i: i + 1, j: j + 1 }), exchanged(i, j)]),
  ];
}

export const EXCHANGED = "table.rows exchanged";

const exchanged = (i, j) => (rows) =>
  j < rows.length ? rows.map((row, k) => (k === i ? rows[j] : k === j ? rows[i] : row)) : rows;

// The other way: a and alpha stand one row too high.
const toCraig = (rows) =>
  rows.map((row, k) => ({ ...row, a: rows[k - 1]?.a ?? 0, alpha: rows[k - 1]?.alpha ?? 0 }));

// Other arms that a student may have described: without the pen, or one length taken for another.
/** @returns {[Cause, Numbers[]][]} */
export const references = (arm) => [
  ...(arm.penless ? [[cause("table.pen"), arm.penless.rows]] : []),
  ...(arm.alike ?? []).map(({ name, other, rows }) => [cause("table.length", { name, other }), rows]),
];

// One sign turned.
/** @returns {[Cause, Numbers[]][]} */
export const flips = (rows) =>
  rows.flatMap((row, k) =>
    ["alpha", "a", "d"].flatMap((column) => {
      const twist = column === "alpha";
      if (!row[column] || (twist && Math.abs(Math.sin(row.alpha)) < 1e-9)) return [];
      const why = twist ? cause("table.twist", { row: k + 1 }) : cause("table.sign", { column, row: k + 1 });
      return [[why, rows.map((r, i) => (i === k ? { ...r, [column]: -r[column] } : r))]];
    }),
  );
