// Says in JavaScript what tests/judge_words.py asks for: JSON in (arms, sentences, questions), the words of each out.

import { readFileSync } from "node:fs";
import * as judge from "../explorer/src/judge/index.js";

const { sentences, arms, questions } = JSON.parse(readFileSync(0, "utf8"));
judge.learn(sentences);

const JUDGES = {
  jacobian: ({ typed, arm, q, options }) => judge.compareJacobian(typed, arms[arm], q, options),
  torques: ({ typed, arm, q, options }) => judge.compareTorques(typed, arms[arm], q, options),
};

function words(question) {
  try {
    const report = JUDGES[question.topic](question);
    return [report.grade, report.causes, judge.textOf(report)];
  } catch (error) {
    if (error instanceof judge.ArmError) return ["refused", [], error.message];
    throw error;
  }
}

process.stdout.write(JSON.stringify(questions.map(words)));
