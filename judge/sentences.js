// The sentences of the checkers: templates by key, from sentences.json.

import templates from "./sentences.json" with { type: "json" };

// A sentence with its fields put in.
export function formatMessage(key, fields = {}) {
  let text = templates[key];
  for (const [name, value] of Object.entries(fields))
    text = text.replaceAll(`{${name}}`, () => String(value));
  return text;
}

// What was asked for cannot be judged: how it was asked is wrong, not the answer.
export class ArmError extends Error {
  /** @param {string} message @param {import("./advice.js").Advice[]} advice */
  constructor(message, advice = []) {
    super(message);
    this.advice = advice;
  }
}

// What `make` gives, null where it refuses.
export function tryOrNull(make) {
  try {
    return make();
  } catch (error) {
    if (error instanceof ArmError) return null;
    throw error;
  }
}

// A, b and c.
export const joinList = (words, last = "and") =>
  words.length < 2 ? words.join("") : `${words.slice(0, -1).join(", ")} ${last} ${words.at(-1)}`;

// What stands inside a sentence, at the beginning of one.
export const capitalize = (text) => text.slice(0, 1).toUpperCase() + text.slice(1);

// A sentence to stand inside another; a name such as N mm, q_1 or A_i keeps its capital.
export const uncapitalize = (text) =>
  /^.(\p{Lu}|_)/su.test(text) ? text : text.slice(0, 1).toLowerCase() + text.slice(1);

const MOST = 75; // characters of a text that is quoted

// A number to so many significant digits.
export const formatNumber = (x, digits = 3) => String(Number(x.toPrecision(digits)));

// A text in a sentence, in quotes and one line, cut where it is long.
export function quoteText(text) {
  const line = [...text.replace(/[\p{C}\s]+/gu, " ").trim()];
  const mark = line.includes("'") && !line.includes('"') ? '"' : "'";
  const cut = line.length > MOST ? [...line.slice(0, MOST), "..."] : line;
  return `${mark}${cut.join("")}${mark}`;
}

// How many numbers there are, as rows and columns where they have some.
export const describeShape = (shape) => {
  const all = shape.filter((n) => n !== 1).join("x") || "1";
  return `${all} ${all === "1" ? "value" : "values"}`;
};
