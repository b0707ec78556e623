// A Denavit-Hartenberg table as people type it: rows in any order of columns, parallel lists,
// dictionaries, Link(...) lines, A matrices. What is not said is guessed, and every guess is told.

import { RAD } from "../geometry/angles.js";
import { without } from "./aside.js";
import { fromHeads } from "./heads.js";
import { ordered, withoutIndex } from "./table_columns.js";
import { fromMatrix, matrices } from "./table_matrices.js";
import { few, ofText } from "./table_notations.js";
import { ENTRIES, isVariable, rowOf, simple, UNITS } from "./table_rows.js";
import { ArmError, listed, say, shown } from "../sentences.js";

const MILLIMETRES = 10; // a length this large is no number of metres
const MOST_RADIANS = 2 * Math.PI + 0.1; // an angle this large is no number of radians
const EXCHANGED = { alpha: "theta", theta: "alpha" };

/** @typedef {import("../geometry/axes.js").Numbers} Numbers */

/**
 * A row as it was meant; its numbers as typed, `radians` for entries with pi or a degree sign in
 * them. The kind is "unknown" where no variable stands in it.
 * @typedef {object} TypedRow
 * @property {string} kind
 * @property {Record<string, number>} numbers
 * @property {Record<string, string>} texts
 * @property {boolean} backwards
 * @property {Set<string>} radians
 * @property {Record<string, any>} [trees] the formulas of its entries; none where they were found
 *   by matrices
 */

/**
 * The rows in the units typed, and what was said or guessed of them; null where nothing was.
 * `exchanged` where the heads of alpha and theta stand over one another's entries, as the joints'
 * variables show.
 * @typedef {{ rows: TypedRow[], lengths: string | null, angles: string | null, convention: string |
 *   null, said: string[], exchanged?: boolean, guessed?: boolean, entries?: string[] }} TypedTable
 *   `entries` are all cells that were read, as typed
 */

/**
 * The readings of a table, the likeliest first: more than one only where the order of the columns
 * had to be guessed. One whose heads of alpha and theta are exchanged is read too.
 * @param {string} text
 * @param {{ columns?: string, lengths?: string, angles?: string, convention?: string }} options
 * @param {[string, number][]} values of its symbols
 * @returns {TypedTable[]}
 */
export function read(text, { columns, ...options } = {}, values = []) {
  const typed = ofText(text);
  if (!typed.cells.length) throw new ArmError(say("no rows", { given: shown(text) }));
  const known = new Map(values.map(([name, x]) => [simple(name), x]));
  const found = matrices(typed.cells);
  if (found) return [{ ...ofMatrices(found, known, options), entries: typed.cells.flat() }];
  const { cells, heads } = withoutIndex(typed);
  few(cells.length);
  const order = ordered(cells, heads, columns);
  const units = unitsOf(options, fromHeads(heads));
  const used = without(cells.flat(), order.unused ?? []);
  const entries = typed.entries ?? used;
  return readings(order, known).map((table) => ({
    ...units,
    ...table,
    entries,
    said: [...typed.said, ...table.said],
  }));
}

/**
 * What was said of the units and the convention: by the reader, else by the heads.
 * @param {{ lengths?: string, angles?: string, convention?: string }} options
 * @param {{ lengths?: string, angles?: string, convention?: string }} heads
 */
const unitsOf = ({ lengths, angles, convention }, heads = {}) => ({
  lengths: lengths || (heads.lengths ?? null),
  angles: angles || (heads.angles ?? null),
  convention: convention || (heads.convention ?? null),
});

function ofMatrices(found, known, options) {
  few(found.length);
  const rows = found.map((A, k) => fromMatrix(k + 1, A, known));
  return { ...unitsOf(options), rows, said: [say("taken: matrices")] };
}

// The tables that the possible orders give. Where the order was said and fails, since the joints'
// variables stand in alpha, the heads of alpha and theta are exchanged.
function readings({ orders, sure, rows }, known) {
  const attempts = orders.map((order) => attempted(rows, order, known, sure));
  const tables = attempts.filter((attempt) => attempt.rows);
  if (tables.length) return tables;
  if (!sure || !variablesInAlpha(rows, orders[0])) throw attempts[0].error;
  const exchanged = orders[0].map((name) => EXCHANGED[name] ?? name);
  const table = attempted(rows, exchanged, known, sure);
  if (!table.rows) throw table.error;
  return [{ ...table, exchanged: true }];
}

function variablesInAlpha(rows, order) {
  const [alphas, thetas] = ["alpha", "theta"].map((name) =>
    rows.map((row) => row[order.indexOf(name)]),
  );
  return alphas.some(isVariable) && !thetas.some(isVariable);
}

// Whether the lengths are taken as millimetres though nobody said so.
export const inMillimetres = ({ lengths, rows }) =>
  lengths === null &&
  rows.some(({ numbers: n }) => Math.max(Math.abs(n.a), Math.abs(n.d)) >= MILLIMETRES);

function attempted(cells, order, known, sure) {
  try {
    const rows = cells.map((row, k) => {
      const entries = Object.fromEntries(order.map((name, i) => [name, row[i]]));
      return rowOf(k + 1, entries, known);
    });
    const said = sure ? [] : [say("taken: columns", { columns: order.join(" ") })];
    return { rows, said, guessed: !sure };
  } catch (error) {
    if (error instanceof ArmError) return { error };
    throw error;
  }
}

/**
 * A table as it was meant: standard rows in m and rad, what was guessed, and the sizes of the units
 * typed. `kinds` are taken where no row holds a variable and there are as many; all turn otherwise.
 * @param {TypedTable} table
 * @param {string[]} kinds
 * @returns {{ rows: Numbers[], said: string[], length: number, angle: number }}
 */
export function meant(table, kinds) {
  const millimetres = inMillimetres(table);
  const degrees = table.angles === null && largestAngle(table) > MOST_RADIANS;
  const length = UNITS[millimetres ? "mm" : (table.lengths ?? "m")];
  const angle = degrees || table.angles === "deg" ? RAD : 1;
  const craig = table.convention === "craig";
  const rows = inUnits(table, kinds, length, angle);
  const said = [
    ...table.said,
    ...(millimetres ? [say("taken: millimetres")] : []),
    ...(degrees ? [say("taken: degrees")] : []),
    ...saidOfRows("taken: fixed", fixedRows(table, kinds)),
    ...(craig ? [say("taken: craig")] : []),
    ...saidOfRows(
      "taken: backwards",
      numbersOf(table.rows, ({ backwards }) => backwards),
    ),
  ];
  return { rows: craig ? fromCraig(rows) : rows, said, length, angle };
}

const ANGLES = ["alpha", "theta"];

// The largest of the angles that hold no pi and no degree sign.
const largestAngle = ({ rows }) =>
  rows
    .flatMap(({ numbers, radians }) => ANGLES.map((c) => (radians.has(c) ? 0 : numbers[c])))
    .reduce((top, x) => Math.max(top, Math.abs(x)), 0);

function inUnits(table, kinds, length, angle) {
  const moving = kindsOf(table, kinds);
  return table.rows.map(({ numbers: n, radians }, k) => {
    const [alpha, theta] = ANGLES.map((c) => n[c] * (radians.has(c) ? 1 : angle));
    return { kind: moving[k], a: n.a * length, alpha, d: n.d * length, theta };
  });
}

const numbersOf = (rows, chosen) => rows.flatMap((row, k) => (chosen(row, k) ? [k + 1] : []));

// The rows of a table without variables that are more than the arm's joints.
const fixedRows = ({ rows }, kinds) =>
  kinds.length && rows.every(unknown) ? numbersOf(rows, (_, k) => k >= kinds.length) : [];

const saidOfRows = (key, rows) => (rows.length ? [say(key, { rows: namedRows(rows) })] : []);

const namedRows = (rows) =>
  rows.length === 1
    ? say("row", { row: rows[0] })
    : say("rows", { rows: listed(rows.map(String)) });

const unknown = ({ kind }) => kind === "unknown";

function kindsOf({ rows }, wanted) {
  const more = rows.length - wanted.length;
  if (rows.every(unknown))
    return wanted.length && more >= 0
      ? [...wanted, ...Array(more).fill("fixed")]
      : rows.map(() => "revolute");
  return rows.map(({ kind }) => (kind === "unknown" ? "fixed" : kind));
}

const EMPTY = { kind: "fixed", a: 0, alpha: 0, d: 0, theta: 0 };
const isEmpty = (row) => row.kind === "fixed" && ENTRIES.every((name) => row[name] === 0);

// Standard rows from modified ones, which begin with a_{i-1}, alpha_{i-1}: a fixed row before them
// takes a_0 and alpha_0; a last one that is left empty goes.
/** @param {Numbers[]} rows @returns {Numbers[]} */
export function fromCraig(rows) {
  const shifted = rows.map((row, k) => {
    const { a, alpha } = rows[k + 1] ?? EMPTY;
    return { ...row, a, alpha };
  });
  if (shifted.length > 1 && isEmpty(shifted.at(-1))) shifted.pop();
  const first = { ...EMPTY, a: rows[0].a, alpha: rows[0].alpha };
  return isEmpty(first) ? shifted : [first, ...shifted];
}
