// What the page shows of an answer: how it is read, cell by cell, and the verdict in words.

import { joints } from "../kinematics.js";
import { h } from "../dom.js";
import { linesOf, MARKS } from "./ranking.js";

const ROWS = {
  v: ["vx", "vy", "vz", "ωx", "ωy", "ωz"],
  omega: ["ωx", "ωy", "ωz", "vx", "vy", "vz"],
};
const MOST_ROWS = 40;

/** @typedef {import("./ask.js").Question} Question */

/**
 * How the rows and columns of an answer are called.
 * @param {Question} question
 * @param {import("../arm.js").Arm} arm
 * @param {number[]} shape
 */
export function namesOf({ ask, first }, arm, [rows, width]) {
  const numbers = joints(arm).map((i) => i + 1);
  const above = (k) => (numbers.length === width ? `joint ${numbers[k]}` : String(k + 1));
  const lines = { torques: rows === 1 ? ["τ"] : [], jacobian: rows === 6 ? ROWS[first] : [] }[ask] ?? [];
  return {
    columns: Array.from({ length: width }, (_, k) => above(k)),
    rows: Array.from({ length: rows }, (_, i) => lines[i] ?? `row ${i + 1}`),
  };
}

/**
 * What was typed as rows of cells, or null where it is no matrix.
 * @param {Question} question
 */
export function matrixOf(question, { report, arm }) {
  const typed = report?.typed;
  if (!typed || typed.shape.length !== 2) return null;
  const column = question.ask === "torques" && typed.shape[1] === 1;
  const [rows, width] = column ? [1, typed.values.length] : typed.shape;
  const wrong = report.wrong?.length === typed.values.length ? report.wrong : [];
  return { ...namesOf(question, arm, [rows, width]), typed, wrong, shape: [rows, width] };
}

// What stands in the answer as it is understood; wrong cells are marked.
export function showRead(place, question, verdict) {
  const { table } = verdict.report ?? {};
  const found = table ? tableRead(table) : matrixRead(matrixOf(question, verdict));
  place.hidden = !found;
  if (!found) return;
  const { columns, rows, cell } = found;
  const head = h("tr", {}, h("td"), columns.map((name) => h("th", { scope: "col" }, name))); // prettier-ignore
  const body = rows.slice(0, MOST_ROWS).map((name, i) =>
    h(
      "tr", {}, h("th", { scope: "row" }, name),
      columns.map((_, k) => cell(i, k)),
    ),
  ); // prettier-ignore
  const words = "How your answer is read";
  place.replaceChildren(h("table", {}, h("caption", {}, words), h("thead", {}, head), h("tbody", {}, body)));
}

/** @param {import("./ranking.js").ReadTable} table */
const tableRead = ({ cells, wrong }) => ({
  columns: ["a (m)", "α", "d (m)", "θ"],
  rows: cells.map((_, i) => String(i + 1)),
  cell: (i, k) => marked(typeset(cells[i][k].replaceAll("-", "−")), wrong[i][k]),
});

/** @param {ReturnType<typeof matrixOf>} found */
const matrixRead = (found) =>
  found && {
    ...found,
    cell(i, k) {
      const at = i * found.shape[1] + k;
      return marked(spelt(found.typed, at), found.wrong[at]);
    },
  };

function spelt({ values, units }, i) {
  const decimals = Math.min(6, units[i] ? Math.max(0, Math.round(-Math.log10(units[i]))) : 4);
  return (Number(values[i].toFixed(decimals)) + 0).toFixed(decimals).replace("-", "−");
}

const marked = (words, wrong) =>
  wrong ? h("td.off", {}, h("span.unseen", {}, "wrong: "), words) : h("td", {}, words);

// The verdict, or why there is none yet.
export function tell(box, { report, error }) {
  box.className = `verdict ${report?.grade ?? ""}`;
  if (!report) return box.replaceChildren(h("p", {}, typeset(error)));
  const lines = linesOf(report).filter((line) => !report.headline.endsWith(line.slice(1)));
  const list = lines.length ? [h("ul", {}, lines.map((line) => h("li", {}, typeset(line))))] : []; // prettier-ignore
  const mark = h("span", { "aria-hidden": "true" }, `${MARKS[report.grade]} `);
  return box.replaceChildren(h("p.headline", {}, mark, typeset(report.headline)), ...list);
}

const SYMBOL = /(?<!\w)([A-Za-z]|theta|alpha)_(?:\{([^}]+)\}|(\w+))(?![\w=])/g;
const LETTERS = { theta: "θ", alpha: "α" };

// A sentence with its symbols set: z_{i-1} as a letter and an index.
export function typeset(words) {
  const parts = [];
  let at = 0;
  for (const match of words.matchAll(SYMBOL)) {
    const [whole, letter, braced, bare] = match;
    parts.push(words.slice(at, match.index), h("i", {}, LETTERS[letter] ?? letter));
    parts.push(h("sub", {}, (braced ?? bare).replace("-", "−")));
    at = match.index + whole.length;
  }
  return [...parts, words.slice(at)];
}
