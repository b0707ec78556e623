// What is said of an answer: one report for all topics, and its words.

import { adviceOn } from "./advice.js";
import { RIGHT, ROUNDED, SO_FAR } from "./digits.js";

export const MARKS = { [RIGHT]: "✔", [SO_FAR]: "◐", [ROUNDED]: "≈", wrong: "✘" };

/**
 * Its rows as meant (standard, m and rad); and as typed, a row of cells a, alpha, d, theta in m and
 * degrees for each, the formulas that stood there, and which of them are wrong.
 * @typedef {import("./geometry/axes.js").Numbers} Numbers
 * @typedef {{ rows: Numbers[], cells: string[][], trees: any[][], wrong: boolean[][] }} ReadTable
 */

/**
 * One report for all topics.
 * @typedef {{ what: string, where: string, words: string }} Finding
 * @typedef {object} Report
 * @property {string} topic
 * @property {string} arm
 * @property {string} grade
 * @property {string} headline
 * @property {Finding[]} findings
 * @property {string[]} causes
 * @property {string[]} taken
 * @property {string[]} notes
 * @property {import("./advice.js").Advice[]} [advice] what the reader may set
 * @property {import("./reading/numbers.js").Typed} [typed] what was read, in its own order
 * @property {boolean[]} [wrong] which of its entries are wrong
 * @property {ReadTable} [table] a Denavit-Hartenberg table as it was read
 * @property {{ signs: number[], offsets: number[], rows: any[] }} [map] from the joints of that
 *   table to those of the reference: q_k = signs[k] * yours + offsets[k]
 * @property {Record<string, any>} [figures] measured numbers by name
 */

/**
 * A report of which only what is given says anything.
 * @returns {Report}
 */
export const reportOf = (topic, arm, grade, headline, rest = {}) => ({
  topic,
  arm: arm.name,
  grade,
  headline,
  findings: [],
  causes: [],
  taken: [],
  notes: [],
  ...rest,
});

/**
 * A judge whose reports advise what the reader may set; its options come last.
 * @template {any[]} Asked
 * @param {(...asked: Asked) => Report} judge @returns {(...asked: Asked) => Report}
 */
export const advising =
  (judge) =>
  (...asked) => {
    const report = judge(...asked);
    const options = asked[judge.length] ?? {};
    return (
      report && {
        ...report,
        advice: [...(report.advice ?? []), ...adviceOn(report.causes, options)],
      }
    );
  };

// Everything below the headline, a sentence each; what stands in the headline is not repeated.
export const linesOf = ({ headline, findings, taken, notes }) => [
  ...findings
    .filter(({ what, words }) => what !== "cause" && !headline.includes(words.slice(1)))
    .map(({ words }) => words),
  ...taken.map((words) => `Taken as ${words}`),
  ...notes.map((words) => `Note: ${words}`),
];

// The whole report in words, as str(report) says it in Python.
export const textOf = (report) =>
  [report.headline, ...linesOf(report).map((line) => `- ${line}`)].join("\n");
