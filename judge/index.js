// The judge: what is said of an answer, in the page and, through helpers.checks, in Python.

import { sampledPath } from "./geometry/path.js";
import { formulaOf } from "./reading/entry.js";
import { meant, read } from "./reading/table.js";
import { ENTRIES } from "./reading/table_rows.js";
import { numbers, pose } from "./reading/numbers.js";
import { ArmError, formatMessage } from "./sentences.js";
import { compareBranches } from "./topics/branches.js";
import { compareJacobian } from "./topics/jacobian.js";
import { comparePose } from "./topics/pose.js";
import { compareTables } from "./topics/table.js";
import { compareTorques, readPoses } from "./topics/torques.js";
import { compareTrace } from "./topics/trace.js";

/**
 * What Python asks, as plain data: an answer to be judged, or something to be read.
 * @type {Record<string, (question: any) => any>}
 */
const ANSWERS = {
  branches: ({ mine, arm, options }) => compareBranches(mine, arm, null, options),
  jacobian: ({ mine, arm, q, options }) => compareJacobian(mine, arm, q, options),
  pose: ({ mine, arm, target, options }) => comparePose(mine, arm, target, options),
  table: ({ mine, arm, options }) => compareTables(mine, arm, options),
  torques: ({ mine, arm, q, options }) => compareTorques(mine, arm, q, options),
  trace: traced,
  joints: ({ q, arm, angles }) => pose(q, arm, angles),
  poses: ({ q, arm, angles }) => readPoses(q, arm, angles),
  numbers: ({ mine, what, wanted }) => numbers(mine, what, undefined, wanted),
  rows: ({ mine, options }) => meant(read(mine, options, options.values)[0], []),
  entry: ({ text, kinds }) => formulaOf(text, kinds),
  words: ({ key, fields }) => formatMessage(key, fields),
};

// A run along a path that Python holds; the times at which the path is needed too, where some are.
function traced({ mine, arm, path, options }) {
  const wanted = new Set();
  const report = compareTrace(mine, arm, sampledPath(path, wanted), options);
  return wanted.size ? { wanted: [...wanted] } : report;
}

// A report as Python takes it: without what only a page shows.
function told(report) {
  const rest = { ...report, rows: report.table?.rows, read: entriesRead(report) };
  for (const key of ["typed", "wrong", "table"]) delete rest[key];
  return rest;
}

/**
 * List the numbers that were taken as the answer's entries, row by row.
 * @param {import("./report.js").Verdict} verdict
 */
function entriesRead({ typed, table }) {
  if (table?.typed) {
    const entry = (row, k) => (name, c) => ({
      row: k,
      column: c,
      value: row.numbers[name],
      text: row.texts[name],
    });
    return table.typed.flatMap((row, k) => ENTRIES.map(entry(row, k)));
  }
  if (!typed) return [];
  const width = typed.shape.at(-1) ?? 1;
  return typed.values.map((value, i) => {
    const [row, column] = [Math.floor(i / width), i % width];
    return { row, column, value, text: typed.entries[i].text };
  });
}

/**
 * The answer to a question, or why there is none in words.
 * @param {string} text
 */
export function ask(text) {
  const question = JSON.parse(text);
  try {
    const answer = ANSWERS[question.topic](question);
    return JSON.stringify({ answer: answer?.grade ? told(answer) : answer });
  } catch (error) {
    if (error instanceof ArmError)
      return JSON.stringify({ refused: error.message, advice: error.advice });
    throw error;
  }
}

export { compareJacobian, compareTables, compareTorques };
export { listDetails, GRADE_MARKS, formatVerdict } from "./report.js";
export { ArmError } from "./sentences.js";
