// Shows how an answer was read, cell by cell, and the verdict on it.

import { h } from "../dom.js";
import { GREEK, typesetFormula } from "./mathml.js";
import { makeBlockFinders, makePlainText } from "../../../judge/reading/blocks.js";
import { parse, plain, symbols } from "../../../judge/reading/formula.js";
import { lookup } from "../../../judge/reading/numbers.js";
import { SpannedText } from "../../../judge/reading/spans.js";
import { formatEntryValue, getHeaders, getMatrix } from "../../../judge/marks.js";
import { RIGHT, RIGHT_BY_MAP, ROUNDED, SO_FAR, WRONG } from "../../../judge/digits.js";
import { listDetails, GRADE_MARKS } from "../../../judge/verdict.js";
import { ArmError } from "../../../judge/sentences.js";

const CAPTION = "How your answer is read";
const TABLE_HEADERS = ["a (m)", "α", "d (m)", "θ"];
const MAX_ROWS = 40;
const MAX_FORMULA_LENGTH = 1000; // characters of a formula that is typeset
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
 * @property {boolean} [isSymbolic] whether cells are formulas, which may be too wide for one table
 */

/** Make the region that shows how the answer was read. */
export function makeReadingView() {
  const root = h("div.scroll.taken", {
    role: "region",
    tabindex: "0",
    "aria-label": "How your answer is read",
  });
  /** @type {Reading | null} */
  let reading = null;
  let [kind, width] = ["", 0];

  // Show the cells as one table, or each column by itself if formulas do not fit beside each other.
  function draw() {
    width = root.clientWidth;
    root.classList.remove("by-column");
    root.replaceChildren(makeReadTable(reading, kind));
    if (!reading.isSymbolic || root.scrollWidth <= width) return;
    root.classList.add("by-column");
    root.replaceChildren(...makeColumnTables(reading));
  }
  new ResizeObserver(() => {
    if (reading && root.clientWidth !== width) draw();
  }).observe(root);

  /**
   * Show how the answer was read: formulas typeset, wrong cells marked, unreadable cells as typed.
   * @param {Question} question
   * @param {Outcome} outcome
   */
  function update(question, outcome) {
    reading = getReading(question, outcome);
    kind = question.ask === "table" ? "table.read" : "table.read.grid";
    root.hidden = !reading;
    if (reading) draw();
  }
  return { root, update };
}

/** @param {Reading} reading @param {string} kind tag and classes of the table */
function makeReadTable({ columns, rows, cell, unread = 0 }, kind) {
  const headers = columns.map((name) => h("th", { scope: "col" }, name));
  const shownRows = rows.slice(0, MAX_ROWS);
  const body = shownRows.map((name, i) =>
    makeRow(
      name,
      columns.map((_, k) => cell(i, k)),
    ),
  );
  const first = rows.length > MAX_ROWS ? `, its first ${MAX_ROWS} of ${rows.length} rows` : "";
  const caption = h("caption", {}, CAPTION, first, describeUnread(unread));
  const head = h("thead", {}, h("tr", {}, h("td"), headers));
  return h(kind, {}, caption, head, h("tbody", {}, body));
}

/** @param {Reading} reading */
function makeColumnTables({ columns, rows, cell, unread = 0 }) {
  const tables = columns.map((column, k) => {
    const body = rows.slice(0, MAX_ROWS).map((name, i) => makeRow(name, [cell(i, k)]));
    return h("table.read", {}, h("caption", {}, column), h("tbody", {}, body));
  });
  return [h("p.caption", {}, CAPTION, describeUnread(unread)), ...tables];
}

export const makeRow = (name, cells) => h("tr", {}, h("th", { scope: "row" }, name), cells);
const describeUnread = (count) =>
  count ? `; ${count === 1 ? "1 entry" : `${count} entries`} could not be` : "";

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
const readTableCells = ({ cells, trees, wrong }) => ({
  columns: TABLE_HEADERS,
  rows: cells.map((_, i) => String(i + 1)),
  isSymbolic: true,
  cell(i, k) {
    const tree = trees[i]?.[k];
    const isFormula = tree && symbols(tree).size > 0 && !cells[i][k].includes("q_");
    return makeCell(typesetEntry(isFormula ? tree : null, cells[i][k]), wrong[i][k]);
  },
});

/** @param {ReturnType<typeof getMatrix>} matrix @returns {Reading | null} */
function readMatrixCells(matrix) {
  if (!matrix) return null;
  const { typed, wrong, shape } = matrix;
  return {
    ...matrix,
    isSymbolic: typed.symbolic,
    cell(i, k) {
      const at = i * shape[1] + k;
      const tree = typed.symbolic ? typed.formulas?.[at] : null;
      const isFormula = tree && (typed.entries[at]?.text ?? "").length <= MAX_FORMULA_LENGTH;
      const value = formatEntryValue(typed, at);
      return makeCell(typesetEntry(isFormula && !isNumeral(tree) ? tree : null, value), wrong[at]);
    },
  };
}

const isNumeral = ([kind, first]) => kind === "num" || (kind === "neg" && first[0] === "num");

/**
 * Typeset an entry: its formula, if it is one, above its value.
 * @param {any[] | null} tree
 * @param {string} value
 */
const typesetEntry = (tree, value) =>
  tree
    ? [typesetFormula(tree), h("span.value", {}, "= ", typesetNumber(value))]
    : typesetNumber(value);

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

const GRADE_NAMES = {
  [RIGHT]: "Right",
  [RIGHT_BY_MAP]: "Right",
  [SO_FAR]: "Right so far",
  [ROUNDED]: "Right but for a last digit",
  [WRONG]: "Not right",
};

/**
 * Show the verdict in one line above the answer, for screens on which the verdict itself is below
 * the keyboard.
 * @param {HTMLElement} line
 * @param {import("./question.js").Outcome} outcome
 * @param {boolean} isExample
 */
export function showShortVerdict(line, { verdict, error = "" }, isExample) {
  const grade = verdict?.mark ?? verdict?.grade ?? "";
  const [, cause = ""] = /: (.*)/s.exec(verdict?.headline ?? "") ?? [];
  const parts = [GRADE_NAMES[grade], cause].filter(Boolean).join(": ");
  const text = verdict ? `${GRADE_MARKS[grade]} ${parts}` : error;
  line.className = `short ${isExample ? "example" : grade}`;
  line.replaceChildren(...typeset(isExample ? EXAMPLE : text));
}

const SYMBOL_PATTERN = /(?<!\w)([A-Za-z]|theta|alpha)_(?:\{([^}]+)\}|(\w+))(?![\w=])/g;

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
