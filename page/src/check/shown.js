// What the page shows of an answer: how it is read, cell by cell, and the verdict in words.

import { movingRows } from "../../../judge/geometry/kinematics.js";
import { h } from "../dom.js";
import { blocksIn } from "../../../judge/reading/blocks.js";
import { parse, plain, symbols } from "../../../judge/reading/formula.js";
import { lookup } from "../../../judge/reading/numbers.js";
import { listDetails, GRADE_MARKS } from "../../../judge/report.js";
import { ArmError } from "../../../judge/sentences.js";

const ROWS = {
  v: ["vx", "vy", "vz", "ωx", "ωy", "ωz"],
  omega: ["ωx", "ωy", "ωz", "vx", "vy", "vz"],
};
const TABLE_HEADS = ["a (m)", "α", "d (m)", "θ"];
const MOST_ROWS = 40;
const LONGEST_SHOWN = 8000; // characters of an answer that is shown cell by cell as it was typed

/** @typedef {import("./question.js").Question} Question */

/**
 * How the rows and columns of an answer are called.
 * @param {Question} question
 * @param {import("../../../judge/geometry/arm.js").Arm} arm
 * @param {number[]} shape
 */
export function namesOf({ ask, first }, arm, [rows, width]) {
  const numbers = movingRows(arm).map((i) => i + 1);
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
  const kind = question.ask === "table" ? "table.read" : "table.read.grid";
  place.replaceChildren(h(kind, {}, caption, h("thead", {}, head), h("tbody", {}, body)));
}

function readOf(question, verdict) {
  const { table } = verdict.report ?? {};
  if (table) return tableRead(table);
  return matrixRead(matrixOf(question, verdict)) ?? partlyRead(question, verdict);
}

/** @param {import("../../../judge/report.js").ReadTable} table */
const tableRead = ({ cells, wrong }) => ({
  columns: TABLE_HEADS,
  rows: cells.map((_, i) => String(i + 1)),
  cell: (i, k) => marked(signed(cells[i][k]), wrong[i][k]),
});

/** @param {ReturnType<typeof matrixOf>} found */
function matrixRead(found) {
  if (!found) return null;
  const { typed, wrong, shape } = found;
  return {
    ...found,
    cell(i, k) {
      const at = i * shape[1] + k;
      const value = signed(spelt(typed, at));
      const { text = "" } = typed.entries[at] ?? {};
      const formula = typed.symbolic && !/^[-+−\d.,\s]*$/.test(text);
      const under = formula && [...typeset(text), h("span.value", {}, "= ", value)];
      return marked(under || value, wrong[at]);
    },
  };
}

// What can be read of an answer that could not be judged, cell by cell.
function partlyRead(question, { error, waiting, arm, q }) {
  const { ask, answer } = question;
  const long = answer.length > LONGEST_SHOWN;
  if (!error || waiting || !arm || !answer.trim() || ask === "trace" || long) return null;
  const rows = largest(answer);
  const width = Math.max(0, ...rows.map((row) => row.length));
  const understood = rows.map((row) => row.map((text) => isRead(ask, text, arm, q)));
  return {
    ...namesOf(question, arm, [rows.length, width]),
    unread: understood.flat().filter((is) => !is).length,
    cell(i, k) {
      const text = rows[i][k];
      if (text === undefined) return h("td");
      const is = understood[i][k];
      return marked(is ? typeset(text) : text, !is, "not read: ");
    },
  };
}

// The rows of the largest block of what may be entries.
function largest(text) {
  const isEntry = (cell) => /\d/.test(cell) || /^[-+]?(?:[a-z]|theta|pi)$/i.test(cell);
  const blocks = blocksIn(text, { isEntry }).flatMap((way) => way());
  const size = (rows) => rows.flat().length;
  return blocks.reduce((most, { rows }) => (size(rows) > size(most) ? rows : most), []);
}

// Whether a cell is a formula that means something to this arm.
function isRead(ask, text, arm, q) {
  const named = ask === "branches" || ask === "pose";
  const bare = plain(named ? text.replace(/^.*[=:]/, "") : text).replace(/\*+$/, "");
  try {
    const tree = parse(bare || "0");
    if (ask === "jacobian" && q) lookup(arm, q)(symbols(tree));
    return true;
  } catch (error) {
    if (error instanceof ArmError) return false;
    throw error;
  }
}

function spelt({ values, units }, i) {
  const decimals = Math.min(6, units[i] ? Math.max(0, Math.round(-Math.log10(units[i]))) : 4);
  return (Number(values[i].toFixed(decimals)) + 0).toFixed(decimals);
}

const signed = (words) => typeset(words.replaceAll("-", "−"));

const marked = (content, off, why = "wrong: ") =>
  off ? h("td.off", {}, h("span.hidden", {}, why), content) : h("td", {}, content);

const EXAMPLE = "An example, with a mistake in it.";
const OVER_IT = " Paste or type your own over it."; // which takes a script

/**
 * The verdict, or why there is none yet; of an example it is none on the reader. `buttons` set what
 * the judge advises.
 */
export function tell(box, { report, error }, { example, buttons }) {
  box.className = `verdict ${example ? "example" : (report?.mark ?? report?.grade ?? "")}`;
  const offer = buttons.length
    ? [h("p.offer", {}, "If that is what you mean, set ", ...buttons)]
    : [];
  const note = example ? [h("p.note", {}, EXAMPLE, h("span.screen", {}, OVER_IT))] : [];
  if (!report) return box.replaceChildren(...note, h("p", {}, typeset(error)), ...offer);
  const lines = listDetails(report).filter((line) => !report.headline.endsWith(line.slice(1)));
  const items = lines.map((line) => h("li", {}, typeset(line)));
  const list = items.length ? [h("ul", {}, items)] : [];
  const mark = h(
    "span.mark",
    { "aria-hidden": "true" },
    `${GRADE_MARKS[report.mark ?? report.grade]} `,
  );
  const headline = h("p.headline", {}, mark, typeset(report.headline));
  return box.replaceChildren(...note, headline, ...list, ...offer);
}

const SYMBOL = /(?<!\w)([A-Za-z]|theta|alpha)_(?:\{([^}]+)\}|(\w+))(?![\w=])/g;
const LETTERS = { theta: "θ", alpha: "α" };

// What no line parts: a number with its sign, its power of ten and its unit.
const UNIT = String.raw`(?:N m|N|mm|m\/s²|m|degrees|deg|rad)(?![\w/^])`;
const NUMBER = String.raw`(?<![\w^{+±−-])[-+±−]*\d[\d.]*(?:e-\d+)?(?: ${UNIT})?`;
const PARTS = new RegExp(`(${NUMBER})`);

/**
 * A sentence with its symbols set, z_{i-1} as a letter and an index, and what it quotes between
 * backticks as it was typed.
 * @param {string} words
 */
const typeset = (words) =>
  words.split(/`(.*?)`/).flatMap((part, k) => (k % 2 ? h("code", {}, part) : unbroken(part)));

// With what belongs together on one line.
const unbroken = (words) =>
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
