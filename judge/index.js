// Answers questions from Python, which come and go as JSON text.

import { makeSampledPath } from "./geometry/path.js";
import { formulaOf } from "./reading/entry.js";
import { ENTRIES } from "./reading/table_rows.js";
import { numbers, readConfiguration } from "./reading/numbers.js";
import { getShownKind, listMarks, MARK_NAMES, splitAtMarks } from "./marks.js";
import { evaluateFormulas, findTableMistake, listMistakes } from "./mistakes.js";
import { ArmError } from "./sentences.js";
import { readArmTable } from "./topics/arm_table.js";
import { compareBranches } from "./topics/branches.js";
import { compareJacobian } from "./topics/jacobian.js";
import { comparePose } from "./topics/pose.js";
import { compareTables } from "./topics/table.js";
import { compareTorques, readConfigurations } from "./topics/torques.js";
import { compareTrace } from "./topics/trace.js";

/** @typedef {import("./verdict.js").Verdict} Verdict */
/**
 * A question from Python (helpers/checks/engine.py) with the fields that its topic needs.
 * @typedef {{ topic: string, [field: string]: any }} Question
 */

/**
 * The function that answers each topic. It judges an answer or reads a typed text.
 * @type {Record<string, (question: Question) => any>}
 */
const TOPICS = {
  branches: ({ mine, arm, options }) => compareBranches(mine, arm, null, options),
  jacobian: ({ mine, arm, q, options }) => compareJacobian(mine, arm, q, options),
  pose: ({ mine, arm, target, options }) => comparePose(mine, arm, target, options),
  table: ({ mine, arm, options }) => compareTables(mine, arm, options),
  torques: ({ mine, arm, q, options }) => compareTorques(mine, arm, q, options),
  trace: ({ mine, arm, path, options }) => compareTrace(mine, arm, makeSampledPath(path), options),
  joints: ({ q, arm, angles }) => readConfiguration(q, arm, angles),
  configurations: ({ q, arm, angles }) => readConfigurations(q, arm, angles),
  numbers: ({ mine, what, wanted }) => numbers(mine, what, undefined, wanted),
  rows: ({ mine, options }) => readArmTable(mine, options),
  entry: ({ text, kinds }) => formulaOf(text, kinds),
  mistakes: (question) => listMistakes(/** @type {any} */ (question)),
  formulas: (question) => evaluateFormulas(/** @type {any} */ (question)),
  "table mistake": (question) => findTableMistake(/** @type {any} */ (question)),
};

/**
 * Remove the fields that only the page shows, and list the numbers that were read.
 * @param {Verdict} verdict
 */
function convertForPython(verdict) {
  const otherTokens = (verdict.tokens ?? []).filter(({ owner }) => owner !== "entry");
  const read = [...listEntries(verdict), ...otherTokens.map(pickTokenFields)];
  const fields = { ...verdict, rows: verdict.table?.rows, read };
  for (const name of ["typed", "wrong", "table", "tokens"]) delete fields[name];
  return fields;
}

const pickTokenFields = ({ text, owner, line, reason = "" }) => ({ text, owner, line, reason });

/**
 * List the entries of an answer as they were read, row by row.
 * @param {Verdict} verdict
 */
function listEntries({ typed, table }) {
  if (table?.typed) {
    const makeEntry =
      ({ numbers: values, texts }, row) =>
      (name, column) => ({
        row,
        column,
        value: values[name],
        text: texts[name],
      });
    return table.typed.flatMap((typedRow, row) => ENTRIES.map(makeEntry(typedRow, row)));
  }
  if (!typed) return [];
  const width = typed.shape.at(-1) ?? 1;
  return typed.values.map((value, i) => {
    const [row, column] = [Math.floor(i / width), i % width];
    return { row, column, value, text: typed.entries[i].text };
  });
}

/**
 * Mark the numbers of an answer that is a text.
 * @param {Question} question
 * @param {{ verdict?: Verdict, tokens?: import("./marks.js").Token[] }} outcome
 * @returns the pieces of the text, those that are numbers with a kind and a description, and the
 *   name of each kind; undefined for an answer without marks
 */
function markAnswer({ topic, mine, arm, options }, outcome) {
  if (typeof mine !== "string") return undefined;
  const first = options?.angularFirst ? "omega" : "v";
  const marks = listMarks({ answer: mine, ask: topic, first }, { ...outcome, arm });
  if (!marks.length) return undefined;
  const pieces = splitAtMarks(mine, marks).map(({ text, index }) =>
    index === undefined ? [text] : [text, getShownKind(marks[index]), marks[index].description],
  );
  return { pieces, names: MARK_NAMES };
}

/**
 * Answer a question, or return the reason why it cannot be answered.
 * @param {string} text a `Question` as JSON
 * @returns {string} JSON: `{ answer }`, or `{ refused, advice }` with the reason. If the answer is
 *   a text, `marked` is the text with its marks.
 */
export function ask(text) {
  /** @type {Question} */
  const question = JSON.parse(text);
  try {
    const answer = TOPICS[question.topic](question);
    if (!answer?.grade) return JSON.stringify({ answer });
    const marked = markAnswer(question, { verdict: answer, tokens: answer.tokens });
    return JSON.stringify({ answer: { ...convertForPython(answer), marked } });
  } catch (error) {
    if (!(error instanceof ArmError)) throw error;
    const { message: refused, advice, tokens } = error;
    const marked = error.text === question.mine ? markAnswer(question, { tokens }) : undefined;
    return JSON.stringify({ refused, advice, marked });
  }
}

export { compareJacobian, compareTables, compareTorques };
export { formatVerdict, GRADE_MARKS, listDetails } from "./verdict.js";
export { ArmError } from "./sentences.js";
