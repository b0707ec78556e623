// The script that judges Denavit-Hartenberg tables.

import { ownValues } from "../../../../judge/reading/values.js";
import { rowsOf } from "../../../../judge/reading/own_table.js";
import { register, registerTable } from "../checkers.js";
import { compareTables } from "../../../../judge/topics/table.js";

registerTable(rowsOf);

register("table", (question, arm) =>
  compareTables(question.answer, arm, { ...question, values: ownValues(question.values) }),
);
