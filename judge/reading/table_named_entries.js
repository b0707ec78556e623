// Lists the brackets of a text, and the entries inside a bracket such as (d=0.3, a=0).

/** @typedef {import("./spans.js").Span} Span */
/**
 * A bracket of a text. `open` is its opening character, `before` the text before it, and `body` the
 * text inside, which begins at `start`. `hasPairs` is true if the bracket holds "=" or ":" outside
 * of inner brackets, and no inner bracket does.
 * @typedef {{ from: number, to: number, open: string, before: string, body: string, start: number,
 *   hasPairs: boolean }} Bracket
 */
/**
 * An entry and its spans in the text. An entry that the text leaves out has no spans.
 * @typedef {{ text: string, spans: Span[] }} Entry
 */
/**
 * The rows and headers of a table. `parts` are the spans of its rows in the text, and `unread` is
 * an argument of a call that was not read.
 * @typedef {{ rows: Entry[][], headers: string[], parts: Span[], assumptions?: string[],
 *   convention?: string, unread?: Span }} EntryRows
 */

const NEAR = 40; // characters before a bracket that may hold its name

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
 * Make an entry of a piece of the text, without blanks and quotes around it.
 * @param {string} text of the piece @param {number} from its position in the whole text
 * @returns {Entry}
 */
export function makeEntry(text, from) {
  const inner = text.trim().replace(/^['"]+|['"]+$/g, "");
  const start = from + text.indexOf(inner);
  return { text: inner, spans: [{ from: start, to: start + inner.length }] };
}

/** Make an entry that the text leaves out. @param {string} text @returns {Entry} */
export const makeUntyped = (text) => ({ text, spans: [] });

/** List the entries of a text, separated by commas, else by blanks. @returns {Entry[]} */
export function listEntries(body, start) {
  const pattern = /[,;\n]/.test(body.trim()) ? /[^,;\n]+/g : /\S+/g;
  return [...body.matchAll(pattern)]
    .map(({ 0: text, index }) => makeEntry(text, start + index))
    .filter(({ text }) => text);
}
