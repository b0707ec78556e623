// Switches the decisions of the judge one at a time: node tests/ablate.mjs QUESTIONS PATHS [SECONDS] (see ablate.py).

import { Linter } from "eslint";
import { cpSync, mkdtempSync, readdirSync, readFileSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { Script } from "node:vm";

const ROOT = new URL("..", import.meta.url).pathname;
const EXPLORER = ["entry", "paste", "corrections", "units", "joint_vectors", "formulas", "drawn_formulas", "tables", "surroundings"]; // tests of tests/explorer that read texts
const [, , QUESTIONS, PATHS, SECONDS = "3"] = process.argv; // processor time for a change, then it is not decided
const changes = []; // Patches of a single decision each: { where, what, texts }, with the texts that it may change
const sites = []; // position and changes of each call that the copy contains
let active = null; // the change that is switched on
let textIndex = -1; // index of the text that is judged without a change

const addChange = (site, what, more) => changes[changes.push({ where: site.where, what, texts: new Set(), ...more }) - 1];
const note = (change) => textIndex >= 0 && change.texts.add(textIndex);

// A condition. The right operand of && or || is only forced where it is true or false.
globalThis.decide = (id, value) => {
  for (const change of sites[id].forced) {
    if (change === active) return change.value;
    if (Boolean(value) !== change.value && (typeof value === "boolean" || !change.isLast)) note(change);
  }
  return value;
};

// A list of spellings: an array, object, Map or Set.
globalThis.list = (id, entries) => {
  const isDropped = (key) => {
    const change = (sites[id][`:${String(key)}`] ??= addChange(sites[id], `no entry ${String(key)}`));
    note(change);
    return change === active;
  };
  const { has, get } = Object.getPrototypeOf(entries);
  if (has) {
    entries.has = (key) => has.call(entries, key) && !isDropped(key);
    entries.get = (key) => (entries.has(key) ? get.call(entries, key) : undefined);
    return entries;
  }
  const isPresent = (object, key) => key in object && !(Object.hasOwn(object, key) && key !== "length" && isDropped(key));
  return new Proxy(entries, { has: isPresent, get: (object, key) => (isPresent(object, key) ? object[key] : undefined) });
};

class TracedPattern extends RegExp {
  constructor(pattern, flags, patternChanges = pattern.changes) {
    super(pattern, flags);
    this.changes = patternChanges;
  }
  exec(string) {
    const start = this.lastIndex;
    const match = super.exec(string);
    const end = this.lastIndex;
    for (const change of this.changes) {
      if (change !== active && (textIndex < 0 || change.texts.has(textIndex))) continue;
      change.pattern.lastIndex = start;
      const other = change.pattern.exec(string);
      if (change === active) this.lastIndex = change.pattern.lastIndex;
      if (change === active) return other;
      if (JSON.stringify([other, other?.index]) !== JSON.stringify([match, match?.index])) note(change);
    }
    this.lastIndex = end;
    return match;
  }
}

globalThis.trace = (id, pattern) => {
  const variants = () => [["never matches", "(?!)"], ...dropAlternatives(pattern.source)];
  const asChange = ([what, source]) => addChange(sites[id], `${pattern} ${what}`, { pattern: new RegExp(source, pattern.flags) });
  sites[id][`:${pattern}`] ??= variants().map(asChange);
  return new TracedPattern(pattern, pattern.flags, sites[id][`:${pattern}`]);
};

// Return a regular expression without each of its alternatives.
function dropAlternatives(source) {
  const [groups, variants] = [[[0]], []];
  for (const { 0: sign, index } of `${source})`.matchAll(/\\.|\[(?:\\.|[^\]\\])*\]|\((?:\?(?:[:=!]|<[=!]|<\w+>))?|[|)]/gs)) {
    if (sign[0] === "(") groups.push([index + sign.length]);
    if (sign === "|") groups.at(-1).push(index + 1);
    if (sign !== ")") continue;
    const starts = [...groups.pop(), index + 1];
    for (let k = 0; starts.length > 2 && k < starts.length - 1; k++) {
      const [from, to] = [starts[k], starts[k + 1] - 1];
      variants.push([`without ${source.slice(from, to)}`, source.slice(0, k ? from - 1 : from) + source.slice(k ? to : to + 1)]);
    }
  }
  return variants;
}

// Return the code of a module with a call around each of its decisions.
function instrument(file, code) {
  const linter = new Linter();
  linter.verify(code, {});
  const { ast, visitorKeys } = linter.getSourceCode();
  const [opens, closes] = [{}, {}];
  const wrap = (call, { range: [from, to], loc }, values = [], isLast = false) => {
    const site = { where: `${file}:${loc.start.line}` };
    site.forced = values.map((value) => addChange(site, `${code.slice(from, to)} is ${value}`, { value, isLast }));
    (opens[from] ??= []).push(`${call}(${sites.push(site) - 1},(`);
    (closes[to] ??= []).push("))");
  };
  const visit = (node, parent) => {
    const { type, operator, callee } = node;
    if (/^(If|Cond)/.test(type)) wrap("decide", node.test, [true, false]);
    for (const side of type === "LogicalExpression" && operator !== "??" ? ["left", "right"] : [])
      if (node[side].operator !== operator) wrap("decide", node[side], [operator === "&&"], side === "right");
    if (parent?.callee?.property?.name === "filter" && node.body && node.body.type !== "BlockStatement") wrap("decide", node.body, [true]);
    if (node.regex || (type === "NewExpression" && callee.name === "RegExp")) wrap("trace", node);
    const start = type === "VariableDeclaration" && /^(Prog|Exp)/.test(parent.type) && node.declarations[0].init;
    const isFilled = /^(Map|Set)$/.test(start?.callee?.name) && start.arguments.length; // an empty one is filled later
    const isList = start && (/^(Array|Object)/.test(start.type) || isFilled);
    if (isList && !/\/[gimuy]*[,\]]|RegExp|=>/.test(code.slice(...start.range))) wrap("list", start);
    for (const child of visitorKeys[type].flatMap((key) => node[key] ?? [])) if (child) visit(child, node);
  };
  visit(ast, null);
  return [...code.split(""), ""].map((character, k) => (closes[k] ?? []).join("") + (opens[k] ?? []).join("") + character).join("");
}

// Copy the project to a folder, with calls in the modules whose paths begin so; return runs of the texts.
async function loadTexts(questions, paths, copy) {
  for (const name of ["judge", "page", "tests/explorer", "tests/judge_reading.mjs", "tests/cases.json", "package.json"])
    cpSync(ROOT + name, copy + name, { recursive: true });
  symlinkSync(`${ROOT}node_modules`, `${copy}node_modules`);
  const edit = (file, change) => writeFileSync(copy + file, change(readFileSync(copy + file, "utf8")));
  const modules = readdirSync(`${copy}judge`, { recursive: true }).map((name) => `judge/${name}`);
  const isChosen = (file) => file.endsWith(".js") && paths.some((path) => file.startsWith(path));
  for (const file of modules.filter(isChosen)) edit(file, (code) => instrument(file, code));
  edit("tests/judge_reading.mjs", (code) => `${code.split("for await")[0]}export { answerQuestion };`);
  for (const name of EXPLORER)
    edit(`tests/explorer/${name}.test.mjs`, (code) => code.replace(/import.*"node:test";/, "const test = (_, run) => globalThis.runs.push(run);"));
  const { ask } = await import(`${copy}judge/index.js`);
  const { answerQuestion } = await import(`${copy}tests/judge_reading.mjs`);
  const read = (question) => JSON.stringify(answerQuestion(JSON.parse(question)));
  const lines = readFileSync(questions, "utf8").split("\n").map((line) => JSON.parse(line));
  globalThis.runs = lines.map(({ script, question }) => () => (script === "judge_bundle.mjs" ? ask : read)(question));
  for (const name of EXPLORER) await import(`${copy}tests/explorer/${name}.test.mjs`);
  return globalThis.runs;
}

const script = new Script("globalThis.answer()");
function judge(run, milliseconds) {
  globalThis.answer = run;
  try {
    return script.runInThisContext({ timeout: milliseconds });
  } catch (error) {
    return String(error);
  }
}

const seconds = () => process.cpuUsage().user / 1e6;
const copy = `${mkdtempSync(`${tmpdir()}/ablate-`)}/`;
process.on("exit", () => rmSync(copy, { recursive: true }));
const texts = (await loadTexts(QUESTIONS, PATHS.split(","), copy)).map((run, k) => {
  textIndex = k;
  const start = seconds();
  return { run, answer: judge(run, 9e5), cost: seconds() - start };
});
textIndex = -1;
const counts = {};
for (active of changes) {
  const chosen = [...active.texts].map((k) => texts[k]).sort((one, other) => one.cost - other.cost);
  const end = seconds() + Number(SECONDS);
  const isFelt = ({ run, answer, cost }) => seconds() < end && judge(run, Math.ceil(3000 + 50000 * cost)) !== answer;
  const result = chosen.some(isFelt) ? "felt" : !chosen.length ? "not reached" : seconds() < end ? "not felt" : "not decided";
  counts[result] = (counts[result] ?? 0) + 1;
  if (result !== "felt") console.log(`${active.where}: ${active.what}: ${result}, ${chosen.length} texts`);
}
console.log(`${changes.length} decisions, ${texts.length} texts, ${Math.round(seconds())} s: ${JSON.stringify(counts)}`);
