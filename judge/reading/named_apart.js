// Refuses values if the joint names beside them have another order, as in "0.3 (q2), 0.8 (q1)". No
// other step reads such names.

import { ArmError, formatMessage, quoteText } from "../sentences.js";

/** @typedef {import("./owners.js").Token} Token */

const JOINT = new RegExp(
  String.raw`(?<![\p{L}\d])(?:q|θ|\\?theta|tau|τ|joint|axis|motor|Gelenk|Achse|articulation)` +
    String.raw`[ _{]{0,2}([1-9])(?!\.?\d)`,
  "giu",
);

/**
 * Raise an error if a single joint name stands before or behind each value, and the order of the
 * values is not that of these joints.
 * @param {string} text @param {Token[]} tokens @param {{ length: number }[]} rows of the answer
 */
export function refuseContraryNames(text, tokens, rows) {
  const entries = tokens.filter(({ owner }) => owner === "entry");
  const isList = rows.length === 1 || rows[0].length === 1;
  if (!isList) return;
  const ends = entries.map(({ to }) => to);
  const starts = entries.map(({ from }) => from);
  const before = starts.map((from, k) => text.slice(ends[k - 1] ?? 0, from));
  const behind = ends.map((to, k) => text.slice(to, starts[k + 1] ?? endOfLine(text, to)));
  const [joints, jointsBehind] = [before, behind].map((parts) => parts.map(findOnlyJoint));
  const named = joints.includes(null) ? jointsBehind : joints;
  if (named.includes(null)) return;
  const order = entries.map(({ index }, k) => ({ index, joint: named[k] }));
  order.sort((p, q) => p.index - q.index);
  const isContrary = order.some(({ joint }, k) => k > 0 && joint <= order[k - 1].joint);
  const line = quoteText(text.slice(starts[0], endOfLine(text, starts[0])).trim());
  if (isContrary) throw new ArmError(formatMessage("contrary names", { line }));
}

const endOfLine = (text, at) => (text.indexOf("\n", at) + text.length + 1) % (text.length + 1);

// Return the joint number that a text names, or null if it names no joint or several.
function findOnlyJoint(text) {
  const all = new Set([...text.matchAll(JOINT)].map(([, number]) => Number(number)));
  return all.size === 1 ? [...all][0] : null;
}
