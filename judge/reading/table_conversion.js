// Converts a typed table to standard rows in m and rad. Units and conventions that the text does
// not state are guessed from the numbers, and each guess is reported.

import { RAD } from "../geometry/angles.js";
import { ENTRIES } from "./table_rows.js";
import { LENGTH_UNITS, nameLengthUnit, toMetres } from "./units.js";
import { ArmError, formatMessage, formatNumber, formatRowNumbers } from "../sentences.js";

/** @typedef {import("../geometry/arm.js").TableRow} TableRow */
/** @typedef {import("./table.js").TypedTable} TypedTable */

const LEAST_MILLIMETRES = 10; // a length this large is no number of metres
export const MOST_RADIANS = 2 * Math.PI + 0.1; // an angle above this is no number of radians
const ANGLES = ["alpha", "theta"];
const LENGTHS = ["a", "d"];

/**
 * A table in m and rad.
 * @typedef {object} ConvertedTable
 * @property {TableRow[]} rows in the standard convention
 * @property {string[]} assumptions what was guessed, as phrases
 * @property {number} length the unit of bare lengths, in m
 * @property {number} angle the unit of bare angles, in rad
 */

/**
 * Convert a typed table to standard rows.
 * @param {TypedTable} table
 * @param {string[]} kinds the rows' kinds if no row holds a variable; [] for joints that all turn
 * @returns {ConvertedTable}
 */
export function convertTable(table, kinds) {
  const isMillimetres = isInMillimetres(table);
  const bareAngles = listBareAngles(table).map(Math.abs);
  const isDegrees = table.angles === null && Math.max(...bareAngles) > MOST_RADIANS;
  if (isDegrees) refuseMixedAngles(bareAngles);
  refuseLargeAngles(table, bareAngles);
  const length = LENGTH_UNITS[isMillimetres ? "mm" : (table.lengths ?? "m")];
  const angle = isDegrees || table.angles === "deg" ? RAD : 1;
  const isCraig = table.convention === "craig";
  const rows = convertRows(table, kinds, length, angle);
  const assumptions = [
    ...table.assumptions,
    ...(isMillimetres ? [formatMessage("taken: millimetres")] : []),
    ...(isDegrees ? [formatMessage("taken: degrees")] : []),
    ...formatRowsMessage("taken: fixed", (_, k) => isBeyondJoints(table, kinds, k), table),
    ...(isCraig ? [formatMessage("taken: craig")] : []),
    ...formatRowsMessage("taken: backwards", ({ backwards }) => backwards, table),
  ];
  return { rows: isCraig ? convertFromCraig(rows) : rows, assumptions, length, angle };
}

// Return whether the lengths count as millimetres though nobody said so.
const isInMillimetres = ({ lengths, rows }) =>
  lengths === null &&
  rows.some(({ numbers }) => LENGTHS.some((name) => Math.abs(numbers[name]) >= LEAST_MILLIMETRES));

// List the angles typed without pi and without a unit; 0 stands for each other one.
const listBareAngles = ({ rows }) =>
  rows.flatMap(({ numbers, radians }) =>
    ANGLES.map((name) => (radians.has(name) ? 0 : numbers[name])),
  );

// Refuse angles of which one is above a full turn in radians and another looks like a right angle
// in radians.
function refuseMixedAngles(angles) {
  const rightAngle = angles.find(isRightAngle);
  if (!rightAngle) return;
  const fields = { one: formatNumber(Math.max(...angles), 4), other: formatNumber(rightAngle, 6) };
  throw new ArmError(formatMessage("two angles", fields), [{ field: "angles", value: "deg" }]);
}

// Refuse angles of more than a turn where radians were stated. In a guessed order of columns they
// may be lengths.
/** @param {TypedTable} table @param {number[]} angles */
function refuseLargeAngles({ angles: unit, isOrderGuessed }, angles) {
  const most = Math.max(...angles);
  if (unit !== "rad" || isOrderGuessed || most <= MOST_RADIANS) return;
  const angle = formatNumber(most, 6);
  throw new ArmError(formatMessage("stated radians", { angle }), [
    { field: "angles", value: "deg" },
  ]);
}

// Return whether a number is pi/2 or pi, to two decimals or more.
const isRightAngle = (x) => [Math.PI / 2, Math.PI].some((angle) => Math.abs(x - angle) < 0.005);

function convertRows(table, kinds, length, angle) {
  const rowKinds = listKinds(table, kinds);
  return table.rows.map(({ numbers, radians, metres }, k) => {
    const [alpha, theta] = ANGLES.map((name) => numbers[name] * (radians.has(name) ? 1 : angle));
    const [a, d] = LENGTHS.map((name) => toMetres(numbers[name], metres.has(name) ? 1 : length));
    return { kind: rowKinds[k], a, alpha, d, theta };
  });
}

const isUnknown = ({ kind }) => kind === "unknown";

// Return whether row k of a table without variables lies beyond the arm's joints.
const isBeyondJoints = ({ rows }, kinds, k) =>
  kinds.length > 0 && k >= kinds.length && rows.every(isUnknown);

function formatRowsMessage(key, isListed, { rows }) {
  const numbers = rows.flatMap((row, k) => (isListed(row, k) ? [k + 1] : []));
  return numbers.length ? [formatMessage(key, { rows: formatRowNumbers(numbers) })] : [];
}

function listKinds({ rows }, kinds) {
  if (!rows.every(isUnknown)) return rows.map((row) => (isUnknown(row) ? "fixed" : row.kind));
  return rows.map((_, k) => kinds[k] ?? (kinds.length ? "fixed" : "revolute"));
}

/** @type {TableRow} */
const EMPTY_ROW = { kind: "fixed", a: 0, alpha: 0, d: 0, theta: 0 };
const isEmpty = (row) => row.kind === "fixed" && ENTRIES.every((name) => row[name] === 0);

/**
 * Convert rows of the modified convention, which begin with a_{i-1} and alpha_{i-1}. A fixed row
 * before them takes a_0 and alpha_0; a last row that is left empty is dropped.
 * @param {TableRow[]} rows @returns {TableRow[]}
 */
export function convertFromCraig(rows) {
  const shifted = rows.map((row, k) => {
    const { a, alpha } = rows[k + 1] ?? EMPTY_ROW;
    return { ...row, a, alpha };
  });
  if (shifted.length > 1 && isEmpty(shifted.at(-1))) shifted.pop();
  const first = { ...EMPTY_ROW, a: rows[0].a, alpha: rows[0].alpha };
  return isEmpty(first) ? shifted : [first, ...shifted];
}

/**
 * Describe how a table was read: the order of its columns, its convention, its units and other
 * guesses. A unit is left out if every entry has its own.
 * @param {TypedTable} table @param {ConvertedTable} converted
 */
export function describeReading(table, { assumptions, length, angle }) {
  const { rows, order = [], convention } = table;
  const columns = order.map((name) => COLUMN_SYMBOLS[name]).join(" ");
  const unit = nameLengthUnit(length);
  const hasBareLength = rows.some(({ numbers, metres }) =>
    LENGTHS.some((name) => numbers[name] !== 0 && !metres.has(name)),
  );
  const hasBareAngle = listBareAngles(table).some(Boolean);
  const parts = [
    ...(columns ? [formatMessage("taken: columns", { columns })] : []),
    formatMessage(convention === "craig" ? "taken: craig" : "taken: standard"),
    ...(hasBareLength ? [formatMessage("taken: lengths", { unit })] : []),
    ...(hasBareAngle ? [formatMessage(angle === 1 ? "taken: radians" : "taken: degrees")] : []),
  ];
  const stated = ["taken: millimetres", "taken: degrees", "taken: craig"].map((key) =>
    formatMessage(key),
  );
  const guessedOrder = formatMessage("taken: columns", { columns: order.join(" ") });
  const rest = assumptions.filter((phrase) => phrase !== guessedOrder && !stated.includes(phrase));
  return [...parts, ...rest].join("; ");
}

const COLUMN_SYMBOLS = { a: "a", alpha: "α", d: "d", theta: "θ" };
