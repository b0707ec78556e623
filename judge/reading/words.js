// Knows the few words that say how the numbers of an answer are meant: an order, a frame or "not".
// On the lines of the answer, or on the lines next to them, such words stop a verdict that took the
// numbers otherwise. "Not" counts only on a line with numbers. All other words change nothing.

import { linesOf } from "./characters.js";
import { ArmError, formatMessage, quoteText } from "../sentences.js";

/**
 * Known words. `topics` are those in which they have this meaning, all if missing. `isBeside` is
 * true if they also count on the next line, and `isAcross` if they may stand on several lines.
 * `isApplied` returns whether the answer was taken so.
 * @typedef {{ pattern: RegExp, topics?: string[], isBeside?: boolean, isAcross?: boolean,
 *   isApplied?: (options: Record<string, any>, words: string) => boolean }} KnownWords
 */

const word = (words) => new RegExp(String.raw`(?<![\p{L}\d_\\])(?:${words})(?![\p{L}\d_])`, "iu");

const TIP = "(?:tool|tip|wrist|hand|end[- ]?effector|flange|gripper|last joint)";
const LINEAR = String.raw`(?:J_?\{?[vp]\}?|v|(?:linear|translation(?:al)?)(?: part| rows)?)`;
const ANGULAR =
  String.raw`(?:J_?\{?(?:w|ω|\\?omega)\}?|w|ω|\\?omega|` +
  String.raw`(?:angular|rotation(?:al)?)(?: part| rows)?)`;
const BEHIND_NAME = String.raw`(?:\([^()\n]*\))?\s*[=:]`;
const ABOVE = String.raw`(?:\s+(?:above|over|on top of|before)|\s*[;,])\s+(?:the )?`;
const JOINTS_IN_ORDER =
  /\b(?:columns?|order|spalten)\b[^\n\d]{0,20}[qθ]_?\d(?:[\s,;|&]+[qθ]_?\d)+/iu;
// "in the tool frame" and "(tool frame, 4 digits)", but not "the velocity of the tool frame"
const TOOL_FRAME = new RegExp(
  String.raw`^(?!.*(?:base|world|space|frame 0))` +
    String.raw`.*((?:(?<!\p{L})(?:in|into|to|w\.?r\.?t\.?) (?:the )?|[(,] ?)` +
    String.raw`(?:tool|tip|end[- ]?effector|ee|body|hand|flange)(?:'s)? ` +
    String.raw`(?:frame|axes|coordinates)(?!\p{L}))`,
  "iu",
);

/** @type {KnownWords[]} */
const KNOWN_WORDS = [
  {
    pattern: word("not|wrong|incorrect|false|typo|should|must|nicht|falsch|pas|faux"),
  },
  {
    pattern: word(
      `(?:counted|numbered|listed|ordered|starting|beginning|order) from (?:the )?${TIP}|` +
        String.raw`${TIP}[\s\d]*(?:->|→|\.{2,}|…)\s*base|last joint first|reversed? order`,
    ),
    isBeside: true,
  },
  {
    pattern: JOINTS_IN_ORDER,
    topics: ["Jacobian"],
    isBeside: true,
    isApplied: (_, words) => isAscending(words),
  },
  {
    pattern: TOOL_FRAME,
    topics: ["Jacobian"],
    isBeside: true,
    isApplied: ({ frame }) => Boolean(frame),
  },
  {
    pattern: word(`${ANGULAR}${ABOVE}${LINEAR}|(?:angular|rotation(?:al)?)(?: part| rows)? first`),
    topics: ["Jacobian"],
    isBeside: true,
    isApplied: ({ angularFirst }) => Boolean(angularFirst),
  },
  {
    // J_w = ... J_v = ...
    pattern: word(String.raw`(${ANGULAR})${BEHIND_NAME}[^]*\s${LINEAR}(?=${BEHIND_NAME})`),
    topics: ["Jacobian"],
    isAcross: true,
    isApplied: ({ angularFirst }) => Boolean(angularFirst),
  },
  {
    pattern: word(String.raw`(?:rad|deg|°) ?\/ ?s|N ?\/ ?m`), // rates and stiffnesses
    topics: ["pose", "branches", "torques"],
    isBeside: true,
  },
];

const isAscending = (words) => {
  const joints = (words.match(/\d+/g) ?? []).map(Number);
  return joints.every((joint, k) => k === 0 || joint > joints[k - 1]);
};

const COMMENT = /(?:#(?!\d)|%|\/\/).*/;

/**
 * Raise an error if known words beside the numbers of a verdict say that they are meant otherwise.
 * @param {string} text as it was pasted @param {import("../verdict.js").Verdict} verdict
 * @param {Record<string, any>} options
 */
export function stopAtWords(text, { topic, tokens, typed }, options) {
  const entries = (tokens ?? typed?.tokens ?? []).filter(({ owner }) => owner === "entry");
  const used = new Set(entries.map(({ line }) => line));
  const known = KNOWN_WORDS.filter(({ topics = [topic] }) => topics.includes(topic));
  const lines = linesOf(text);
  const beside = listLinesBeside(lines, [...used]);
  for (const [i, k] of beside.entries()) {
    const following = beside.slice(i).map((line) => lines[line]);
    const find = (one) =>
      findWords(one, one.isAcross ? following.join("\n") : lines[k], used.has(k), options);
    const words = known.map(find).find(Boolean);
    if (words) throw new ArmError(formatMessage("words", { words: quoteText(words), line: k + 1 }));
  }
}

/** @param {KnownWords} known @param {string} line @param {boolean} isOwn */
function findWords({ pattern, isBeside, isAcross, isApplied }, line, isOwn, options) {
  if (!isBeside && !isAcross && !isOwn) return null;
  const isWhole = isBeside || isAcross;
  const [whole, words = whole] = pattern.exec(isWhole ? line : line.replace(COMMENT, "")) ?? [];
  return words && !isApplied?.(options, words) ? words : null;
}

// List the lines from the one above an answer's first line to the one below its last line. Lines
// without letters and digits are skipped.
/** @param {string[]} lines @param {number[]} used lines of the answer, from 0 */
function listLinesBeside(lines, used) {
  if (!used.length) return [];
  const hasText = (line) => /[\p{L}\d]/u.test(line);
  const [first, last] = [Math.min(...used), Math.max(...used)];
  const above = lines.findLastIndex((line, k) => k < first && hasText(line));
  const below = lines.findIndex((line, k) => k > last && hasText(line));
  const inside = Array.from({ length: last - first + 1 }, (_, k) => first + k);
  return [above, ...inside, below].filter((k) => k >= 0);
}
