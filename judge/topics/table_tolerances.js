// Finds the last typed places of a table's entries, and how much the entries may differ from the
// reference's because of them.

import { units } from "../digits.js";
import { ANGLE_TOLERANCE } from "../geometry/rows.js";
import { DECIMAL } from "./table_messages.js";

/** @typedef {import("../geometry/arm.js").TableRow} TableRow */
/** @typedef {import("./table.js").Table} Table */

export const EXACT_LENGTH = 1e-6; // m
const COARSEST_UNIT = 1e-3; // m: lengths typed to the millimetre are still compared
const WHOLE_NUMBERS = /^(?:[-+−()$\s0-9]|(?<=[0-9])\.(?![0-9]))*$/; // and their sums

// Return the finest unit of the last digits in some columns, or 0 if they have no decimals.
export function findFinestUnit(texts, columns) {
  const decimals = texts.flatMap((row) =>
    columns.flatMap((column) => row[column].match(DECIMAL) ?? []),
  );
  const finest = units(decimals).filter(Boolean);
  return finest.length ? Math.min(...finest) : 0;
}

// Return the unit of lengths that are all whole numbers if it is small, else 0. Whole numbers among
// formulas are exact.
export function findWholeUnit(typed, scale) {
  const lengths = typed.rows.flatMap(({ kind, texts }) =>
    kind === "prismatic" ? [texts.a] : [texts.a, texts.d],
  );
  const isWhole = lengths.every((text) => WHOLE_NUMBERS.test(text));
  return scale <= COARSEST_UNIT && isWhole ? scale : 0;
}

/**
 * Compute how much the lengths (m) and angles (rad) of a table may differ from the reference's.
 * `exact` holds for a right table, `rounded` and `roundedAngle` for one with rounded entries,
 * `mapLength` for lengths in the search for a joint map, and `typedLength` is half of the last
 * typed place of the lengths.
 * @param {Table} table @param {TableRow[]} rows @param {number | null} tolerance of the question
 */
export function computeTolerances(table, rows, tolerance) {
  const [typedLength, typedAngle] = [table.lengthUnit, table.angleUnit].map((unit) =>
    tolerance === null && unit <= COARSEST_UNIT ? 0.51 * unit : 0,
  );
  const exact = tolerance === null ? EXACT_LENGTH : Math.max(tolerance, 1e-12);
  const longest = Math.max(...rows.flatMap(({ a, d }) => [Math.abs(a), Math.abs(d)]));
  // A rounded angle moves the point where an axis meets the next axis.
  const rounded = Math.max(exact, 2 * typedLength, 2.5 * typedAngle * longest);
  const lastPlace = Math.min(table.lengthUnit || table.angleUnit * longest, COARSEST_UNIT);
  return {
    exact,
    rounded: tolerance === null ? rounded : exact,
    roundedAngle: Math.max(ANGLE_TOLERANCE, 4 * typedAngle),
    mapLength: 10 * lastPlace,
    typedLength,
  };
}
