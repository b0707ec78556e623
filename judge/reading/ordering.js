// The order that labels give to a block's rows and columns.

import { foldCharacters, foldNames, plainCharacters } from "./characters.js";
import { labelIn } from "./labels.js";
import { SpannedText } from "./spans.js";
import { formatMessage } from "../sentences.js";

/** @typedef {import("./answers.js").Want} Want */

/** @typedef {{ kind: string, at: number[] }} Labels numbers of labels of one kind */

/**
 * Read the labels of rows or columns; null unless all are of one kind and no two are the same.
 * @param {import("./lines.js").Cell[][]} words of each row or column @returns {Labels | null}
 */
export function readLabels(words) {
  const labels = words.map((cells) => cells[0]?.label ?? labelIn(cells));
  const kind = labels[0]?.kind;
  if (!kind || labels.some((label) => label?.kind !== kind)) return null;
  const at = labels.map((label) => label.at);
  return new Set(at).size === at.length ? { kind, at } : null;
}

/**
 * Read the labels of a block's column headers.
 * @param {any} block @returns {Labels | null}
 */
export function readHeaderLabels({ headers, rows }) {
  const extra = headers.length - rows[0].length;
  return extra >= 0 && extra < 3
    ? readLabels(headers.slice(extra).map((header) => [header]))
    : null;
}

// Return whether labels say that the rows of a block are the wanted columns.
export function isTransposed(block, { by }) {
  if (by === "row" && (TURNED.test(block.name) || areColumns(block))) return true;
  const [rows, headers] = [readLabels(block.labels), readHeaderLabels(block)];
  if (by === "row") return headers?.kind === "row" || rows?.kind === "joint";
  return rows?.kind === "joint" && block.rows[0].length > 1 && !namesJoints(block.headers);
}

// Return whether each row was typed as a column vector, [1; 2; 3], of several side by side.
const areColumns = ({ rows, sources }) =>
  rows.length > 1 && sources.every(({ isColumn }) => isColumn);

// Return whether two column headers or more name joints.
const namesJoints = (headers) =>
  headers.filter((header) => labelIn([header])?.kind === "joint").length > 1;

const TURNED = /(?:\.T|\^T|ᵀ|')$/; // behind the name of a transposed matrix

// Exchange rows and columns of a block.
export function transpose(block) {
  const { rows, labels, headers } = block;
  const columnHeaders = headers.slice(headers.length - rows[0].length);
  return {
    ...block,
    rows: rows[0].map((_, k) => rows.map((row) => row[k])),
    labels: rows[0].map((_, k) => (columnHeaders[k] ? [columnHeaders[k]] : [])),
    headers: labels.map((words) => words.at(-1) ?? NO_CELL),
  };
}

const NO_CELL = { text: "", from: 0, to: 0 };

/**
 * Order values by names of joints that the text lists apart from them, as ROS does.
 * @param {any} block @param {Want} want @param {string} text
 */
export function orderByListedNames(block, { by, turned, columns }, text) {
  if (by !== "joint" || (!turned && columns === null) || block.said.length) return block;
  const at = findListedJoints(text, block.rows[0].length);
  if (!at || at.every((joint, k) => !k || joint > at[k - 1])) return block;
  const order = at.map((_, k) => k).sort((p, q) => at[p] - at[q]);
  const rows = block.rows.map((row) => order.map((k) => row[k]));
  return { ...block, rows, said: [formatMessage("taken: by names")] };
}

// Find the numbers of `size` joints whose names stand beside each other; null if none do.
function findListedJoints(text, size) {
  const plain = plainCharacters(foldNames(foldCharacters(new SpannedText(text))));
  const words = plain.text.split(/[\s,;:=[\]{}"-]+/);
  const labels = words.map((word) => (/\p{L}/u.test(word) ? labelIn([{ text: word }]) : null));
  const joints = [];
  for (const label of [...labels, null]) {
    if (label?.kind === "joint") joints.push(label.at);
    else if (joints.length === size && new Set(joints).size === size) return joints;
    else joints.length = 0;
  }
  return null;
}

// Order rows and columns of a block by their labels.
export function orderByLabels(block, { by }) {
  const [rows, headers] = [readLabels(block.labels), readHeaderLabels(block)];
  const order = (label) => label.at.map((_, k) => k).sort((p, q) => label.at[p] - label.at[q]);
  const whole = rows && (by === "row" ? rows.kind === "row" : rows.kind === "joint");
  const down = whole ? order(rows) : block.rows.map((_, i) => i);
  const across = headers?.kind === "joint" ? order(headers) : block.rows[0].map((_, k) => k);
  const moved = [...down, -1, ...across].join() !== [...down.keys(), -1, ...across.keys()].join();
  return {
    ...block,
    rows: down.map((i) => across.map((k) => block.rows[i][k])),
    said: moved ? [formatMessage("taken: by names")] : [],
    hasRowNames: Boolean(whole) && by === "row",
  };
}
