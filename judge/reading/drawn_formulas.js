// Writes fractions and roots that SymPy drew over several lines on a single line. All other drawn
// formulas are refused.

import { listLines } from "./spans.js";
import { ArmError, formatMessage, quoteText } from "../sentences.js";

/** @typedef {import("./spans.js").SpannedText} SpannedText */
/** @typedef {import("./spans.js").Span} Span */
/**
 * An edit of a text. The `parts` are spans of the text and new characters, and replace its span.
 * @typedef {Span & { parts: (Span | string)[] }} Edit
 */

const ROOT = /\\\/|╲╱/g;
const OVERLINE = /^_{3,}/;
const DRAWN_BRACKET = /[⎛-⎭]/g;
// A bar between blanks, brackets and commas. It may also be a minus.
const BAR = /(?<![^\s[(⎛-⎭])(?:─+|-+)(?![^\s\]),⎛-⎭])/g;
const TERM = /^(?=.*[\dπp])(?:[-+*·\d. √π()]|pi)+$/;
const FRAME = /[\s⎛-⎭[\](),]/g; // characters that are no part of an entry
const OPENING = /[⎛-⎭[]/;
const UNREAD_SIGN = /\\\/|╲╱|[⎛-⎭].*─/; // a root or a bar
const FLATTENED = /√\(|\)\/\(/;

/**
 * Write each drawn fraction and root on a single line.
 * @param {SpannedText} pasted
 * @param {string} what the name of the answer, for the error
 * @returns {SpannedText} a text with the same number of lines
 * @throws {ArmError} if a part of a drawn formula cannot be read, such as a power
 */
export function flattenFormulas(pasted, what) {
  const flat = rewrite(rewrite(pasted, listRootEdits), listFractionEdits);
  const isDrawn = [DRAWN_BRACKET, ROOT].some((pattern) => pasted.text.search(pattern) >= 0);
  if (flat === pasted && !isDrawn) return pasted;
  const [typedLines, flatLines] = [pasted, flat].map(({ text }) => text.split("\n"));
  const line = findUnreadLine(typedLines, flatLines);
  if (line < 0) return flat;
  const quoted = quoteText(typedLines[line].trim());
  throw new ArmError(formatMessage("drawn formula", { what, line: line + 1, quoted }));
}

/** @param {SpannedText} text @param {(lines: any[], k: number) => Edit[]} listEdits of a line */
function rewrite(text, listEdits) {
  const lines = listLines(text.text);
  const edits = lines.flatMap((_, k) => listEdits(lines, k));
  if (!edits.length) return text;
  edits.sort((left, right) => left.from - right.from);
  const parts = edits.flatMap(({ from, parts: instead }, k) => [
    { from: edits[k - 1]?.to ?? 0, to: from },
    ...instead,
  ]);
  return text.assemble([...parts, { from: edits.at(-1).to, to: text.text.length }]);
}

const blank = ({ from, to }) => ({ from, to, parts: [" ".repeat(to - from)] });

// Write √( over a root sign, and ) over the blank behind the root. All columns stay in place.
function listRootEdits(lines, k) {
  const { text, from } = lines[k];
  const above = lines[k - 1] ?? { text: "", from: 0 };
  return [...text.matchAll(ROOT)].flatMap(({ index }) => {
    const start = index + 2;
    const width = OVERLINE.exec(above.text.slice(start))?.[0].length ?? 0;
    const end = Math.min(start + width - 1, text.length);
    if (!TERM.test(text.slice(start, end)) || text[end]?.trim()) return [];
    return [
      blank({ from: above.from + start, to: above.from + start + width }),
      { from: from + index, to: from + start, parts: ["√("] },
      { from: from + end, to: from + Math.min(end + 1, text.length), parts: [")"] },
    ];
  });
}

// Write a fraction in place of its bar, and blanks in place of numerator and denominator.
function listFractionEdits(lines, k) {
  const { text, from } = lines[k];
  return [...text.matchAll(BAR)].flatMap(({ 0: { length }, index }) => {
    const end = index + length;
    const [over, under] = [lines[k - 1], lines[k + 1]].map((line) => findTerm(line, index, end));
    if (!over || !under || under.text.includes(".")) return [];
    const spare = length - Math.max(over.text.length, under.text.length);
    const isSummand = /[-+] $/.test(text.slice(0, index)) || /^ [-+] /.test(text.slice(end));
    // SymPy draws a fraction of whole numbers only within a sum. Any other whole number above a bar
    // may be a column header.
    if (spare > 1 || !(isSummand || /[√π]|pi/.test(over.text + under.text))) return [];
    const parts = ["(", over, ")/(", under, ")"];
    return [blank(over), { from: from + index, to: from + end, parts }, blank(under)];
  });
}

// Find the term between two columns of a line.
function findTerm(line, start, end) {
  const typed = line?.text.slice(start, end) ?? "";
  const text = typed.trim();
  if (!TERM.test(text)) return null;
  const from = line.from + start + typed.indexOf(text);
  return { from, to: from + text.length, text };
}

// Return the index of the first line with an unread part of a drawn formula, or -1. Around a drawn
// row SymPy leaves lines without entries.
function findUnreadLine(typedLines, flatLines) {
  return flatLines.findIndex((line, k) => {
    const [typed, below = ""] = typedLines.slice(k, k + 2);
    if (UNREAD_SIGN.test(line) || isPower(typed, below) || isShifted(typed, below)) return true;
    if (!FLATTENED.test(line)) return false;
    const isWhole = [0, 2].includes(line.match(DRAWN_BRACKET)?.length ?? 0);
    return !isWhole || hasEntries(flatLines[k - 1]) || hasEntries(flatLines[k + 1]);
  });
}

const hasEntries = (line = "") => line.replace(FRAME, "") && !/\p{L}{3}|[:=]\s*$/u.test(line);

// Return whether a line has an exponent above the blank behind its base. The base ends with a
// letter or a bracket. Ordinary words on two lines may look the same, and are refused, too.
const isPower = (line, below) =>
  hasEntries(below) &&
  [...line.matchAll(/[^\s⎛-⎭[\](),]+/g)].some(
    ({ 0: exponent, index }) =>
      /\d/.test(exponent) &&
      !below.slice(index, index + exponent.length).trim() &&
      /[\p{L})]/u.test(below[index - 1] ?? ""),
  );

// Return whether a line and the line below seem to be parts of a drawn formula whose brackets do
// not begin at the same column.
function isShifted(line, below) {
  const [start, startBelow] = [line, below].map((part) => part.search(OPENING));
  if (start < 0 || startBelow < 0 || start === startBelow) return false;
  const rows = [line.slice(start), below.slice(startBelow)];
  return rows.every((row) => hasEntries(row)) && /[\p{L}√]/u.test(rows.join(""));
}
