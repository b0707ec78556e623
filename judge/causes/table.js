// What students make of a right table, undone: each mend changes the rows as typed into what was
// meant.

import { combinations } from "../geometry/walk.js";
import { RAD } from "../geometry/angles.js";
import { both, cause } from "./ranking.js";
import { fromCraig } from "../reading/table.js";

const [SMALL, LARGE] = [1e-2, 10]; // m: lengths beyond these were meant in the other unit
const TURN = 6.4; // rad: a larger angle was meant in degrees

/** @typedef {import("../geometry/axes.js").Numbers} Numbers */
/** @typedef {import("./ranking.js").Cause} Cause */
/** @typedef {(rows: Numbers[]) => Numbers[]} Mend */

/** @returns {Cause | null} */
export const joined = (first, second) =>
  first && second ? both(first, second) : (first ?? second);

// The readings of the numbers that their sizes allow: lengths in m, cm or mm, angles in radians or
// degrees.
/** @returns {[Cause | null, Numbers[]][]} */
export function units(rows, reference) {
  const wanted = totalLength(reference) || 1;
  /** @type {[Cause, Numbers[] | null][]} */
  const sizes = [
    [cause("table.millimetres"), scaledBy(rows, 1e-3)],
    [cause("table.centimetres"), scaledBy(rows, 1e-2)],
    [cause("table.mixed units"), ofOneSize(rows)],
  ];
  /** @type {[Cause | null, Numbers[]][]} */
  const lengths = [[null, rows]];
  for (const [why, read] of sizes) {
    const share = read ? totalLength(read) / wanted : 0;
    if (0.2 < share && share < 5) lengths.push([why, read ?? []]);
  }
  return lengths.flatMap(([first, read]) =>
    angleUnits(rows).map(([second, t, o]) => {
      const turned = read.map((r) => ({ ...r, alpha: r.alpha * t, theta: r.theta * o }));
      return /** @type {[Cause | null, Numbers[]]} */ ([joined(first, second), turned]);
    }),
  );
}

// The units that twists and joint angles may have been typed in, as factors.
/** @returns {[Cause | null, number, number][]} */
function angleUnits(rows) {
  const largest = Math.max(...rows.map((r) => Math.abs(r.theta)));
  if (largest <= TURN && rows.every((r) => Math.abs(r.alpha) <= TURN)) return [[null, 1, 1]];
  // The zero of a joint that turns is free: only its size tells in what unit it is.
  const held = rows.some((r) => r.kind !== "revolute" && r.theta);
  const small = 0 < largest && largest <= TURN;
  return [
    [null, 1, 1],
    ...(held || !small ? [row(cause("table.degrees"), RAD, RAD)] : []),
    ...(held || small ? [row(cause("table.twists in degrees"), RAD, 1)] : []),
  ];
}

/** @returns {[Cause, number, number]} */
const row = (why, twists, angles) => [why, twists, angles];

// All lengths of a table added up.
export const totalLength = (rows) =>
  rows.reduce((sum, r) => sum + (Math.abs(r.a) + Math.abs(r.d)), 0);

const scaledBy = (rows, factor) => rows.map((r) => ({ ...r, a: r.a * factor, d: r.d * factor }));

// Lengths of which some were typed in metres and some in millimetres, all in metres; null where
// they are of one size.
function ofOneSize(rows) {
  const read = (x) => (Math.abs(x) < SMALL ? x * 1e3 : Math.abs(x) >= LARGE ? x * 1e-3 : x);
  const found = rows.map((r) => ({ ...r, a: read(r.a), d: read(r.d) }));
  const changed = new Set(
    rows.flatMap((r, k) => ["a", "d"].filter((c) => r[c]).map((c) => r[c] === found[k][c])),
  );
  return changed.size === 2 ? found : null;
}

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
    [cause("table.d and theta"), swap("d", "theta")],
    [cause("table.a and alpha"), swap("a", "alpha")],
    [cause("table.twists"), (rows) => rows.map((r) => ({ ...r, alpha: -r.alpha }))],
    [cause("table.rows reversed"), (rows) => [...rows].reverse()],
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

// One sign turned.
/** @returns {[Cause, Numbers[]][]} */
export const flips = (rows) =>
  rows.flatMap((row, k) =>
    ["alpha", "a", "d"].flatMap((column) => {
      const twist = column === "alpha";
      if (!row[column] || (twist && Math.abs(Math.sin(row.alpha)) < 1e-9)) return [];
      const why = twist
        ? cause("table.twist", { row: k + 1 })
        : cause("table.sign", { column, row: k + 1 });
      return [[why, rows.map((r, i) => (i === k ? { ...r, [column]: -r[column] } : r))]];
    }),
  );
