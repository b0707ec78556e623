// Converts a typed table to standard rows in m and rad. If the text does not state a unit, it is
// guessed from the numbers, and the guess is reported.

import { RAD } from "../geometry/angles.js";
import { ENTRIES } from "./table_rows.js";
import { LENGTH_UNITS, nameLengthUnit, toMetres } from "./units.js";
import { ArmError, formatMessage, formatNumber, formatRowNumbers } from "../sentences.js";

/** @typedef {import("../geometry/arm.js").TableRow} TableRow */
/** @typedef {import("./table.js").TypedTable} TypedTable */

const LEAST_MILLIMETRES = 10; // no link of an arm is 10 m long
export const MOST_RADIANS = 2 * Math.PI + 0.1; // a larger angle is in degrees
const ANGLES = ["alpha", "theta"];
const LENGTHS = ["a", "d"];

/**
 * A table in m and rad.
 * @typedef {object} ConvertedTable
 * @property {TableRow[]} rows in the standard convention
 * @property {string[]} assumptions the guesses, as phrases
 * @property {number} length the unit of bare lengths, in m
 * @property {number} angle the unit of bare angles, in rad
 */

/**
 * Convert a typed table to standard rows.
 * @param {TypedTable} table
 * @param {string[]} kinds the kinds of the rows, used if no row has a joint variable; an empty list
 *   makes all joints revolute
 * @returns {ConvertedTable}
 */
export function convertTable(table, kinds) {
  const isMillimetres = isInMillimetres(table);
  if (isMillimetres && table.otherUnit)
    throw new ArmError(formatMessage("unit seen", { unit: table.otherUnit }));
  const bareAngles = listBareAngles(table).map(Math.abs);
  const isDegrees = table.angles === null && Math.max(...bareAngles) > MOST_RADIANS;
  if (isDegrees) refuseMixedAngles(bareAngles);
  refuseContraryAngles(table, bareAngles);
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

// Return whether lengths without a stated unit are so large that they must be millimetres.
const isInMillimetres = ({ lengths, rows }) =>
  lengths === null &&
  rows.some((row) => LENGTHS.some((name) => Math.abs(typedLength(row, name)) >= LEAST_MILLIMETRES));

// Return the part of a length that comes from typed numbers, in the unit of the table.
/** @param {import("./table.js").TypedRow} row @param {string} name "a" or "d" */
const typedLength = ({ numbers, symbolMetres }, name) =>
  numbers[name] - (symbolMetres?.[name] ?? 0);

/**
 * Return a length of a row in m.
 * @param {import("./table.js").TypedRow} row @param {string} name "a" or "d"
 * @param {number} unit of the table, in m
 */
export const lengthInMetres = (row, name, unit) =>
  toMetres(typedLength(row, name), row.metres.has(name) ? 1 : unit) +
  (row.symbolMetres?.[name] ?? 0);

// List the angles, with 0 in place of an angle that was typed with pi or a unit.
const listBareAngles = ({ rows }) =>
  rows.flatMap(({ numbers, radians }) =>
    ANGLES.map((name) => (radians.has(name) ? 0 : numbers[name])),
  );

// Refuse guessed degrees beside an angle such as 1.5708, which looks like a right angle in radians.
function refuseMixedAngles(angles) {
  const rightAngle = angles.find(isRightAngle);
  if (!rightAngle) return;
  const fields = { one: formatNumber(Math.max(...angles), 4), other: formatNumber(rightAngle, 6) };
  throw new ArmError(formatMessage("two angles", fields), [{ field: "angles", value: "deg" }]);
}

// Refuse an angle above a full turn if radians were stated, and an angle such as 1.5708 if degrees
// were. In a guessed order of columns they may be lengths, and are not refused.
/** @param {TypedTable} table @param {number[]} angles */
function refuseContraryAngles({ angles: unit, isOrderGuessed }, angles) {
  const [isContrary, other] =
    unit === "rad" ? [(x) => x > MOST_RADIANS, "deg"] : [isRightAngle, "rad"];
  const contrary = unit && !isOrderGuessed ? angles.find(isContrary) : undefined;
  if (contrary === undefined) return;
  const key = unit === "rad" ? "stated radians" : "stated degrees";
  throw new ArmError(formatMessage(key, { angle: formatNumber(contrary, 6) }), [
    { field: "angles", value: other },
  ]);
}

// Return whether a number is pi/2 or pi, rounded to two decimals or more.
const isRightAngle = (x) => [Math.PI / 2, Math.PI].some((angle) => Math.abs(x - angle) < 0.005);

function convertRows(table, kinds, length, angle) {
  const rowKinds = listKinds(table, kinds);
  return table.rows.map((row, k) => {
    const { numbers, radians } = row;
    const [alpha, theta] = ANGLES.map((name) => numbers[name] * (radians.has(name) ? 1 : angle));
    const [a, d] = LENGTHS.map((name) => lengthInMetres(row, name, length));
    return { kind: rowKinds[k], a, alpha, d, theta };
  });
}

const isUnknown = ({ kind }) => kind === "unknown";

// Return whether row k of a table without joint variables comes after the rows of the arm's joints.
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
 * Convert rows of the modified (Craig) convention, whose row i holds a_{i-1} and alpha_{i-1}. Each
 * row takes a and alpha from the row below. A new fixed row takes a_0 and alpha_0 of the first row.
 * The last row is dropped if it becomes empty.
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
 * Describe how a table was read, from the order of its columns to its units. A unit is left out if
 * every entry was typed with a unit.
 * @param {TypedTable} table @param {ConvertedTable} converted
 */
export function describeReading(table, { assumptions, length, angle }) {
  const { rows, order = [], convention } = table;
  const columns = order.map((name) => COLUMN_SYMBOLS[name]).join(" ");
  const unit = nameLengthUnit(length);
  const hasBareLength = rows.some((row) =>
    LENGTHS.some((name) => typedLength(row, name) !== 0 && !row.metres.has(name)),
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
