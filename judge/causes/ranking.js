// Which slips explain an answer: one, or two. A slip is stated only if, with it, every entry of the
// answer is right to its digits.

import { agrees, largest, room, slackOf, tellable } from "../digits.js";
import { joinList, uncapitalize, formatMessage, capitalize } from "../sentences.js";

const CHANCE = 1e-3; // that some slip of those tried would fit numbers off by chance as well
const SAID = 3; // slips that give the same numbers; nobody reads more
const NEAR = 3; // times what the digits of q may change in right entries: worth a closer look

/** @typedef {{ keys: string[], fields: Record<string, any>[] }} Cause one mistake or two */
/** @typedef {import("../digits.js").Entries} Entries */
/**
 * A mistake: what entries it makes of joint values.
 * @typedef {{ cause: Cause, make: (q: number[]) => number[], steps?: any }} Mistake
 */

/** @returns {Cause} */
export const makeCause = (key, fields = {}) => ({ keys: [key], fields: [fields] });

/** @returns {Cause} */
export const combineCauses = (one, two) => ({
  keys: [...one.keys, ...two.keys],
  fields: [...one.fields, ...two.fields],
});

// How reports and the corpus call a cause, as "J.frame:3 + J.millimetres".
export const causeName = ({ keys, fields }) =>
  keys.map((key, i) => partName(key, fields[i])).join(" + ");

function partName(key, fields) {
  const shown = Object.entries(fields).filter(([name]) => !name.startsWith("_"));
  return [key, ...shown.map(([, value]) => value)].join(":");
}

// What a cause says, without a full stop.
export function causeMessage({ keys, fields }) {
  const [first, second] = keys.map((key, i) => formatMessage(key, fields[i]));
  return second === undefined
    ? first
    : formatMessage("and also", { first, second: uncapitalize(second) });
}

// What the causes say, one after another: they give the same numbers. Of pairs the first.
export function joinCauseMessages(found) {
  const words = [...new Set(found.map(causeMessage))].slice(0, found[0].keys.length > 1 ? 1 : SAID);
  if (words.length === 1) return words[0];
  return formatMessage("or", {
    first: words[0],
    others: joinList(words.slice(1).map(uncapitalize), "or"),
  });
}

/**
 * The slips that explain an answer, given `truth` and the `slack` that it has by q, and which of
 * its entries are wrong: those that fit as typed, or else with what the digits of q may change.
 * @param {{ mine: Entries, q: Entries, dof: number, truth: number[], slack: number[], wrong:
 *   boolean[] }} answer
 * @param {Iterable<Mistake>} slips
 * @returns {Mistake[]}
 */
export function findExplanations({ mine, q, dof, truth, slack, wrong }, slips) {
  const wide = Math.max(...slack);
  const kept = wrong.flatMap((is, i) => (is ? [] : [i]));
  const those = (list) => kept.map((i) => list[i]);
  const rest = { values: those(mine.values), units: those(mine.units) };
  const allowed = those(slack);
  const [exact, near] = [[], []];
  let rivals = 0; // slips that leave right what is right
  for (const slip of slips) {
    const values = slip.make(q.values);
    if (agrees(rest, those(values), allowed) && tellable(mine, truth, values)) rivals++;
    if (agrees(mine, values)) exact.push(slip);
    else if (wide && !exact.length) {
      const most = NEAR * wide * Math.max(1, largest(values) / largest(truth));
      const look = values.map(() => most);
      if (agrees(mine, values, look) && agrees(mine, values, slackOf(q, dof, slip.make)))
        near.push(slip);
    }
  }
  const found = exact.length ? exact : near;
  if (Math.log10(rivals) - room(mine, truth, slack, wrong) > Math.log10(CHANCE)) return [];
  return found.slice(0, SAID);
}

// A cause that leaves something unexplained is no more than likely.
export const hedgeMessage = (words, left) =>
  left.length ? capitalize(formatMessage("perhaps", { cause: uncapitalize(words) })) : words;
