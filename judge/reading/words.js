// Finds the few words that state how the numbers of an answer are meant: an order, a frame or
// "not". On the lines of the answer, or on the lines next to them, such words are applied, or stop
// a verdict that used another meaning. "Not" counts only on a line with numbers. All other words
// change nothing.

import { WRONG } from "../digits.js";
import { linesOf, listNextLines } from "./characters.js";
import { readLabels } from "./ordering.js";
import { ArmError, formatMessage, quoteText, tryOrNull } from "../sentences.js";

/** @typedef {import("../verdict.js").Verdict} Verdict */
/** @typedef {import("./ordering.js").StatedOrder} StatedOrder */
/**
 * Known words. `topics` are those in which they have this meaning, all if missing. `isBeside` is
 * true if they also count on the next line, and `isAcross` if they may stand on several lines.
 * `readOrder` returns the order that they state. `isApplied` returns whether the answer was taken
 * so. `stopsWrong` is true if they also stop the verdict that an answer is wrong.
 * @typedef {{ pattern: RegExp, topics?: string[], isBeside?: boolean, isAcross?: boolean,
 *   readOrder?: (words: string) => StatedOrder, stopsWrong?: boolean,
 *   isApplied?: (options: Record<string, any>, verdict: Verdict) => boolean }} KnownWords
 */

const word = (words) => new RegExp(String.raw`(?<![\p{L}\d_\\])(?:${words})(?![\p{L}\d_])`, "iu");

const TIP = "(?:tool|tip|wrist|hand|end[- ]?effector|flange|gripper|last joint)";
const FROM_TIP =
  "(?:counted|numbered|listed|ordered|starting|beginning|running|order|columns?|joints?) " +
  String.raw`from (?:the )?${TIP}|${TIP}[\s\d]*(?:->|→|\.{2,}|…|to(?: the)?)\s*base|` +
  "(?:last joint|joint [2-9]|tool|tip) first|reversed? order";
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

const PART = "(?:[- ](?:velocit(?:y|ies)|motion|part|half|block|rows?|jacobian))*";
// The halves of a Jacobian: the words for each, its letters, and the letters of its rows.
const LINEAR = {
  words: `(?:linear|translation(?:al)?|lineargeschwindigkeit)${PART}`,
  letters: "[vp]",
  ofRows: "[vpd]?",
};
const ANGULAR = {
  words: `(?:angular|rotation(?:al)?|winkelgeschwindigkeit)${PART}`,
  letters: String.raw`(?:w|ω|\\?omega)`,
  ofRows: String.raw`(?:w|ω|\\?omega|d?r)`,
};
const BEHIND_NAME = String.raw`(?:\([^()\n]*\))?\s*[=:]`;
const ABOVE = String.raw`(?: (?:above|over|on top of|before) (?:the )?|,? then | ?(?:[;,]|\\\\) ?)`;
const IS = ",? (?:(?:is|are|comes?) )?";
const nameHalf = ({ words, letters }) => String.raw`(?:J_?\{?${letters}\}?|${letters}|${words})`;
const nameRows = ({ ofRows }) =>
  String.raw`${ofRows}_?\{?[xyz]\}?(?:[\s,;|&]+${ofRows}_?\{?[xyz]\}?){2}`;

/** @param {typeof LINEAR} upper @param {typeof LINEAR} lower @returns {KnownWords[]} */
const listWordsForHalves = (upper, lower) => {
  const angularFirst = upper === ANGULAR;
  /** @type {Omit<KnownWords, "pattern">} */
  const shared = {
    topics: ["Jacobian"],
    readOrder: () => ({ angularFirst }),
    isApplied: (options, { typed }) =>
      Boolean(options.angularFirst) === angularFirst || Boolean(typed?.hasRowNames),
  };
  const [first, last] = [nameHalf(upper), nameHalf(lower)];
  const order = [
    `${first}${ABOVE}${last}`,
    `${upper.words}${IS}(?:first|on top|at the top|zuerst|oben)`,
    `${lower.words}${IS}(?:last|below|at the bottom)`,
    String.raw`${nameRows(upper)}[\s,;|&]+${nameRows(lower)}`,
  ];
  return [
    { pattern: word(order.join("|")), isBeside: true, ...shared },
    // J_w = ... J_v = ...
    {
      pattern: word(String.raw`(${first})${BEHIND_NAME}[^]*\s${last}(?=${BEHIND_NAME})`),
      isAcross: true,
      ...shared,
    },
  ];
};

const LISTS = ["Jacobian", "torques", "pose", "branches"]; // topics that apply an order of joints

/** @type {KnownWords[]} */
const KNOWN_WORDS = [
  {
    pattern: word("not|wrong|incorrect|false|typo|should|must|nicht|falsch|pas|faux"),
  },
  {
    pattern: word(FROM_TIP),
    topics: LISTS,
    isBeside: true,
    readOrder: () => ({ joints: "reversed" }),
  },
  { pattern: word(FROM_TIP), topics: ["table", "trace"], isBeside: true, stopsWrong: true },
  {
    pattern: JOINTS_IN_ORDER,
    topics: LISTS,
    isBeside: true,
    readOrder: (words) => ({ joints: (words.match(/\d+/g) ?? []).map(Number) }),
  },
  {
    pattern: TOOL_FRAME,
    topics: ["Jacobian"],
    isBeside: true,
    isApplied: ({ frame }) => Boolean(frame),
  },
  ...listWordsForHalves(ANGULAR, LINEAR),
  ...listWordsForHalves(LINEAR, ANGULAR),
  {
    pattern: word("transposed?|transponiert|rows?(?: are|:)?(?: per| for each)? joints?"),
    topics: ["Jacobian"],
    isBeside: true,
    readOrder: () => ({ transposed: true }),
  },
  {
    pattern: word(String.raw`(?:rad|deg|°) ?\/ ?s|N ?\/ ?m`), // rates and stiffnesses
    topics: ["pose", "branches", "torques"],
    isBeside: true,
  },
];

const COMMENT = /(?:#(?!\d)|%|\/\/).*/;

/**
 * Apply the known words beside the numbers of an answer to its verdict.
 * @param {string} text as it was pasted @param {Verdict} verdict of the text without these words
 * @param {Record<string, any>} options
 * @param {(stated: StatedOrder) => Verdict} judgeInOrder judges the text in a stated order
 * @returns {Verdict} the one of the stated order, unless the answer is wrong in this order
 * @throws {ArmError} if words cannot be applied, and the verdict took the numbers otherwise
 */
export function applyWords(text, verdict, options, judgeInOrder) {
  const knownWords = listWords(text, verdict, options);
  const stated = Object.assign({}, ...knownWords.map(({ order }) => order));
  if (knownWords.length && knownWords.every(({ order }) => order)) {
    const other = tryOrNull(() => judgeInOrder(stated));
    if (other && other.grade !== WRONG) return other;
  }
  const isWrong = verdict.grade === WRONG;
  const obstacle = isWrong
    ? (knownWords.find((one) => one.stopsWrong) ?? findUnknownNames(text, verdict))
    : knownWords[0];
  if (!obstacle) return verdict;
  const { words, line } = obstacle;
  throw new ArmError(formatMessage("words", { words: quoteText(words), line: line + 1 }));
}

// List the known words beside the numbers of a verdict that used another meaning.
function listWords(text, verdict, options) {
  const known = KNOWN_WORDS.filter(({ topics = [verdict.topic] }) =>
    topics.includes(verdict.topic),
  );
  const lines = linesOf(text);
  const used = listEntryLines(verdict);
  const beside = listLinesBeside(lines, used);
  const isOrderedByNames = verdict.taken.includes(formatMessage("taken: by names"));
  return beside.flatMap((line, i) =>
    known.flatMap((one) => {
      if (!one.isBeside && !one.isAcross && !used.has(line)) return [];
      const following = one.isAcross ? beside.slice(i) : [line];
      const words = findWords(one, following.map((k) => lines[k]).join("\n"));
      if (!words || one.isApplied?.(options, verdict)) return [];
      if (one.readOrder && isOrderedByNames) return [];
      return [{ words, line, order: one.readOrder?.(words), stopsWrong: one.stopsWrong }];
    }),
  );
}

/** @param {KnownWords} known @param {string} text */
function findWords({ pattern, isBeside, isAcross }, text) {
  const [whole, words = whole] =
    pattern.exec(isBeside || isAcross ? text : text.replace(COMMENT, "")) ?? [];
  return words;
}

const listEntryLines = ({ tokens, typed }) => {
  const entries = (tokens ?? typed?.tokens ?? []).filter(({ owner }) => owner === "entry");
  return new Set(entries.map(({ line }) => line));
};

// Find unknown names above the columns of an answer whose only mistake is its order. The names may
// state this order.
function findUnknownNames(text, verdict) {
  const { causes, topic, typed } = verdict;
  const lines = linesOf(text);
  const used = listEntryLines(verdict);
  const isOrderWrong = causes.some((cause) => /reversed order|exchanged/.test(cause));
  if (!used.size || !isOrderWrong || !LISTS.includes(topic)) return null;
  const [line] = listLinesBeside(lines, used);
  const names = lines[line].split(/[\s|,;&]+/).filter(Boolean);
  const areNames = names.every(
    (name) => /^\p{L}[\p{L}\d_]*$/u.test(name) && !SMALL_WORD.test(name),
  );
  const isKnown = readLabels(names.map((name) => [{ text: name, from: 0, to: 0 }]));
  if (used.has(line) || !areNames || names.length !== typed.shape.at(-1) || isKnown) return null;
  return { words: lines[line].trim(), line };
}

const SMALL_WORD = /^(?:the|of|in|at|for|my|is|a|der|die|das|von)$/i;

// List the lines from the one above an answer's first line to the one below its last line.
/** @param {string[]} lines @param {Set<number>} used lines of the answer, from 0 */
function listLinesBeside(lines, used) {
  if (!used.size) return [];
  const [first, last] = [Math.min(...used), Math.max(...used)];
  const inside = Array.from({ length: last - first + 1 }, (_, k) => first + k);
  return [...inside, ...listNextLines(lines, first, last)].sort((p, q) => p - q);
}
