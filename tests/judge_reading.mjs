// What judge/reading makes of a text, for tests/reading.py: a line of JSON in, a line of JSON out, until nobody asks.

import { createInterface } from "node:readline";
import { number, parse, symbols, value } from "../judge/reading/formula.js";
import { lookup } from "../judge/reading/numbers.js";
import { meant, read } from "../judge/reading/table.js";
import { ArmError } from "../judge/sentences.js";

const tableOf = (kinds) => (table) => ({
  ...table,
  rows: table.rows.map((row) => ({ ...row, radians: [...row.radians] })),
  meant: meant(table, kinds),
});

const JOBS = {
  number: ({ text }) => number(text),
  formula({ text, what, known }) {
    const tree = parse(text, what);
    return { names: [...symbols(tree)].sort(), value: known && value(tree, (name) => known[name]) };
  },
  tables: ({ text, options, values, kinds }) => read(text, options, values).map(tableOf(kinds)),
  names({ names, arm, q, values }) {
    const { known, said } = lookup(arm, q, values);
    return { found: Object.fromEntries(known(new Set(names))), said };
  },
};

function answered({ job, ...given }) {
  try {
    return { answer: JOBS[job](given) };
  } catch (error) {
    if (error instanceof ArmError) return { refused: error.message };
    throw error;
  }
}

for await (const line of createInterface({ input: process.stdin })) {
  process.stdout.write(`${JSON.stringify(answered(JSON.parse(line)))}\n`);
}
