// Reads texts by judge/reading, for tests/reading.py: a line of JSON in, a line of JSON out, until the input ends.

import { createInterface } from "node:readline";
import { number, parse, symbols, value } from "../judge/reading/formula.js";
import { lookup, numbers } from "../judge/reading/numbers.js";
import { readTables } from "../judge/reading/table.js";
import { convertTable } from "../judge/reading/table_conversion.js";
import { ArmError } from "../judge/sentences.js";

const tableOf = (kinds) => (table) => ({
  ...table,
  rows: table.rows.map((row) => ({ ...row, radians: [...row.radians] })),
  converted: convertTable(table, kinds),
});

const READERS = { table: readTables, numbers: (text) => numbers(text, "mine") };

// Return the processor's time to read a text, in microseconds. Unlike a clock's time it hardly
// depends on the machine's load.
function spent(reader, text) {
  const start = process.cpuUsage();
  try {
    reader(text);
  } catch (error) {
    if (!(error instanceof ArmError)) throw error;
  }
  const { user, system } = process.cpuUsage(start);
  return user + system;
}

// Return the times of a short and a long text, the least of three measurements each. The long one is read
// again only while it takes too many times as long, since other processes may have slowed it down.
function measurePace({ as, text, before = "", behind = "", counts, factor }) {
  const [short, long] = counts.map((n) => before + text.repeat(n / text.length) + behind);
  const measure = (repeated) => spent(READERS[as], repeated);
  const few = Math.min(measure(short), measure(short), measure(short));
  let many = measure(long);
  for (let k = 0; k < 2 && many >= factor * few; k++) many = Math.min(many, measure(long));
  return [few, many];
}

const JOBS = {
  pace: measurePace,
  number: ({ text }) => number(text),
  formula({ text, what, known }) {
    const tree = parse(text, what);
    return { names: [...symbols(tree)].sort(), value: known && value(tree, (name) => known[name]) };
  },
  matrix: ({ text, rows, columns }) =>
    numbers(text, "mine", undefined, undefined, { wants: [{ rows, columns }] }).values,
  tables: ({ text, options, values, kinds }) => readTables(text, options, values).map(tableOf(kinds)),
  names({ names, arm, q, values }) {
    return Object.fromEntries(lookup(arm, q, values)(new Set(names)));
  },
};

function answerQuestion({ job, ...question }) {
  try {
    return { answer: JOBS[job](question) };
  } catch (error) {
    if (error instanceof ArmError) return { refused: error.message };
    throw error;
  }
}

for await (const line of createInterface({ input: process.stdin })) {
  process.stdout.write(`${JSON.stringify(answerQuestion(JSON.parse(line)))}\n`);
}
