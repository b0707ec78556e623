// The script that judges Denavit-Hartenberg tables.

import { ownValues } from "../../../../judge/reading/values.js";
import { rowsOf } from "../../../../judge/reading/own_table.js";
import { readers, register } from "../checkers.js";
import { compareTables } from "../../../../judge/topics/table.js";

readers.rowsOf = rowsOf;

register("table", (question, arm) =>
  compareTables(question.answer, arm, { ...question, values: ownValues(question.values) }),
);
