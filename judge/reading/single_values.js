// Makes blocks of single values, which have names, q1 = 0.3, or two indices, J[2,3] = 0.5, or stand
// on separate lines.

import { applyFactor } from "./block.js";
import { findValueLabel } from "./labels.js";
import { namesOtherQuantity } from "./row_names.js";

/** @typedef {import("./block.js").Block} Block */
/** @typedef {import("./lines.js").Cell} Cell */
/** @typedef {import("./lines.js").Row} Row */

/**
 * Join single values with joint names, q1 = 0.3, to rows. A repeated joint name begins the next
 * row.
 * @param {Row[]} rows @returns {Block[]}
 */
export function joinNamedValues(rows) {
  const labelled = rows.flatMap((row) => {
    const label = row.cells.length === 1 ? findValueLabel(row) : null;
    return label && label.kind !== "count" ? [{ row, label }] : [];
  });
  const values = labelled.filter((value, k) => {
    const neighbours = [labelled[k - 1], labelled[k + 1]].filter(Boolean);
    return !namesOtherQuantity(value.row) || neighbours.some((other) => isSlide(value, other));
  });
  const sets = [];
  for (const value of values) {
    const isRepeated = sets.at(-1)?.some(({ label }) => label.number === value.label.number);
    if (!sets.length || isRepeated) sets.push([]);
    sets.at(-1).push(value);
  }
  if (!sets.length || sets.some((set) => set.length !== sets[0].length)) return [];
  const headers = sets[0].map(({ row, label }) => ({ ...joinWords(row.words), label }));
  const [first, last] = [values[0].row, values.at(-1).row];
  return [
    {
      rows: sets.map((set) => set.flatMap(({ row }) => applyFactor(row))),
      labels: sets.map(() => []),
      headers,
      name: first.name,
      firstLine: first.line,
      lastLine: last.last,
      sources: values.map(({ row }) => row),
    },
  ];
}

// Return whether a value such as d3 = 0.4 belongs to a prismatic joint. The value of a neighbouring
// joint, such as q2 = 0.3, must stand beside it; otherwise d3 is a length.
const isSlide = ({ label }, other) =>
  Math.abs(label.number - other.label.number) === 1 && !namesOtherQuantity(other.row);

const joinWords = (words) => ({
  text: words.map(({ text }) => text).join(" "),
  from: words[0].from,
  to: words.at(-1).to,
});

/**
 * Join the cells of a table to rows, if each cell was pasted on a separate line. Column headers
 * come first, and a label begins each row.
 * @param {Row[]} rows @param {Cell[]} words @returns {Block[]}
 */
export function joinCellLines(rows, words) {
  const lines = listSingleCells(rows, words);
  const sets = lines.flatMap((line, k) =>
    line.row && lines[k - 1]?.row === null ? [readCellsFrom(lines, k)] : [],
  );
  const labelled = sets.filter(({ cells }) => !countsUp(cells.map(({ text }) => text)));
  const values = labelled.length === 1 ? splitCountedRows(labelled[0], lines) : labelled;
  if (values.length < 2) return [];
  const width = values[0].cells.length;
  if (values.some(({ cells }) => cells.length !== width)) return [];
  const sources = values.flatMap((set) => set.rows);
  const end = lines.findIndex(({ cell }) => cell === values[0].label);
  const top = findFirstHeader(lines, end);
  return [
    {
      rows: values.map(({ cells }) => cells),
      labels: values.map(({ label }) => [label]),
      headers: lines.slice(Math.max(top, end - width - 1), end).map(({ cell }) => cell),
      name: "",
      firstLine: sources[0].line,
      lastLine: sources.at(-1).last,
      sources,
    },
  ];
}

// Return the index of the first header. The headers are words on the lines directly above a line.
function findFirstHeader(lines, end) {
  let first = end;
  while (lines[first - 1]?.row === null && lines[first - 1].line === lines[first].line - 1) first--;
  return first;
}

// List the lines that hold a single entry or a single word, in order.
function listSingleCells(rows, words) {
  const entries = rows.flatMap((row) =>
    applyFactor(row).map((cell) => ({ line: row.line, cell, row })),
  );
  const all = [...entries, ...words.map((cell) => ({ line: cell.line, cell, row: null }))];
  const counts = new Map();
  for (const { line } of all) counts.set(line, (counts.get(line) ?? 0) + 1);
  return all
    .filter(({ line }) => counts.get(line) === 1)
    .sort((first, second) => first.line - second.line);
}

// Read the entries from a line up to the next word, and the word before them.
function readCellsFrom(lines, first) {
  let end = first + 1;
  while (lines[end]?.row && lines[end].line === lines[end - 1].line + 1) end++;
  const set = lines.slice(first, end);
  return {
    label: lines[first - 1].cell,
    cells: set.map(({ cell }) => cell),
    rows: set.map(({ row }) => row),
  };
}

// Split cells into rows, if the first cells of the rows count 1, 2, 3. The number of headers above
// gives the length of a row. The count may have no header.
function splitCountedRows({ cells, rows }, lines) {
  const first = lines.findIndex(({ row }) => row === rows[0]);
  const width = first - findFirstHeader(lines, first) + 1;
  const widths = [width, width - 1].filter((size) => size > 2);
  for (const size of widths) {
    const from = Array.from({ length: Math.floor(cells.length / size) }, (_, i) => i * size);
    if (cells.length % size || !countsUp(from.map((at) => cells[at].text))) continue;
    return from.map((at) => ({
      label: cells[at],
      cells: cells.slice(at + 1, at + size),
      rows: rows.slice(at, at + size),
    }));
  }
  return [];
}

const countsUp = (texts) => texts.every((text, k) => Number(text) === k + 1);

const INDICES = /[[({](\d{1,2})\s*,\s*(\d{1,2})[\])}]$/;

/**
 * Join single values with two indices, such as J[2,3] := 0.5, to a matrix.
 * @param {Row[]} rows @returns {Block[]}
 */
export function joinIndexedValues(rows) {
  const indexed = rows.flatMap((row) => {
    const indices = row.cells.length === 1 && INDICES.exec(row.words.at(-1)?.text ?? "");
    return indices ? [{ row, i: Number(indices[1]), j: Number(indices[2]) }] : [];
  });
  const least = (key) => Math.min(...indexed.map((value) => value[key]));
  const size = (key) => Math.max(...indexed.map((value) => value[key])) - least(key) + 1;
  if (size("i") * size("j") !== indexed.length) return [];
  const matrix = Array.from({ length: size("i") }, () => Array(size("j")));
  for (const { row, i, j } of indexed) [matrix[i - least("i")][j - least("j")]] = row.cells;
  if (matrix.some((row) => row.includes(undefined))) return [];
  const [first, last] = [indexed[0].row, indexed.at(-1).row];
  return [
    {
      rows: matrix,
      labels: matrix.map(() => []),
      headers: [],
      name: first.name,
      firstLine: first.line,
      lastLine: last.last,
      sources: indexed.map(({ row }) => row),
    },
  ];
}
