// Cuts off the end of an answer that was not filled in yet.

/** The marks of any case that stand in place of a number which is not known yet. */
export const PLACEHOLDER = [
  String.raw`\?+|[-–—_]+|…|\.{2,}|\$?\\[lcdv]?dots\$?`,
  "tbd|todo|none|nan|null|xx+",
].join("|");
const ONLY_PLACEHOLDER = new RegExp(`^(?:${PLACEHOLDER})$`, "i");
const LABEL = /^[\p{L}\p{M}_^{}\\$()\s]{0,40}\d{0,3}[})$\s]{0,9}[=:]/u;

/**
 * Cut off the last lines of a text if they have a "?", a dash or nothing in place of their numbers,
 * such as "q_6 = ?".
 * @param {any} answer a text; anything else is returned as it is
 */
export function dropUnfilledEnd(answer) {
  if (typeof answer !== "string") return answer;
  const lines = answer.split("\n");
  while (lines.length > 1 && isUnfilled(lines.at(-1))) lines.pop();
  return lines.join("\n");
}

// Return whether a line holds a label and placeholders only.
const isUnfilled = (line) =>
  line
    .replace(LABEL, "")
    .split(/[\s,;|&$]+/)
    .every((word) => !word || ONLY_PLACEHOLDER.test(word));
