// The script that judges Denavit-Hartenberg tables.

import { ownValues, valuesCall } from "../../../../judge/reading/values.js";
import { rowsOf } from "../../../../judge/reading/own_table.js";
import { register, registerTable } from "../checkers.js";
import { compareTables } from "../../../../judge/topics/table.js";

const OPTIONS = ["columns", "lengths", "angles", "convention"];

registerTable(rowsOf);

register("table", {
  verdict(question, arm) {
    const values = ownValues(question.values);
    return compareTables(question.answer, arm, { ...question, values });
  },
  call(question, name) {
    const said = OPTIONS.filter((key) => question[key]).map((key) => `${key}="${question[key]}"`);
    const given = ["mine", name, ...said, ...valuesCall(question.values)];
    return `checks.compare_tables(${given.join(", ")})`;
  },
});
