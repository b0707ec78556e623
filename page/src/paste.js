// Read a DH table from the clipboard with the judge's table reader.

import { findRowsFault } from "../../judge/geometry/arm.js";
import { readOwnTable } from "../../judge/reading/table.js";
import { ArmError } from "../../judge/sentences.js";

// Separators that occur in a table and not in a single entry.
const TABLE_PATTERN = /[\n\t;&|]|\]\s*,|,\s*\[|\d +[-\d]/;

/**
 * Read a pasted table.
 * @param {string} text
 * @returns {{ rows: any[], reading: string } | { error: string } | null} the rows and how the text
 *   was read; null for a single entry
 */
export function readPastedTable(text) {
  try {
    if (!TABLE_PATTERN.test(text.trim())) return null;
    const { rows, reading } = readOwnTable(text);
    const fault = findRowsFault(rows);
    return fault ? { error: `${fault}.` } : { rows, reading };
  } catch (error) {
    if (error instanceof ArmError) return { error: `${error.message}.` };
    throw error;
  }
}
