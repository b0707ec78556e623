// A DH table out of what is on a clipboard, by the reader that judges tables too.

import { findRowsFault } from "../../judge/geometry/arm.js";
import { ownRows } from "../../judge/reading/table.js";
import { ArmError } from "../../judge/sentences.js";

// A table has them, an entry has none.
const SEVERAL = /[\n\t;&|]|\]\s*,|,\s*\[|\d +[-\d]/;

/**
 * The rows that a text describes and what was guessed of them, or what is wrong with it, or null
 * where it is a single entry.
 * @param {string} text
 * @param {string} unit of bare angles
 * @returns {{ rows: any[], said: string[] } | { error: string } | null}
 */
export function readTable(text, unit) {
  try {
    if (!SEVERAL.test(text.trim())) return null;
    const found = ownRows(text, unit);
    const fault = findRowsFault(found.rows);
    return fault ? { error: `${fault}.` } : found;
  } catch (error) {
    if (error instanceof ArmError) return { error: `${error.message}.` };
    throw error;
  }
}
