// Finds the mistakes that explain an answer. A candidate is a single mistake or a pair. It explains
// the answer only if it gives every entry to the typed digits. If no candidate does, last places
// may be off by one, as after rounding on the way.

import {
  agrees,
  compareDigits,
  isRight,
  largest,
  logCountPossibleValues,
  computeSlack,
  canBeDistinguished,
} from "../digits.js";
import { capitalize, formatMessage, joinList, uncapitalize } from "../sentences.js";

// Accepted probability that some mistake fits numbers that are off by chance.
const LARGEST_CHANCE = 1e-3;
const MAX_STATED = 3; // at most this many mistakes that give the same numbers are named
// A mistake's own slack is slow to compute. It is computed only if the mistake's entries are within
// this many times the widest slack.
const NEAR_FACTOR = 3;
// A last place that may be off by one has this many possible values.
const VALUES_ONE_OFF = 3;

/** @typedef {import("../digits.js").Entries} Entries */
/**
 * A mistake or a pair of mistakes, as keys in sentences.json with the fields of their messages. A
 * field whose name begins with _ is no part of the cause's name.
 * @typedef {{ keys: string[], fields: Record<string, any>[] }} Cause
 */
/**
 * A candidate mistake. `make` returns the entries that it gives for joint values.
 * @typedef {{ cause: Cause, make: (q: number[]) => number[], steps?: any }} Mistake
 */

/**
 * A step of a computation that a mistake does otherwise, as functions by the name of the step.
 * @typedef {{ cause: Cause } & Record<string, any>} Step
 */
/**
 * Computes numbers with some steps done otherwise: returns a function from joint values to them.
 * @typedef {(step?: any) => (q: number[]) => number[]} Maker
 */

// Steps that a second function can follow. In any other step one mistake replaces the other.
const COMPOSED_STEPS = ["change", "write"];

/** List single mistakes. @param {Step[]} steps @param {Maker} maker @returns {Mistake[]} */
export const listSingleMistakes = (steps, maker) =>
  steps.map((step) => ({ cause: step.cause, steps: step, make: maker(step) }));

/**
 * List pairs of mistakes that can be made together.
 * @param {Step[]} steps @param {Maker} maker @returns {Generator<Mistake>}
 */
export function* listMistakePairs(steps, maker) {
  for (const [n, first] of steps.entries())
    for (const second of steps.slice(n + 1)) {
      const both = combineSteps(first, second);
      if (!both) continue;
      yield {
        // Computed on demand, since hardly any of thousands of pairs explains an answer.
        get cause() {
          return combineCauses(first.cause, second.cause);
        },
        steps: both,
        make: maker(both),
      };
    }
}

// Return both steps in one, or null if one would replace the other.
function combineSteps({ cause: _, ...first }, second) {
  const both = { ...first, ...second };
  for (const name of Object.keys(first).filter((key) => second[key])) {
    if (!COMPOSED_STEPS.includes(name)) return null;
    both[name] = (x, T) => second[name](first[name](x, T), T);
  }
  return both;
}

/**
 * Cache a function's results by its argument, an object or a function.
 * @param {(argument: any) => any} compute @returns {(argument: any) => any}
 */
export function cacheResults(compute) {
  const results = new WeakMap();
  return (argument) => {
    if (!results.has(argument)) results.set(argument, compute(argument));
    return results.get(argument);
  };
}

/** Return x unchanged: a step without a mistake. @returns {any} */
export const keep = (x, ..._others) => x;

/** Make the cause of a single mistake. @param {string} key @returns {Cause} */
export const makeCause = (key, fields = {}) => ({ keys: [key], fields: [fields] });

/** Make the cause of two mistakes. @param {Cause} first @param {Cause} second @returns {Cause} */
export const combineCauses = (first, second) => ({
  keys: [...first.keys, ...second.keys],
  fields: [...first.fields, ...second.fields],
});

/** Return a cause's name, as "J.frame:3 + J.millimetres". @param {Cause} cause */
export const causeName = ({ keys, fields }) =>
  keys.map((key, i) => formatPartName(key, fields[i])).join(" + ");

function formatPartName(key, fields) {
  const named = Object.entries(fields).filter(([name]) => !name.startsWith("_"));
  return [key, ...named.map(([, value]) => value)].join(":");
}

/** Return a cause's message, without a full stop. @param {Cause} cause */
export function causeMessage({ keys, fields }) {
  const [first, second] = keys.map((key, i) => formatMessage(key, fields[i]));
  return second === undefined
    ? first
    : formatMessage("and also", { first, second: uncapitalize(second) });
}

/**
 * Join the messages of causes that give the same numbers. Only the first pair is stated.
 * @param {Cause[]} causes
 */
export function joinCauseMessages(causes) {
  const count = causes[0].keys.length > 1 ? 1 : MAX_STATED;
  const [first, ...others] = [...new Set(causes.map(causeMessage))].slice(0, count);
  if (!others.length) return first;
  return formatMessage("or", { first, others: joinList(others.map(uncapitalize), "or") });
}

/**
 * Find the mistakes that explain an answer. These fit the typed digits, or else fit them with the
 * slack of q's digits, or else with last places that are off by one.
 * @param {object} answer
 * @param {Entries} answer.typed
 * @param {Entries} answer.q joint values
 * @param {number} answer.dof
 * @param {number[]} answer.expected the right entries
 * @param {number[]} answer.slack how far q's digits may move each entry
 * @param {boolean[]} answer.wrong whether each entry is wrong
 * @param {boolean} [answer.areGiven] whether the entries are given, so that nobody rounded them
 * @param {Iterable<Mistake>} candidates
 * @returns {Mistake[]} none if some candidate would fit random numbers as well
 */
export function findExplanations(answer, candidates) {
  const { typed, q, expected, slack, wrong, areGiven } = answer;
  const rightIndices = wrong.flatMap((isWrong, i) => (isWrong ? [] : [i]));
  const selectRight = (list) => rightIndices.map((i) => list[i]);
  const rightEntries = { values: selectRight(typed.values), units: selectRight(typed.units) };
  const rightSlack = selectRight(slack);
  const noSlack = expected.map(() => 0);
  const [exact, near, oneOff] = [[], [], []];
  let rivals = 0; // candidates that leave the right entries right
  for (const candidate of candidates) {
    const values = candidate.make(q.values);
    const leavesRight = agrees(rightEntries, selectRight(values), rightSlack);
    if (leavesRight && canBeDistinguished(typed, expected, values)) rivals++;
    const agreement = compareDigits(typed, values, noSlack);
    if (isRight(agreement)) exact.push(candidate);
    else if (!exact.length && agreesWithSlack(answer, candidate, values)) near.push(candidate);
    else if (agreement && !areGiven) oneOff.push(candidate);
  }
  const explanations = [exact, near, oneOff].find((mistakes) => mistakes.length) ?? [];
  const places = explanations === oneOff ? VALUES_ONE_OFF : 1;
  const allowed = { ...typed, units: typed.units.map((unit) => places * unit) };
  const logValues = logCountPossibleValues(allowed, expected, slack, wrong);
  const isChance = Math.log10(rivals) - logValues > Math.log10(LARGEST_CHANCE);
  return isChance ? [] : explanations.slice(0, MAX_STATED);
}

// Return whether a candidate's entries fit the typed ones with the slack of q's digits.
function agreesWithSlack({ typed, q, dof, expected, slack }, { make }, values) {
  const widest = Math.max(...slack);
  if (!widest) return false;
  const most = NEAR_FACTOR * widest * Math.max(1, largest(values) / largest(expected));
  const isNear = agrees(typed, values, new Array(values.length).fill(most));
  return isNear && agrees(typed, values, computeSlack(q, dof, make));
}

/** Put "perhaps" before a message if its cause leaves findings unexplained. */
export const hedgeMessage = (message, unexplained) =>
  unexplained.length
    ? capitalize(formatMessage("perhaps", { cause: uncapitalize(message) }))
    : message;
