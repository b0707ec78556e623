// Corrections of a pasted text: a number is changed, or put behind a # because it is no entry.

/**
 * Replace a stretch of the text.
 * @param {string} text
 * @param {{ from: number, to: number }} span
 * @param {string} replacement
 */
export const replaceSpan = (text, { from, to }, replacement) =>
  text.slice(0, from) + replacement + text.slice(to);

/**
 * Move a number behind a # at the end of its line, where it does not count.
 * @param {string} text
 * @param {{ from: number, to: number }} span
 */
export function putBehindHash(text, span) {
  const { start, end } = findLine(text, span);
  const word = text.slice(span.from, span.to);
  const rest = text.slice(start, span.from) + text.slice(span.to, end);
  if (!/\d/.test(rest)) return replaceSpan(text, { from: start, to: start }, "# ");
  const line = `${rest.replace(/\s+$/, "")}${rest.includes("#") ? "" : "  #"} ${word}`;
  return replaceSpan(text, { from: start, to: end }, line);
}

/**
 * Put # before lines that hold a number, so that they do not count.
 * @param {string} text
 * @param {(line: number) => boolean} isUnwanted by the number of the line, from 0
 */
export const commentLines = (text, isUnwanted) =>
  text
    .split("\n")
    .map((line, i) => (isUnwanted(i) && /\d/.test(line) ? `# ${line}` : line))
    .join("\n");

function findLine(text, { from, to }) {
  const start = text.lastIndexOf("\n", from - 1) + 1;
  const end = text.indexOf("\n", to);
  return { start, end: end < 0 ? text.length : end };
}
