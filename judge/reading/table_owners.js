// Records for each number of a text whether it is an entry of the table, and of which row and
// column. Other numbers become labels or context.

import { Tokens } from "./owners.js";
import { EXCHANGED, nameTableColumns } from "./table_columns.js";
import { findReadEntry } from "./table_matrices.js";
import { ENTRIES } from "./table_rows.js";

/** @typedef {import("./owners.js").Token} Token */

export const IN_NAME = "part of a name";

// The characters before a number that is part of a name: q1, q_1, q_{1}, q[1] and q(1).
const NAME_BEFORE = /(?:[\p{L}_]\{?|(?<!\p{L})(?:q|θ|theta)[[(])$/u;

// Make a number a label if it is part of a name.
function labelName(token, text) {
  const before = text.slice(Math.max(0, token.from - 7), token.from);
  return NAME_BEFORE.test(before) ? setOwner(token, "label", IN_NAME) : token;
}

// Give a number an owner, and take its row and column from it.
const setOwner = ({ text, from, to, line }, owner, reason = undefined) => ({
  text,
  from,
  to,
  line,
  owner,
  reason,
});

/**
 * Give the numbers of a block their rows and columns in the table. The number of a row becomes a
 * label, and a number in a column of unknown name becomes context.
 * @param {Token[]} tokens with their rows and columns in the block
 * @param {import("./table_blocks.js").TableBlock} block
 * @param {import("./table.js").TypedTable} table that was read from the block
 * @param {string} text
 * @returns {Token[]}
 */
export function placeBlockNumbers(tokens, { cells, headers, isTurned = false }, table, text) {
  const columns = listColumns(headers, table.order);
  const exchange = (name) => (table.isExchanged ? (EXCHANGED[name] ?? name) : name);
  return tokens.map((token) => {
    if (token.owner !== "entry") return token;
    const [row, at] = isTurned ? [token.column, token.row] : [token.row, token.column];
    // A row of four cells holds the four entries, even if there are more headers.
    const isBare = cells[row].length === table.order.length;
    const names = (isBare ? table.order : columns).map(exchange);
    const k = at - (cells[row].length - names.length);
    const column = ENTRIES.indexOf(names[k] === "offset" ? getJointEntry(table, row) : names[k]);
    if (column >= 0) return labelName({ ...token, row, column }, text);
    const isOther = k in headers && names[k] === undefined;
    return isOther
      ? setOwner(token, "context", `column ${headers[k].trim()}`)
      : setOwner(token, "label");
  });
}

// List the names of all columns. If the headers do not give the order that was read, use the order.
function listColumns(headers, order) {
  const names = nameTableColumns(headers);
  const entries = names?.filter((name) => ENTRIES.includes(name));
  return entries?.join() === order.join() ? names : order;
}

const getJointEntry = ({ rows }, row) => (rows[row].kind === "prismatic" ? "d" : "theta");

/**
 * Give the numbers of link matrices A_1 ... A_n, one below the other, their rows in the table.
 * `matrix` is the position within A_i, from 0. `column` is the entry that this position gives.
 * @param {Token[]} tokens @param {string} text
 * @returns {Token[]}
 */
export const placeMatrixNumbers = (tokens, text) =>
  tokens.map((token) => {
    if (token.owner !== "entry") return token;
    const [row, matrix] = [Math.floor(token.row / 4), [token.row % 4, token.column]];
    const column = ENTRIES.indexOf(findReadEntry(matrix));
    return labelName({ ...token, row, matrix, column: column < 0 ? undefined : column }, text);
  });

/**
 * List the numbers of a table whose entries have names, with their owners.
 * @param {import("./spans.js").SpannedText} pasted the text that was read
 * @param {string} text as it was pasted
 * @param {import("./table_notations.js").NamedTable} table
 * @returns {Token[]}
 */
export function listNamedNumbers(pasted, text, { sources, parts }) {
  const tokens = new Tokens(text);
  for (const { from, to, row, column } of sources)
    tokens.claim(pasted.span(from, to), "entry", { row, column });
  for (const { from, to } of parts)
    tokens.claim(pasted.span(from, to), "label", { reason: "not an entry of the table" });
  for (const token of tokens.list)
    if (!token.owner) Object.assign(token, { owner: "context", reason: "outside the table" });
  return tokens.list.map((token) => (token.owner === "context" ? token : labelName(token, text)));
}
