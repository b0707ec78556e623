// What the page shows of an answer: how it is read, cell by cell, and the verdict in words.

import { joints } from "../../../judge/geometry/kinematics.js";
import { h } from "../dom.js";
import { lookup } from "../../../judge/reading/numbers.js";
import { parse, plain, symbols } from "../../../judge/reading/formula.js";
import { cells } from "../../../judge/reading/grid.js";
import { withoutHeader } from "../../../judge/reading/heads.js";
import { isPlain, made, mathOf } from "./mathml.js";
import { linesOf, MARKS } from "../../../judge/report.js";
import { ArmError } from "../../../judge/sentences.js";

const ROWS = {
  v: ["vx", "vy", "vz", "ωx", "ωy", "ωz"],
  omega: ["ωx", "ωy", "ωz", "vx", "vy", "vz"],
};
const TABLE_HEADS = ["a (m)", "α", "d (m)", "θ"];
const MOST_ROWS = 40;
const LONGEST_SET = 8000; // characters of an answer whose formulas are set

/** @typedef {import("./question.js").Question} Question */

/**
 * How the rows and columns of an answer are called.
 * @param {Question} question
 * @param {import("../../../judge/geometry/arm.js").Arm} arm
 * @param {number[]} shape
 */
export function namesOf({ ask, first }, arm, [rows, width]) {
  const numbers = joints(arm).map((i) => i + 1);
  const above = (k) => (numbers.length === width ? `joint ${numbers[k]}` : String(k + 1));
  const lines =
    { torques: rows === 1 ? ["τ"] : [], jacobian: rows === 6 ? ROWS[first] : [] }[ask] ?? [];
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

/**
 * What stands in the answer as it is understood: formulas set, wrong cells marked, and those that
 * could not be read.
 * @param {Question} question
 */
export function showRead(place, question, verdict) {
  /** @type {any} */
  const found = readOf(question, verdict);
  place.hidden = !found;
  if (!found) return;
  const { columns, rows, cell, unread = 0 } = found;
  const head = h(
    "tr",
    {},
    h("td"),
    columns.map((name) => h("th", { scope: "col" }, name)),
  );
  const body = rows.slice(0, MOST_ROWS).map((name, i) =>
    h(
      "tr",
      {},
      h("th", { scope: "row" }, name),
      columns.map((_, k) => cell(i, k)),
    ),
  );
  const first = rows.length > MOST_ROWS ? `, its first ${MOST_ROWS} of ${rows.length} rows` : "";
  const odd = unread ? `; ${unread === 1 ? "1 entry" : `${unread} entries`} could not be` : "";
  const caption = h("caption", {}, `How your answer is read${first}${odd}`);
  const kind = question.ask === "table" ? "table.read" : "table.read.matrix";
  place.replaceChildren(h(kind, {}, caption, h("thead", {}, head), h("tbody", {}, body)));
}

function readOf(question, verdict) {
  const { table } = verdict.report ?? {};
  if (table) return tableRead(table);
  return matrixRead(question, matrixOf(question, verdict)) ?? partlyRead(question, verdict);
}

/** @param {import("../../../judge/report.js").ReadTable} table */
const tableRead = ({ cells, trees, wrong }) => ({
  columns: TABLE_HEADS,
  rows: cells.map((_, i) => String(i + 1)),
  cell(i, k) {
    const [tree, words] = [trees[i][k], cells[i][k]];
    const bare = /^-?q_\d+$/.test(words);
    return marked(
      tree && !isPlain(tree) ? formula(tree, bare ? "" : words) : signed(words),
      wrong[i][k],
    );
  },
});

/** @param {Question} question @param {ReturnType<typeof matrixOf>} found */
function matrixRead({ answer }, found) {
  if (!found) return null;
  const { typed, wrong, shape } = found;
  const trees = answer.length > LONGEST_SET ? [] : (typed.trees ?? []);
  return {
    ...found,
    cell(i, k) {
      const at = i * shape[1] + k;
      const tree = trees[at];
      if (!tree || (isPlain(tree) && typed.units[at]))
        return marked(signed(spelt(typed, at)), wrong[at]);
      return marked(formula(tree, isPlain(tree) ? "" : spelt(typed, at)), wrong[at]);
    },
  };
}

// What can be read of an answer that could not be judged, cell by cell.
function partlyRead(question, { error, waiting, arm, q }) {
  const { ask, answer } = question;
  if (!error || waiting || !arm || !answer.trim() || ask === "trace" || answer.length > LONGEST_SET)
    return null;
  const rows = rowsOf(ask, answer).map((row) => row.map((text) => treeOf(ask, text, arm, q)));
  const width = Math.max(0, ...rows.map((row) => row.length));
  return {
    ...namesOf(question, arm, [rows.length, width]),
    unread: rows.flat().filter(({ tree }) => !tree).length,
    cell(i, k) {
      const { tree, text } = rows[i][k] ?? {};
      if (text === undefined) return h("td");
      return tree ? h("td", {}, made(mathOf(tree))) : marked(text, true, "not read: ");
    },
  };
}

// The cells of a text as typed; none where it cannot be read.
export const textsOf = (text) => readOrNone(() => (text.trim() ? cells(text) : []));

const rowsOf = (ask, answer) =>
  readOrNone(() => {
    const rows = withoutHeader(cells(answer));
    return ask === "table" && !rows[0].some((text) => /\d/.test(text)) ? rows.slice(1) : rows;
  });

function readOrNone(read) {
  try {
    return read();
  } catch (error) {
    if (error instanceof ArmError) return [];
    throw error;
  }
}

// The formula of a cell, or none where it is no formula or means nothing to this arm.
function treeOf(ask, text, arm, q) {
  const named = ask === "branches" || ask === "pose";
  try {
    const tree = parse(
      plain(named ? text.replace(/^.*[=:]/, "") : text).replace(/\*+$/, "") || "0",
    );
    if (ask === "jacobian" && q) lookup(arm, q).known(symbols(tree));
    return { tree, text };
  } catch (error) {
    if (error instanceof ArmError) return { tree: null, text };
    throw error;
  }
}

function spelt({ values, units }, i) {
  const decimals = Math.min(6, units[i] ? Math.max(0, Math.round(-Math.log10(units[i]))) : 4);
  return (Number(values[i].toFixed(decimals)) + 0).toFixed(decimals);
}

const signed = (words) => typeset(words.replaceAll("-", "−"));

// A formula, and under it what it comes to, if that says more.
const formula = (tree, words) =>
  words ? [made(mathOf(tree)), h("span.value", {}, "= ", signed(words))] : [made(mathOf(tree))];

const marked = (content, off, why = "wrong: ") =>
  off ? h("td.off", {}, h("span.unseen", {}, why), content) : h("td", {}, content);

// The verdict, or why there is none yet.
export function tell(box, { report, error }) {
  box.className = `verdict ${report?.grade ?? ""}`;
  if (!report) return box.replaceChildren(h("p", {}, typeset(error)));
  const lines = linesOf(report).filter((line) => !report.headline.endsWith(line.slice(1)));
  const list = lines.length
    ? [
        h(
          "ul",
          {},
          lines.map((line) => h("li", {}, typeset(line))),
        ),
      ]
    : [];
  const mark = h("span", { "aria-hidden": "true" }, `${MARKS[report.grade]} `);
  return box.replaceChildren(h("p.headline", {}, mark, typeset(report.headline)), ...list);
}

const SYMBOL = /(?<!\w)([A-Za-z]|theta|alpha)_(?:\{([^}]+)\}|(\w+))(?![\w=])/g;
const LETTERS = { theta: "θ", alpha: "α" };

// What no line parts: a number and its unit, short sums and comparisons, a sign and what it stands
// before or (elbow -) behind. A line may end behind any hyphen, though behind no true minus.
const UNIT = String.raw`(?:N m|N|mm|m\/s\^2|m\/s²|m|degrees|deg|rad)(?![\w/^])`;
const NAME = String.raw`[-+±−]*[\w.^°]{1,8}(?:\{[^}\s]{1,5}\})?(?![\w^°({]|\.\w)`;
const SHORT = String.raw`[^\s,;]{1,16}(?![^\s,;])`;
const UNBROKEN = [
  String.raw`(?<![\w.^°}])\(?${NAME} [-+−<>] ${NAME}(?: ${UNIT})?[)'’”",.;:]*`,
  String.raw`(?<![\w.])[-+±−]*\d[\d.]*(?:(?:e-?\d+)? ${UNIT}|e-\d+)`,
  String.raw`\p{L}+ [-+−]['’”",.;:)]+`,
  String.raw`(?<![\w)\]}])[-+±]+(?:${SHORT}|${NAME})`,
  String.raw`N m(?!\w)`,
];
const PARTS = new RegExp(`(${UNBROKEN.join("|")})`, "u");

/**
 * A sentence with its symbols set, z_{i-1} as a letter and an index, of which no line parts what
 * belongs together.
 * @param {string} words
 */
export const typeset = (words) =>
  words.split(PARTS).flatMap((part, k) => (k % 2 ? h("span.unbroken", {}, set(part)) : set(part)));

function set(words) {
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
