// What students make of a right table, undone: each mend changes the rows as typed into what was
// meant.

import { combinations } from "../geometry/walk.js";
import { RAD } from "../geometry/angles.js";
import { both, cause } from "./ranking.js";
import { fromCraig } from "../reading/table.js";

const TURN = 6.4; // rad: a larger angle was meant in degrees

/** @typedef {import("../geometry/axes.js").Numbers} Numbers */
/** @typedef {import("./ranking.js").Cause} Cause */
/** @typedef {(rows: Numbers[]) => Numbers[]} Mend */

/** @returns {Cause | null} */
export const joined = (first, second) =>
  first && second ? both(first, second) : (first ?? second);

// The units that the numbers may have been typed in: millimetres for metres, degrees for radians.
/** @returns {[Cause | null, Numbers[]][]} */
export function units(rows, reference) {
  const share = (1e-3 * totalLength(rows)) / (totalLength(reference) || 1);
  const long = 0.2 < share && share < 5;
  const turned = rows.some((r) => Math.max(Math.abs(r.alpha), Math.abs(r.theta)) > TURN);
  /** @type {[Cause | null, number][][]} */
  const [lengths, angles] = [[[null, 1]], [[null, 1]]];
  if (long) lengths.push([cause("table.millimetres"), 1e-3]);
  if (turned) angles.push([cause("table.degrees"), RAD]);
  return lengths.flatMap(([first, m]) =>
    angles.map(([second, rad]) => [
      joined(first, second),
      rows.map((r) => ({
        ...r,
        a: r.a * m,
        d: r.d * m,
        alpha: r.alpha * rad,
        theta: r.theta * rad,
      })),
    ]),
  );
}

// All lengths of a table added up.
export const totalLength = (rows) =>
  rows.reduce((sum, r) => sum + (Math.abs(r.a) + Math.abs(r.d)), 0);

const swap = (one, other) => (rows) =>
  rows.map((r) => ({ ...r, [one]: r[other], [other]: r[one] }));

// Mistakes in the arrangement: columns, rows, convention (where it is not the modified one).
/** @returns {[Cause, Mend][]} */
export function structures(count, modified) {
  const places = combinations([...Array(count).keys()], 2);
  /** @type {[Cause, Mend][]} */
  const craig = modified ? [] : [[cause("table.craig"), fromCraig]];
  return [
    [cause("table.alpha and theta"), swap("alpha", "theta")],
    [cause("table.a and d"), swap("a", "d")],
    ...craig,
    [cause("table.twists"), (rows) => rows.map((r) => ({ ...r, alpha: -r.alpha }))],
    [cause("table.into craig"), toCraig],
    ...Array.from({ length: count }, (_, k) => aAndDOf(k)),
    ...places.map(([i, j]) => [cause(EXCHANGED, { i: i + 1, j: j + 1 }), exchanged(i, j)]),
  ];
}

// The lengths of one row.
/** @returns {[Cause, Mend]} */
const aAndDOf = (k) => [
  cause(IN_ROW, { row: k + 1 }),
  (rows) => rows.map((r, i) => (i === k && r.kind !== "prismatic" ? { ...r, a: r.d, d: r.a } : r)),
];

export const IN_ROW = "table.a and d in row";
export const EXCHANGED = "table.rows exchanged";

const exchanged = (i, j) => (rows) =>
  rows.map((row, k) => (k === i ? rows[j] : k === j ? rows[i] : row));

// The other way: a and alpha stand one row too high.
const toCraig = (rows) =>
  rows.map((row, k) => ({ ...row, a: rows[k - 1]?.a ?? 0, alpha: rows[k - 1]?.alpha ?? 0 }));

// Other arms that a student may have described: without the pen, one length taken for another, or
// another robot of a like name.
/** @returns {[Cause, Numbers[]][]} */
export const references = (arm) => [
  ...(arm.penless ? [[cause("table.pen"), arm.penless.rows]] : []),
  ...(arm.alike ?? []).map(({ name, other, rows }) => [
    cause("table.length", { name, other }),
    rows,
  ]),
  ...(arm.robots ?? []).flatMap(({ name, rows, penless }) => {
    const why = cause("table.robot", { name });
    return penless
      ? [
          [why, rows],
          [both(why, cause("table.pen")), penless],
        ]
      : [[why, rows]];
  }),
];
