// What is said of an answer: one report for all topics, and its words.

import { adviseOnCauses } from "./advice.js";
import { RIGHT, ROUNDED, SO_FAR, WRONG } from "./digits.js";
import { tryOrNull, formatMessage } from "./sentences.js";

export const GRADE_MARKS = { [RIGHT]: "✔", [SO_FAR]: "◐", [ROUNDED]: "≈", wrong: "✘" };

/**
 * Its rows as meant (standard, m and rad); and as typed, a row of cells a, alpha, d, theta in m and
 * degrees for each, the formulas that stood there, and which of them are wrong.
 * @typedef {import("./geometry/arm.js").TableRow} TableRow
 * @typedef {{ rows: TableRow[], cells: string[][], trees: any[][], wrong: boolean[][],
 *   typed?: import("./reading/table.js").TypedRow[] }} ReadTable
 */

/**
 * One report for all topics.
 * @typedef {{ what: string, where: string, words: string }} Finding
 * @typedef {object} Verdict
 * @property {string} topic
 * @property {string} arm
 * @property {string} grade
 * @property {string} headline
 * @property {string} [mark] the grade in whose colour it is shown, where that is another
 * @property {Finding[]} findings
 * @property {string[]} causes
 * @property {string[]} taken
 * @property {string[]} notes
 * @property {import("./advice.js").Advice[]} [advice] what the reader may set
 * @property {import("./reading/numbers.js").Typed} [typed] what was read, in its own order
 * @property {string[]} [left] the lines that were set aside
 * @property {boolean[]} [wrong] which of its entries are wrong
 * @property {ReadTable} [table] a Denavit-Hartenberg table as it was read
 * @property {{ signs: number[], offsets: number[], rows: any[] }} [map] from the joints of that
 *   table to those of the reference: q_k = signs[k] * yours + offsets[k]
 * @property {Record<string, any>} [figures] measured numbers by name
 */

/**
 * A report of which only what is given says anything.
 * @returns {Verdict}
 */
export const makeVerdict = (topic, arm, grade, headline, rest = {}) => ({
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
 * A judge whose reports advise what the reader may set, and show what was set aside. The judge's
 * options come last.
 * @template {any[]} Asked
 * @param {(mine: any, ...asked: Asked) => Verdict} judge
 * @returns {(mine: any, ...asked: Asked) => Verdict}
 */
export const completeVerdicts =
  (judge) =>
  (mine, ...asked) => {
    const first = judge(mine, ...asked);
    const report = ofFamily(first, judge, mine, asked) ?? first;
    const options = asked[judge.length - 1] ?? {};
    const advice = [...(report.advice ?? []), ...adviseOnCauses(report.causes, options)];
    return withLeft({ ...report, advice }, first.left ?? first.typed?.left ?? mine?.left ?? []);
  };

// The report on an answer that is right for another arm of the same name; null where there is none.
/** @param {Verdict} first */
function ofFamily({ topic, grade, typed }, judge, text, asked) {
  if (grade !== WRONG || topic === "table") return null; // whose own causes name it
  const [arm, ...rest] = asked;
  const isRight = (one) =>
    [RIGHT, ROUNDED].includes(tryOrNull(() => judge(text, one, ...rest))?.grade);
  const other = (arm.family ?? []).find(isRight);
  if (!other) return null;
  const names = { arm: arm.name, lengths: arm.lengths, other: other.name, others: other.lengths };
  const words = formatMessage("arm.other", names);
  return makeVerdict(topic, arm, WRONG, words, {
    findings: [{ what: "cause", where: "", words }],
    causes: [`arm.other:${other.name}`],
    advice: [{ field: "arm", value: other.name }],
    typed,
  });
}

// A report that shows what was set aside.
function withLeft(report, left) {
  if (!left.length) return report;
  const texts = left.map((line) => `\`${line}\``).join(", ");
  return { ...report, notes: [...report.notes, formatMessage("set aside", { texts })] };
}

// Everything below the headline, a sentence each; what stands in the headline is not repeated.
export const listDetails = ({ headline, findings, taken, notes }) => [
  ...findings
    .filter(({ what, words }) => what !== "cause" && !headline.includes(words.slice(1)))
    .map(({ words }) => words),
  ...taken.map((words) => `Taken as ${words}`),
  ...notes.map((words) => `Note: ${words}`),
];

// The whole report in words, as str(report) says it in Python.
export const formatVerdict = (report) =>
  [report.headline, ...listDetails(report).map((line) => `- ${line}`)].join("\n");
