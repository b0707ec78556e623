// Finds the mistakes that explain an answer. A candidate is a single mistake or a pair. It explains
// the answer only if it gives every entry to the typed digits.

import {
  agrees,
  largest,
  logCountPossibleValues,
  computeSlack,
  canBeDistinguished,
} from "../digits.js";
import { capitalize, formatMessage, joinList, uncapitalize } from "../sentences.js";

// Accepted probability that some mistake fits numbers that are off by chance.
const LARGEST_CHANCE = 1e-3;
const MAX_STATED = 3; // mistakes that give the same numbers; nobody reads more
// A mistake's own slack is slow to compute. It is computed only if the mistake's entries are within
// this many times the widest slack.
const NEAR_FACTOR = 3;

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
 * slack of q's digits.
 * @param {object} answer
 * @param {Entries} answer.typed
 * @param {Entries} answer.q joint values
 * @param {number} answer.dof
 * @param {number[]} answer.expected the right entries
 * @param {number[]} answer.slack how far q's digits may move each entry
 * @param {boolean[]} answer.wrong whether each entry is wrong
 * @param {Iterable<Mistake>} candidates
 * @returns {Mistake[]} none if some candidate would fit random numbers as well
 */
export function findExplanations({ typed, q, dof, expected, slack, wrong }, candidates) {
  const widest = Math.max(...slack);
  const largestExpected = largest(expected);
  const rightIndices = wrong.flatMap((isWrong, i) => (isWrong ? [] : [i]));
  const selectRight = (list) => rightIndices.map((i) => list[i]);
  const rightEntries = { values: selectRight(typed.values), units: selectRight(typed.units) };
  const rightSlack = selectRight(slack);
  const [exact, near] = [[], []];
  let rivals = 0; // candidates that leave the right entries right
  for (const candidate of candidates) {
    const values = candidate.make(q.values);
    const leavesRight = agrees(rightEntries, selectRight(values), rightSlack);
    if (leavesRight && canBeDistinguished(typed, expected, values)) rivals++;
    if (agrees(typed, values)) exact.push(candidate);
    else if (widest && !exact.length) {
      const most = NEAR_FACTOR * widest * Math.max(1, largest(values) / largestExpected);
      const isNear = agrees(typed, values, new Array(values.length).fill(most));
      if (isNear && agrees(typed, values, computeSlack(q, dof, candidate.make)))
        near.push(candidate);
    }
  }
  const explanations = exact.length ? exact : near;
  if (
    Math.log10(rivals) - logCountPossibleValues(typed, expected, slack, wrong) >
    Math.log10(LARGEST_CHANCE)
  )
    return [];
  return explanations.slice(0, MAX_STATED);
}

/** Put "perhaps" before a message if its cause leaves findings unexplained. */
export const hedgeMessage = (message, unexplained) =>
  unexplained.length
    ? capitalize(formatMessage("perhaps", { cause: uncapitalize(message) }))
    : message;
