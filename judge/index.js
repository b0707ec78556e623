// The judge: what is said of an answer, in the page and, through helpers.checks, in Python.

export { compareJacobian } from "./topics/jacobian.js";
export { compareTorques } from "./topics/torques.js";
export { compareTables } from "./topics/table.js";
export { linesOf, MARKS, textOf } from "./report.js";
export { ArmError, learn } from "./sentences.js";
