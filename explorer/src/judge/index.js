// The judge: what helpers.checks says of an answer, in the page. Its words are Python's, letter by letter.

export { compareJacobian } from "./jacobian.js";
export { compareTorques } from "./torques.js";
export { compareTables } from "./tables.js";
export { linesOf, MARKS, textOf } from "./ranking.js";
export { ArmError, learn } from "./say.js";
