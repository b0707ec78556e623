// Lists the lines and numbers of a pasted text that no step used.

import { linesOf } from "./characters.js";
import { hasDecimals } from "./formula.js";

/** @typedef {import("./block.js").Block} Block */
/** @typedef {import("./spans.js").SpannedText} SpannedText */

const textsOf = (cells) => cells.map(({ text }) => text);

/**
 * List the lines with text above and below a block, and the comments and unused numbers on the
 * lines of the block.
 * @param {string} text @param {Block} block
 * @param {SpannedText} [uncommented] the text without comments
 */
export function listUnusedLines(text, block, uncommented = null) {
  const { firstLine, lastLine } = block;
  const lines = linesOf(text);
  const rest = lines.filter((_, i) => i < firstLine || i > lastLine);
  const linesWithText = rest.filter((line) => /[\p{L}\d]/u.test(line.replace(ENVIRONMENT, "")));
  const isAligned = uncommented?.text.length === text.length;
  const uncommentedLines = isAligned ? linesOf(uncommented.text) : lines;
  const comments = lines
    .slice(firstLine, lastLine + 1)
    .map((line, i) => line.slice(uncommentedLines[firstLine + i].trimEnd().length).trim())
    .filter(Boolean);
  return [...linesWithText.map((line) => line.trim()), ...comments, ...listNumbersBeside(block)];
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
