// A Denavit-Hartenberg table as people type it: rows in any order of columns, parallel lists,
// dictionaries, Link(...) lines, A matrices. What is not said is guessed, and every guess is told.

import { RAD } from "../geometry/angles.js";
import { withoutComments, withoutStruckText } from "./decorations.js";
import { hasDecimals, number, plain, simple } from "./formula.js";
import { refuseUnread, tokensOf } from "./owners.js";
import { SpannedText } from "./spans.js";
import { entryIn, tablesIn } from "./table_blocks.js";
import { joinCellLines } from "./table_cell_lines.js";
import { EXCHANGED, fromHeads, headOf, ordered, withoutIndex } from "./table_columns.js";
import { fromMatrix, matrices, NoLink } from "./table_matrices.js";
import { readNamedTable, refuseManyRows } from "./table_notations.js";
import { listNamedNumbers, placeBlockNumbers, placeMatrixNumbers } from "./table_owners.js";
import { ENTRIES, entryText, isVariable, rowOf, toMetres, UNITS } from "./table_rows.js";
import {
  ArmError,
  formatMessage,
  formatRowNumbers,
  quoteText,
  formatNumber,
  tryOrNull,
} from "../sentences.js";

const MILLIMETRES = 10; // a length this large is no number of metres
const MOST_RADIANS = 2 * Math.PI + 0.1; // an angle this large is no number of radians

/** @typedef {import("../geometry/arm.js").TableRow} Numbers */

/**
 * A row as it was meant; its numbers as typed, `radians` for entries with pi or a degree sign in
 * them. The kind is "unknown" where no variable stands in it.
 * @typedef {object} TypedRow
 * @property {string} kind
 * @property {Record<string, number>} numbers
 * @property {Record<string, string>} texts
 * @property {boolean} backwards
 * @property {{ name: string, number: number } | null} [joint] its variable, where that has a number
 * @property {Set<string>} radians
 * @property {Set<string>} metres entries with a length's unit of their own, in m
 * @property {Record<string, any>} [trees] the formulas of its entries; none where they were found
 *   by matrices
 */

/**
 * The rows in the units typed, and what was said or guessed of them; null where nothing was.
 * `exchanged` where the heads of alpha and theta stand over one another's entries, as the joints'
 * variables show.
 * @typedef {{ rows: TypedRow[], lengths: string | null, angles: string | null, convention: string |
 *   null, said: string[], exchanged?: boolean, guessed?: boolean, left?: string[],
 *   tokens?: import("./owners.js").Token[], order?: string[] }} TypedTable `left` is what else
 *   stands in the text, `order` the entries of its columns
 */

/**
 * The readings of a table, the likeliest first: more than one only where the order of the columns
 * had to be guessed. One whose heads of alpha and theta are exchanged is read too.
 * @param {string} typedText
 * @param {{ columns?: string, lengths?: string, angles?: string, convention?: string }} options
 * @param {[string, number][]} values of its symbols
 * @returns {TypedTable[]}
 */
export function read(typedText, { columns, ...options } = {}, values = []) {
  refuseSize(typedText);
  const own = defined(withoutStruckText(new SpannedText(typedText)).text);
  const known = new Map([...values, ...own].map(([name, x]) => [simple(name), x]));
  const text = joinCellLines(typedText, entryIn(known));
  const pasted = withoutStruckText(new SpannedText(text));
  const live = withoutComments(pasted);
  for (const plainText of [live, pasted]) {
    const named = plainText && readNamedTable(plainText.text);
    if (!named) continue;
    const tokens = listNamedNumbers(plainText, text, named);
    return tablesOf(named, { columns, options, known }).map((table) => ({ ...table, tokens }));
  }
  const tables =
    live &&
    tryOrNull(() => tablesOfBlocks(text, tablesIn(text, known, live), { columns, options, known }));
  return tables ?? tablesOfBlocks(text, tablesIn(text, known, pasted), { columns, options, known });
}

// The tables of the first block that is one.
function tablesOfBlocks(text, blocks, asked) {
  let refused = null;
  for (const block of blocks) {
    let tokens = [];
    try {
      tokens = refuseBlock(block, text);
      return tablesOf({ ...block, said: [] }, asked).map((table) => ({
        ...table,
        tokens: table.order
          ? placeBlockNumbers(tokens, block, table, text)
          : placeMatrixNumbers(tokens, text),
      }));
    } catch (error) {
      if (!(error instanceof ArmError)) throw error;
      if (error instanceof NoLink) {
        error.tokens = placeMatrixNumbers(tokens, text);
        throw error;
      }
      refused ??= error;
    }
  }
  if (refused) throw refused;
  throw new ArmError(formatMessage("no rows", { given: quoteText(text) }));
}

// An error for numbers that are not read, rows torn in two, and frames where links are asked for.
/** @param {import("./table_blocks.js").TableBlock} block @param {string} text */
function refuseBlock({ torn, cells, block }, text) {
  if (torn) throw new ArmError(formatMessage("row torn", { line: quoteText(torn.trim()) }));
  const tokens = tokensOf(text, block, FEWEST_ROWS);
  refuseUnread(text, tokens, formatMessage("your table"));
  if (matrices(cells) && FRAMES.test(text)) throw new NoLink("table.frames");
  return tokens;
}

const FEWEST_ROWS = 2; // of a table beside which a row of its width is one of its own

function refuseSize(text) {
  const what = formatMessage("your table");
  if (text.length > LONGEST)
    throw new ArmError(formatMessage("too long", { what, count: text.length }));
  if (!text.trim()) throw new ArmError(formatMessage("empty", { what }));
}

// Lengths that a text gives itself, l_1 = 0.5 m, but for the names of columns and joints.
function defined(text) {
  const found = [...text.matchAll(DEFINED)].map(([, name, x, unit]) => [
    plain(name),
    toMetres(number(x), UNITS[unit ?? "m"]),
  ]);
  return found.filter(([name, x]) => Number.isFinite(x) && !headOf(name) && !isVariable(name));
}

const LONGEST = 100_000; // characters
const PRODUCT = String.raw`-?\d+(?:\.\d+)?(?:[ ]?[*/][ ]?\d+(?:\.\d+)?)*`; // L1 = 2 * 0.15
const DEFINED = new RegExp(
  String.raw`(?<![\p{L}\p{N}_.])([A-Za-z](?:_?\{?\w{1,4}\}?)?)\s*:?=` +
    String.raw`\s*(${PRODUCT})\s*(mm|cm|m)?(?![\w.*/+^°]| ?[*/+^])`,
  "gu",
);

// The tables that cells below their heads may be.
/** @param {any} found @returns {TypedTable[]} */
function tablesOf(found, { columns, options, known }) {
  const typed = { ...found, cells: found.cells.map((row) => row.map(entryText)) };
  const links = matrices(typed.cells);
  if (links) return [{ ...ofMatrices(links, known, options), left: typed.left }];
  const { cells, heads } = withoutIndex(typed);
  refuseManyRows(cells.length);
  const order = ordered(cells, heads, columns);
  const named = { ...fromHeads(heads), ...(found.convention && { convention: found.convention }) };
  const units = unitsOf(options, withContext(named, typed.context));
  const held = order.rows.flat().join(" & ");
  const unused = typed.cells.flat().filter((cell) => hasDecimals(cell) && !held.includes(cell));
  return readings(order, known).map((table) => ({
    ...units,
    ...table,
    order: order.typedOrder ?? table.order,
    left: [...typed.left, ...unused],
    said: [...typed.said, ...table.said],
  }));
}

const FRAMES = /\bT_?\{?0_?[2-9]|\b0_?T_?[2-9]|\bT_?\{?[2-9]\}?\^\{?0/; // T_02 and 0T2

// Around a table may stand whose convention it follows.
const withContext = (heads, context) => {
  const craig = /\bcraig\b|\bmodified\b/i.test(context) && !/\bstandard\b|\bspong\b/i.test(context);
  return craig ? { ...heads, convention: "craig" } : heads;
};

/**
 * Find the units and the convention that were given: by the reader, else by the heads.
 * @param {{ lengths?: string, angles?: string, convention?: string }} options
 * @param {{ lengths?: string, angles?: string, convention?: string }} heads
 */
const unitsOf = ({ lengths, angles, convention }, heads = {}) => ({
  lengths: lengths || (heads.lengths ?? null),
  angles: angles || (heads.angles ?? null),
  convention: convention || (heads.convention ?? null),
});

function ofMatrices(found, known, options) {
  refuseManyRows(found.length);
  const rows = found.map((A, k) => fromMatrix(k + 1, A, known));
  return { ...unitsOf(options), rows, said: [formatMessage("taken: matrices")] };
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

// Return whether the lengths are taken as millimetres though nobody said so.
const inMillimetres = ({ lengths, rows }) =>
  lengths === null &&
  rows.some(({ numbers: n, metres }) =>
    ["a", "d"].some((c) => !metres.has(c) && Math.abs(n[c]) >= MILLIMETRES),
  );

function attempted(cells, order, known, sure) {
  try {
    const rows = cells.map((row, k) => {
      const entries = Object.fromEntries(order.map((name, i) => [name, row[i]]));
      return rowOf(k + 1, entries, known);
    });
    const said = sure ? [] : [formatMessage("taken: columns", { columns: order.join(" ") })];
    return { rows, said, order, guessed: !sure };
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
  const bare = bareAngles(table).map(Math.abs);
  const degrees = table.angles === null && Math.max(...bare) > MOST_RADIANS;
  const quarter = degrees && bare.find(isQuarter);
  if (quarter)
    throw new ArmError(
      formatMessage("two angles", {
        one: formatNumber(Math.max(...bare), 4),
        other: formatNumber(quarter, 6),
      }),
      [{ field: "angles", value: "deg" }],
    );
  const length = UNITS[millimetres ? "mm" : (table.lengths ?? "m")];
  const angle = degrees || table.angles === "deg" ? RAD : 1;
  const craig = table.convention === "craig";
  const rows = inUnits(table, kinds, length, angle);
  const said = [
    ...table.said,
    ...(millimetres ? [formatMessage("taken: millimetres")] : []),
    ...(degrees ? [formatMessage("taken: degrees")] : []),
    ...saidOfRows("taken: fixed", fixedRows(table, kinds)),
    ...(craig ? [formatMessage("taken: craig")] : []),
    ...saidOfRows(
      "taken: backwards",
      numbersOf(table.rows, ({ backwards }) => backwards),
    ),
  ];
  return { rows: craig ? fromCraig(rows) : rows, said, length, angle };
}

const ANGLES = ["alpha", "theta"];

// The angles that hold no pi and no degree sign.
const bareAngles = ({ rows }) =>
  rows.flatMap(({ numbers, radians }) => ANGLES.map((c) => (radians.has(c) ? 0 : numbers[c])));

// Return whether a number is a quarter turn or two in radians, to two decimals or more.
const isQuarter = (x) =>
  [Math.PI / 2, Math.PI].some((turn) => !Number.isInteger(x) && Math.abs(x - turn) < 0.005);

function inUnits(table, kinds, length, angle) {
  const moving = kindsOf(table, kinds);
  return table.rows.map(({ numbers: n, radians, metres }, k) => {
    const [alpha, theta] = ANGLES.map((c) => n[c] * (radians.has(c) ? 1 : angle));
    const [a, d] = ["a", "d"].map((c) => toMetres(n[c], metres.has(c) ? 1 : length));
    return { kind: moving[k], a, alpha, d, theta };
  });
}

const numbersOf = (rows, chosen) => rows.flatMap((row, k) => (chosen(row, k) ? [k + 1] : []));

// The rows of a table without variables that are more than the arm's joints.
const fixedRows = ({ rows }, kinds) =>
  kinds.length && rows.every(unknown) ? numbersOf(rows, (_, k) => k >= kinds.length) : [];

const saidOfRows = (key, rows) =>
  rows.length ? [formatMessage(key, { rows: formatRowNumbers(rows) })] : [];

const unknown = ({ kind }) => kind === "unknown";

function kindsOf({ rows }, wanted) {
  const more = wanted.length ? "fixed" : "revolute";
  if (rows.every(unknown)) return rows.map((_, k) => wanted[k] ?? more);
  return rows.map(({ kind }) => (kind === "unknown" ? "fixed" : kind));
}

/** @type {Numbers} */
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

/**
 * An arm of one's own, typed into a field that asks for a, alpha, d, theta: standard rows in m and
 * rad, what was guessed of them, and whether the columns' order was. Where no heads say otherwise
 * the columns are in the field's order, if they can be; bare angles are in degrees where that is
 * the unit.
 * @param {string} text
 * @param {string} unit "deg" or "rad"
 * @param {[string, number][]} values of its symbols
 * @param {string | null} length the unit of bare lengths; guessed where there is none
 */
export function ownRows(text, unit, values = [], length = null) {
  const asked = formatMessage("taken: columns", { columns: "a alpha d theta" });
  const tables = read(text, {}, values);
  const table = tables.find(({ said }) => said.includes(asked)) ?? tables[0];
  const angles = table.angles ?? (unit === "deg" || length ? unit : null);
  const taken = meant({ ...table, lengths: table.lengths ?? length, angles }, []);
  const said = taken.said.filter((words) => words !== asked);
  const guessed = table.guessed && !table.said.includes(asked);
  return { rows: taken.rows, said, guessed, reading: describeReading(table, taken) };
}

// Say how a table was read: the order of its columns, its convention and units, and the rest that
// was guessed. A unit is left out where every entry has one of its own.
export function describeReading(table, { said, length, angle }) {
  const { rows, order = [], convention } = table;
  const columns = order.map((name) => COLUMN_SYMBOLS[name]).join(" ");
  const unit = Object.keys(UNITS).find((name) => UNITS[name] === length);
  const hasBareLength = rows.some(({ numbers, metres }) =>
    ["a", "d"].some((name) => numbers[name] && !metres.has(name)),
  );
  const hasBareAngle = bareAngles(table).some(Boolean);
  const parts = [
    columns && formatMessage("taken: columns", { columns }),
    formatMessage(convention === "craig" ? "taken: craig" : "taken: standard"),
    hasBareLength && formatMessage("taken: lengths", { unit }),
    hasBareAngle && formatMessage(angle === 1 ? "taken: radians" : "taken: degrees"),
  ].filter(Boolean);
  const stated = ["taken: millimetres", "taken: degrees", "taken: craig"].map((key) =>
    formatMessage(key),
  );
  const guessedOrder = formatMessage("taken: columns", { columns: order.join(" ") });
  const rest = said.filter((words) => words !== guessedOrder && !stated.includes(words));
  return [...parts, ...rest].join("; ");
}

const COLUMN_SYMBOLS = { a: "a", alpha: "α", d: "d", theta: "θ" };
