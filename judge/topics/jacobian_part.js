// Judges the first rows of a Jacobian whose last rows are missing.

import { makeJacobian } from "../causes/jacobian.js";
import { SO_FAR, WRONG } from "../digits.js";
import { judgeEntries } from "../entries.js";
import { formatMessage, joinList } from "../sentences.js";
import { makeVerdict } from "../verdict.js";
import { ROWS } from "./jacobian_rows.js";

/** @typedef {import("../reading/numbers.js").Typed} Typed */

/** Counts of rows in an unfinished Jacobian. Three rows are missing here: they are a half. */
export const PARTIAL_COUNTS = [5, 4, 2];

/**
 * Judge the first rows of a Jacobian.
 * @param {Typed} typed
 * @param {{ arm: import("../geometry/arm.js").Arm, typedQ: import("../digits.js").Entries,
 *   frame: number, angularFirst?: boolean, tolerance?: number | null }} question
 * @param {string[]} taken how the answer was read
 * @returns {import("../verdict.js").Verdict | null} null if they are not the right first rows
 */
export function judgeFirstRows(typed, question, taken) {
  const { arm, typedQ, frame, angularFirst = false, tolerance = null } = question;
  const [count, width] = typed.shape;
  const dof = typedQ.values.length;
  if (!PARTIAL_COUNTS.includes(count) || width !== dof || !hasEntriesOnly(typed)) return null;
  const makeWhole = makeJacobian(arm, frame);
  const makeExpected = (q) => {
    const J = makeWhole(q);
    const ordered = angularFirst ? [...J.slice(3 * dof), ...J.slice(0, 3 * dof)] : J;
    return ordered.slice(0, count * dof);
  };
  const { grade, wrong } = judgeEntries({
    typed,
    q: typedQ,
    dof,
    makeExpected,
    mistakes: [],
    tolerance,
  });
  if (grade === WRONG) return null;
  const names = angularFirst ? [...ROWS.slice(3), ...ROWS.slice(0, 3)] : ROWS;
  const missing = joinList(names.slice(count));
  const headline = formatMessage("J first rows", { arm: arm.name, count });
  return makeVerdict("Jacobian", arm, SO_FAR, headline, {
    findings: [
      { what: "missing", where: missing, words: formatMessage("J rows missing", { missing }) },
    ],
    taken,
    typed,
    wrong,
    rowNames: names.slice(0, count),
  });
}

// Return whether each number of a text is an entry or a label. Any other number may be an entry of
// a row that could not be read.
/** @param {Typed} typed */
const hasEntriesOnly = ({ tokens = [] }) =>
  tokens.every(({ owner }) => owner === "entry" || owner === "label" || owner === "header");
