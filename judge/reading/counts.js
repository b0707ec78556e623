// Blocks without the rows and columns that only count, tell the time, or name the others.

import { hasDecimals, number } from "./formula.js";
import { readLabels } from "./ordering.js";

/** @typedef {import("./blocks.js").Block} Block */

const textsOf = (cells) => cells.map(({ text }) => text);

// Return whether a row only numbers the joints, as in "for joints 1, 2, 4, 5, 6 and 7".
export const countsJoints = (cells) => {
  const texts = textsOf(cells).map((text) => text.replace(/[():.]/g, ""));
  return texts.every((text, k) => /^\d$/.test(text) && (!k || text > texts[k - 1]));
};

// A block of decimals below a row 1 2 3, without that row.
export const withoutCountedHeader = (block) =>
  (isCount(textsOf(block.rows[0])) || countsJoints(block.rows[0])) &&
  block.rows
    .slice(1)
    .flat()
    .some(({ text }) => hasDecimals(text))
    ? withoutRow(block)
    : [];

/**
 * Take the counts out of a column of twice as many cells, as a table pasted with a cell on each
 * line has them: before each value, or all before the first value.
 * @param {Block} block @returns {Block[]}
 */
export function withoutCountedCells(block) {
  const { rows, sources } = block;
  const half = rows.length / 2;
  if (rows[0].length > 1 || half < 2 || !Number.isInteger(half)) return [];
  const parts = [(k) => k % 2 === 0, (k) => k < half];
  return parts.flatMap((isLabel) => {
    const labels = rows.filter((_, k) => isLabel(k));
    const values = rows.filter((_, k) => !isLabel(k));
    if (!isCount(textsOf(labels.flat())) || !hasDecimals(textsOf(values.flat()).join(" ")))
      return [];
    const kept = sources.filter((_, k) => !isLabel(k));
    return [{ ...block, rows: values, labels, sources: kept, from: kept[0].line }];
  });
}

// The block without a first column that counts its rows or tells the time, or names them, and
// without a first row that counts or names its columns.
export function withoutLabels(block) {
  const below = withoutRow(block);
  const once = [block, ...below].flatMap(withoutColumn);
  return [...once, ...below, ...once.flatMap(withoutColumn)];
}

function withoutColumn(block) {
  const { rows, labels } = block;
  const down = rows.map(([cell]) => cell);
  if (rows[0].length < 2 || !(isSeries(textsOf(down)) || areNames(down))) return [];
  const words = labels.map((own, i) => [...own, rows[i][0]]);
  return [{ ...block, rows: rows.map((row) => row.slice(1)), labels: words }];
}

function withoutRow(block) {
  const { rows, labels } = block;
  const [first, ...rest] = rows;
  const isHeader =
    first.length > 1 && (isCount(textsOf(first)) || countsJoints(first) || areNames(first));
  if (!rest.length || !isHeader) return [];
  return [{ ...block, rows: rest, labels: labels.slice(1), headers: first }];
}

const areNames = (cells) => {
  const found = readLabels(cells.map((cell) => [cell]));
  return found !== null && cells.every(({ text }) => number(text) === null);
};

const isCount = (texts) =>
  [0, 1].some((from) => texts.every((text, k) => Number(text.replace(/[()]/g, "")) === k + from));

// Return whether cells count, or grow by as much each, as times do.
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
