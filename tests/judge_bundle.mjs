// The judge's bundle under Node.js, for tests/node.py: a question as a line of JSON in, its answer as a line of JSON out.

import { readFileSync } from "node:fs";
import { createInterface } from "node:readline";
import { runInThisContext } from "node:vm";

const bundle = new URL("../helpers/checks/judge.js", import.meta.url);
runInThisContext(`${readFileSync(bundle, "utf8")}; globalThis.ArmJudge = ArmJudge;`);

function answer(question) {
  try {
    return globalThis.ArmJudge.ask(question);
  } catch (error) {
    return JSON.stringify({ crash: String(error.stack) });
  }
}

for await (const line of createInterface({ input: process.stdin })) process.stdout.write(`${answer(line)}\n`);
