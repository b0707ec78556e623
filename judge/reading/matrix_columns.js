// A matrix given as its columns, J1 = [...], J2 = [...] and on.

import { cellsOf } from "./numbers.js";
import { partsOf } from "./parts.js";

const COLUMN = /^J_?\{?(\d)\}?$/i;

/** The rows of such a text; anything else as it is. */
export function rowsOfColumns(text) {
  if (typeof text !== "string") return text;
  const columns = partsOf(text).filter(({ name = "" }) => COLUMN.test(name));
  const counted = columns.every(({ name }, k) => Number(COLUMN.exec(name)[1]) === k + 1);
  if (columns.length < 2 || !counted) return text;
  const cells = columns.map(({ lines }) => cellsOf(lines.join("\n")).flat());
  if (!cells.every(({ length }) => length === cells[0].length && [3, 6].includes(length)))
    return text;
  return cells[0].map((_, i) => cells.map((column) => column[i]).join("\t")).join("\n");
}
