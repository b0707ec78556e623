// Joins the parts of a wide pandas frame. On a narrow screen pandas prints the columns in parts,
// one below the other. Each part but the last ends its line of column headers with a \.

import { listLines } from "./spans.js";

/** @typedef {import("./spans.js").Span} Span */

/**
 * Put the parts of each frame side by side.
 * @param {import("./spans.js").SpannedText} pasted
 */
export function joinFrameParts(pasted) {
  if (!WRAPPED.test(pasted.text)) return pasted;
  const lines = listLines(pasted.text);
  const pieces = [];
  for (let k = 0; k < lines.length;) {
    const frame = WRAPPED.test(lines[k].text) ? findFrame(lines, k) : null;
    const rows = frame ? frame.rows : [[lines[k]]];
    for (const row of rows) pieces.push(...row.flatMap((span) => [span, " "]).slice(0, -1), "\n");
    k = frame ? frame.next : k + 1;
  }
  return pasted.assemble(pieces);
}

const WRAPPED = /\S[ \t]+\\[ \t]*$/m;
const LEAST_GAP = 2; // blanks between two columns

/** @typedef {Span & { text: string }} Line */

/**
 * Find the frame that begins at a line.
 * @param {Line[]} lines @param {number} start
 * @returns {{ rows: Span[][], next: number } | null} the spans of each row, and the index of the
 *   first line below the frame; null if the parts have different rows
 */
function findFrame(lines, start) {
  const { parts, end } = listParts(lines, start);
  const [first, ...others] = parts;
  const haveSameRows = first.length > 1 && others.every((part) => part.length >= first.length);
  const width = haveSameRows ? findIndexWidth(parts) : null;
  if (width === null) return null;
  const rows = first.map((line, row) => [
    line,
    ...others.map((part) => cutIndex(part[row], width)),
  ]);
  // The last part may include the text below the frame if no blank line stands between them.
  return { rows, next: end - (others.at(-1).length - first.length) };
}

// List the parts from a line on. A part ends at a blank line, and the last has no \.
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
  } while (WRAPPED.test(parts.at(-1)[0]?.text ?? ""));
  return { parts, end };
}

// Find the width of the index, which is the first column of each part. Return null if the parts
// have different first columns.
function findIndexWidth(parts) {
  const [first, ...others] = parts;
  const body = first.slice(1).map(({ text }) => text);
  const shortest = Math.min(...body.map((text) => text.length));
  const isIndex = (text, width) =>
    text.slice(0, width).trim() && !text.slice(width, width + LEAST_GAP).trim();
  for (let width = 1; width + LEAST_GAP <= shortest; width++) {
    if (!body.every((text) => isIndex(text, width))) continue;
    const repeatsIndex = (part) =>
      body.every((text, k) => part[k + 1].text.startsWith(text.slice(0, width)));
    return others.every(repeatsIndex) ? width : null;
  }
  return null;
}

/** @param {Span} line @param {number} width @returns {Span} */
const cutIndex = ({ from, to }, width) => ({ from: Math.min(from + width, to), to });
