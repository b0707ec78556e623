// Orders the rows and columns of a block by their labels, as "q2 = 0.8, q1 = 0.3" by q1, q2.

import { foldCharacters, foldNames, plainCharacters } from "./characters.js";
import { findLabel } from "./labels.js";
import { SpannedText } from "./spans.js";
import { ArmError, formatMessage } from "../sentences.js";

/** @typedef {import("./answers.js").Want} Want */

/** @typedef {import("./blocks.js").Block} Block */
/** @typedef {{ kind: string, numbers: number[] }} Labels labels of one kind */
/**
 * The order that words state: the first half of a Jacobian, and its columns. `commas` is "decimal"
 * or "separators" if only one reading of the commas is tried.
 * @typedef {{ angularFirst?: boolean, joints?: number[] | "reversed", transposed?: boolean,
 *   commas?: string }} StatedOrder
 */

/**
 * Read the labels of rows or columns. Return null unless all labels have the same kind and
 * different numbers.
 * @param {import("./lines.js").Cell[][]} words the words of each row or column
 * @returns {Labels | null}
 */
export function readLabels(words) {
  const readOne = (cells) => cells[0]?.label ?? findLabel(cells);
  const kind = readOne(words[0])?.kind;
  if (!kind) return null;
  const numbers = new Set();
  for (const cells of words) {
    const label = readOne(cells);
    if (label?.kind !== kind || numbers.has(label.number)) return null;
    numbers.add(label.number);
  }
  return { kind, numbers: [...numbers] };
}

// Read labels that differ only in a number, as "config(2).q" and "config(1).q". Return null unless
// the numbers are 0, 1, 2 or 1, 2, 3, in any order.
/** @param {import("./lines.js").Cell[][]} words @returns {number[] | null} */
function readNumberedLabels(words) {
  const texts = words.map((cells) => cells.map(({ text }) => text).join(" "));
  const parts = texts.map((text) => text.split(/(\d+)/));
  if (!parts.every(([before]) => before === parts[0][0])) return null;
  const numbers = parts.map(([, number]) => Number(number));
  const sorted = [...numbers].sort((x, y) => x - y);
  return sorted.every((x, k) => x === sorted[0] + k) ? numbers : null;
}

/**
 * Read the labels of a block's column headers.
 * @param {Pick<Block, "headers" | "rows">} block @returns {Labels | null}
 */
export function readHeaderLabels({ headers, rows }) {
  const extra = headers.length - rows[0].length; // headers above the labels of the rows
  return extra < 0 ? null : readLabels(headers.slice(extra).map((header) => [header]));
}

/**
 * Return whether the rows of a block are the wanted columns, as its labels show.
 * @param {Block} block @param {Want} want
 */
export function isTransposed(block, { by }) {
  if (by === "row" && (TRANSPOSE_MARK.test(block.name) || areColumnVectors(block))) return true;
  const [rows, headers] = [readLabels(block.labels), readHeaderLabels(block)];
  if (by === "row")
    return headers?.kind === "row" || (rows?.kind === "joint" && !COUNTS_ROWS.test(block.name));
  return rows?.kind === "joint" && block.rows[0].length > 1;
}

const COUNTS_ROWS = /^J\(0\)/; // J[0] is the first row in Python; joints count from 1

// Return whether the rows of a block were typed as column vectors, [1; 2; 3].
const areColumnVectors = ({ sources }) => sources.every(({ isColumn }) => isColumn);

/** A pattern of the mark of a transposed matrix: J^T, J.T and Jᵀ. */
export const TRANSPOSED = String.raw`(?:\.T|\^\{?(?:T|\\top)\}?|ᵀ)`;
// The end of the name of a transposed matrix, such as J^T(q), J' and "J transposed".
const TRANSPOSE_MARK = new RegExp(
  String.raw`(?:${TRANSPOSED}|'|(?<!\p{L})transposed?)(?:\([^()]*\))?$`,
  "iu",
);

/**
 * Exchange the rows and columns of a block.
 * @param {Block} block @returns {Block}
 */
export function transpose(block) {
  const { rows, labels, headers } = block;
  const extra = headers.length - rows[0].length;
  const columnHeaders = extra < 0 ? [] : headers.slice(extra);
  return {
    ...block,
    rows: rows[0].map((_, k) => rows.map((row) => row[k])),
    labels: rows[0].map((_, k) => (columnHeaders[k] ? [columnHeaders[k]] : [])),
    headers: labels.map((words) => words.at(-1) ?? NO_CELL),
    isTransposed: true,
  };
}

const NO_CELL = { text: "", from: 0, to: 0 };

/**
 * Order values by a list of joint names elsewhere in the text. ROS prints joint states like this.
 * @param {Block & { taken: string[] }} block @param {Want} want @param {string} text
 */
export function orderByListedNames(block, { by }, text) {
  if (by !== "joint" || block.taken.length) return block;
  const joints = findListedJoints(text, block.rows[0].length);
  if (!joints || joints.every((joint, k) => !k || joint > joints[k - 1])) return block;
  const order = sortIndices(joints);
  const rows = block.rows.map((row) => order.map((k) => row[k]));
  return { ...block, rows, taken: [formatMessage("taken: by names")] };
}

// Find `size` joint names beside each other. Return the joint numbers, or null if there are no such
// names.
function findListedJoints(text, size) {
  const plain = plainCharacters(foldNames(foldCharacters(new SpannedText(text))));
  const words = plain.text.split(/[\s,;:=[\]{}"-]+/);
  const labels = words.map((word) => findLabel([{ text: word }]));
  const joints = [];
  for (const label of [...labels, null]) {
    if (label?.kind === "joint") joints.push(label.number);
    else if (joints.length === size && new Set(joints).size === size) return joints;
    else joints.length = 0;
  }
  return null;
}

// Return the indices that sort the numbers.
const sortIndices = (numbers) => numbers.map((_, k) => k).sort((p, q) => numbers[p] - numbers[q]);

/**
 * Order values from Python by the names before them, and drop the names:
 * [("theta2", 0.8), ("theta1", 0.3)] becomes [0.3, 0.8].
 * @param {any} mine nested lists; those of a mapping are { named: pairs }
 */
export function orderByGivenNames(mine) {
  if (isNamed(mine)) return orderByGivenNames(mine[1]);
  const items = mine?.named ?? mine;
  if (!Array.isArray(items)) return mine;
  const labels =
    items.length > 0 && items.every(isNamed)
      ? readLabels(items.map(([text]) => [{ text, from: 0, to: 0 }]))
      : null;
  const order = labels ? sortIndices(labels.numbers) : [...items.keys()];
  return order.map((k) => orderByGivenNames(items[k]));
}

const isNamed = (item) =>
  Array.isArray(item) &&
  item.length === 2 &&
  typeof item[0] === "string" &&
  typeof item[1] !== "string";

/**
 * Order the rows and columns of a block by their labels.
 * @param {Block} block @param {Want} want
 */
export function orderByLabels(block, { by }) {
  refuseUnevenNames(block.labels);
  const [rows, headers] = [readLabels(block.labels), readHeaderLabels(block)];
  const hasRowNames = by === "row" && rows?.kind === "row";
  const numbers = hasRowNames ? rows.numbers : readNumberedLabels(block.labels);
  const rowOrder = numbers ? sortIndices(numbers) : [...block.rows.keys()];
  const columnOrder =
    headers?.kind === "joint" ? sortIndices(headers.numbers) : [...block.rows[0].keys()];
  const isMoved = [rowOrder, columnOrder].some((order) => order.some((index, k) => index !== k));
  return {
    ...block,
    rows: rowOrder.map((i) => columnOrder.map((k) => block.rows[i][k])),
    taken: isMoved ? [formatMessage("taken: by names")] : [],
    hasRowNames,
  };
}

/**
 * Put the rows and columns of a block in the usual order, given the order that words state.
 * @param {Block & { taken: string[], hasRowNames?: boolean }} block @param {StatedOrder} stated
 */
export function applyOrder(block, { angularFirst, joints, transposed = false }) {
  const given = transposed && !block.isTransposed ? transpose(block).rows : block.rows;
  const columns = [...given[0].keys()];
  const listed = joints === "reversed" ? [...columns].reverse() : (joints ?? columns);
  const order = listed.length === columns.length ? sortIndices(listed) : columns;
  const half = given.length / 2;
  const halves = angularFirst ? [...given.slice(half), ...given.slice(0, half)] : given;
  const rows = halves.map((row) => order.map((k) => row[k]));
  const isMoved = rows.flat().some((cell, k) => cell !== block.rows.flat()[k]);
  return {
    ...block,
    rows,
    taken: isMoved ? [formatMessage("taken: by names")] : block.taken,
    hasRowNames: block.hasRowNames || angularFirst !== undefined,
  };
}

// Refuse rows of joints of which one is named more often than another, as in "q1, q2, q2".
/** @param {import("./lines.js").Cell[][]} labels */
function refuseUnevenNames(labels) {
  const joints = labels.map((words) => findLabel(words));
  if (joints.length < 2 || !joints.every((label) => label?.kind === "joint")) return;
  const counts = new Map();
  for (const { number } of joints) counts.set(number, (counts.get(number) ?? 0) + 1);
  const most = Math.max(...counts.values());
  const [joint] = [...counts].find(([, count]) => count === most);
  if ([...counts.values()].some((count) => count !== most))
    throw new ArmError(formatMessage("joint twice", { joint }));
}
