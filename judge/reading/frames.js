// Puts frames side by side again that pandas printed in parts, one below the other, because the
// screen was too narrow. Each part but the last has a \ at the end of its column headers.

import { listLines } from "./spans.js";

/** @typedef {import("./spans.js").Span} Span */

/**
 * Put the parts of printed frames side by side.
 * @param {import("./spans.js").SpannedText} pasted
 */
export function unwrapFrames(pasted) {
  if (!WRAPPED.test(pasted.text)) return pasted;
  const lines = listLines(pasted.text);
  const parts = [];
  for (let k = 0; k < lines.length;) {
    const frame = WRAPPED.test(lines[k].text) ? findFrame(lines, k) : null;
    const rows = frame ? frame.rows : [[lines[k]]];
    for (const row of rows) parts.push(...row.flatMap((piece) => [piece, " "]).slice(0, -1), "\n");
    k = frame ? frame.next : k + 1;
  }
  return pasted.assemble(parts);
}

const WRAPPED = /\S[ \t]+\\[ \t]*$/m;
const LEAST_GAP = 2; // blanks between two columns

/** @typedef {Span & { text: string }} Line */

/**
 * Return the rows of the frame whose first part begins at a line, each as its pieces, and the
 * first line behind it; nothing if the parts do not haveSameRows together.
 * @param {Line[]} lines @param {number} start
 */
function findFrame(lines, start) {
  const { parts, end } = listParts(lines, start);
  const [first, ...others] = parts;
  const haveSameRows = first.length > 1 && others.every((part) => part.length >= first.length);
  const width = others.length && haveSameRows ? findIndexWidth(parts) : null;
  if (width === null) return null;
  const rows = first.map((line, row) => [
    cutBackslash(line),
    ...others.map((part) => cutIndex(cutBackslash(part[row]), width)),
  ]);
  // Other text may follow the last part without a blank line between them.
  return { rows, next: end - (others.at(-1).length - first.length) };
}

// List the parts from a line on, each up to a blank line, until one has no \ behind its headers.
function listParts(lines, start) {
  const isBlank = (k) => lines[k] !== undefined && !lines[k].text.trim();
  const parts = [];
  let end = start;
  do {
    let next = end;
    while (isBlank(next)) next++;
    end = next;
    while (end < lines.length && !isBlank(end)) end++;
    parts.push(lines.slice(next, end));
  } while (end < lines.length && WRAPPED.test(parts.at(-1)[0]?.text ?? ""));
  return { parts: parts.filter(({ length }) => length), end };
}

// Find the width of the index, which is the same in all parts with a gap behind it; null if none.
function findIndexWidth(parts) {
  const [first, ...others] = parts;
  const body = first.slice(1).map(({ text }) => text);
  const longest = Math.min(...body.map((text) => text.length));
  const isIndex = (text, width) =>
    text.slice(0, width).trim() && !text.slice(width, width + LEAST_GAP).trim();
  for (let width = 1; width + LEAST_GAP <= longest; width++) {
    if (!body.every((text) => isIndex(text, width))) continue;
    const isSame = (part) =>
      body.every((text, k) => part[k + 1].text.startsWith(text.slice(0, width)));
    return others.every(isSame) ? width : null;
  }
  return null;
}

/** @param {Line} line @returns {Span} */
function cutBackslash({ from, text }) {
  return { from, to: from + text.replace(/[ \t]*\\[ \t]*$/, "").length };
}

/** @param {Span} line @param {number} width @returns {Span} */
const cutIndex = ({ from, to }, width) => ({ from: Math.min(from + width, to), to });
