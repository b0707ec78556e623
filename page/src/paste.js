// A DH table out of what is on a clipboard: cells of a spreadsheet, a matrix of MATLAB or NumPy,
// Markdown, LaTeX.

import { rowsFault } from "../../judge/geometry/arm.js";
import { readEntry } from "./entry.js";

const NAMES = {
  a: "a",
  r: "a",
  alpha: "alpha",
  α: "alpha",
  "\\alpha": "alpha",
  d: "d",
  theta: "theta",
  θ: "theta",
  "\\theta": "theta",
};
const ORDER = ["a", "alpha", "d", "theta"];
const VARIABLE = /^(.*?)(?:\+\s*)?(?:q|θ|theta|\\theta|d)\s*_?\{?\d+\}?\s*\*?\s*(.*)$/i;

/**
 * The rows that a text describes, or what is wrong with it, or null where it is a single entry.
 * @param {string} text
 * @param {string} unit of bare angles
 * @returns {{ rows: import("../../judge/geometry/arm.js").Row[] } | { error: string } | null}
 */
export function readTable(text, unit) {
  const lines = linesOf(text);
  const cells = lines.map(cellsOf);
  if (cells.flat().length < 2) return null;
  const names = cells[0].map(
    (cell) =>
      NAMES[cell.replace(/[$ ()°]|_?rad|_?deg|_?m\b/g, "").replace(/_?\{?i\}?$/, "")] ?? null,
  );
  const headed = names.filter(Boolean).length >= 4;
  const body = headed ? cells.slice(1) : cells;
  const width = Math.max(...body.map((row) => row.length));
  const columns = headed ? names : width === 5 ? [null, ...ORDER] : ORDER;
  if (!headed && width !== 4 && width !== 5)
    return { error: `has ${width} columns; a, α, d, θ are expected` };
  const rows = [];
  for (const [i, row] of body.entries()) {
    if (row.length !== body[0].length)
      return {
        error: `has ${row.length} cells in row ${i + 1} and ${body[0].length} in the first`,
      };
    const read = readRow(row, columns, unit);
    if (read.error) return { error: `has in row ${i + 1}: ${read.error}` };
    rows.push(read.row);
  }
  const fault = rowsFault(rows);
  return fault ? { error: `makes no table: ${fault}` } : { rows };
}

const linesOf = (text) =>
  text
    .replace(/\\begin\{[^}]*\}(\{[^}]*\})?|\\end\{[^}]*\}|\\hline/g, "")
    .replace(/^[^[=]*=\s*(?=\[)|(np\.)?array\(|[()]\s*;?\s*$/g, "")
    .split(/\r?\n|\\\\|;(?!\s*$)|\]\s*,/)
    .map((line) =>
      line
        .replace(/[[\]{};]|^\s*\||\|\s*$/g, (sign) => (sign === "{" || sign === "}" ? sign : ""))
        .trim(),
    )
    .filter((line) => line && !/^[\s|:+-]*$/.test(line));

function cellsOf(line) {
  const sign = ["\t", "|", "&"].find((one) => line.includes(one));
  if (sign) return line.split(sign).map((cell) => cell.trim());
  if (/,\s/.test(line) || (line.match(/,/g) ?? []).length >= 3)
    return line.split(",").map((cell) => cell.trim());
  return line.split(/\s+/);
}

function readRow(cells, columns, unit) {
  const row = { kind: "revolute", a: 0, alpha: 0, d: 0, theta: 0 };
  for (const [k, key] of columns.entries()) {
    if (!key) continue;
    const angle = key === "alpha" || key === "theta";
    let text = (cells[k] ?? "").replace(/^\$|\$$/g, "").replace(/\\pi/g, "pi");
    const variable = key === "theta" || key === "d" ? VARIABLE.exec(text) : null;
    if (variable) {
      row.kind = key === "theta" ? "revolute" : "prismatic";
      text = `${variable[1]}${variable[2]}`.trim() || "0";
    }
    const { value, error } = readEntry(text || "0", angle ? "angle" : "length", unit);
    if (error) return { error: `${key} ${error}` };
    row[key] = value;
  }
  return { row };
}
