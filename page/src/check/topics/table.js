// Check Denavit-Hartenberg tables.

import { readSymbolValues } from "../../../../judge/reading/values.js";
import { compareTables } from "../../../../judge/topics/table.js";

/** @type {import("../question.js").Checker} */
export const checkTable = (question, arm) =>
  compareTables(question.answer, arm, { ...question, values: readSymbolValues(question.values) });
