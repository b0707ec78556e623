// Says in JavaScript what tests/judge_words.py asks for: a line of JSON in (arms, sentences, questions), the words of
// each out, a line too.

import { createInterface } from "node:readline";
import { asPython, EMPTY, fromFragment, judge as verdict, toFragment } from "../page/src/check/question.js";
import { numbers } from "../judge/reading/numbers.js";
import { number, parse, symbols, value } from "../judge/reading/formula.js";
import { cells as cellsOf, withoutHeader } from "../judge/reading/grid.js";
import * as judge from "../judge/index.js";
import { compareBranches } from "../judge/topics/branches.js";
import { circle, circleBelow, restToRest } from "../judge/geometry/path.js";
import { comparePose } from "../judge/topics/pose.js";
import { size } from "../judge/sentences.js";
import "../page/src/check/scripts/jacobian.js";
import "../page/src/check/scripts/table.js";
import "../page/src/check/scripts/motion.js";
import { ENTRIES, meant, read as readTable } from "../judge/reading/table.js";
import { compareTrace } from "../judge/topics/trace.js";

let arms = [];

const JUDGES = {
  read: ({ typed }) => read(typed),
  branches: ({ typed, arm, target, options }) => compareBranches(typed, arms[arm], target, options),
  jacobian: ({ typed, arm, q, options }) => judge.compareJacobian(typed, arms[arm], q, options),
  table: ({ typed, arm, options }) => judge.compareTables(typed, arms[arm], options),
  page: ({ fields }) => throughLink({ ...EMPTY, ...fields }),
  pose: ({ typed, arm, target, options }) => comparePose(typed, arms[arm], target, options),
  torques: ({ typed, arm, q, options }) => judge.compareTorques(typed, arms[arm], q, options),
  trace: ({ typed, arm, path, options }) => compareTrace(typed, arms[arm], pathOf(arms[arm], path), options),
};

function pathOf(arm, { rest, ...asked }) {
  const path = asked.centre ? circle(asked) : circleBelow(arm, asked);
  return rest ? restToRest(path) : path;
}

// What the page says of a question that came by a link, and the call that says the same.
function throughLink(asked) {
  const { question, words } = fromFragment(toFragment(asked), arms.map(({ key }) => key));
  if (!question) throw new judge.ArmError(words);
  const { report, error } = verdict(question, arms);
  if (error) throw new judge.ArmError(error);
  return { ...report, call: asPython(question, arms) };
}

// What a paste is read as, in the place of words.
function read(text) {
  const { values, shape } = numbers(text, "your matrix");
  return { grade: "read", causes: shape, headline: values.join(" "), findings: [], taken: [], notes: [] };
}

// Whose report it is, and each finding.
const whole = ({ topic, arm, findings }) => [
  [topic, arm],
  ...findings.map(({ what, where, words }) => [what, where, words]),
];

// What tests/readings.py says of Python's reading: cells, formulas, tables.
function reading({ typed, options: { values = [], ...said } }) {
  const cells = tried(() => cellsOf(typed));
  const rows = typeof cells === "string" ? [] : withoutHeader(cells);
  const formulas = rows.flatMap((row) => row.slice(0, 9).map((cell) => tried(() => ofFormula(cell))));
  const tables = tried(() => readTable(typed, said, values).slice(0, 3).map(ofTable)); // prettier-ignore
  return ["read", [], [cells, rows.length, formulas.slice(0, 40), tables]];
}

function tried(ask) {
  try {
    return ask();
  } catch (error) {
    if (error instanceof judge.ArmError) return error.message;
    throw error;
  }
}

function ofFormula(text) {
  const tree = parse(text, "a cell");
  const x = value(tree, (name) => 0.3 + 0.1 * name.length);
  return [tree, [...symbols(tree)].sort(), size(x, 9), number(text) === null];
}

function ofTable(table) {
  const kinds = ["revolute", "revolute", "prismatic"];
  const { rows, said, length, angle } = meant(table, kinds);
  const sizes = (row) => ENTRIES.map((name) => size(row[name], 9));
  const typed = table.rows.map(({ kind, numbers: n, texts, backwards, radians }) => [
    kind, sizes(n), ENTRIES.map((name) => texts[name]), backwards, [...radians].sort(),
  ]); // prettier-ignore
  const { lengths, angles, convention, exchanged = false } = table;
  const taken = [lengths, angles, convention, table.said, exchanged];
  return [taken, typed, rows.map((row) => [row.kind, ...sizes(row)]), said, size(length, 9), size(angle, 9)];
}

function words(question) {
  if (question.topic === "reading") return reading(question);
  try {
    const report = JUDGES[question.topic](question);
    const said = [report.grade, report.causes, judge.textOf(report)];
    return report.call ? [...said, report.call] : report.topic ? [...said, whole(report)] : said;
  } catch (error) {
    if (error instanceof judge.ArmError) return ["refused", [], error.message];
    throw error;
  }
}

for await (const line of createInterface({ input: process.stdin })) {
  const given = JSON.parse(line);
  judge.learn(given.sentences);
  arms = given.arms;
  process.stdout.write(`${JSON.stringify(given.questions.map(words))}\n`);
}
