// Reads texts by judge/reading, for tests/reading.py: a line of JSON in, a line of JSON out, until the input ends.

import { createInterface } from "node:readline";
import { number, parse, symbols, value } from "../judge/reading/formula.js";
import { lookup, numbers } from "../judge/reading/numbers.js";
import { meant, read } from "../judge/reading/table.js";
import { ArmError } from "../judge/sentences.js";

const tableOf = (kinds) => (table) => ({
  ...table,
  rows: table.rows.map((row) => ({ ...row, radians: [...row.radians] })),
  meant: meant(table, kinds),
});

const READERS = { table: read, numbers: (text) => numbers(text, "mine") };

// Return the processor's time to read a text, the least of three, in microseconds. Unlike a clock's
// time it hardly depends on the machine's load.
function spent(reader, text) {
  const once = () => {
    const start = process.cpuUsage();
    try {
      reader(text);
    } catch (error) {
      if (!(error instanceof ArmError)) throw error;
    }
    const { user, system } = process.cpuUsage(start);
    return user + system;
  };
  return Math.min(once(), once(), once());
}

const JOBS = {
  pace: ({ as, text, counts }) =>
    counts.map((n) => spent(READERS[as], text.repeat(n / text.length))),
  number: ({ text }) => number(text),
  formula({ text, what, known }) {
    const tree = parse(text, what);
    return { names: [...symbols(tree)].sort(), value: known && value(tree, (name) => known[name]) };
  },
  tables: ({ text, options, values, kinds }) => read(text, options, values).map(tableOf(kinds)),
  names({ names, arm, q, values }) {
    return Object.fromEntries(lookup(arm, q, values)(new Set(names)));
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
