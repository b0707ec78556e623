// Reads a Denavit-Hartenberg table as an arm, and describes how it was read. Arm.from_table in
// Python calls this.

import { ANGLE_TOLERANCE, snapAngle } from "../geometry/rows.js";
import { isInFieldOrder, readTables } from "../reading/table.js";
import { convertTable, describeReading } from "../reading/table_conversion.js";
import { dropOtherColumns } from "../reading/table_other_columns.js";
import { formatMessage, joinList } from "../sentences.js";
import { makeTable, snapTypedAngles } from "./table.js";
import { entryUnit } from "./table_messages.js";
import { noteRightAngles } from "./table_same.js";

/** @typedef {import("../geometry/arm.js").TableRow} TableRow */
/** @typedef {import("../reading/table.js").TypedTable} TypedTable */

const JOINT_NAME = /[qθϑ]|th/i; // shows which column holds the joints

/**
 * Read a table.
 * @param {string} text
 * @param {{ columns?: string, lengths?: string, angles?: string, convention?: string,
 *   values: [string, number][] }} options
 * @returns {{ rows: TableRow[], reading: string, guessed: boolean, warnings: string[] }} standard
 *   rows in m and rad, how the text was read, whether the order of the columns is a guess from
 *   numbers alone, and what the reader of the arm must know
 */
export function readArmTable(text, options) {
  const whole = dropOtherColumns(text);
  const typed = readTables(whole.rest.text, options, options.values)[0];
  const converted = convertTable(typed, []);
  const table = keepCoarseAngles(makeTable(typed, converted));
  const rows = snapTypedAngles(table);
  const renumbered = noteRenumberedJoints(typed, table, rows);
  const headers = whole.others.map(({ header }) => header);
  const others = headers.length
    ? [formatMessage("left out: columns", { columns: joinList(headers) })]
    : [];
  const parts = [
    describeReading(typed, converted),
    ...others,
    ...renumbered,
    ...noteRightAngles(table),
  ];
  // The warning about a guessed order asks for the convention too. The page's order is no guess if
  // a joint variable shows it.
  const isShown = isInFieldOrder(typed) && JOINT_NAME.test(text);
  const guessed = !options.columns && Boolean(typed.isOrderGuessed) && !isShown;
  const warnings = [
    ...renumbered,
    ...(guessed ? [] : noteLikelyCraig(typed, text, rows)),
    ...noteRightAngles(table, ANGLE_TOLERANCE),
  ];
  return { rows, reading: parts.join("; "), guessed, warnings };
}

// Return a table whose angles of few decimals stay as typed if a right angle has four or more:
// a 1.57 beside 1.570796 is no rounded right angle.
function keepCoarseAngles(table) {
  const isFine = (row, k, column) => {
    const isTyped = entryUnit(table, k + 1, column) > 0;
    return isTyped && row[column] !== snapAngle(row[column]);
  };
  const hasFineAngle = table.rows.some(
    (row, k) => isFine(row, k, "alpha") || isFine(row, k, "theta"),
  );
  return hasFineAngle ? { ...table, angleScale: 0 } : table; // decimals count as exact
}

// Note the joints whose typed numbers differ from the numbers of their rows. The arm uses the
// numbers of the rows.
/** @param {TypedTable} typed */
function noteRenumberedJoints(typed, { added }, rows) {
  const pairs = typed.rows.flatMap(({ joint }, k) => {
    const number = k + 1 + added;
    return joint && joint.number !== number ? [{ name: joint.name, number }] : [];
  });
  if (!pairs.length) return [];
  const before = rows
    .slice(0, pairs[0].number - 1)
    .flatMap(({ kind }, k) => (kind === "fixed" ? [k + 1] : []));
  const key = before.length ? "joints renumbered by fixed rows" : "joints renumbered";
  const names = joinRange(pairs.map(({ name }) => name));
  const numbers = joinRange(pairs.map(({ number }) => `q_${number}`));
  const is = formatMessage(pairs.length === 1 ? "is one" : "are many");
  return [formatMessage(key, { names, numbers, is, rows: joinList(before) })];
}

const joinRange = (names) =>
  names.length > 2 ? `${names[0]} to ${names.at(-1)}` : joinList(names);

// Note a table that is likely in Craig's convention. A first row without a and alpha is usual
// there, since it belongs to the base. In the standard convention it would give joints 1 and 2 the
// same axis.
/** @param {TypedTable} typed */
function noteLikelyCraig({ convention }, text, rows) {
  if (convention || /standard|spong|distal/i.test(text) || rows.length < 2) return [];
  const [first, second] = rows;
  const isBare = first.kind !== "fixed" && !first.a && !first.alpha;
  const last = rows.at(-1);
  const isLikely = first.kind === second.kind || last.a || last.alpha;
  return isBare && isLikely ? [formatMessage("likely craig")] : [];
}
