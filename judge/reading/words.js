// Knows the few words that say how the numbers of an answer are meant: an order, a frame or
// "not". On the lines of the answer, or on the lines next to them, such words stop a verdict that
// took the numbers otherwise. "Not" counts on a line with numbers of the answer only. All other words
// change nothing.

import { linesOf } from "./characters.js";
import { ArmError, formatMessage, quoteText } from "../sentences.js";

/** @typedef {import("../verdict.js").Verdict} Verdict */
/**
 * Known words. `topic` is the only topic in which they have this meaning, `isBeside` is true if they
 * also count on the next line, and `isApplied` returns whether the options say the same.
 * @typedef {{ pattern: RegExp, topic?: string, isBeside?: boolean,
 *   isApplied?: (options: Record<string, any>, words: string) => boolean }}
 *   KnownWords
 */

const TIP = "(?:tool|tip|wrist|hand|end[- ]?effector|flange|gripper|last joint)";
const LINEAR = String.raw`(?:J_?\{?[vp]\}?|v|(?:linear|translation(?:al)?)(?: part| rows)?)`;
const ANGULAR =
  String.raw`(?:J_?\{?(?:w|ω|\\?omega)\}?|w|ω|\\?omega|` +
  String.raw`(?:angular|rotation(?:al)?)(?: part| rows)?)`;
const ABOVE = String.raw`(?:\s+(?:above|over|on top of|before)|\s*[;,])\s+(?:the )?`;
const word = (words) => new RegExp(String.raw`(?<![\p{L}\d_\\])(?:${words})(?![\p{L}\d_])`, "iu");

const COMMENT = /(?:#(?!\d)|%|\/\/).*/;
const isAscending = (words) =>
  [...words.matchAll(/\d+/g)].every(
    ([joint], k, all) => !k || Number(joint) > Number(all[k - 1][0]),
  );

/** @type {KnownWords[]} */
const KNOWN_WORDS = [
  {
    pattern: word(
      "not|wrong|incorrect|false|correct(?:ed|ion)|typo|should|must|nicht|falsch|pas|faux",
    ),
  },
  {
    pattern: word(
      `(?:counted|numbered|listed|ordered|starting|beginning|order) from (?:the )?${TIP}|` +
        String.raw`${TIP}[\s\d]*(?:->|→|\.{2,}|…)\s*base|last joint first|reversed? order`,
    ),
    isBeside: true,
  },
  ...[
    {
      pattern: /\b(?:columns?|order|spalten)\b[^\n\d]{0,20}[qθ]_?\d(?:[\s,;|&]+[qθ]_?\d)+/iu,
      isApplied: (_, words) => isAscending(words),
    },
    {
      // "in the tool frame" and "(tool frame, 4 digits)", but not "the velocity of the tool frame"
      pattern: new RegExp(
        String.raw`^(?!.*(?:base|world|space|frame 0)).*((?:(?<!\p{L})(?:in|into|to|w\.?r\.?t\.?) (?:the )?|[(,] ?)` +
          String.raw`(?:tool|tip|end[- ]?effector|ee|body|hand|flange)(?:'s)? (?:frame|axes|coordinates)(?!\p{L}))`,
        "iu",
      ),
      isApplied: ({ frame }) => Boolean(frame),
    },
    {
      pattern: word(
        `${ANGULAR}${ABOVE}${LINEAR}|(?:angular|rotation(?:al)?)(?: part| rows)? first`,
      ),
      isApplied: ({ angularFirst }) => Boolean(angularFirst),
    },
  ].map((words) => ({ ...words, topic: "Jacobian", isBeside: true })),
];

/**
 * Raise an error if known words beside the numbers of a verdict say that they are meant otherwise.
 * @param {string} text as it was pasted @param {Verdict} verdict @param {Record<string, any>} options
 */
export function stopAtWords(text, { topic, tokens, typed }, options) {
  const entries = (tokens ?? typed?.tokens ?? []).filter(({ owner }) => owner === "entry");
  const used = new Set(entries.map(({ line }) => line));
  const lines = linesOf(text);
  for (const k of listLinesBeside(lines, [...used]))
    for (const { pattern, topic: only = topic, isBeside, isApplied } of KNOWN_WORDS) {
      const line = isBeside ? lines[k] : lines[k].replace(COMMENT, "");
      const [whole, words = whole] = (only === topic && pattern.exec(line)) || [];
      if (!words || !(isBeside || used.has(k)) || isApplied?.(options, words)) continue;
      throw new ArmError(formatMessage("words", { words: quoteText(words), line: k + 1 }));
    }
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
