// The numbers that a reader gives to symbols of their own: "h = 0.333, phi_0 = pi/4", or as
// Python's dictionary.

import { number, plain } from "./formula.js";
import { ArmError, shown } from "../sentences.js";

const WHOLE = /^\s*(?:values\s*=\s*)?(?:dict\s*\(([^]*)\)|\{([^]*)\})\s*$/;
const PAIR = /^\s*(["']?)(.+?)\1\s*[=:]\s*([^=:]+?)\s*$/s;
const NAME = /^[A-Za-z][A-Za-z0-9_]*'?(?:\{[\w+-]*\})?$/;

/**
 * Names and their numbers; an error in words where a text holds something else.
 * @param {string} text
 * @returns {[string, number][]}
 */
export function ownValues(text) {
  const [, called, braced] = WHOLE.exec(text) ?? [];
  const parts = (called ?? braced ?? text).split(/[,;\n]/).filter((part) => part.trim());
  return parts.map((part) => {
    const [, , name, typed] = PAIR.exec(part) ?? [];
    const [word, found] = name ? [plain(name), number(typed)] : ["", null];
    if (found !== null && NAME.test(word)) return [word, found];
    throw new ArmError(
      `your own symbols: ${shown(part.trim())} is not read; expected such as h = 0.333`,
    );
  });
}
