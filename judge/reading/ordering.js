// The order that labels give to a block's rows and columns.

import { foldCharacters, foldNames, plainCharacters } from "./characters.js";
import { labelIn } from "./labels.js";
import { SpannedText } from "./spans.js";
import { formatMessage } from "../sentences.js";

/** @typedef {import("./answers.js").Want} Want */

// The labels of rows and of columns, where each has one of its kind and no two are the same.
export function labelsOf(words) {
  const found = words.map(labelIn);
  const kind = found[0]?.kind;
  const even = kind && found.every((one) => one?.kind === kind);
  return even && new Set(found.map(({ at }) => at)).size === found.length
    ? { kind, at: found.map(({ at }) => at) }
    : null;
}

export const headerLabels = ({ headers, rows }) => {
  const extra = headers.length - rows[0].length;
  return extra >= 0 && extra < 3 ? labelsOf(headers.slice(extra).map((one) => [one])) : null;
};

// Return whether labels say that rows are what is wanted as columns.
export function liesBy(block, { by }) {
  if (by === "row" && TURNED.test(block.name)) return true;
  const [rows, headers] = [labelsOf(block.labels), headerLabels(block)];
  if (by === "row") return headers?.kind === "row" || rows?.kind === "joint";
  return rows?.kind === "joint" && block.rows[0].length > 1 && !namesJoints(block.headers);
}

// Return whether two column headers or more name joints.
const namesJoints = (headers) =>
  headers.filter((header) => labelIn([header])?.kind === "joint").length > 1;

const TURNED = /(?:\.T|\^T|ᵀ|')$/; // behind the name of a transposed matrix

export function transposed(block) {
  const { rows, labels, headers } = block;
  const own = headers.slice(headers.length - rows[0].length);
  return {
    ...block,
    rows: rows[0].map((_, k) => rows.map((row) => row[k])),
    labels: rows[0].map((_, k) => (own[k] ? [own[k]] : [])),
    headers: labels.map((words) => words.at(-1) ?? NO_CELL),
  };
}

const NO_CELL = { text: "", from: 0, to: 0 };

// In the order of names that the text lists apart from the values, as ROS does.
/** @param {any} block @param {Want} want @param {string} text */
export function inListedOrder(block, { by, turned, columns }, text) {
  const [own] = block.rows;
  if (by !== "joint" || (!turned && columns === null) || block.said.length) return block;
  const at = listedJoints(text, own.length);
  if (!at || at.every((one, k) => !k || one > at[k - 1])) return block;
  const order = at.map((_, k) => k).sort((p, q) => at[p] - at[q]);
  const rows = block.rows.map((row) => order.map((k) => row[k]));
  return { ...block, rows, said: [formatMessage("taken: by names")] };
}

// The numbers of so many joints whose names stand beside each other, null where none do.
function listedJoints(text, size) {
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

// In the order of the labels.
export function ordered(block, { by }) {
  const [rows, headers] = [labelsOf(block.labels), headerLabels(block)];
  const order = (label) => label.at.map((_, k) => k).sort((p, q) => label.at[p] - label.at[q]);
  const whole = rows && (by === "row" ? rows.kind === "row" : rows.kind === "joint");
  const down = whole ? order(rows) : block.rows.map((_, i) => i);
  const across = headers?.kind === "joint" ? order(headers) : block.rows[0].map((_, k) => k);
  const moved = [...down, -1, ...across].join() !== [...down.keys(), -1, ...across.keys()].join();
  return {
    ...block,
    rows: down.map((i) => across.map((k) => block.rows[i][k])),
    said: moved ? [formatMessage("taken: by names")] : [],
  };
}
