// Cuts off the end of an answer that was not filled in yet.

const PLACEHOLDER = String.raw`(?:\?+|[-–—_]+|…|\.{2,}|tbd|todo)`;
const LABEL = String.raw`[\p{L}\p{M}_^{}\\$()\s]*\d*[})$\s]*[=:]`;
const UNFILLED_LINE = new RegExp(`^(?:${LABEL})?[\\s,;|&$]*(?:${PLACEHOLDER}[\\s,;|&$]*)*$`, "iu");

/**
 * Cut off the last lines of a text if they have a "?", a dash or nothing in place of their numbers,
 * such as "q_6 = ?".
 * @param {any} answer a text; anything else is returned as it is
 */
export function dropUnfilledEnd(answer) {
  if (typeof answer !== "string") return answer;
  const lines = answer.split("\n");
  while (lines.length > 1 && UNFILLED_LINE.test(lines.at(-1))) lines.pop();
  return lines.join("\n");
}
