// Defines a text whose characters remember their positions in the pasted text. The reader
// changes the text in several steps; thanks to the positions, a message can quote the pasted text
// and mark a place in it.

/**
 * A part of the pasted text, from a position up to, but without, the position `to`.
 * @typedef {{ from: number, to: number }} Span
 */

/**
 * List the lines of a text with their spans.
 * @param {string} text @returns {(Span & { text: string })[]}
 */
export function listLines(text) {
  let from = 0;
  return text.split("\n").map((line) => {
    const span = { from, to: from + line.length, text: line };
    from = span.to + 1;
    return span;
  });
}

/** A text with the span of the pasted text that each of its characters stands for. */
export class SpannedText {
  /** @param {string} text @param {number[]} [starts] @param {number[]} [ends] of each character */
  constructor(text, starts = null, ends = null) {
    this.text = text;
    this.starts = starts;
    this.ends = ends;
  }

  /**
   * Return the span of the pasted text that characters of this text stand for.
   * @param {number} from @param {number} to @returns {Span}
   */
  span(from, to) {
    if (!this.starts) return { from, to };
    if (from >= to) return { from: this.starts[from] ?? 0, to: this.starts[from] ?? 0 };
    return { from: this.starts[from], to: this.ends[to - 1] };
  }

  /**
   * List the separate spans of the pasted text that characters stand for. A drawn fraction has a
   * span on each line.
   * @param {number} from @param {number} to @returns {Span[]}
   */
  stretches(from, to) {
    const stretches = [];
    for (let at = from; at < to; at++) {
      const span = this.span(at, at + 1);
      const last = stretches.at(-1);
      if (last && span.from >= last.from && span.from <= last.to)
        last.to = Math.max(last.to, span.to);
      else if (span.to > span.from) stretches.push(span);
    }
    return stretches;
  }

  /**
   * Replace all matches. A replacement that is a part of its match keeps its place. Of another one,
   * blanks stand for nothing and other characters for the whole match.
   * @param {RegExp} pattern with the flag g
   * @param {string | ((match: string, ...groups: string[]) => string)} replacement
   */
  replace(pattern, replacement) {
    const parts = [];
    const [starts, ends] = [[], []];
    let last = 0;
    for (const match of this.text.matchAll(pattern)) {
      this.#copy(last, match.index, parts, starts, ends);
      last = match.index + match[0].length;
      const text = replacementFor(match, replacement);
      parts.push(text);
      this.#align(match, text, starts, ends);
    }
    if (!parts.length) return this;
    this.#copy(last, this.text.length, parts, starts, ends);
    return new SpannedText(parts.join(""), starts, ends);
  }

  /**
   * Replace parts of this text, given in order. The new text stands for the whole part.
   * @param {{ from: number, to: number, text: string }[]} edits
   */
  edit(edits) {
    const parts = [];
    const [starts, ends] = [[], []];
    let last = 0;
    for (const { from, to, text } of edits) {
      this.#copy(last, from, parts, starts, ends);
      last = to;
      parts.push(text);
      const whole = this.span(from, to);
      for (let at = 0; at < text.length; at++) {
        starts.push(whole.from);
        ends.push(whole.to);
      }
    }
    this.#copy(last, this.text.length, parts, starts, ends);
    return new SpannedText(parts.join(""), starts, ends);
  }

  /**
   * Make a text of parts of this text, in any order.
   * @param {(Span | string)[]} parts spans of this text, and new characters that stand for nothing
   */
  assemble(parts) {
    const texts = [];
    const [starts, ends] = [[], []];
    for (const part of parts) {
      if (typeof part !== "string") this.#copy(part.from, part.to, texts, starts, ends);
      else {
        texts.push(part);
        const at = ends.at(-1) ?? 0;
        for (let k = 0; k < part.length; k++) {
          starts.push(at);
          ends.push(at);
        }
      }
    }
    return new SpannedText(texts.join(""), starts, ends);
  }

  #copy(from, to, parts, starts, ends) {
    parts.push(this.text.slice(from, to));
    for (let at = from; at < to; at++) {
      starts.push(this.starts ? this.starts[at] : at);
      ends.push(this.ends ? this.ends[at] : at + 1);
    }
  }

  #align(match, text, starts, ends) {
    const kept = match[0].indexOf(text); // where the match holds all of its replacement
    const whole = this.span(match.index, match.index + match[0].length);
    for (let at = 0; at < text.length; at++) {
      const place = match.index + kept + at;
      const own = kept < 0 ? whole : this.span(place, place + 1);
      starts.push(own.from);
      ends.push(kept < 0 && /\s/.test(text[at]) ? own.from : own.to);
    }
  }
}

function replacementFor(match, replacement) {
  if (typeof replacement === "function") return replacement(...match);
  return replacement.replace(/\$(\d)/g, (_, group) => match[Number(group)] ?? "");
}
