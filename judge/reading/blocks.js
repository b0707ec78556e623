// Every rectangular block of entries in a text, with the words beside it.

import { RAD } from "../geometry/angles.js";
import { foldCharacters, foldNames, plainCharacters } from "./characters.js";
import { withoutDecorations } from "./decorations.js";
import { number } from "./formula.js";
import { findLabel, findValueLabel, readRowLabels, haveDifferentUnits } from "./labels.js";
import { markHeadings, readRows } from "./lines.js";

/** @typedef {import("./lines.js").Cell} Cell */
/** @typedef {import("./lines.js").Row} Row */
/**
 * Rows of entries; the words before each row, and of the line above; the name that the block is
 * assigned to; its first and last line; the rows of the text that it is made of; all rows and
 * words of the text as it was parted, and the rows that the question itself gave.
 * @typedef {object} Block
 * @property {Cell[][]} rows
 * @property {Cell[][]} labels
 * @property {Cell[]} headers
 * @property {string} name
 * @property {number} from
 * @property {number} to
 * @property {Row[]} sources
 * @property {Lines} [lines]
 */
/** @typedef {{ all: Row[], given: Set<Row>, words: Cell[] }} Lines */

// A decimal comma before one that parts; a line's end before a printer's break; gaps last.
const PARTINGS = [false, true].flatMap((gaps) =>
  [true, false].flatMap((decimal) => [false, true].map((wrapped) => ({ gaps, decimal, wrapped }))),
);

/**
 * Take decorations off a text and make its characters plain.
 * @param {import("./spans.js").SpannedText} pasted
 */
export const makePlainText = (pasted) =>
  plainCharacters(withoutDecorations(foldNames(foldCharacters(pasted))));

/**
 * Return a function for each way to part the text, which makes its blocks.
 * @param {import("./spans.js").SpannedText} plain
 * @param {{ isEntry: (cell: string) => boolean, names?: RegExp, given?: number[][] }} question
 * @param {boolean} [keepsGiven] whether rows that the question itself gave may be part of a block
 * @returns {(() => Block[])[]}
 */
export function makeBlockFinders(plain, { isEntry, names, given = [] }, keepsGiven = false) {
  const text = markHeadings(plain);
  const known = new Map();
  const isPadded = COMMA_BEFORE_ZERO.test(text.text) ? (cell) => PADDED.test(cell) : () => false;
  const entry = (cell) => {
    if (!known.has(cell)) known.set(cell, !isPadded(cell) && !NO_ENTRY.test(cell) && isEntry(cell));
    return known.get(cell);
  };
  const partings = PARTINGS.filter(({ decimal }) => !decimal || DECIMAL_COMMA.test(text.text));
  return partings.map((parting) =>
    once(() => blocksOf(readRows(text, entry, parting), names, given, keepsGiven)),
  );
}

const DECIMAL_COMMA = /\d,\d|[:=] ?[-+]?,\d/;
// (1) numbers a row; 0.066 -24.842 are two numbers.
const NO_ENTRY = /^\(\d{1,2}\)$|\d\.\d*\s+[-+]\d*\.\d/;
const COMMA_BEFORE_ZERO = /(?:^|[\d\s|&;-]),0\d/;
const PADDED = /^[-+]?0\d/; // the decimals of 1,0365 where a comma parts cells

// A function that makes its result when it is first called.
function once(make) {
  let made = null;
  return () => (made ??= make());
}

/** @returns {Block[]} */
function blocksOf({ rows: all, words }, names, given, keepsGiven) {
  const isOfQuestion = ({ cells }) => given.some((values) => isGiven(cells, values));
  const lines = { all, words, given: new Set(all.filter(isOfQuestion)) };
  const rows = keepsGiven ? all : all.filter((row) => !lines.given.has(row));
  const blocks = [
    ...followingRows(rows, names),
    ...rowsOfOneName(rows),
    ...joinNamed(rows),
    ...joinIndexed(rows),
    ...joinCellLines(rows, words),
  ];
  return blocks.map((block) => ({ ...block, lines }));
}

// Return whether cells are numbers that the question gave, to their digits, in radians or degrees.
const isGiven = (cells, given) =>
  cells.length === given.length &&
  given.length > 1 &&
  given.some(Boolean) &&
  cells.every(({ text }, k) => {
    const bare = text.replace(/ ?deg$/, "");
    const half = 0.51 * 10 ** -(bare.split(".")[1]?.length ?? 0);
    const x = number(bare);
    return [given[k], given[k] / RAD].some((y) => x !== null && Math.abs(x - y) <= half);
  });

const isNamed = (name, names) => names?.test(name.replace(/^"|[^\p{L}\p{N}]$/gu, "")) ?? false;

/** Rows of one length that follow each other; a line of numbers of other lengths parts them. */
function followingRows(rows, names) {
  const stretches = [];
  for (const width of new Set(rows.map(({ cells }) => cells.length))) {
    let stretch = [];
    let last = -1;
    rows.forEach((row, k) => {
      if (row.cells.length !== width) return;
      const between = rows.slice(last + 1, k);
      if (last >= 0 && follows(row, rows[last], between) && sharesName(row, stretch[0], names))
        stretch.push(row);
      else stretches.push((stretch = [row]));
      last = k;
    });
  }
  const joined = joinParts(stretches);
  const whole = joined.length ? stretches.filter(([row]) => !row.part) : stretches;
  return [...whole.map(blockOf), ...joined];
}

// Return whether a row goes on the row before it, with only numbers of their lines between them.
const follows = (row, before, between) =>
  !haveDifferentUnits(row.above, before.above) &&
  before.part === row.part &&
  before.depth === row.depth &&
  between.every(({ line }) => line === before.line || line === row.line) &&
  (row.cells.length > 1
    ? namesOtherQuantity(row) === namesOtherQuantity(before)
    : isAlike(row, before));

// Return whether a row may go on a list: without a name, or both or neither named as the answer. If
// the list has no name, only the answer's may stand beside a later row of it.
const sharesName = (row, first, names) => {
  if (!row.name) return true;
  if (first.name) return isNamed(row.name, names) === isNamed(first.name, names);
  return !names || isNamed(row.name, names) || !/\p{L}/u.test(row.name);
};

const OTHER_NAMES = /^(?:m|mass(?:es)?|F|f|F_?ext|force|w|wrench|g|p|[dalLhrm]_?\{?\d\}?|l_?pen)$/;
const OTHER_WORDS =
  /\b(?:mass(?:es)?|wrench|force|target|given|lengths?|at q|for F|norm|elapsed time)\b/i;

/**
 * Return whether the words before a row call it a quantity that nobody asks for: masses, lengths,
 * a force, a target.
 * @param {Row} row
 */
export function namesOtherQuantity({ name, words }) {
  const last = words.slice(-4).map(({ text }) => text);
  return OTHER_NAMES.test(name.split(" ").at(-1)) || OTHER_WORDS.test([...last, name].join(" "));
}

const OLD = /\b(?:old|wrong|first (?:try|attempt|run)|previous|earlier|before I)\b/i;

/**
 * Return whether the words before a row call it an old answer.
 * @param {Row} row
 */
export const isCalledOld = ({ name, words }) =>
  OLD.test([...words.map(({ text }) => text), name].join(" "));

// Return whether two values of a column are named alike: on one line both or neither with =, on two
// lines both with labels of one kind or without, and in a sentence. A list has one name for all.
function isAlike(row, other) {
  if (row.depth) return true;
  if (row.line === other.line) return !row.name === !other.name;
  return (
    sharesStem(row, other) && labelKind(row) === labelKind(other) && row.tail > 1 === other.tail > 1
  );
}

// Return whether the labels of two rows are called alike but for their numbers, or have consecutive
// numbers, as q2 and d3; also where one has no number.
function sharesStem(row, other) {
  const [label, before] = [findLabel(row.words), findLabel(other.words)];
  if (label?.kind !== "joint" || before?.kind !== "joint") return true;
  return stemOf(row) === stemOf(other) || label.number === before.number + 1;
}

const stemOf = ({ words }) =>
  words
    .at(-1)
    .text.toLowerCase()
    .replace(/[^\p{L}]/gu, "");

const labelKind = ({ name, words }) =>
  /^\(?\d{1,3}\)?$/.test(name) ? "count" : (findLabel(words)?.kind ?? "");

function applyUnits({ cells, scale, hasAnd }) {
  if (scale) return cells.map((cell) => ({ ...cell, text: `${cell.text}${scale}` }));
  const inDegrees = cells.filter(({ text }) => DEGREES_BEHIND.test(text));
  const isList = hasAnd && cells.length > 1;
  if (!isList || inDegrees.length !== 1 || inDegrees[0] !== cells.at(-1)) return cells;
  // In "10, 20 and 30 deg" the unit belongs to the whole list, which the text's unit is for.
  return cells.map((cell) => ({ ...cell, text: cell.text.replace(DEGREES_BEHIND, "") }));
}

const DEGREES_BEHIND = / deg$/;

/** @param {Row[]} rows @returns {Block} */
function blockOf(rows) {
  return {
    rows: rows.map(applyUnits),
    ...readRowLabels(rows),
    name: rows[0].name || (rows[0].words.at(-1)?.text ?? ""),
    from: rows[0].line,
    to: rows.at(-1).last,
    sources: rows,
  };
}

// MATLAB's parts of a wide matrix, "Columns 1 through 4" and on.
function joinParts(found) {
  const below = found
    .filter(([row]) => row.part > 0)
    .sort(([one], [other]) => one.part - other.part || one.line - other.line);
  const parts = below.filter(([row], k) => row.part !== below[k - 1]?.[0].part).map(blockOf);
  if (parts.length < 2 || parts.some(({ rows }) => rows.length !== parts[0].rows.length)) return [];
  const rows = parts[0].rows.map((_, i) => parts.flatMap((part) => part.rows[i]));
  const sources = parts.flatMap((part) => part.sources);
  return [{ ...parts[0], rows, headers: [], to: parts.at(-1).to, sources }];
}

// Rows with the same words before them, "positions:", between which other numbers stand.
function rowsOfOneName(rows) {
  const byName = new Map();
  for (const row of rows) {
    const name = `${row.cells.length} ${row.words.map(({ text }) => text).join(" ")}`;
    if (!row.words.length || row.cells.length < 2) continue;
    if (!byName.has(name)) byName.set(name, []);
    byName.get(name).push(row);
  }
  return [...byName.values()].filter(({ length }) => length > 2).map(blockOf);
}

// Single values with names of joints, q1 = 0.3: a row for each set of them.
function joinNamed(rows) {
  const labelled = rows.flatMap((row) => {
    const label = row.cells.length === 1 ? findValueLabel(row) : null;
    return label && label.kind !== "count" ? [{ row, label }] : [];
  });
  const single = labelled.filter(({ row }, k) => {
    const beside = [labelled[k - 1], labelled[k + 1]].filter((one) => one);
    return !namesOtherQuantity(row) || beside.some((one) => isSlideBeside(labelled[k], one));
  });
  const sets = [];
  for (const one of single) {
    const seen = sets.at(-1)?.some(({ label }) => label.number === one.label.number);
    if (!sets.length || seen) sets.push([]);
    sets.at(-1).push(one);
  }
  const count = sets[0]?.length;
  if (!count || count < 2 || sets.some((set) => set.length !== count)) return [];
  const headers = sets[0].map(({ row, label }) => ({ ...joinedCell(row.words), label }));
  const [first, last] = [single[0].row, single.at(-1).row];
  return [
    {
      rows: sets.map((set) => blockOf(set.map(({ row }) => row)).rows.flat()),
      labels: sets.map(() => []),
      headers,
      name: first.name,
      from: first.line,
      to: last.last,
      sources: single.map(({ row }) => row),
    },
  ];
}

// Return whether a row d3 = 0.4 stands beside one of the next joint, q2 = 0.3: then it is a slide.
const isSlideBeside = ({ row, label }, other) =>
  /^d/i.test(row.name) &&
  Math.abs(label.number - other.label.number) === 1 &&
  Math.abs(row.line - other.row.line) < 2 &&
  !namesOtherQuantity(other.row);

const joinedCell = (words) => ({
  text: words.map(({ text }) => text).join(" "),
  from: words[0].from,
  to: words.at(-1).to,
});

// A table that was pasted a cell to a line: column headers, then each row behind its label.
function joinCellLines(rows, words) {
  const lines = singleCells(rows, words);
  const sets = lines.flatMap((line, k) => {
    const label = lines[k - 1];
    return line.row && label && !label.row ? [cellsFrom(lines, k)] : [];
  });
  const labelled = sets.filter(({ cells }) => !countsUp(cells.map(({ text }) => text)));
  const values = labelled.length === 1 ? partByCount(labelled[0], lines) : labelled;
  const width = values[0]?.cells.length ?? 0;
  if (width < 2 || values.length < 2 || values.some(({ cells }) => cells.length !== width))
    return [];
  const sources = values.flatMap((set) => set.rows);
  return [
    {
      rows: values.map(({ cells }) => cells),
      labels: values.map(({ label }) => [label]),
      headers: headersAbove(
        lines,
        lines.findIndex(({ cell }) => cell === values[0].label),
        width,
      ),
      name: "",
      from: sources[0].line,
      to: sources.at(-1).last,
      sources,
    },
  ];
}

// The words of the lines directly above a line, at most one more than a row has cells.
function headersAbove(lines, end, width) {
  let first = end;
  while (
    end - first <= width &&
    first > 0 &&
    !lines[first - 1].row &&
    lines[first - 1].line === lines[first].line - 1
  )
    first--;
  return lines.slice(first, end).map(({ cell }) => cell);
}

// Lines that hold a single cell, an entry or a word, in order.
function singleCells(rows, words) {
  const entries = rows.flatMap((row) =>
    applyUnits(row).map((cell) => ({ line: row.line, cell, row })),
  );
  const all = [...entries, ...words.map((cell) => ({ line: cell.line, cell, row: null }))];
  const counts = new Map();
  for (const { line } of all) counts.set(line, (counts.get(line) ?? 0) + 1);
  return all
    .filter(({ line }) => counts.get(line) === 1)
    .sort((one, other) => one.line - other.line);
}

// The entries from a line on, up to the next word, and the word before them.
function cellsFrom(lines, first) {
  let end = first + 1;
  while (lines[end]?.row && lines[end].line === lines[end - 1].line + 1) end++;
  const set = lines.slice(first, end);
  return {
    label: lines[first - 1].cell,
    cells: set.map(({ cell }) => cell),
    rows: set.map(({ row }) => row),
  };
}

// Cells whose rows count 1, 2, 3, parted by their width: that of the headers above and the count.
function partByCount({ cells, rows }, lines) {
  const first = lines.findIndex(({ row }) => row === rows[0]);
  let top = first;
  while (top && !lines[top - 1].row && lines[top - 1].line === lines[top].line - 1) top--;
  const width = first - top + 1;
  const widths = [width, width - 1].filter((size) => size > 2);
  for (const size of widths) {
    const from = Array.from({ length: Math.floor(cells.length / size) }, (_, i) => i * size);
    if (cells.length % size || !countsUp(from.map((at) => cells[at].text))) continue;
    return from.map((at) => ({
      label: cells[at],
      cells: cells.slice(at + 1, at + size),
      rows: rows.slice(at, at + size),
    }));
  }
  return [];
}

const countsUp = (texts) => texts.every((text, k) => Number(text) === k + 1);

const INDICES = /[[({](\d{1,2})\s*,\s*(\d{1,2})[\])}]$/;

// Single values with two indices, J[2,3] := 0.5.
function joinIndexed(rows) {
  const indexed = rows.flatMap((row) => {
    const indices = row.cells.length === 1 && INDICES.exec(row.words.at(-1)?.text ?? "");
    return indices ? [{ row, i: Number(indices[1]), j: Number(indices[2]) }] : [];
  });
  if (indexed.length < 2) return [];
  const least = (key) => Math.min(...indexed.map((one) => one[key]));
  const size = (key) => Math.max(...indexed.map((one) => one[key])) - least(key) + 1;
  if (size("i") * size("j") !== indexed.length) return [];
  const matrix = Array.from({ length: size("i") }, () => Array(size("j")));
  for (const { row, i, j } of indexed) [matrix[i - least("i")][j - least("j")]] = row.cells;
  if (matrix.some((row) => row.includes(undefined))) return [];
  const [first, last] = [indexed[0].row, indexed.at(-1).row];
  return [
    {
      rows: matrix,
      labels: matrix.map(() => []),
      headers: [],
      name: first.name,
      from: first.line,
      to: last.last,
      sources: indexed.map(({ row }) => row),
    },
  ];
}
