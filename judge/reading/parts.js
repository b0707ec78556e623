// A text of several things with names, q = ..., tau = ... and det(J) = ..., one below another.

import { PROMPT } from "./surroundings.js";
import { lines } from "./text.js";

// The name that a line begins with, behind a prompt or LaTeX's signs; |J| and det(J) are names too.
const NAMED = new RegExp(
  String.raw`^\s*${PROMPT}?(?:\\\[|[\s$])*` +
    String.raw`(\|?\\?\p{L}[\p{L}\p{N}_{}]*)\s*\|?\s*(?:\([^()]*\))?\^?[T']?\s*:?=(?!=)`,
  "u",
);

/**
 * The parts, each from its name on; the first has none where something stands above.
 * @param {string} text
 * @returns {{ name?: string, lines: string[] }[]}
 */
export function partsOf(text) {
  const parts = [];
  for (const line of lines(text)) {
    const name = NAMED.exec(line)?.[1];
    if (name !== undefined || !parts.length) parts.push({ name, lines: [] });
    parts.at(-1).lines.push(line);
  }
  return parts;
}

/**
 * A text without the parts that have another name than what is asked for, and their lines; the
 * whole where nothing else is there.
 * @param {string} text @param {RegExp} asked
 * @param {(line: string) => boolean} isAside
 */
export function withoutOthers(text, asked, isAside) {
  const parts = partsOf(text);
  const isOther = ({ name = undefined }) => name !== undefined && !asked.test(name);
  const kept = parts.filter((part) => !isOther(part));
  const holds = ({ name, lines: all }) =>
    name !== undefined || all.some((line) => /\d/.test(line) && !isAside(line));
  if (kept.length === parts.length || !kept.some(holds)) return { text, others: [] };
  const linesOf = (some) => some.flatMap((part) => part.lines);
  return { text: linesOf(kept).join("\n"), others: linesOf(parts.filter(isOther)) };
}
