// Lists the lines and numbers of a pasted text that no step used.

import { BESIDE_WORDS } from "./owners.js";
import { IN_DEFINITION } from "./table_definitions.js";

const COLUMN = /^column /; // the reason of a number in a column that does not belong to a table
const FACTOR = /^1\.0e[+-]\d+ ?\*$/; // that MATLAB prints above a matrix, and that is applied
const NAME_BEFORE = /[\p{L}_][{[(]?$/u; // q_1

// Return the part of a line between commas or semicolons that has the character at an index.
function findPart(line, index) {
  const before = line.slice(0, index).split(/[,;]/).at(-1);
  const [behind] = line.slice(index).split(/[,;]/);
  return `${before}${behind}`.trim();
}

// Return whether a number is unused where no entry stands on its line. Words above the answer are
// its labels, as a date is; a label with a reason, as the length that a table uses, is used.
/** @param {import("./owners.js").Token} token */
const isUnusedAlone = ({ owner, reason }) => owner === "given" || (owner === "label" && !reason);

/**
 * List the lines without entries that have an unused number, and the unused numbers on the lines of
 * entries. Beside a used definition, only the part with the number is listed. The numbers of an
 * unused column are its header.
 * @param {string} text as it was pasted @param {import("./owners.js").Token[]} tokens
 */
export function listUnused(text, tokens) {
  const startOf = ({ from }) => text.lastIndexOf("\n", from) + 1;
  const entries = tokens.filter(({ owner }) => owner === "entry");
  const linesOfEntries = new Set(entries.map(startOf));
  const definitions = tokens.filter(({ reason }) => reason === IN_DEFINITION);
  const linesOfDefinitions = new Set(definitions.map(startOf));
  const unused = tokens.flatMap((token) => {
    const { owner, reason = "", from } = token;
    if (NAME_BEFORE.test(text.slice(Math.max(0, from - 2), from))) return [];
    const start = startOf(token);
    const isAlone = !linesOfEntries.has(start);
    if (owner !== "context" && !(isAlone && isUnusedAlone(token))) return [];
    if (COLUMN.test(reason)) return [reason.replace(COLUMN, "")];
    const line = text.slice(start).split("\n", 1)[0];
    if (isAlone && linesOfDefinitions.has(start)) return [findPart(line, from - start)];
    if (isAlone) return FACTOR.test(line.trim()) ? [] : [line.trim()];
    const sign = "-−–".includes(text[from - 1]) ? text[from - 1] : "";
    return reason === BESIDE_WORDS ? [] : [sign + token.text];
  });
  return [...new Set(unused)];
}
