// Judges questions that come by a link, for tests/test_judge.py: a line of JSON in, a line of JSON out.

import { createInterface } from "node:readline";
import { formatVerdict } from "../judge/verdict.js";
import { EMPTY, parseQuestionLink, judgeQuestion, formatQuestionLink } from "../page/src/check/question.js";

// Return the verdict, or the message of the error.
function answered(fields, arms) {
  const keys = arms.map(({ key }) => key);
  const { question, message } = parseQuestionLink(formatQuestionLink({ ...EMPTY, ...fields }), keys);
  if (!question) return { error: message };
  const { verdict, error } = judgeQuestion(question, arms);
  if (error) return { error };
  return { grade: verdict.grade, causes: verdict.causes, words: formatVerdict(verdict) };
}

for await (const line of createInterface({ input: process.stdin })) {
  const { arms, questions } = JSON.parse(line);
  process.stdout.write(`${JSON.stringify(questions.map((fields) => answered(fields, arms)))}\n`);
}
