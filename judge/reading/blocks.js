// Finds all blocks in a text. A block is a rectangle of entries with the words beside it.

import { RAD } from "../geometry/angles.js";
import { foldCharacters, foldNames, plainCharacters } from "./characters.js";
import { bareName } from "./columns.js";
import { withoutDecorations } from "./decorations.js";
import { number } from "./formula.js";
import { makeBlock } from "./block.js";
import { findLabel } from "./labels.js";
import { markHeadings, readRows } from "./lines.js";
import { haveSimilarLabels, isCalledOld, namesOtherQuantity } from "./row_names.js";
import { joinCellLines, joinIndexedValues, joinNamedValues } from "./single_values.js";

/** @typedef {import("./lines.js").Cell} Cell */
/** @typedef {import("./lines.js").Row} Row */
/** @typedef {import("./block.js").Block} Block */

// The order in which splittings are tried. Single blanks as separators come before wide gaps only.
// Decimal commas come before commas as separators. A row on each line comes before a row in each
// list.
const SPLITTINGS = [false, true].flatMap((gaps) =>
  [true, false].flatMap((decimal) => [false, true].map((wrapped) => ({ gaps, decimal, wrapped }))),
);

/**
 * Remove decorations and make the characters plain.
 * @param {import("./spans.js").SpannedText} pasted
 */
export const makePlainText = (pasted) =>
  plainCharacters(withoutDecorations(foldNames(foldCharacters(pasted))));

/**
 * Return a function for each splitting of the text. The function finds the blocks, and its argument
 * says whether a block may include numbers of the question.
 * @param {import("./spans.js").SpannedText} plain
 * @param {{ isEntry: (cell: string) => boolean, names?: RegExp, given?: number[][],
 *   commas?: string }} question `commas` is "decimal" or "separators", or undefined for both
 * @returns {((keepsGiven?: boolean) => Block[])[]}
 */
export function makeBlockFinders(plain, { isEntry, names, given = [], commas }) {
  const text = markHeadings(plain);
  const isEntryByCell = new Map();
  const isKnownEntry = (cell) => {
    if (!isEntryByCell.has(cell)) isEntryByCell.set(cell, !NO_ENTRY.test(cell) && isEntry(cell));
    return isEntryByCell.get(cell);
  };
  const mayBeDecimal = DECIMAL_COMMA.test(text.text);
  const mayBeWrapped = /[[({]/.test(text.text);
  const splittings = SPLITTINGS.filter(
    ({ decimal, wrapped }) =>
      (!decimal || mayBeDecimal) &&
      (!wrapped || mayBeWrapped) &&
      (!commas || decimal === (commas === "decimal")),
  );
  return splittings.map((splitting) => {
    const splitsCommas = mayBeDecimal && !splitting.decimal && !POINT_AND_COMMA.test(text.text);
    const readLines = callOnce(() => markGivenRows(readRows(text, isKnownEntry, splitting), given));
    const findOnce = (keepsGiven) =>
      callOnce(() => {
        const blocks = findBlocks(readLines(), names, keepsGiven);
        return splitsCommas ? blocks.map((block) => ({ ...block, splitsCommas })) : blocks;
      });
    const [findAll, findOthers] = [findOnce(true), findOnce(false)];
    return (keepsGiven = false) =>
      keepsGiven && readLines().given.size > 0 ? findAll() : findOthers();
  });
}

const DECIMAL_COMMA = /,\d/;
const POINT_AND_COMMA = /\d\.\d+,[-+]?\d/; // 0.5,10: the comma separates numbers
const NO_ENTRY = /^\(\d{1,2}\)$|\d\.\d*\s+[-+]\d*\.\d/; // the number of a row, or two numbers

// Return a function that computes its result at the first call only.
function callOnce(compute) {
  let result = null;
  return () => (result ??= compute());
}

// Collect the rows that repeat numbers of the question.
/** @returns {import("./block.js").Lines} */
function markGivenRows({ rows: all, words }, given) {
  const vectors = given.filter((values) => values.length > 1 && values.some(Boolean));
  const isOfQuestion = ({ cells, words }) => {
    if (findLabel(words)?.kind === "row") return false; // vy of a Jacobian
    const readCells = callOnce(() => cells.map(readWithHalfPlace));
    return vectors.some(
      (values) => values.length === cells.length && areGivenValues(readCells(), values),
    );
  };
  return { all, words, given: new Set(all.filter(isOfQuestion)) };
}

/** @param {import("./block.js").Lines} lines @returns {Block[]} */
function findBlocks(lines, names, keepsGiven) {
  const { all, words, given } = lines;
  const rows = keepsGiven ? all : all.filter((row) => !given.has(row));
  const blocks = [
    ...groupFollowingRows(rows, names),
    ...groupRowsByWords(rows),
    ...joinNamedValues(rows),
    ...joinIndexedValues(rows),
    ...joinCellLines(rows, words),
  ];
  return blocks.map((block) => ({ ...block, lines }));
}

// Return whether cells repeat numbers of the question, within their digits, in radians or degrees.
const areGivenValues = (cells, given) =>
  cells.every(
    ({ value, half }, k) =>
      Math.abs(value - given[k]) <= half || Math.abs(value - given[k] / RAD) <= half,
  );

// Read the number of a cell, or NaN if it has none, and half a unit of its last decimal place. A
// cell in mm is 200*1e-3.
function readWithHalfPlace({ text }) {
  const bare = text.replace(/ ?deg$/, "");
  const [digits, factor = 1] = bare.split("*");
  const half = 0.51 * 10 ** -(digits.split(".")[1]?.length ?? 0) * Number(factor);
  return { value: number(bare) ?? NaN, half };
}

const isAnswerName = (name, names) => names?.test(bareName(name)) ?? false;

// Group rows that follow each other and have the same length. Any other row between them ends the
// group.
function groupFollowingRows(rows, names) {
  const groups = [];
  for (const width of new Set(rows.map(({ cells }) => cells.length))) {
    let group = [];
    let last = -1;
    rows.forEach((row, k) => {
      if (row.cells.length !== width) return;
      const between = rows.slice(last + 1, k);
      if (last >= 0 && continues(row, rows[last], between) && fitsName(row, group[0], names))
        group.push(row);
      else groups.push((group = [row]));
      last = k;
    });
  }
  const joined = joinMatrixParts(groups);
  const whole = joined.length ? groups.filter(([row]) => !row.part) : groups;
  return [...whole.map(makeBlock), ...joined];
}

// Return whether a row may follow the row `before` in a block. The rows between them must stand on
// the lines of these two rows.
const continues = (row, before, between) =>
  before.part === row.part &&
  before.depth === row.depth &&
  between.every(({ line }) => line === before.line || line === row.line) &&
  isCalledOld(row) === isCalledOld(before) &&
  (row.cells.length > 1
    ? isSameList(row, before) || namesOtherQuantity(row) === namesOtherQuantity(before)
    : haveSimilarLabels(row, before));

const isSameList = (row, other) => row.list >= 0 && row.list === other.list;

// Return whether the name of a row lets it join a group. The row has no name, or both the row and
// the group are called like the answer, or neither is. If the group has no name, the row may have
// the answer's name.
const fitsName = (row, first, names) => {
  if (!row.name) return true;
  if (first.name) return isAnswerName(row.name, names) === isAnswerName(first.name, names);
  return !names || isAnswerName(row.name, names) || !/\p{L}/u.test(row.name);
};

// Join the parts of a wide matrix of MATLAB, which begin with "Columns 1 through 4".
function joinMatrixParts(groups) {
  const parts = groups
    .filter(([row]) => row.part > 0)
    .sort(([first], [second]) => first.line - second.line)
    .filter(([row], k, below) => row.part !== below[k - 1]?.[0].part) // drops rows below a part
    .map(makeBlock);
  if (parts.length < 2 || parts.some(({ rows }) => rows.length !== parts[0].rows.length)) return [];
  const rows = parts[0].rows.map((_, i) => parts.flatMap((part) => part.rows[i]));
  const sources = parts.flatMap((part) => part.sources);
  return [{ ...parts[0], rows, headers: [], lastLine: parts.at(-1).lastLine, sources }];
}

// Group rows with the same words before them but for numbers, such as "joint(1).DH =". Other rows
// may stand between them.
function groupRowsByWords(rows) {
  const byName = new Map();
  for (const row of rows) {
    const words = row.words.map(({ text }) => text).join(" ");
    const name = `${row.cells.length} ${words.replace(/\d+/g, "#")}`;
    if (!row.words.length || row.cells.length < 2) continue;
    if (!byName.has(name)) byName.set(name, []);
    byName.get(name).push(row);
  }
  return [...byName.values()].filter(({ length }) => length > 2).map(makeBlock);
}
