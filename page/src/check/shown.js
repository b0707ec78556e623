// Shows how an answer was read, cell by cell, and the verdict on it.

import { h } from "../dom.js";
import { makeBlockFinders, makePlainText } from "../../../judge/reading/blocks.js";
import { parse, plain, symbols } from "../../../judge/reading/formula.js";
import { lookup } from "../../../judge/reading/numbers.js";
import { SpannedText } from "../../../judge/reading/spans.js";
import { formatEntryValue, getHeaders, getMatrix } from "../../../judge/marks.js";
import { listDetails, GRADE_MARKS } from "../../../judge/verdict.js";
import { ArmError } from "../../../judge/sentences.js";

const TABLE_HEADERS = ["a (m)", "α", "d (m)", "θ"];
const MAX_ROWS = 40;
const MAX_CELLWISE_LENGTH = 8000; // characters of an answer that is shown without a verdict

/** @typedef {import("../../../judge/geometry/arm.js").Arm} Arm */
/** @typedef {import("./question.js").Question} Question */
/** @typedef {import("./question.js").Outcome} Outcome */
/**
 * The cells of an answer, as they were read.
 * @typedef {object} Reading
 * @property {string[]} columns their headers
 * @property {string[]} rows their headers
 * @property {(row: number, column: number) => HTMLElement} cell makes a cell
 * @property {number} [unread] count of cells that could not be read
 */

/**
 * Show how the answer was read: formulas typeset, wrong cells marked, unreadable cells as typed.
 * @param {HTMLElement} region
 * @param {Question} question
 * @param {Outcome} outcome
 */
export function showReading(region, question, outcome) {
  const reading = getReading(question, outcome);
  region.hidden = !reading;
  if (!reading) return;
  const { columns, rows, cell, unread = 0 } = reading;
  const head = h(
    "tr",
    {},
    h("td"),
    columns.map((name) => h("th", { scope: "col" }, name)),
  );
  const body = rows.slice(0, MAX_ROWS).map((name, i) =>
    h(
      "tr",
      {},
      h("th", { scope: "row" }, name),
      columns.map((_, k) => cell(i, k)),
    ),
  );
  const first = rows.length > MAX_ROWS ? `, its first ${MAX_ROWS} of ${rows.length} rows` : "";
  const odd = unread ? `; ${unread === 1 ? "1 entry" : `${unread} entries`} could not be` : "";
  const caption = h("caption", {}, `How your answer is read${first}${odd}`);
  const kind = question.ask === "table" ? "table.read" : "table.read.grid";
  region.replaceChildren(h(kind, {}, caption, h("thead", {}, head), h("tbody", {}, body)));
}

/**
 * Return the cells of an answer; null if none are shown.
 * @param {Question} question
 * @param {Outcome} outcome
 * @returns {Reading | null}
 */
function getReading(question, outcome) {
  const { table } = outcome.verdict ?? {};
  if (table) return readTableCells(table);
  return readMatrixCells(getMatrix(question, outcome)) ?? readPartly(question, outcome);
}

/** @param {import("../../../judge/verdict.js").ReadTable} table @returns {Reading} */
const readTableCells = ({ cells, wrong }) => ({
  columns: TABLE_HEADERS,
  rows: cells.map((_, i) => String(i + 1)),
  cell: (i, k) => makeCell(typesetNumber(cells[i][k]), wrong[i][k]),
});

/** @param {ReturnType<typeof getMatrix>} matrix @returns {Reading | null} */
function readMatrixCells(matrix) {
  if (!matrix) return null;
  const { typed, wrong, shape } = matrix;
  return {
    ...matrix,
    cell(i, k) {
      const at = i * shape[1] + k;
      const value = typesetNumber(formatEntryValue(typed, at));
      const { text = "" } = typed.entries[at] ?? {};
      const formula = typed.symbolic && !/^[-+−\d.,\s]*$/.test(text);
      const under = formula && [...typeset(text), h("span.value", {}, "= ", value)];
      return makeCell(under || value, wrong[at]);
    },
  };
}

/**
 * Read an answer that could not be judged, cell by cell.
 * @param {Question} question
 * @param {Outcome} outcome
 * @returns {Reading | null}
 */
function readPartly(question, { error, tokens, arm, q }) {
  const { ask, answer } = question;
  const isLong = answer.length > MAX_CELLWISE_LENGTH;
  if (!error || tokens || !arm || !answer.trim() || ask === "trace" || isLong) return null;
  const rows = findLargestBlock(answer);
  const width = Math.max(0, ...rows.map((row) => row.length));
  const understood = rows.map((row) => row.map((text) => isReadable(ask, text, arm, q)));
  return {
    ...getHeaders(question, arm, [rows.length, width]),
    unread: understood.flat().filter((isUnderstood) => !isUnderstood).length,
    cell(i, k) {
      const text = rows[i][k];
      if (text === undefined) return h("td");
      return understood[i][k] ? makeCell(typeset(text)) : makeCell(text, true, "not read: ");
    },
  };
}

// Return the rows of the largest block of possible entries.
function findLargestBlock(text) {
  const isEntry = (cell) => /\d/.test(cell) || /^[-+]?(?:[a-z]|theta|pi)$/i.test(cell);
  const plain = makePlainText(new SpannedText(text));
  const blocks = makeBlockFinders(plain, { isEntry }).flatMap((way) => way());
  const size = (rows) => rows.flat().length;
  return blocks
    .reduce((most, { rows }) => (size(rows) > size(most) ? rows : most), [])
    .map((row) => row.map((cell) => cell.text));
}

/**
 * Return whether a cell is a formula with a meaning for this arm.
 * @param {string} ask kind of question
 * @param {string} text
 * @param {Arm} arm
 * @param {number[]} [q]
 */
function isReadable(ask, text, arm, q) {
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

const typesetNumber = (words) => typeset(words.replaceAll("-", "−"));

const makeCell = (content, isOff = false, why = "wrong: ") =>
  isOff ? h("td.off", {}, h("span.hidden", {}, why), content) : h("td", {}, content);

const EXAMPLE = "An example, with a mistake in it.";
const OVER_IT = " Paste or type your own over it."; // typing needs a script

/**
 * Show the verdict, or why there is none yet. The verdict on an example is marked as one.
 * `buttons` apply the judge's advice.
 * @param {HTMLElement} box
 * @param {import("./question.js").Outcome} outcome
 * @param {{ example: boolean, buttons: HTMLElement[] }} options
 */
export function showVerdict(box, { verdict, error }, { example, buttons }) {
  const grade = verdict?.mark ?? verdict?.grade ?? "";
  box.className = `verdict ${example ? "example" : grade}`;
  const offer = buttons.length
    ? [h("p.offer", {}, "If that is what you mean, set ", ...buttons)]
    : [];
  const note = example ? [h("p.note", {}, EXAMPLE, h("span.screen", {}, OVER_IT))] : [];
  if (!verdict) return box.replaceChildren(...note, h("p", {}, typeset(error)), ...offer);
  const lines = listDetails(verdict).filter((line) => !verdict.headline.endsWith(line.slice(1)));
  const items = lines.map((line) => h("li", {}, typeset(line)));
  const list = items.length ? [h("ul", {}, items)] : [];
  const mark = h("span.mark", { "aria-hidden": "true" }, `${GRADE_MARKS[grade]} `);
  const headline = h("p.headline", {}, mark, typeset(verdict.headline));
  return box.replaceChildren(...note, headline, ...list, ...offer);
}

const SYMBOL_PATTERN = /(?<!\w)([A-Za-z]|theta|alpha)_(?:\{([^}]+)\}|(\w+))(?![\w=])/g;
const GREEK = { theta: "θ", alpha: "α" };

// Parts that must not break across lines: a number with its sign, power of ten and unit.
const UNIT_PATTERN = String.raw`(?:N m|N|mm|m\/s²|m|degrees|deg|rad)(?![\w/^])`;
const NUMBER_PATTERN = String.raw`(?<![\w^{+±−-])[-+±−]*\d[\d.]*(?:e-\d+)?(?: ${UNIT_PATTERN})?`;
const UNBREAKABLE = new RegExp(`(${NUMBER_PATTERN})`);

/**
 * Typeset a sentence: symbols such as z_{i-1} as a letter with an index, text between backticks as
 * code.
 * @param {string} words
 */
export const typeset = (words) =>
  words.split(/`(.*?)`/).flatMap((part, k) => (k % 2 ? h("code", {}, part) : keepTogether(part)));

const keepTogether = (words) =>
  words
    .split(UNBREAKABLE)
    .flatMap((part, k) =>
      k % 2 ? h("span.unbroken", {}, typesetSymbols(part)) : typesetSymbols(part),
    );

function typesetSymbols(words) {
  const parts = [];
  let at = 0;
  for (const match of words.matchAll(SYMBOL_PATTERN)) {
    const [whole, letter, braced, bare] = match;
    parts.push(words.slice(at, match.index), h("i", {}, GREEK[letter] ?? letter));
    parts.push(h("sub", {}, (braced ?? bare).replace("-", "−")));
    at = match.index + whole.length;
  }
  return [...parts, words.slice(at)];
}
