// Lists entries that have names, and the brackets in which they stand.

/** @typedef {import("./spans.js").Span} Span */
/**
 * A bracket of a text: its character, the text before it and inside it; `hasPairs` if it holds
 * pairs of names and values and no bracket inside it does. `start` is where `body` begins.
 * @typedef {{ from: number, to: number, open: string, before: string, body: string, start: number,
 *   hasPairs: boolean }} Bracket
 */
/** An entry, with the stretches of the text it was typed in; none if it was left out.
 * @typedef {{ text: string, spans: Span[] }} Entry
 */
/**
 * Rows of entries below their headers; `parts` are the stretches of the text that hold them, and
 * `findUnread` finds text of the table that no entry used.
 * @typedef {{ rows: Entry[][], headers: string[], parts: Span[], assumptions?: string[],
 *   convention?: string, findUnread: () => Span | null }} EntryRows
 */

const NEAR = 40; // characters before a bracket that may name it

/** List the brackets of a text. @param {string} text @returns {Bracket[]} */
export function listBrackets(text) {
  const [brackets, unclosed] = [[], []];
  for (let at = 0; at < text.length; at++) {
    const character = text[at];
    if ("[({".includes(character))
      unclosed.push({ from: at, open: character, hasSign: false, isOuter: false });
    else if ("=:".includes(character) && unclosed.length > 0) unclosed.at(-1).hasSign = true;
    const opening = "[({"["])}".indexOf(character)];
    const mate = opening ? unclosed.findLastIndex(({ open }) => open === opening) : -1;
    if (mate >= 0) {
      const [{ from, open, hasSign, isOuter }] = unclosed.splice(mate);
      const before = text.slice(Math.max(0, from - NEAR), from);
      if (unclosed.length && (hasSign || isOuter)) unclosed.at(-1).isOuter = true;
      const [start, body] = [from + 1, text.slice(from + 1, at)];
      brackets.push({ from, to: at + 1, open, before, body, start, hasPairs: hasSign && !isOuter });
    }
  }
  return brackets.sort((left, right) => left.from - right.from);
}

/**
 * Make an entry of a stretch of a text, without blanks and quotes around it.
 * @param {string} text of the stretch @param {number} from where it begins
 * @returns {Entry}
 */
export function makeEntry(text, from) {
  const inner = text.trim().replace(/^['"]+|['"]+$/g, "");
  const start = from + text.indexOf(inner);
  return { text: inner, spans: [{ from: start, to: start + inner.length }] };
}

/** Make an entry that the text leaves out. @param {string} text @returns {Entry} */
export const makeUntyped = (text) => ({ text, spans: [] });

/** List the entries between commas, else between blanks. @returns {Entry[]} */
export function listEntries(body, start) {
  const pattern = /[,;\n]/.test(body.trim()) ? /[^,;\n]+/g : /\S+/g;
  return [...body.matchAll(pattern)]
    .map(({ 0: text, index }) => makeEntry(text, start + index))
    .filter(({ text }) => text);
}
