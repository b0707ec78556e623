// The table of an arm of one's own, typed into a field that asks for a, alpha, d, theta.

import { say } from "../sentences.js";
import { meant, read } from "./table.js";

/**
 * Standard rows in m and rad, what was guessed of them, and whether the columns' order was. Where
 * no heads say otherwise the columns are in the field's order, if they can be; bare angles are in
 * degrees where that is the unit.
 * @param {string} text
 * @param {string} unit "deg" or "rad"
 * @param {[string, number][]} values of its symbols
 * @param {string | null} length the unit of bare lengths; guessed where there is none
 */
export function rowsOf(text, unit, values = [], length = null) {
  const asked = say("taken: columns", { columns: "a alpha d theta" });
  const tables = read(text, {}, values);
  const table = tables.find(({ said }) => said.includes(asked)) ?? tables[0];
  const angles = table.angles ?? (unit === "deg" || length ? unit : null);
  const { rows, said } = meant({ ...table, lengths: table.lengths ?? length, angles }, []);
  const guessed = table.guessed && !table.said.includes(asked);
  return { rows, said: said.filter((words) => words !== asked), guessed };
}
