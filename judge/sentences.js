// Formats the messages of the judge from the templates in sentences.json.

import templates from "./sentences.json" with { type: "json" };

/**
 * Return a message with its fields filled in.
 * @param {string} key in sentences.json
 * @param {Record<string, any>} [fields]
 * @returns {string}
 */
export function formatMessage(key, fields = {}) {
  let text = templates[key];
  for (const [name, value] of Object.entries(fields))
    text = text.replaceAll(`{${name}}`, () => String(value));
  return text;
}

/** A question that cannot be judged, because of how it was asked. */
export class ArmError extends Error {
  /**
   * @param {string} message @param {import("./advice.js").Advice[]} advice
   * @param {import("./reading/owners.js").Token[]} [tokens] the numbers of `text`, some unread
   * @param {string} [text] the answer, or what was typed into another field
   */
  constructor(message, advice = [], tokens = undefined, text = undefined) {
    super(message);
    this.advice = advice;
    this.tokens = tokens;
    this.text = text;
    /** @type {{ firstLine: number, lastLine: number }[] | undefined} of answers that differ */
    this.answers = undefined;
  }
}

/**
 * Return what `make` returns, or null if it throws an ArmError.
 * @template T @param {() => T} make @returns {T | null}
 */
export function tryOrNull(make) {
  try {
    return make();
  } catch (error) {
    if (error instanceof ArmError) return null;
    throw error;
  }
}

/** Join items as "a, b and c". @param {(string | number)[]} items */
export const joinList = (items, conjunction = "and") =>
  items.length < 2
    ? items.join("")
    : `${items.slice(0, -1).join(", ")} ${conjunction} ${items.at(-1)}`;

/** Name rows of a table, as "row 2" or "rows 2 and 3". @param {number[]} rows */
export const formatRowNumbers = (rows) =>
  rows.length === 1
    ? formatMessage("row", { row: rows[0] })
    : formatMessage("rows", { rows: joinList(rows) });

/** Begin a text with a capital. @param {string} text */
export const capitalize = (text) => text.slice(0, 1).toUpperCase() + text.slice(1);

/**
 * Begin a text with a small letter. A name such as N mm, q_1 or A_i keeps its capital.
 * @param {string} text
 */
export const uncapitalize = (text) =>
  /^.(\p{Lu}|_)/su.test(text) ? text : text.slice(0, 1).toLowerCase() + text.slice(1);

/** Turn a sentence into a clause, without a capital and a full stop. @param {string} sentence */
export const toClause = (sentence) => uncapitalize(sentence).replace(/\.+$/, "");

/** Format a number with so many significant digits. @param {number} x */
export const formatNumber = (x, digits = 3) => String(Number(x.toPrecision(digits)));

const MAX_QUOTE = 75; // characters

/** Quote a text on one line, cut if it is long. @param {string} text */
export function quoteText(text) {
  const line = [...text.replace(/[\p{C}\s]+/gu, " ").trim()];
  const mark = line.includes("'") && !line.includes('"') ? '"' : "'";
  const cut = line.length > MAX_QUOTE ? [...line.slice(0, MAX_QUOTE), "..."] : line;
  return `${mark}${cut.join("")}${mark}`;
}

/** Describe how many numbers there are, as "6x7 values". @param {number[]} shape */
export const describeShape = (shape) => {
  const size = shape.filter((n) => n !== 1).join("x") || "1";
  return `${size} ${size === "1" ? "value" : "values"}`;
};
