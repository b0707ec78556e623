// The block of a text that is a table: rows of entries below their heads, or the matrices of its
// links one below the other.

import { blocksIn, plainText } from "./blocks.js";
import { setAside } from "./answers.js";
import { hasDecimals, isNumber, plain, simple, symbolsIn } from "./formula.js";
import { linesOf, ROW_END } from "./characters.js";
import { withoutMargins } from "./decorations.js";
import { SpannedText } from "./spans.js";
import { headOf } from "./table_columns.js";
import { ENTRIES, entryText, VARIABLE } from "./table_rows.js";

const MOST_COLUMNS = 9; // a number, a kind, four entries, an offset, two limits

/**
 * Rows of cells as typed, the heads above them, what else stands in the text.
 * @typedef {{ cells: string[][], heads: string[], context: string, left: string[],
 *   torn?: string, block: import("./blocks.js").Block, isTurned?: boolean }} TableBlock `torn` is a
 *   line beside it that could not be read; `isTurned` if each typed row is a column of the table
 */

/**
 * The blocks that may be a table, those with heads first, then those with the most rows, then the
 * last.
 * @param {string} text
 * @param {Map<string, number>} known symbols that have numbers
 * @param {SpannedText} [pasted] the text without its comments
 * @returns {TableBlock[]}
 */
export function tablesIn(text, known, pasted = new SpannedText(text)) {
  const plain = plainText(withoutMargins(pasted)).replace(DEFINITIONS, "");
  const all = markColumnHeaders(withoutStars(plain));
  const ways = blocksIn(all.plain, { isEntry: entryIn(known) });
  const blocks = ways.flatMap((way) => way().reverse());
  const lines = all.plain.text.split("\n");
  const typed = linesOf(text);
  const heads = typed.filter((_, k) => lines[k]?.includes(HEADS)).map((line) => line.trim());
  const found = blocks.map(withoutRules).flatMap((block) => upright(block, lines, all.found));
  const order = ({ heads, cells }) => (heads.length ? 100 : 0) + cells.length;
  return found
    .filter(({ cells: [row = []] }) => row.length >= 4 && row.length <= MOST_COLUMNS)
    .sort((one, other) => order(other) - order(one))
    .map((one) => {
      const left = setAside(text, one.block);
      const told = left.filter((line) => !heads.includes(line) || hasDecimals(line));
      const context = contextOf(typed, one.block);
      return { ...one, context, left: told, torn: tornFrom(one.block, lines) };
    });
}

// A line of lengths, "d_1 = 0.5, a_2 = 0.4", which is no row.
const LENGTH = String.raw`(?!al|th|q)[a-z]\w{0,6}[ \t]*=[ \t]*-?[\d.]{1,12}(?:[ \t]*m{1,2})?`;
const DEFINITIONS = new RegExp(String.raw`^[ \t]*(?:${LENGTH}[ \t]*(?:[,;][ \t]*|$)){2,}$`, "gim");

// The text around a block: the lines beside it, the words before its rows and above them.
const contextOf = (lines, { from, to, labels, headers }) =>
  [
    ...lines.filter((_, i) => i < from || i > to),
    ...[...labels.flat(), ...headers].map(({ text }) => text),
  ].join("\n");

// Stars that mark a joint's variable, or stand for it, are no signs of a product.
const STARRED = /((?:[A-Za-zθϑφ]|\\[a-z]+)_?\{?\d*\}?)\^?\{?\*\}?(?=\s)/g;
const ALONE = /(?<=\s)\*(?=[ \t]*$)/gm;
const withoutStars = (plain) => plain.replace(STARRED, "$1").replace(ALONE, "?");

// A line beside a block of numbers for the most part: a row that could not be read as one. Columns
// may be counted behind a word.
const tornFrom = ({ from, to }, lines) =>
  [lines[from - 1], lines[to + 1]].find((line = "") => {
    const parts = line.split(/[|&;,\s[\](){}]+/).filter(Boolean);
    const numbers = parts.filter(isNumber);
    const counted = numbers.every((x, k) => Number(x) === Number(numbers[0]) + k);
    const column = counted && numbers.length < parts.length;
    return numbers.length > 1 && 2 * numbers.length >= parts.length && !column;
  });

// A block without rows that are drawn, | - | - |.
function withoutRules(block) {
  const drawn = block.rows.map((row) => row.every(({ text }) => text === "-"));
  const kept = (list) => list.filter((_, i) => !drawn[i]);
  return { ...block, rows: kept(block.rows), labels: kept(block.labels) };
}

// A block with its heads, on its first line or shortly above; one whose rows are named after the
// columns is turned.
function upright(block, lines, found) {
  const { rows, labels, from } = block;
  if (!rows.length) return [];
  const names = labels.map((words) => marked(textsOf(words), found)?.[0]);
  const named = names.flatMap((name, i) => (name ? [i] : []));
  if (new Set(named.map((i) => headOf(names[i]))).size < 3) {
    const above = lines.slice(Math.max(0, from - NEAR), from + 1).reverse();
    const heads = marked(above.join(" ").split(" "), found) ?? [];
    return [{ block, cells: rows.map(textsOf), heads }];
  }
  const cells = rows[0].map((_, k) => named.map((i) => rows[i][k].text));
  return [{ block, cells, heads: named.map((i) => names[i]), isTurned: true }];
}

const textsOf = (cells) => cells.map(({ text }) => text);
const NEAR = 3; // lines above a table in which its heads stand: a rule, an opening bracket

// Heads

const HEADS = "·heads·"; // begins a word that stands for heads, by their number
const marked = (words, found) => {
  const word = words.find((one) => one.startsWith(HEADS));
  return word ? found[Number(word.slice(HEADS.length))] : null;
};

/**
 * Put a word in place of each line of column headers, and of a header before a line of entries; an
 * empty cell below headers becomes 0.
 * @param {SpannedText} plain
 * @returns {{ plain: SpannedText, found: string[][] }} `found` are the headers
 */
function markColumnHeaders(plain) {
  const found = [];
  const { text } = plain;
  const lines = [...text.matchAll(LINE)].map(({ 0: line, index }) => ({ line, at: index }));
  const edits = [];
  const mark = ({ line, at }, headers, length) => {
    const [open] = /^[\s[({|]*/.exec(line);
    const word = `${open.replaceAll("|", " ")} ${HEADS}${found.push(headers) - 1} `;
    edits.push({ from: at, to: at + length, text: word });
  };
  const whole = lines.filter(({ line }) => headsIn(line));
  for (const one of whole) mark(one, headsIn(one.line), one.line.length);
  if (whole.length)
    for (const one of lines)
      if (!whole.includes(one))
        edits.push(
          ...zerosIn(
            one,
            whole.filter(({ at }) => at < one.at),
          ),
        );
  for (const one of whole.length ? [] : lines) {
    const rest = bare(one.line);
    const [first, head] = ROW_HEAD.exec(rest) ?? [];
    if (head && ENTRIES.includes(headOf(head)))
      mark(one, [head], one.line.length - rest.length + first.length);
  }
  edits.sort((one, other) => one.from - other.from);
  return { plain: edits.length ? plain.edit(edits) : plain, found };
}

const LINE = new RegExp(`[^\n${ROW_END}]+`, "g");
const bare = (line) => line.replace(/^[\s[({|]+/, "");

// A 0 for each empty cell of a line that has as many cells as column headers above it.
function zerosIn({ line, at }, headers) {
  if (!line.trim()) return [];
  for (const { line: heads } of headers) {
    const separator = ["\t", ";", ",", "|", "&"].find((one) => heads.includes(one));
    if (!separator) continue;
    const [cells, above] = [line, heads].map((one) => one.split(separator));
    if (cells.length !== above.length || cells.length < 4) continue;
    let from = at;
    return cells.flatMap((cell, k) => {
      const start = from;
      from += cell.length + 1;
      const isEmpty = !cell.trim() && above[k].trim();
      return isEmpty ? [{ from: start, to: start + cell.length, text: "0" }] : [];
    });
  }
  return [];
}

// A head before entries: "a [mm] | 0 | 88".
const ROW_HEAD = new RegExp(
  String.raw`^([^|&\t;:=\d-]{1,24}?(?:\s?[[(][^\])]{1,8}[\])])?)` +
    String.raw`\s*(?:[|&\t;:,]|\s(?=[-+]?[.\d]))`,
);
const SEPARATORS = [/[|&\t;]/, /\s{2,}/, /,/, /\s+/];

// The heads of a line that names three of the four columns or more, each by itself.
function headsIn(typed) {
  const line = bare(typed).replace(/^(?:#|%|\/\/)+\s*(?![|&\t;,])|[|\s\])}]+$/g, (sign) =>
    sign.replace(/[|\s#%/]/g, ""),
  );
  for (const sign of SEPARATORS) {
    const cells = line.split(sign);
    if (cells.length > 2 * MOST_COLUMNS) continue;
    const heads = withUnits(cells.map((head) => head.trim().replace(/^"|"$/g, ""))).filter(
      (head, k, all) => !k || headOf(head) !== "i" || headOf(all[k - 1]) !== "i", // "Link, i"
    );
    const named = heads.map(headOf).filter((word) => ENTRIES.includes(word));
    if (new Set(named).size >= 3 && heads.length <= named.length + 4) return heads;
  }
  return null;
}

// The heads with a unit that stands apart, as in "a (mm)", joined to its own.
function withUnits(cells) {
  const heads = [];
  for (const cell of cells)
    if (heads.length && /^[([].*[)\]]$/.test(cell)) heads.push(`${heads.pop()} ${cell}`);
    else heads.push(cell);
  return heads;
}

// Entries

const FRAMES = /^\d{1,2} ?- ?\d{1,2}$/; // 0-1 names a row after its frames
// Names of rows, which are no symbols of an arm.
const ROW_NAME = /^(?:joint|link|row|frame)_?\d+$/i;
// A joint's variable, or a length with its number or one letter.
const SYMBOL = /^(?:[a-z]+_?\{?\d+\}?'?|[a-z]_\{?\w+\}?|[adlhrbe])$/i;
// The kind of a joint, and what stands for the number of a row that has none.
const WORD = /^(?:r|p|revolute|prismatic|fixed|base|tool)$/i;
// Return whether a cell may stand in a table: a number, a formula of symbols, what stands for a
// variable.
export function entryIn(known) {
  const isSymbol = (name) => !ROW_NAME.test(name) && (SYMBOL.test(name) || known.has(simple(name)));
  return (cell) => {
    if (FRAMES.test(cell)) return false;
    const text = entryText(cell);
    if (isNumber(text) || VARIABLE.test(plain(text)) || WORD.test(text)) return true;
    return symbolsIn(text)?.every(isSymbol) ?? false;
  };
}
