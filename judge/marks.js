// Makes the marks on a pasted text. A mark has a number's position, its owner, whether it is wrong,
// and a description. The page and Python (helpers/checks/marked_text.py) show the same marks.

import { jointNumbers } from "./geometry/kinematics.js";
import { IN_DEFINITION } from "./reading/table_definitions.js";
import { IN_NAME } from "./reading/table_owners.js";

/** @typedef {import("./geometry/arm.js").Arm} Arm */
/** @typedef {import("./reading/owners.js").Token} Token */
/** @typedef {import("./reading/spans.js").Span} Span */
/** @typedef {import("./verdict.js").ReadTable} ReadTable */
/** @typedef {import("./verdict.js").Verdict} Verdict */
/**
 * A question whose answer is a text. `ask` is its topic; `first` is "v" or "omega", the half of a
 * Jacobian that comes first.
 * @typedef {{ answer: string, ask: string, first: string }} TextQuestion
 */
/**
 * The result of a question. It has no verdict if a number was not read.
 * @typedef {{ verdict?: Verdict, arm?: Arm, tokens?: Token[] }} TextOutcome
 */
/**
 * A mark on a number of the text.
 * @typedef {object} Mark
 * @property {number} from index of its first character
 * @property {number} to index after its last character
 * @property {string} kind "entry", "label", "given", "context" or "unread"
 * @property {boolean} isWrong
 * @property {string} description what the number was taken for
 */
/**
 * An answer as a matrix with headers. `wrong` has for each value whether it is wrong.
 * @typedef {{ columns: string[], rows: string[], shape: number[], wrong: boolean[],
 *   typed: import("./reading/numbers.js").Typed }} Matrix
 */

/** The name of each kind of mark, in the order of a legend. */
export const MARK_NAMES = {
  entry: "entry",
  wrong: "wrong entry",
  label: "label",
  given: "given by the question",
  context: "set aside",
  unread: "not read: nothing is graded",
};
const MAX_LENGTH = 20_000; // characters; a longer text is not marked
const ROW_NAMES = {
  v: ["vx", "vy", "vz", "ωx", "ωy", "ωz"],
  omega: ["ωx", "ωy", "ωz", "vx", "vy", "vz"],
};
const TABLE_COLUMNS = ["a", "α", "d", "θ"];
const SIGN_CHARACTERS = "+-−–";

/**
 * Mark each number of an answer with its owner.
 * @param {TextQuestion} question
 * @param {TextOutcome} outcome
 * @returns {Mark[]}
 */
export function listMarks(question, outcome) {
  const text = question.answer;
  if (text.length > MAX_LENGTH) return [];
  const matrix = getMatrix(question, outcome);
  return joinHalves(text, outcome.tokens ?? []).map((token) => {
    const isUnread = token.owner === "unread";
    const kind = token.owner === "header" ? "label" : token.owner;
    const index = kind === "entry" && matrix ? (token.index ?? -1) : -1;
    const table = kind === "entry" ? outcome.verdict?.table : undefined;
    const description = table?.wrong.length
      ? describeTableEntry(token, table)
      : describeToken(token, question, matrix, index);
    return {
      ...(isUnread ? includeWord(text, token) : includeSign(text, token)),
      kind,
      isWrong: Boolean(matrix?.wrong[index] || isWrongEntry(table, token)),
      description,
    };
  });
}

/**
 * Join the two numbers before and behind a decimal comma, which are one entry.
 * @param {string} text @param {Token[]} tokens @returns {Token[]}
 */
function joinHalves(text, tokens) {
  /** @type {Token[]} */
  const joined = [];
  for (const token of tokens) {
    const before = joined.at(-1);
    const isHalf =
      before && text.slice(before.to, token.from) === "," && isSameEntry(before, token);
    if (isHalf) joined[joined.length - 1] = { ...before, to: token.to };
    else joined.push(token);
  }
  return joined;
}

/** @param {Token} token @param {Token} other */
const isSameEntry = (token, other) =>
  token.owner === "entry" &&
  other.owner === "entry" &&
  token.row === other.row &&
  token.column === other.column &&
  `${token.matrix}` === `${other.matrix}`;

/** Return the kind under which a mark is shown. @param {Mark} mark @returns {string} */
export const getShownKind = ({ kind, isWrong }) => (isWrong ? "wrong" : kind);

/**
 * Cut a text into pieces at its marks. A mark that begins within the mark before it is left out.
 * @param {string} text
 * @param {Mark[]} marks
 * @returns {{ text: string, index?: number }[]} `index` is that of the piece's mark
 */
export function splitAtMarks(text, marks) {
  const pieces = [];
  let end = 0;
  marks.forEach(({ from, to }, index) => {
    if (from < end) return;
    pieces.push({ text: text.slice(end, from) }, { text: text.slice(from, to), index });
    end = to;
  });
  return [...pieces, { text: text.slice(end) }].filter((piece) => piece.text);
}

/** @param {ReadTable | undefined} table @param {Token} token */
const isWrongEntry = (table, { row = -1, column = -1 }) => table?.wrong[row]?.[column];

/** @param {Token} token @param {ReadTable} table */
function describeTableEntry(token, { cells, wrong }) {
  const { row = 0, column, matrix } = token;
  const position = matrix ? describeMatrixEntry(token) : `entry of row ${row + 1}`;
  if (column === undefined) return position;
  const value = cells[row][column].replaceAll("-", "−");
  const unit = column % 2 ? "" : " m";
  const reading = matrix ? `gives ${TABLE_COLUMNS[column]} =` : `${TABLE_COLUMNS[column]}, read as`;
  return `${position}, ${reading} ${value}${unit}${wrong[row][column] ? ", wrong" : ""}`;
}

/** @param {Token} token of a link matrix */
const describeMatrixEntry = ({ row = 0, matrix: [i, k] = [0, 0] }) =>
  `entry of A_${row + 1}, row ${i + 1}, column ${k + 1}`;

/** @param {Token} token @param {TextQuestion} question @param {Matrix | null} matrix */
function describeToken(token, question, matrix, index) {
  switch (token.owner) {
    case "entry":
      if (token.matrix) return describeMatrixEntry(token);
      return describeEntry(token, question, matrix, index);
    case "label":
      if (token.reason === IN_NAME) return "part of a name, such as q_1";
      if (token.reason === IN_DEFINITION) return "value of a symbol in the table";
      return token.reason ? `set aside: ${token.reason}` : "a label: it orders the answer";
    case "header":
      return "part of a column's header";
    case "given":
      return "given by the question";
    case "unread":
      return "not read: nothing is graded";
    default:
      return token.reason ? `set aside: ${token.reason}` : "set aside";
  }
}

/** @param {Token} token @param {TextQuestion} question @param {Matrix | null} matrix */
function describeEntry({ row = 0, column = 0 }, { ask }, matrix, index) {
  if (!matrix || index < 0) return `entry in row ${row + 1}, column ${column + 1}`;
  const [height, width] = matrix.shape;
  const [i, k] = [Math.floor(index / width), index % width];
  const position = height === 1 ? matrix.columns[k] : `${matrix.rows[i]}, ${matrix.columns[k]}`;
  const value = `read as ${formatEntryValue(matrix.typed, index).replace("-", "−")}`;
  const isColumn = (ask === "torques" || ask === "pose") && height > 1 && width === 1;
  const name = isColumn ? matrix.rows[i] : position;
  return `entry of ${name}, ${value}${matrix.wrong[index] ? ", wrong" : ""}`;
}

/**
 * Return the headers of an answer's columns and rows.
 * @param {{ ask: string, first: string }} question
 * @param {Arm} arm
 * @param {number[]} shape
 */
export function getHeaders({ ask, first }, arm, [rows, width]) {
  const numbers = jointNumbers(arm);
  const nameColumn = (k) => (numbers.length === width ? `joint ${numbers[k]}` : String(k + 1));
  const rowNames =
    { torques: rows === 1 ? ["τ"] : [], jacobian: rows === 6 ? ROW_NAMES[first] : [] }[ask] ?? [];
  return {
    columns: Array.from({ length: width }, (_, k) => nameColumn(k)),
    rows: Array.from({ length: rows }, (_, i) => rowNames[i] ?? `row ${i + 1}`),
  };
}

/**
 * Return the answer as rows of cells, or null if it is not a matrix.
 * @param {{ ask: string, first: string }} question
 * @param {TextOutcome} outcome
 * @returns {Matrix | null}
 */
export function getMatrix(question, { verdict, arm }) {
  const typed = verdict?.typed;
  if (!arm || !typed || typed.shape.length !== 2) return null;
  const isColumn = question.ask === "torques" && typed.shape[1] === 1;
  const [rows, width] = isColumn ? [1, typed.values.length] : typed.shape;
  const wrong = verdict.wrong?.length === typed.values.length ? verdict.wrong : [];
  const headers = getHeaders(question, arm, [rows, width]);
  if (rows < 6 && verdict.rowNames)
    headers.rows = verdict.rowNames.map((name) => name.replace("w", "ω"));
  return { ...headers, typed, wrong, shape: [rows, width] };
}

/**
 * Format a typed value with its typed decimals, six at most.
 * @param {import("./reading/numbers.js").Typed} typed @param {number} i
 */
export function formatEntryValue({ values, units }, i) {
  const decimals = Math.min(6, units[i] ? Math.max(0, Math.round(-Math.log10(units[i]))) : 4);
  return (Number(values[i].toFixed(decimals)) + 0).toFixed(decimals);
}

/**
 * Extend a number's span by its sign.
 * @param {string} text
 * @param {Span} token its digits
 */
export function includeSign(text, { from, to }) {
  const isSigned =
    SIGN_CHARACTERS.includes(text[from - 1] ?? " ") && !/[\w)\]]/.test(text[from - 2] ?? " ");
  return { from: isSigned ? from - 1 : from, to };
}

/**
 * Extend a number's span to its whole word, which ends at blanks and separators of cells.
 * @param {string} text
 * @param {Span} token
 */
export function includeWord(text, { from, to }) {
  const before = /[^\s|&;[\],(){}]*$/.exec(text.slice(0, from))?.[0].length ?? 0;
  const after = /^[^\s|&;[\],(){}]*/.exec(text.slice(to))?.[0].length ?? 0;
  return { from: from - before, to: to + after };
}
