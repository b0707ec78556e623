// Pastes tables into the explorer and into the form's field for one's own arm, for
// tests/test_pasted_tables.py: a line of JSON in, a line of JSON out.

import { createInterface } from "node:readline";
import { ArmError } from "../judge/sentences.js";
import { EMPTY, OWN_ARM, findArm } from "../page/src/check/question.js";
import { readPastedTable } from "../page/src/paste.js";

function readInForm(table, unit) {
  try {
    return findArm({ ...EMPTY, arm: OWN_ARM, table, unit }, []);
  } catch (error) {
    if (error instanceof ArmError) return { error: error.message };
    throw error;
  }
}

for await (const line of createInterface({ input: process.stdin })) {
  const { text, unit } = JSON.parse(line);
  const answers = { explorer: readPastedTable(text), form: readInForm(text, unit) };
  process.stdout.write(`${JSON.stringify(answers)}\n`);
}
