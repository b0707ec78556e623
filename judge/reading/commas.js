// Commas: those that part entries, decimal ones, and those of thousands.

import { isNumber } from "./formula.js";
import { stripped } from "./text.js";
import { ArmError, shown } from "../sentences.js";

// 0,333, which cannot be a group of thousands; 1,234.5; 1.234,5; and 1,234, which may be either.
const DECIMAL = /^\s*[-+−]?(?![1-9][0-9]{0,2},[0-9]{3}\s*$)[0-9]+,[0-9]+\s*$/;

const THOUSANDS = /^[-+−]?[0-9]{1,3}(?:,[0-9]{3})+\.[0-9]+$/;
const DOTTED_THOUSANDS = /^[-+−]?[0-9]{1,3}(?:\.[0-9]{3})+,[0-9]+$/;
const EITHER = /^[-+−]?[1-9][0-9]{0,2},[0-9]{3}$/; // a decimal comma, or one of thousands
const QUOTED = /"[^"\n]*,[^"\n]*"/g;

// A number with a decimal comma with a point; as it is where the comma may part thousands.
export const decimal = (cell) => (DECIMAL.test(cell) ? cell.replace(",", ".") : cell);

// A line whose quoted numbers, "0,333", have points for their decimal commas.
export const unquotedNumbers = (line) => line.replace(QUOTED, ofQuotes);

// A number in quotes with a point for its decimal comma.
function ofQuotes(quoted) {
  const inner = quoted.slice(1, -1).trim();
  if (EITHER.test(inner)) throw eitherOf(inner, shown(inner));
  const found = pointed(inner);
  return isNumber(found) ? found : quoted;
}

// Cells with points for decimal commas; an error where a comma may part thousands.
export function pointedRows(rows) {
  const found = rows.map((row) => row.map(pointed));
  const texts = rows.flat().map((cell) => stripped(cell.trim(), '"'));
  const either = texts.find((text) => EITHER.test(text));
  const point = texts.find((text) => /[0-9]\.[0-9]/.test(text));
  if (either && point && !DOTTED_THOUSANDS.test(point))
    throw eitherOf(either, `${shown(either)} beside ${shown(point)}`);
  return found;
}

// A cell with a decimal comma written with a point, and without a spreadsheet's quotes.
function pointed(cell) {
  const inner = cell.trim();
  if (inner[0] === '"' && inner.at(-1) === '"') cell = inner.slice(1, -1);
  if (/^\s*[-+−]?,[0-9]+\s*$/.test(cell)) return cell.replace(",", ".");
  if (THOUSANDS.test(cell.trim())) return cell.replaceAll(",", "");
  if (DOTTED_THOUSANDS.test(cell.trim())) return cell.replaceAll(".", "").replace(",", ".");
  return cell.split(",").length === 2 && !cell.includes("(")
    ? cell.replace(/(?<=\d),(?=\d)/g, ".")
    : cell;
}

// What is said of a comma that may be a decimal one or part thousands.
const eitherOf = (cell, given) =>
  new ArmError(
    `a cell is ${given}; expected ${cell.replace(",", ".")} or ${cell.replace(",", "")}`,
  );
