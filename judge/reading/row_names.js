// Finds rows that are not the answer, because the words before them call them masses, a force or an
// old answer. Compares the names of rows that may belong together.

import { findLabel } from "./labels.js";

/** @typedef {import("./lines.js").Row} Row */

// Masses, forces, points and lengths: m, F_ext, d_1, l_pen.
const OTHER_NAMES =
  /^(?:[fFgmp]|FK|tip|errors?|residual|limits?|F_?ext|[adhlLmr](?:_?\{?\d\}?|_\w+))$/;
const OTHER_WORDS =
  /\b(?:mass(?:es)?|wrench|force|target|given|lengths?|at q|for F|norm|elapsed time)\b/i;

/**
 * Return whether the words before a row name a quantity that is never the answer, such as masses,
 * lengths, a force or a target.
 * @param {Row} row
 */
export function namesOtherQuantity({ name, words }) {
  const lastWords = words.slice(-4).map(({ text }) => text);
  return (
    OTHER_NAMES.test(name.split(" ").at(-1)) || OTHER_WORDS.test([...lastWords, name].join(" "))
  );
}

const OTHER_TOPIC = /^(?:[Δ∆]|[qθτ]$|theta|tau|torques?\b|ω|omega|w$)/;
// q1 before a list may be the number of a question.
const OTHER_VALUE = /^(?:[xyz]|[qθτ][ _{]{0,2}\d+\}?|F_?\{?\d\}?)$/;

/**
 * Return whether "=" on the line of a row assigns it to joint values, torques or velocities. The
 * name of a single value may also be a coordinate, a force or a joint.
 * @param {Row} row
 */
export const namesOtherTopic = ({ name, cells, isAssigned }) =>
  isAssigned && (OTHER_TOPIC.test(name) || (cells.length === 1 && OTHER_VALUE.test(name)));

const OLD = "old|previous|earlier|first (?:try|attempt|run)";
const CALLED_OLD = new RegExp(String.raw`\b(?:${OLD}|wrong|before I)\b`, "i");
// With two words behind it at most, as in "my old answer (wrong)".
const OLD_HEADING = new RegExp(String.raw`^\W*(?:my )?(?:${OLD})(?:\W+\w+){0,2}\W*$`, "i");

const textOf = (cells) => cells.map(({ text }) => text).join(" ");

/**
 * Return whether the words before a row, or the heading above it, call it an old answer.
 * @param {Row} row
 */
export const isCalledOld = ({ name, words, above }) =>
  CALLED_OLD.test(`${textOf(words)} ${name}`) || OLD_HEADING.test(textOf(above));

/**
 * Return whether two single values may be entries of the same column. On the same line, both values
 * have a name or neither has. On different lines, their labels are of the same kind. Values within
 * brackets need no names. A word that is no label, as in "all 3 axes", ends a column.
 * @param {Row} row @param {Row} other
 */
export function haveSimilarLabels(row, other) {
  if (row.depth) return true;
  if (row.line === other.line) return !row.name === !other.name;
  const [label, otherLabel] = [findLabel(row.words), findLabel(other.words)];
  if (!label && row.words.length && !row.isAssigned && !other.words.length) return false;
  return label?.kind === otherLabel?.kind;
}
