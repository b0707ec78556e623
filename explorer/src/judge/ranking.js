// Which mistakes explain an answer, the port of helpers/checks/ranking.py; and the report.

import { RIGHT, ROUNDED, SO_FAR } from "./digits.js";
import { listed, lower, say } from "./say.js";

const SHARE = 0.6; // of the wrong entries that a single mistake must gain
const PAIR_SHARE = 0.85;
const ODD = 0.7; // what an entry that stays unexplained weighs against a second mistake

/** @typedef {{ keys: string[], fields: Record<string, any>[] }} Cause one mistake or two */

/** @returns {Cause} */
export const cause = (key, fields = {}) => ({ keys: [key], fields: [fields] });

/** @returns {Cause} */
export const both = (one, two) => ({
  keys: [...one.keys, ...two.keys],
  fields: [...one.fields, ...two.fields],
});

// How reports and the corpus call a cause, as "J.frame:3 + J.millimetres".
export const nameOf = ({ keys, fields }) => keys.map((key, i) => partName(key, fields[i])).join(" + ");

function partName(key, fields) {
  if ("_of" in fields) return fields._of;
  const shown = Object.entries(fields).filter(([name]) => !name.startsWith("_"));
  return [key, ...shown.map(([, value]) => value)].join(":");
}

// What a cause says, without a full stop.
export function wordsOf({ keys, fields }) {
  const [first, second] = keys.map((key, i) => say(key, fields[i]));
  return second === undefined ? first : say("and also", { first, second: lower(second) });
}

// The causes that explain mine within the band, best first, and the entries that the best leaves; null where none does.
export function explain(mine, right, band, causes, made, weight = ODD) {
  const n = mine.length;
  const wrong = mine.map((x, i) => Math.abs(x - right[i]) > band[i]);
  const count = wrong.filter(Boolean).length;
  const named = [];
  made.forEach((A, k) => {
    let [gained, odd] = [0, 0];
    for (let i = 0; i < n; i++) {
      if (Math.abs(mine[i] - A[i]) <= band[i]) gained += wrong[i] ? 1 : 0;
      else {
        odd++;
        if (!wrong[i]) gained--;
      }
    }
    const edits = causes[k].keys.length;
    const least = edits > 1 ? Math.max(4, PAIR_SHARE * count) : Math.max(3, SHARE * count);
    if ((!odd && count) || gained >= least) named.push({ k, cost: edits + weight * odd });
  });
  if (!named.length) return null;
  const rounded = (x) => Math.round(x * 1e6);
  named.sort((p, q) => rounded(p.cost) - rounded(q.cost) || p.k - q.k);
  const best = made[named[0].k];
  return {
    causes: named.filter(({ cost }) => cost === named[0].cost).map(({ k }) => causes[k]),
    odd: mine.map((x, i) => Math.abs(x - best[i]) > band[i]),
  };
}

export const complete = (found) => Boolean(found) && !found.odd.includes(true);

// What the causes say: single ones that explain equally well one after another, of pairs the first.
export function several(found, most = 3) {
  const words = [...new Set(found.map(wordsOf))].slice(0, found[0].keys.length === 1 ? most : 1);
  if (words.length === 1) return words[0];
  return say("or", { first: words[0], others: listed(words.slice(1).map(lower), "or") });
}

// The one with the least cost.
export function better(all, weight = ODD) {
  const cost = (f) => f.causes[0].keys.length + weight * f.odd.filter(Boolean).length;
  return all.filter(Boolean).reduce((best, f) => (best && cost(best) <= cost(f) ? best : f), null);
}

export const MARKS = { [RIGHT]: "✔", [SO_FAR]: "◐", [ROUNDED]: "≈", wrong: "✘" };

/**
 * One report for all topics, as helpers/checks/verdict.py.
 * @typedef {{ what: string, where: string, words: string }} Finding
 * @typedef {object} Report
 * @property {string} topic
 * @property {string} arm
 * @property {string} grade
 * @property {string} headline
 * @property {Finding[]} findings
 * @property {string[]} causes
 * @property {string[]} taken
 * @property {string[]} notes
 * @property {import("./door.js").Typed} [typed] what was read, in its own order
 * @property {boolean[]} [wrong] which of its entries are wrong
 * @property {Record<string, any>} [figures] measured numbers by name
 */

// Everything below the headline, a sentence each.
export const linesOf = ({ findings, taken, notes }) => [
  ...findings.filter(({ what }) => what !== "cause").map(({ words }) => words),
  ...taken.map((words) => `Taken as ${words}`),
  ...notes.map((words) => `Note: ${words}`),
];

// What Python's str(report) says.
export const textOf = (report) => [report.headline, ...linesOf(report).map((line) => `- ${line}`)].join("\n");
