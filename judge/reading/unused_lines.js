// Lists the lines and numbers of a pasted text that no step used.

import { linesOf } from "./characters.js";
import { hasDecimals } from "./formula.js";
import { UNIT } from "./units.js";

/** @typedef {import("./block.js").Block} Block */
/** @typedef {import("./spans.js").SpannedText} SpannedText */

const textsOf = (cells) => cells.map(({ text }) => text);

const UNIT_WORD = new RegExp(String.raw`(?<![\p{L}\d_\\])(?:${UNIT}|kg)(?![\p{L}\d_])`, "u");
const NUMBER = /(?<![\p{L}\d_])\.?\d/u; // no part of a name such as q1
const FACTOR = /^1\.0e[+-]\d+ ?\*$/; // that MATLAB prints above a matrix, and that is applied

/** Return whether a line has a number or a unit, so that it may matter that it was not used. */
export const hasNumberOrUnit = (line) =>
  !FACTOR.test(line.trim()) && (NUMBER.test(line) || UNIT_WORD.test(line));

/**
 * List the lines with a number or a unit above and below a block, such comments on the lines of the
 * block, and its unused numbers.
 * @param {string} text @param {Block} block
 * @param {SpannedText} [uncommented] the text without comments
 */
export function listUnusedLines(text, block, uncommented = null) {
  const { firstLine, lastLine } = block;
  const lines = linesOf(text);
  const rest = lines.filter((_, i) => i < firstLine || i > lastLine);
  const linesWithNumbers = rest.filter((line) => hasNumberOrUnit(line.replace(ENVIRONMENT, "")));
  const isAligned = uncommented?.text.length === text.length;
  const uncommentedLines = isAligned ? linesOf(uncommented.text) : lines;
  const comments = lines
    .slice(firstLine, lastLine + 1)
    .map((line, i) => line.slice(uncommentedLines[firstLine + i].trimEnd().length).trim())
    .filter(hasNumberOrUnit);
  return [...linesWithNumbers.map((line) => line.trim()), ...comments, ...listNumbersBeside(block)];
}

const ENVIRONMENT = /\\(?:begin|end)\{\w+\*?\}/g; // of LaTeX

/**
 * List the numbers on a block's lines that do not belong to the block, including decimals in words.
 * If each row has such a number alone, it is a label such as a time, and is left out.
 * @param {Block} block
 */
function listNumbersBeside({ firstLine, lastLine, sources, lines }) {
  const rowsOfBlock = new Set(sources);
  const others = lines.all.filter(
    (row) => row.line >= firstLine && row.line <= lastLine && !rowsOfBlock.has(row),
  );
  const words = sources.flatMap((row) => row.words.filter(({ text }) => hasDecimals(text)));
  const lists = [others.map(({ cells }) => textsOf(cells)), words.map(({ text }) => [text])];
  return lists.filter((list) => !areLabels(list, sources.length)).flat(2);
}

// Return whether each of several rows has the same count of single numbers beside it.
const areLabels = (numbers, rowCount) =>
  rowCount > 1 && numbers.length % rowCount === 0 && numbers.every(({ length }) => length === 1);
