// Drops the rows and columns of a block that hold counts, times or names of joints.

import { hasDecimals, number } from "./formula.js";
import { readLabels } from "./ordering.js";

/** @typedef {import("./blocks.js").Block} Block */
/** @typedef {import("./lines.js").Row} Row */

const textsOf = (cells) => cells.map(({ text }) => text);

/**
 * Return whether all cells are joint numbers, as in "for joints 1, 2, 4, 5, 6 and 7".
 * @param {import("./lines.js").Cell[]} cells
 */
export const isJointCount = (cells) => {
  const texts = textsOf(cells).map((text) => text.replace(/[():.]/g, ""));
  return texts.every((text, k) => /^\d$/.test(text) && (!k || text > texts[k - 1]));
};

/**
 * Return whether the first column of a block counts three or more rows: 1, 2, 3.
 * @param {Block} block
 */
export const countsRows = ({ rows }) =>
  rows.length > 2 && rows[0].length > 1 && rows.every(([{ text }], k) => text === `${k + 1}`);

const JOINT_NAME = /^[qθ][ _{]{0,2}\d\}?$/i;

/**
 * Drop the first row if it holds only names of joints, such as q1 q2 q3.
 * @param {Block} block @returns {Block}
 */
export const dropNameHeader = (block) =>
  block.rows[0].every(({ text }) => JOINT_NAME.test(text))
    ? (dropLabelRow(block)[0] ?? block)
    : block;

/**
 * Drop the first row if it counts 1 2 3 above decimals. Return an empty list if there is no such
 * row.
 * @param {Block} block @returns {Block[]}
 */
export const dropCountHeader = (block) =>
  countsColumns(block.rows[0]) && hasDecimals(textsOf(block.rows.slice(1).flat()).join(" "))
    ? dropLabelRow(block)
    : [];

/**
 * Return whether a row of decimals begins with its count. The count is 2 if the next line begins
 * with 3, or if the line before begins with 1.
 * @param {Row} row @param {Row[]} rows of the text
 */
export function beginsWithCount({ cells: [first, ...rest], line }, rows) {
  if (!/^\d{1,4}$/.test(first.text) || !rest.some(({ text }) => hasDecimals(text))) return false;
  return rows.some(
    (other) =>
      Math.abs(other.line - line) === 1 &&
      Number(other.cells[0].text) === Number(first.text) + other.line - line,
  );
}

/**
 * Drop the counts of a single column, as in a table whose cells were pasted on separate lines. Each
 * count stands before its value, or all counts stand before all values.
 * @param {Block} block @returns {Block[]}
 */
export function dropCountCells(block) {
  const { rows, sources } = block;
  const half = rows.length / 2;
  if (rows[0].length > 1 || !Number.isInteger(half)) return [];
  const parts = [(k) => k % 2 === 0, (k) => k < half];
  return parts.flatMap((isLabel) => {
    const labels = rows.filter((_, k) => isLabel(k));
    const values = rows.filter((_, k) => !isLabel(k));
    if (!isCount(textsOf(labels.flat())) || !hasDecimals(textsOf(values.flat()).join(" ")))
      return [];
    const valueSources = sources.filter((_, k) => !isLabel(k));
    const firstLine = valueSources[0].line;
    return [{ ...block, rows: values, labels, sources: valueSources, firstLine }];
  });
}

/**
 * List the block without its first column, without its first row, and without both. The column must
 * hold counts, names or times, and the row must hold counts or names.
 * @param {Block} block @returns {Block[]}
 */
export function dropLabels(block) {
  const below = dropLabelRow(block);
  const beside = [block, ...below].flatMap(dropLabelColumn);
  return [...beside, ...below, ...beside.flatMap(dropLabelColumn)]; // an index and times
}

function dropLabelColumn(block) {
  const { rows, labels } = block;
  const column = rows.map(([cell]) => cell);
  if (rows[0].length < 2 || !(isSeries(textsOf(column)) || areNames(column))) return [];
  const newLabels = labels.map((words, i) => [...words, rows[i][0]]);
  return [{ ...block, rows: rows.map((row) => row.slice(1)), labels: newLabels }];
}

function dropLabelRow(block) {
  const { rows, labels } = block;
  const [first, ...rest] = rows;
  if (!rest.length || first.length < 2) return [];
  if (!countsColumns(first) && !areNames(first)) return [];
  return [{ ...block, rows: rest, labels: labels.slice(1), headers: first }];
}

const areNames = (cells) =>
  cells.every(({ text }) => number(text) === null) &&
  readLabels(cells.map((cell) => [cell])) !== null;

const countsColumns = (cells) => isCount(textsOf(cells)) || isJointCount(cells);

// Return whether texts count from 0 or from 1. A single 0.0 is a value.
const isCount = (texts) =>
  (texts.length > 1 || !/^0\.0*$/.test(texts[0])) &&
  [0, 1].some((start) => texts.every((text, k) => Number(text) === k + start));

/**
 * Return whether texts count, or grow in equal steps as times do.
 * @param {string[]} texts
 */
export function isSeries(texts) {
  const values = texts.map(Number);
  if (isCount(texts)) return true;
  const step = (values.at(-1) - values[0]) / (values.length - 1);
  const unit = 10 ** -Math.max(...texts.map((text) => text.split(".")[1]?.length ?? 0));
  return (
    values.length > 3 &&
    step > 0 &&
    values.every((x, k) => Math.abs(x - values[0] - k * step) <= unit * 1.01)
  );
}
