// Makes verdicts, the results of the judges of all topics, and formats them as text.

import { adviseOnCauses } from "./advice.js";
import { RIGHT, RIGHT_BY_MAP, ROUNDED, SO_FAR, WRONG } from "./digits.js";
import { tryOtherCommas } from "./reading/commas.js";
import { listUnused } from "./reading/unused_lines.js";
import { applyWords } from "./reading/words.js";
import { formatMessage, tryOrNull } from "./sentences.js";

/** The mark that is shown beside each grade. */
export const GRADE_MARKS = {
  [RIGHT]: "✔",
  [RIGHT_BY_MAP]: "✔",
  [SO_FAR]: "◐",
  [ROUNDED]: "≈",
  [WRONG]: "✘",
};

/** @typedef {import("./geometry/arm.js").Arm} Arm */
/** @typedef {import("./geometry/arm.js").Row} Row */
/**
 * A Denavit-Hartenberg table as it was read.
 * @typedef {object} ReadTable
 * @property {Row[]} rows in the standard convention, in m and rad
 * @property {string[][]} cells a, alpha, d, theta of each typed row, in m and degrees
 * @property {any[][]} trees the formulas of these cells
 * @property {boolean[][]} wrong whether each cell is wrong
 * @property {import("./reading/table.js").TypedRow[]} [typed] the rows as they were typed
 */
/**
 * A wrong or missing part of an answer. `what` is its kind (the name of a cause, "cause", "shape",
 * ...), `where` its position, `words` the message about it.
 * @typedef {{ what: string, where: string, words: string }} Finding
 */
/**
 * The map from the joint values of a right table to those of the reference.
 * @typedef {object} JointReport
 * @property {number[]} signs joint k of the reference is signs[k] times the student's joint plus
 *   offsets[k]
 * @property {number[]} offsets rad or m
 * @property {number[]} start the student's joint values where the homework starts; [] if unknown
 * @property {string} message the joints that count otherwise, in one sentence
 * @property {{ headers: string[], rows: string[][] }} table a row for each joint
 * @property {Arm} arm the reference in the student's joints
 */
/**
 * The result of judging an answer.
 * @typedef {object} Verdict
 * @property {string} topic
 * @property {string} arm its name
 * @property {string} grade "right", "right by map", "so far", "rounded" or "wrong"
 * @property {string} headline
 * @property {string} [mark] the grade whose mark is shown, if it is not `grade`
 * @property {Finding[]} findings
 * @property {string[]} causes names of the mistakes that explain the answer
 * @property {string[]} taken how the answer was read: units, order, convention
 * @property {string[]} notes
 * @property {import("./advice.js").Advice[]} [advice] settings to change
 * @property {import("./reading/owners.js").Token[]} [tokens] the numbers of the pasted text, each
 *   with its place and what it was taken for
 * @property {import("./reading/numbers.js").Typed} [typed] the numbers that were read
 * @property {boolean[]} [wrong] whether each of the numbers is wrong
 * @property {string[]} [rowNames] names of the Jacobian's rows that were read
 * @property {ReadTable} [table]
 * @property {JointReport} [map] from the joints of the student's table to those of the reference
 * @property {Record<string, any>} [figures] measured numbers by name
 */

/**
 * Make a verdict. Its lists are empty unless `fields` has them.
 * @param {string} topic
 * @param {{ name: string }} arm
 * @param {string} grade
 * @param {string} headline
 * @param {Partial<Verdict> & Record<string, any>} [fields]
 * @returns {Verdict}
 */
export const makeVerdict = (topic, arm, grade, headline, fields = {}) => ({
  topic,
  arm: arm.name,
  grade,
  headline,
  findings: [],
  causes: [],
  taken: [],
  notes: [],
  ...fields,
});

/** Make a finding. @param {string} what @param {string} words @returns {Finding} */
export const makeFinding = (what, words, where = "") => ({ what, where, words });

/**
 * Wrap a judge so that its verdicts are complete. A wrong answer may be right for a different arm
 * of the same family, which the verdict then names. It also gets advice and a note on unused lines.
 * @template {any[]} Rest
 * @param {(mine: any, ...rest: Rest) => Verdict} judge its last argument holds the options
 * @returns {(mine: any, ...rest: Rest) => Verdict}
 */
export const completeVerdicts =
  (judge) =>
  (mine, ...rest) => {
    const options = rest[judge.length - 1] ?? {};
    const judgeInOrder = (stated) => {
      const args = [...rest];
      args[judge.length - 1] = { ...options, stated };
      return judge(mine, .../** @type {Rest} */ (args));
    };
    const plain = judge(mine, ...rest);
    const applyText = (text) =>
      applyWords(text, tryOtherCommas(text, plain, judgeInOrder), options, judgeInOrder);
    const first = typeof mine === "string" ? applyText(mine) : plain;
    const verdict = findRightArm(first, judge, mine, rest) ?? first;
    const advice = [...(verdict.advice ?? []), ...adviseOnCauses(verdict.causes, options)];
    const tokens = findTokens(first, mine);
    const unused = typeof mine === "string" && tokens ? listUnused(mine, tokens) : [];
    return noteUnused({ ...verdict, advice, tokens }, unused);
  };

/** @param {Verdict} verdict @param {any} mine */
const findTokens = ({ tokens, typed }, mine) => tokens ?? typed?.tokens ?? mine?.tokens;

// Return the verdict on a wrong answer that is right for a different arm of the same family, or
// null. Tables are left out, since their causes already name other arms.
/** @param {Verdict} verdict */
function findRightArm({ topic, grade, typed }, judge, mine, args) {
  const [arm, ...rest] = args;
  if (grade !== WRONG || topic === "table") return null;
  const optionsIndex = judge.length - 2; // in `rest`
  // The search for mistakes takes longest.
  rest[optionsIndex] = { ...rest[optionsIndex], isGradeOnly: true };
  const isRightFor = (member) =>
    [RIGHT, ROUNDED].includes(tryOrNull(() => judge(mine, member, ...rest))?.grade);
  const other = (arm.family ?? []).find(isRightFor);
  if (!other) return null;
  const fields = { arm: arm.name, lengths: arm.lengths, other: other.name, others: other.lengths };
  const message = formatMessage("arm.other", fields);
  return makeVerdict(topic, arm, WRONG, message, {
    findings: [{ what: "cause", where: "", words: message }],
    causes: [`arm.other:${other.name}`],
    advice: [{ field: "arm", value: other.name }],
    typed,
  });
}

function noteUnused(verdict, unused) {
  if (!unused.length) return verdict;
  const texts = unused.map((line) => `\`${line}\``).join(", ");
  return { ...verdict, notes: [...verdict.notes, formatMessage("set aside", { texts })] };
}

/**
 * List the sentences below the headline, without those that the headline contains.
 * @param {Verdict} verdict
 * @returns {string[]}
 */
export const listDetails = ({ headline, findings, taken, notes }) => [
  ...findings
    .filter(({ what, words }) => what !== "cause" && !headline.includes(words.slice(1)))
    .map(({ words }) => words),
  ...taken.map((phrase) => `Taken as ${phrase}`),
  ...notes.map((note) => `Note: ${note}`),
];

/** Format a verdict as text, as str(report) does in Python. @param {Verdict} verdict */
export function formatVerdict(verdict) {
  const details = listDetails(verdict);
  const lines = verdict.map ? [verdict.map.message, ...details] : details;
  return [verdict.headline, ...lines.map((line) => `- ${line}`)].join("\n");
}
