// The script that judges Denavit-Hartenberg tables.

import { register } from "../registry.js";
import { compareTables } from "../tables.js";

const OPTIONS = ["columns", "lengths", "angles", "convention"];

register("table", {
  verdict: (question, arm) => compareTables(question.answer, arm, question),
  call(question, name) {
    const said = OPTIONS.filter((key) => question[key]).map((key) => `${key}="${question[key]}"`);
    return `checks.compare_tables(${["mine", name, ...said].join(", ")})`;
  },
});
