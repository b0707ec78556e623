// Reads the values of a reader's own symbols, as "h = 0.333, phi_0 = pi/4" or a Python dictionary.

import { number, plain } from "./formula.js";
import { ArmError, quoteText } from "../sentences.js";

const NAME = /^[A-Za-z][A-Za-z0-9_]*'?(?:\{[\w+-]*\})?$/;

/**
 * Read symbols and their values.
 * @param {string} text
 * @returns {[string, number][]}
 * @throws {ArmError} if the text has a part that is no symbol with its value
 */
export function readSymbolValues(text) {
  const inner = text.trim().replace(/^\{|\}$/g, "");
  const parts = inner.split(/[,;\n]/).filter((part) => part.trim());
  return parts.map((part) => {
    const [name, typed, ...more] = part.split(/[=:]/);
    const symbol = plain(name.replace(/^\s*(["'])(.*)\1\s*$/, "$2"));
    const x = more.length ? null : number(typed ?? "");
    if (x !== null && NAME.test(symbol)) return [symbol, x];
    throw new ArmError(
      `your own symbols: ${quoteText(part.trim())} is not read; expected such as h = 0.333`,
    );
  });
}
