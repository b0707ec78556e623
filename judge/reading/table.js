// Reads a Denavit-Hartenberg table from a text. People type rows in any order of columns, lists
// such as a = [0, 0.4], dictionaries, Link(...) calls or link matrices. If the text does not state
// a unit or the order of the columns, this module guesses it and reports the guess.

import { replaceFactorNames, withoutComments, withoutStruckText } from "./decorations.js";
import { linesOf } from "./characters.js";
import { simple, symbolsIn } from "./formula.js";
import { refuseUnreadValues } from "./other_values.js";
import { refuseUnread, refuseUnreadCell, tokensOf } from "./owners.js";
import { SpannedText } from "./spans.js";
import { listTableBlocks, makeEntryTest } from "./table_blocks.js";
import { joinCellLines } from "./table_cell_lines.js";
import { dropIndexColumn, EXCHANGED, listOrders } from "./table_columns.js";
import { convertTable, describeReading } from "./table_conversion.js";
import {
  claimDefinitions,
  listDefinedLengths,
  listDefinitions,
  listUsedDefinitions,
  refuseTwoLengths,
} from "./table_definitions.js";
import { NoLink, readLinkMatrix, splitMatrices } from "./table_matrices.js";
import { readNamedTable, refuseManyRows, refuseSize } from "./table_notations.js";
import { listNamedNumbers, placeBlockNumbers, placeMatrixNumbers } from "./table_owners.js";
import { readRow, trimEntry } from "./table_rows.js";
import { applyStatedOrder, chooseStatements, findOtherLengthUnit } from "./table_statements.js";
import { maskUnfinishedRows } from "./table_unfinished.js";
import { findUnreadCell, refuseMixedUnits } from "./table_unread.js";
import { findOtherUnit } from "./units.js";
import { ArmError, formatMessage, joinList, quoteText, tryOrNull } from "../sentences.js";

/** @typedef {import("../geometry/arm.js").TableRow} TableRow */

/**
 * A row of a table as it was typed.
 * @typedef {object} TypedRow
 * @property {string} kind "revolute", "prismatic", or "unknown" if the row has no joint variable
 * @property {Record<string, number>} numbers the entries, in the units that were typed
 * @property {{ a: number, d: number }} [symbolMetres] the parts of a and d that come from symbols,
 *   in m; missing for a link matrix
 * @property {Record<string, string>} texts the entries as they were typed
 * @property {boolean} backwards whether the joint variable has a minus
 * @property {{ name: string, number: number } | null} [joint] the joint variable, if its name has a
 *   number
 * @property {Set<string>} radians the entries with pi or with a unit of angles
 * @property {Set<string>} metres the entries with a unit of lengths; their numbers are in m
 * @property {Record<string, any>} [trees] the formulas of the entries; missing for a link matrix
 */

/**
 * A table in the units that were typed, with the stated units and the guesses.
 * @typedef {object} TypedTable
 * @property {TypedRow[]} rows
 * @property {string | null} lengths "m", "cm" or "mm"; null if the text states no unit of lengths
 * @property {string | null} angles "rad" or "deg"; null if the text states no unit of angles
 * @property {string | null} convention "craig" or "standard"; null if the text states none
 * @property {string[]} assumptions the guesses, as phrases
 * @property {boolean} [isExchanged] whether the headers of alpha and theta are exchanged: the joint
 *   variables stand below "alpha"
 * @property {boolean} [isOrderGuessed] whether the order of the columns is a guess
 * @property {string[]} [order] the entry in each column; missing for link matrices
 * @property {string[]} [typedCells] all cells of the rows, without notes and footnote marks
 * @property {import("./owners.js").Token[]} [tokens]
 * @property {string} [otherUnit] a unit of lengths other than mm that the text shows
 */

/**
 * @typedef {{ columns?: string, lengths?: string, angles?: string, convention?: string }} Options
 */
/**
 * @typedef {{ options: Options, known: Map<string, number> }} Request `known` has the values of
 *   symbols
 */

/**
 * List the possible readings of a table, the likeliest first. There is more than one reading only
 * if the order of the columns is a guess.
 * @param {string} pastedText
 * @param {Options} options the student's settings beside the text
 * @param {[string, number][]} values of the table's symbols
 * @returns {TypedTable[]}
 */
export function readTables(pastedText, options = {}, values = []) {
  refuseSize(pastedText);
  refuseOtherUnit(pastedText);
  const typedText = maskUnfinishedRows(pastedText);
  const known = new Map(values.map(([name, x]) => [simple(name), x]));
  const definitions = listDefinitions(withoutStruckText(new SpannedText(typedText)), known);
  const lengths = listDefinedLengths(definitions, new Set(values.map(([name]) => simple(name))));
  const defined = new Map(lengths.map(([name, x]) => [simple(name), x]));
  const request = { options, known: new Map([...known, ...defined]) };
  const tables = readWithLengths(typedText, request);
  return applyStatedOrder(tables, typedText).map((table) =>
    useDefinitions(table, definitions, typedText),
  );
}

// Apply the lengths that a text defines, such as d_1 = 0.5.
/**
 * @param {TypedTable} table @param {import("./table_definitions.js").Definition[]} definitions
 */
function useDefinitions(table, definitions, text) {
  const { tokens, typedCells } = table;
  refuseTwoTables(table, text);
  refuseMixedUnits(table, text);
  const used = listUsedDefinitions(definitions, typedCells, tokens);
  refuseTwoLengths(used, tokens, text);
  if (table.order) refuseUnreadValues(text, table, definitions); // a link matrix has its c1 and s1
  return {
    ...table,
    otherUnit: findOtherLengthUnit(tokens, text),
    tokens: claimDefinitions(used, tokens),
  };
}

/** @param {string} typedText @param {Request} request @returns {TypedTable[]} */
function readWithLengths(typedText, request) {
  const { known } = request;
  const text = joinCellLines(typedText, makeEntryTest(known));
  const pasted = replaceFactorNames(withoutStruckText(new SpannedText(text)));
  const uncommented = withoutComments(pasted);
  for (const plainText of [uncommented, pasted]) {
    const named = plainText && readNamedTable(plainText.text);
    if (!named) continue;
    const tokens = listNamedNumbers(plainText, text, named);
    const { unread } = named;
    if (unread) {
      const span = plainText.span(unread.from, unread.to);
      refuseUnreadCell(text, tokens, span, formatMessage("your table"));
    }
    return readCells(named, request).map((table) => ({ ...table, tokens }));
  }
  const readWithout = (spannedText) =>
    readFirstBlock(text, listTableBlocks(text, known, spannedText), request);
  return (uncommented && tryOrNull(() => readWithout(uncommented))) ?? readWithout(pasted);
}

function refuseOtherUnit(text) {
  const unit = findOtherUnit(text);
  if (unit)
    throw new ArmError(formatMessage("other unit", { what: formatMessage("your table"), unit }));
}

/**
 * Read the first block that is a table.
 * @param {string} text @param {import("./table_blocks.js").TableBlock[]} blocks
 * @param {Request} request @returns {TypedTable[]}
 */
function readFirstBlock(text, blocks, request) {
  let firstError = null;
  let unreadRows = 0; // of the first block beside which a number is unread
  for (const block of blocks) {
    if (block.cells.length < unreadRows) break; // it may be a part of that table
    let tokens = [];
    try {
      tokens = requireReadable(block, text, request);
      const assumptions = hasEmptyCells(block) ? [formatMessage("taken: empty")] : [];
      return readCells({ ...block, assumptions }, request).map((table) => ({
        ...table,
        tokens: table.order
          ? placeBlockNumbers(tokens, block, table, text)
          : placeMatrixNumbers(tokens, text),
      }));
    } catch (error) {
      if (!(error instanceof ArmError)) throw error;
      if (error instanceof NoLink) {
        error.tokens = placeMatrixNumbers(tokens, text);
        throw error;
      }
      firstError ??= error;
      if (error.tokens) unreadRows ||= block.cells.length;
    }
  }
  throw firstError ?? new ArmError(formatMessage("no rows", { given: quoteText(text) }));
}

// Return whether a row has an empty cell. An empty cell counts as 0.
/** @param {import("./table_blocks.js").TableBlock} table */
const hasEmptyCells = ({ block: { sources } }) =>
  sources.some(({ cells }) => cells.some(({ from, to }) => from === to));

// Return the numbers of a block with their owners. Refuse unread cells.
/**
 * @param {import("./table_blocks.js").TableBlock} table
 * @param {string} text @param {Request} request
 */
function requireReadable(table, text, { known }) {
  const tokens = tokensOf(text, table.block);
  const what = formatMessage("your table");
  const unread = findUnreadCell(table, text, makeEntryTest(known));
  if (unread?.cell) refuseUnreadCell(text, tokens, unread.cell, what);
  if (unread) throw makeTornError(table, findOddLine(table, unread.line), tokens, text);
  refuseUnread(text, tokens, what);
  return tokens;
}

// Make an error that lists the entries of an odd line, and tells how many a row has.
/** @param {import("./table_blocks.js").TableBlock} table */
function makeTornError({ block: { lines, rows } }, odd, tokens, text) {
  const entries = lines.all.filter(({ line }) => line === odd).flatMap(({ cells }) => cells);
  const fields = {
    line: quoteText(linesOf(text)[odd].trim()),
    count: entries.length,
    entries: joinList(entries.map((cell) => quoteText(text.slice(cell.from, cell.to)))),
    width: rows[0].length,
  };
  return new ArmError(formatMessage("row torn", fields), [], tokens, text);
}

// Return the line whose row has an odd number of cells: 0 for the first line of the text. If most
// rows are as long as the unread line, the block's first row is the odd row.
/** @param {import("./table_blocks.js").TableBlock} table @param {number} unreadLine from 0 */
function findOddLine({ block: { lines, firstLine, rows } }, unreadLine) {
  const length = lines.all.find(({ line }) => line === unreadLine)?.cells.length ?? 0;
  const alike = lines.all.filter(({ cells }) => cells.length === length);
  return alike.length > rows.length ? firstLine : unreadLine;
}

// Refuse a text with two tables. Its second half repeats the joint numbers of its first half.
/** @param {TypedTable} table @param {string} text as it was pasted */
function refuseTwoTables({ rows, tokens }, text) {
  const half = rows.length / 2;
  const numbers = rows.map(({ joint }) => joint?.number);
  const isAgain = (number, k) => number !== undefined && number === numbers[half + k];
  if (half > 1 && numbers.slice(0, half).every(isAgain))
    throw new ArmError(formatMessage("two tables"), [], tokens, text);
}

/**
 * Read cells below their headers in each possible order of columns.
 * @param {{ cells: string[][], headers: string[], assumptions: string[], context: string,
 *   convention?: string }} block
 * @param {Request} request @returns {TypedTable[]}
 */
function readCells(block, { options, known }) {
  const trimmed = block.cells.map((row) => row.map(trimEntry));
  const typedCells = trimmed.flat();
  const matrices = splitMatrices(trimmed);
  if (matrices) {
    const hasLengths = typedCells.some((cell) =>
      symbolsIn(cell)?.some((name) => known.has(simple(name))),
    );
    const context = hasLengths ? "" : block.context; // a symbol has its value in m
    const table = readMatrices(matrices, known, options, context);
    return [{ ...table, typedCells }];
  }
  const { cells, headers } = dropIndexColumn({ cells: trimmed, headers: block.headers });
  refuseManyRows(cells.length);
  const orders = listOrders(cells, headers, options.columns);
  const statements = chooseStatements({ ...block, headers }, options);
  return readOrders(orders, known).map((table) => ({
    ...statements,
    ...table,
    order: orders.typedOrder ?? table.order,
    typedCells,
    assumptions: [...block.assumptions, ...table.assumptions],
  }));
}

function readMatrices(matrices, known, options, context) {
  refuseManyRows(matrices.length);
  const rows = matrices.map((matrix, k) => readLinkMatrix(k + 1, matrix, known));
  const statements = chooseStatements({ headers: [], context: "" }, options);
  const { lengths } = chooseStatements({ headers: [], context }, options);
  return { ...statements, lengths, rows, assumptions: [formatMessage("taken: matrices")] };
}

// Read rows in each possible order of columns. If the stated order fails, try exchanged headers of
// alpha and theta, where the joint variables stand below "alpha".
function readOrders({ orders, isStated, rows }, known) {
  const attempts = orders.map((order) => readOrder(rows, order, known, isStated));
  const tables = attempts.filter((attempt) => attempt.rows);
  if (tables.length) return tables;
  const exchangedOrder = orders[0].map((name) => EXCHANGED[name] ?? name);
  const table = readOrder(rows, exchangedOrder, known, isStated);
  if (!isStated || !table.rows) throw attempts[0].error;
  return [{ ...table, isExchanged: true }];
}

// Read rows in a given order of columns. Return the error if the rows do not fit.
function readOrder(cells, order, known, isStated) {
  try {
    const rows = cells.map((row, k) => {
      const entries = Object.fromEntries(order.map((name, i) => [name, row[i]]));
      return readRow(k + 1, entries, known);
    });
    const columns = formatMessage("taken: columns", { columns: order.join(" ") });
    return { rows, assumptions: isStated ? [] : [columns], order, isOrderGuessed: !isStated };
  } catch (error) {
    if (error instanceof ArmError) return { error };
    throw error;
  }
}

/**
 * Read the table that a reader types for an arm of her own. The page asks for the columns in the
 * order a, alpha, d, theta, so a table without headers is read in this order if possible.
 * @param {string} text
 * @param {[string, number][]} values of its symbols
 * @returns {{ rows: TableRow[], reading: string }} standard rows in m and rad, and how the text was
 *   read
 */
export function readOwnTable(text, values = []) {
  const tables = readTables(text, {}, values);
  const table = tables.find(isInFieldOrder) ?? tables[0];
  if (table.isOrderGuessed && !isInFieldOrder(table))
    throw new ArmError(formatMessage("order of columns", { taken: table.assumptions[0] }));
  const converted = convertTable(table, []);
  return { rows: converted.rows, reading: describeReading(table, converted) };
}

/**
 * Return whether a table was read in the order in which the page shows the columns.
 * @param {TypedTable} table
 */
export const isInFieldOrder = ({ assumptions }) =>
  assumptions.includes(formatMessage("taken: columns", { columns: "a alpha d theta" }));
