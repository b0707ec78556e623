// The checkers of each kind of question: every script of them registers its own, and is loaded when
// it is first asked.

import { loaded } from "../scripts.js";
import { ASKED } from "./questions.js";

/**
 * @typedef {import("./question.js").Question} Question
 * @typedef {import("../../../judge/geometry/arm.js").Arm} Arm
 * @typedef {import("../../../judge/report.js").Report} Report
 * @typedef {(question: Question, arm: Arm) => Report} Checker the verdict on what is typed; throws
 *   ArmError
 */

/** @type {Map<string, Checker>} */
const checkers = new Map();

/** @param {string} ask @param {Checker} checker */
export const register = (ask, checker) => void checkers.set(ask, checker);

/**
 * Readers of what stands in other fields, which come with the scripts that need them: a table of
 * one's own with that of tables, a pose and the symbols there with those that ask for a pose.
 * @type {{ rowsOf?: typeof import("../../../judge/reading/own_table.js").rowsOf,
 *   pose?: typeof import("../../../judge/reading/numbers.js").pose,
 *   lookup?: typeof import("../../../judge/reading/numbers.js").lookup }}
 */
export const readers = {};

// The checker of a question, or undefined while its script has not come.
export const checkerOf = (ask) => checkers.get(ask);

// When the checker of a question is there; its script is loaded if need be.
export const ready = (ask) =>
  checkers.has(ask) ? Promise.resolve() : loaded(`judge-${ASKED[ask].script}.js`);
