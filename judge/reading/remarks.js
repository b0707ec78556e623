// Refuses an answer if a remark beside it corrects it, doubts it or takes it back, as "Correction:
// joint 3 is -93.3" and "draft, do not mark" do. The judge does not apply such remarks.

import { beginsAsOld } from "./row_names.js";
import { ArmError, formatMessage, quoteText } from "../sentences.js";

const NUMBER = String.raw`[-+\u2212]? ?\.?\d`;
// The number or the sign of "joint 3 should be -93.3" and "joint 3 should be negative".
const SIGNED = `(?:${NUMBER}|negativ|positiv|minus|plus|reversed|the opposite)`;

// Write a pattern of whole words. `behind` is the pattern of the text behind the words.
const word = (words, behind = "") => String.raw`(?<!\p{L})(?:${words})${behind}(?!\p{L})`;

const INDEX = String.raw`_?[ ({[]{0,2}\d+`;
// The part of an answer that a remark is about, such as "joint 3" and "tau_2".
const PART = [
  word("joints?|gelenk|lines?|rows?|zeile|columns?|spalte|entry|link", INDEX),
  word("no\\.|solution|theta|th|q|tau|alpha|[adj]", INDEX),
  String.raw`[θτα]_?\{?[\d₀-₉]`,
  word("(?:first|second|third|fourth|fifth|sixth|last) (?:joint|row|column|entry)"),
].join("|");
const DOUBT = [
  "wrong|incorrect|falsch|typo|mistyped|opposite sign|other sign|reversed|please read",
  "not as written|(?:positive|negative),? of course|natürlich (?:positiv|negativ)",
].join("|");
const SHOULD = "should|must|ha[sd] to|have to";
const MUST = String.raw`(?:${SHOULD}|needs to|muss) (?:be|have|read|sein)(?: an?| the)? ` + SIGNED;
const MUST_CHANGE =
  `(?:${SHOULD}|needs? to|still) be ` +
  "(?:added|subtracted|multiplied|divided|doubled|halved|negated|flipped|swapped|exchanged)";
const LEFT_OUT = "(?:do(?:es)? not reach|dropped|rejected|left out|invalid|(?:is|are) not valid)";
const NEAR = "[^?!]{0,120}"; // within one sentence that asks nothing
const CORRECTION = "(?:correction|corrected|erratum|errata|korrektur|edit|sorry)";

const compile = (patterns) => patterns.map((pattern) => new RegExp(pattern, "iu"));

const REMARKS = compile([
  `(?:${PART})${NEAR}(?:${word(DOUBT)}(?! ?[?])|${MUST})`,
  `${word(DOUBT)}${NEAR}(?:${PART})`,
  String.raw`^\W*${CORRECTION}\b${NEAR}(?:${PART})${NEAR}${NUMBER}`,
  word("(?:do not|don't) (?:use|mark|grade|count)|not my (?:final |own )?answer|discarded"),
  String.raw`^\W*(?:draft(?!\p{L})|(?:wrong, )?ignore(?: this| these)?[:. ]*$)`,
  word("still (?:missing|to be divided)|to be multiplied by|divide by the gear"),
  word(MUST_CHANGE),
  `${word("(?:solutions?|branch(?:es)?|answers?|rows?|nos?\\.?) \\d")}${NEAR}${word(LEFT_OUT)}`,
  `${word("only (?:the )?(?:first|last|rows?|solutions?)")}${NEAR}${word("(?:is|are) my")}`,
  String.raw`in multiples of (?:pi|π)`,
]);

// On a line with an entry, a remark is about the entry even if it does not name it.
const BESIDE_ENTRY = compile([
  word(DOUBT),
  MUST,
  String.raw`[✗✘❌]|^\W*not(?!\p{L})`,
  String.raw`\((?:no|non|nein|rather|actually)(?!\p{L})[^)]{0,80}\d`,
]);

const COMMENT = /(?:#(?!\d)|%|\/\/).*/;

/**
 * Refuse an answer if a remark in the text would change it.
 * @param {string[]} lines of the pasted text
 * @param {import("./owners.js").Token[]} tokens @param {string} what the answer
 */
export function refuseRemark(lines, tokens, what) {
  const entries = tokens.filter(({ owner }) => owner === "entry");
  const ownLines = new Set(entries.map(({ line }) => line));
  const line = lines.findIndex((text, k) => isRemark(text, ownLines.has(k)));
  if (line < 0) return;
  const fields = { what, line: line + 1, quoted: quoteText(lines[line].trim()) };
  throw new ArmError(formatMessage("remark", fields));
}

/**
 * Return whether a line has a remark that changes the answer. Comments change nothing.
 * @param {string} line @param {boolean} hasEntry whether the line holds an entry
 */
export function isRemark(line, hasEntry) {
  const text = line.replace(COMMENT, "");
  if (!hasEntry && beginsAsOld(text)) return false;
  return [...REMARKS, ...(hasEntry ? BESIDE_ENTRY : [])].some((pattern) => pattern.test(text));
}
