// The numbers that a reader gives to symbols of their own: "h = 0.333, phi_0 = pi/4", or as
// Python's dictionary.

import { number, plain } from "./formula.js";
import { ArmError, quoteText } from "../sentences.js";

const NAME = /^[A-Za-z][A-Za-z0-9_]*'?(?:\{[\w+-]*\})?$/;

/**
 * Names and their numbers; an error in words where a text holds something else.
 * @param {string} text
 * @returns {[string, number][]}
 */
export function ownValues(text) {
  const inner = text.trim().replace(/^\{|\}$/g, "");
  const parts = inner.split(/[,;\n]/).filter((part) => part.trim());
  return parts.map((part) => {
    const [name, typed, ...more] = part.split(/[=:]/);
    const word = plain(name.replace(/^\s*(["'])(.*)\1\s*$/, "$2"));
    const found = more.length ? null : number(typed ?? "");
    if (found !== null && NAME.test(word)) return [word, found];
    throw new ArmError(
      `your own symbols: ${quoteText(part.trim())} is not read; expected such as h = 0.333`,
    );
  });
}
