// The sentences of the checkers: templates by key, from sentences.json.

import templates from "./sentences.json" with { type: "json" };

// A sentence with its fields put in.
export function say(key, fields = {}) {
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

// A, b and c.
export const listed = (words, last = "and") =>
  words.length < 2 ? words.join("") : `${words.slice(0, -1).join(", ")} ${last} ${words.at(-1)}`;

// What stands inside a sentence, at the beginning of one.
export const upper = (text) => text.slice(0, 1).toUpperCase() + text.slice(1);

// A sentence to stand inside another; a name such as N mm, q_1 or A_i keeps its capital.
export const lower = (text) =>
  /^.(\p{Lu}|_)/su.test(text) ? text : text.slice(0, 1).toLowerCase() + text.slice(1);

const MOST = 75; // characters of a text that is quoted
const LONG = 9e6; // from here on numbers are told by a power of ten

// A number to so many significant digits, as C's %g, but for whole ones of up to seven places.
export function size(x, digits = 3) {
  if (!Number.isFinite(x)) return Number.isNaN(x) ? "nan" : x > 0 ? "inf" : "-inf";
  if (x === 0) return "0";
  const [mantissa, power] = evenly(x, digits).split("e");
  const exponent = Number(power);
  const trimmed = (text) => (text.includes(".") ? text.replace(/\.?0+$/, "") : text);
  if (exponent >= digits && Math.abs(x) < LONG) return Number(`${mantissa}e${power}`).toFixed(0);
  if (exponent < -4 || exponent >= digits) return `${trimmed(mantissa)}e${signed(exponent)}`;
  return trimmed(Number(`${mantissa}e${power}`).toFixed(Math.max(0, digits - 1 - exponent)));
}

// So many digits of a number; one that lies in the middle of two goes to the even one, where
// toExponential goes up.
function evenly(x, digits) {
  const up = x.toExponential(digits - 1);
  const [mantissa, power] = x.toExponential(digits + 25).split("e");
  const kept = digits === 1 ? mantissa.indexOf(".") : mantissa.indexOf(".") + digits;
  const rest = mantissa.slice(kept).replace(".", "");
  const down = mantissa.slice(0, kept);
  return /^50*$/.test(rest) && "02468".includes(down.at(-1)) ? `${down}e${power}` : up;
}

const signed = (exponent) =>
  `${exponent < 0 ? "-" : "+"}${String(Math.abs(exponent)).padStart(2, "0")}`;

// A number as Python spells it: the shortest text that gives it back.
export function spelled(x) {
  const [mantissa, power] = x.toExponential().split("e");
  const exponent = Number(power);
  if (x !== 0 && (exponent < -4 || exponent >= 16)) return `${mantissa}e${signed(exponent)}`;
  const text = BigInt(Math.trunc(x)).toString();
  return exponent > 20
    ? text
    : String(x).includes("e")
      ? x.toFixed(20).replace(/0+$/, "")
      : String(x);
}

// A text in a sentence, in quotes and one line, cut where it is long.
export function shown(text) {
  const line = [...text.replace(/[\p{C}\s]+/gu, " ").trim()];
  const mark = line.includes("'") && !line.includes('"') ? '"' : "'";
  const cut = line.length > MOST ? [...line.slice(0, MOST), "..."] : line;
  return `${mark}${cut.join("")}${mark}`;
}

// How many numbers there are, as rows and columns where they have some.
export const counted = (shape) => {
  const all = shape.filter((n) => n !== 1).join("x") || "1";
  return `${all} ${all === "1" ? "value" : "values"}`;
};
