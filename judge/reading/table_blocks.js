// Finds the rows of a Denavit-Hartenberg table in a text, with their column headers. The rows may
// be those of link matrices, A_1 above A_2.

import { makeBlockFinders, makePlainText } from "./blocks.js";
import { isNumber, plain, simple, symbolsIn } from "./formula.js";
import { foldCharacters, linesOf, ROW_END } from "./characters.js";
import { flattenFormulas } from "./drawn_formulas.js";
import { withoutMargins } from "./decorations.js";
import { SpannedText } from "./spans.js";
import { findEntry } from "./table_columns.js";
import { ENTRIES, trimEntry, VARIABLE } from "./table_rows.js";
import { findColumnNames } from "./table_statements.js";
import { LENGTH_UNIT } from "./units.js";
import { formatMessage } from "../sentences.js";

/**
 * The typed cells of a table, their headers and the rest of the text.
 * @typedef {{ cells: string[][], headers: string[], context: string,
 *   block: import("./blocks.js").Block, isTurned?: boolean, plainLines: string[] }} TableBlock
 *   `context` is the whole text; `isTurned` is true if each typed row is a column of the table;
 *   `plainLines` are the lines without decorations
 */

/**
 * List the blocks that may be a table, the likeliest first. A block with headers comes first, then
 * a block with more rows, then a block further down.
 * @param {string} text
 * @param {Map<string, number>} known symbols that have numbers
 * @param {SpannedText} [pasted] the text without its comments
 * @returns {TableBlock[]}
 */
export function listTableBlocks(text, known, pasted = new SpannedText(text)) {
  const flat = flattenFormulas(pasted, formatMessage("your table"));
  const plain = makePlainText(withoutMargins(flat)).replace(DEFINITIONS, "");
  const marked = markColumnHeaders(nameToolRow(dropStars(plain)));
  const blockFinders = makeBlockFinders(marked.plain, { isEntry: makeEntryTest(known) });
  const lines = linesOf(marked.plain.text);
  const rank = ({ headers, cells }) => (headers.length ? 100 : 0) + cells.length;
  return blockFinders
    .flatMap((findBlocks) => findBlocks().reverse())
    .map(dropDrawnRows)
    .flatMap((block) => addHeaders(block, lines, marked.headers))
    .filter(({ cells: [row = []] }) => row.length >= 4)
    .sort((left, right) => rank(right) - rank(left))
    .map((table) => ({
      ...table,
      context: foldCharacters(text),
      plainLines: lines,
    }));
}

// A line that defines lengths, "d_1 = 0.5, a_2 = 0.4", is no row.
const LENGTH = String.raw`(?!al|th|q)[a-z]\w{0,6}[ \t]*=[ \t]*-?[\d.]{1,12}(?:[ \t]*m{1,2})?`;
// D1, A2 = 0.5, 0.4
const SEVERAL = String.raw`[a-z]\w?(?:[ \t]*,[ \t]*[a-z]\w?){1,20}[ \t]*=[ \t]*[-\d., \t]+`;
const DEFINITIONS = new RegExp(
  String.raw`^[ \t]*(?:(?:${LENGTH}[ \t]*(?:[,;][ \t]*|$)){2,}|${SEVERAL})$`,
  "gim",
);

// Stars behind a joint variable, q1*, and in place of a joint variable. They are no products.
const STARRED = /([A-Za-zθϑφ]_?\{?[\d₀-₉]*\}?)\^?\{?(?:[*∗⋆]|\\(?:ast|star))\}?(?!\S)/g;
const ALONE = /(?<=\s)\*(?=[ \t]*$)/gm;
const dropStars = (plain) => plain.replace(STARRED, "$1").replace(ALONE, "?");

// Names of the tool's row, as in "EE | 0 | 0 | 0.1 | 0". It is the last row and has four numbers.
const TOOL_ROW =
  /^([ \t|]*)(?:T|EE|TCP|flange)(?=(?:[ \t|&;,]+[-+−]?[\d.][^\s|&;,]*){4}[\s|&;,\\]*(?![\s\S]))/gm;
const nameToolRow = (plain) => plain.replace(TOOL_ROW, "$1tool");

// Drop rows that only draw a line, | - | - |.
function dropDrawnRows(block) {
  const drawn = block.rows.map((row) => row.every(({ text }) => text === "-"));
  const kept = (list) => list.filter((_, i) => !drawn[i]);
  return { ...block, rows: kept(block.rows), labels: kept(block.labels) };
}

// Add the headers to a block, from its first line or shortly above it. If the words before the rows
// name a, alpha, d and theta, each row is a column of the table.
function addHeaders(block, lines, allHeaders) {
  const { rows, labels, firstLine } = block;
  const names = labels.map((words) => findMarkedHeaders(listTexts(words), allHeaders)?.[0]);
  const named = names.flatMap((name, i) => (name ? [i] : []));
  if (new Set(named.map((i) => findEntry(names[i]))).size < 3) {
    const above = lines.slice(Math.max(0, firstLine - NEAR), firstLine + 1).reverse();
    const headers = findMarkedHeaders(above.join(" ").split(" "), allHeaders) ?? [];
    return [{ block, cells: rows.map(listTexts), headers }];
  }
  const cells = rows[0].map((_, k) => named.map((i) => rows[i][k].text));
  return [{ block, cells, headers: named.map((i) => names[i]), isTurned: true }];
}

const listTexts = (cells) => cells.map(({ text }) => text);
const NEAR = 3; // lines between headers and rows, such as a drawn line and an opening bracket

// Column headers

const HEADER_MARK = "·headers·"; // "·headers·2" replaces the line with the headers of index 2
const findMarkedHeaders = (words, allHeaders) => {
  const word = words.find((text) => text.startsWith(HEADER_MARK));
  return word ? allHeaders[Number(word.slice(HEADER_MARK.length))] : null;
};

/**
 * Replace each line of column headers, and each header before a line of entries, by a marked word.
 * An empty cell below headers becomes 0.
 * @param {SpannedText} plain
 * @returns {{ plain: SpannedText, headers: string[][] }}
 */
function markColumnHeaders(plain) {
  const allHeaders = [];
  const edits = [];
  const lines = [...plain.text.matchAll(LINE)].map(({ 0: text, index }) => ({ text, from: index }));
  const mark = ({ text, from }, headers, length) => {
    const [open] = /^[\s[({|]*/.exec(text);
    const word = `${open.replaceAll("|", " ")} ${HEADER_MARK}${allHeaders.push(headers) - 1} `;
    edits.push({ from, to: from + length, text: word });
  };
  const headerLines = lines.filter(({ text }) => listHeaders(text));
  const unitLines = [];
  for (const line of headerLines) {
    const headers = listHeaders(line.text);
    const below = lines.slice(lines.indexOf(line) + 1).find(({ text }) => /[\p{L}\d]/u.test(text));
    const units = below ? listUnits(below.text, headers.length) : null;
    const joined = units ? headers.map((header, k) => `${header} ${units[k]}`) : headers;
    mark(line, joined, line.text.length);
    if (units) mark(below, joined, below.text.length);
    if (units) unitLines.push(below);
  }
  for (const line of lines)
    if (!unitLines.includes(line) && !headerLines.includes(line))
      edits.push(...listZeros(line, headerLines));
  const rowHeaders = headerLines.length ? [] : lines.flatMap(listRowHeader);
  if (new Set(rowHeaders.map(({ header }) => findEntry(header))).size >= FEWEST_HEADERS)
    for (const { line, header, length } of rowHeaders) mark(line, [header], length);
  edits.sort((left, right) => left.from - right.from);
  return { plain: plain.edit(edits), headers: allHeaders };
}

const LINE = new RegExp(`[^\n${ROW_END}]+`, "g");
const trimOpening = (line) => line.replace(/^[\s[({|]+/, "");

// List the edits that write 0 into the empty cells of a line, and a short word for a row without a
// number. The line must have as many cells as a line of column headers.
function listZeros(line, headerLines) {
  if (!line.text.trim()) return [];
  for (const headerLine of headerLines) {
    const separator = ["\t", ";", ",", "|", "&"].find((mark) => headerLine.text.includes(mark));
    const [cells, headers] = [line, headerLine].map(({ text }) => text.split(separator));
    if (cells.length !== headers.length) continue;
    let next = line.from;
    return cells.flatMap((cell, k) => {
      const start = next;
      next += cell.length + 1;
      const header = headers[k].trim();
      const isEmpty = !cell.trim() && header !== "";
      // The last row may have a word in place of its number: "n (or z)".
      const isWord = findEntry(header) === "i" && /^\p{L}\D*$/u.test(cell.trim());
      const text = isEmpty ? "0" : "tool";
      return isEmpty || isWord ? [{ from: start, to: start + cell.length, text }] : [];
    });
  }
  return [];
}

const FEWEST_HEADERS = 3; // of the four, before the rows of a table that lies on its side
// A header before entries: "a [mm] | 0 | 88", "theta q1 q2".
const ROW_HEADER = new RegExp(
  String.raw`^([^|&\t;:=\d-]{1,24}?(?:\s?[[(][^\])]{1,8}[\])]|_\{?i ?- ?1\}?)?)` +
    String.raw`\s*(?:[|&\t;:,=]|\s(?=[-+]?[.\d]|(?:q|θ|th)[\w]*\d))`,
);

function listRowHeader(line) {
  const rest = trimOpening(line.text);
  const [start, header] = ROW_HEADER.exec(rest) ?? [];
  if (!header || !ENTRIES.includes(findEntry(header))) return [];
  return [{ line, header, length: line.text.length - rest.length + start.length }];
}

// The first separates the cells of a table that was copied from HTML.
const SEPARATORS = [/\| {2}\||[|&\t;]/, /\s{2,}/, /,/, /\s+/];

// List the headers of a line. Return null if it names fewer than three of a, alpha, d and theta.
function listHeaders(typed) {
  const [, comment] = COMMENT.exec(typed) ?? [];
  const [, behind = ""] = COMMENT_BEHIND.exec(typed) ?? [];
  const namesAll = (headers) => ENTRIES.every((entry) => headers?.map(findEntry).includes(entry));
  const all = splitHeaders(typed);
  const whole = [splitHeaders(behind), all].find(namesAll) ?? all;
  if (namesAll(whole) || !comment) return whole;
  const names = findColumnNames(comment) ?? [];
  return names.length === ENTRIES.length ? names : whole;
}

// Split a line at the first separator that gives headers.
function splitHeaders(typed) {
  const line = trimOpening(typed).replace(/^(?:%|\/\/)+\s*|[|\s\])}]+$/g, (margin) =>
    margin.replace(/[|\s%/]/g, ""),
  );
  const countsRows = (header) => findEntry(header) === "i";
  for (const separator of SEPARATORS) {
    const cells = line.split(separator);
    const headers = joinUnits(cells.map((header) => header.trim())).filter(
      (header, k, all) => !k || !countsRows(header) || !countsRows(all[k - 1]), // "Link, i"
    );
    const named = headers.map(findEntry).filter((word) => ENTRIES.includes(word));
    if (headers.some(isNumber)) continue;
    if (new Set(named).size >= 3 && headers.length <= named.length + 4) return headers;
  }
  return null;
}

const COMMENT = /^[^\p{N}]*(?:#|%|\/\/)(.*)/u;
const COMMENT_BEHIND = /^\W*\p{L}[^#%]*(?:#|%|\/\/)(.*)/u; // dh % theta d a alpha

// Join a unit to the header before it: the words "a" and "(mm)" become "a (mm)".
function joinUnits(cells) {
  const headers = [];
  for (const cell of cells)
    if (/^[([].*[)\]]$/.test(cell)) headers.push(`${headers.pop() ?? ""} ${cell}`);
    else headers.push(cell);
  return headers;
}

const UNIT_CELL = new RegExp(`^[[(]?(?:${LENGTH_UNIT}|deg|rad|°|-)?[\\])]?$`);

// List the units of a line below headers, such as "[rad] [cm] [cm] [rad]". Return null if the line
// has any other cell, or another count of cells than the headers.
function listUnits(line, count) {
  for (const separator of SEPARATORS) {
    const cells = trimOpening(`|${line.replace(/_\(([^()]*)\)/g, " $1")}`)
      .replace(/[|\s]+$/, "")
      .split(separator);
    const units = cells.map((cell) => cell.trim());
    const typed = units.filter((unit) => /\p{L}|°/u.test(unit));
    if (units.length !== count || !typed.length || !units.every((unit) => UNIT_CELL.test(unit)))
      continue;
    return units.map((unit) =>
      /\p{L}|°/u.test(unit) ? `(${unit.replace(/[^\p{L}°]/gu, "")})` : "",
    );
  }
  return null;
}

// Entries

const FRAMES = /^\d{1,2} ?- ?\d{1,2}$/; // 0-1 names the row between frames 0 and 1
const TWO_SIGNS = /^[-+−–]\s*[-+−–]\s*[^-+−–\s]/; // --90, which may be a dash of LaTeX
const FOOTNOTE = /^[-+−–]?\s*\d+\(\d\)$/; // 400(2), which may be a product
const ANGLE_UNIT = /^(?:deg|rad)$/; // without a number
// Names of rows, which are not symbols of an arm.
const ROW_NAME = /^(?:joint|link|row|frame)_?\d+$/i;
// A joint variable or a length, such as q1, l_{2} and h.
const SYMBOL = /^(?:[a-z]+_?\{?\d+\}?'?|[a-z]_\{?\w+\}?|[adlhrbeq])$/i;
// The kind of a joint, and the name of a row without a number.
const WORD = /^(?:p|revolute|prismatic|fixed|base|tool)$/i;
// Make a test of cells. A cell may stand in a table if it is a number, a formula of symbols, or a
// mark for the joint variable.
export function makeEntryTest(known) {
  const isSymbol = (name) => !ROW_NAME.test(name) && (SYMBOL.test(name) || known.has(simple(name)));
  return (cell) => {
    if ([FRAMES, FOOTNOTE, ANGLE_UNIT, TWO_SIGNS].some((pattern) => pattern.test(cell)))
      return false;
    const text = trimEntry(cell);
    if (isNumber(text) || VARIABLE.test(plain(text)) || WORD.test(text)) return true;
    return symbolsIn(text)?.every(isSymbol) ?? false;
  };
}
