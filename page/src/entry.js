// A field for one quantity: what is typed so far, and what is said of it.

import { readEntry, unfinished } from "../../judge/reading/entry.js";
import { attribute, h } from "./dom.js";

// Mark a field, and give what is wrong with it in words: none while its entry may still be
// completed.
export function marked(input, error, whole) {
  const words = error && (whole || !unfinished(input.value)) ? error : "";
  attribute(input, "aria-invalid", String(Boolean(words)));
  return words;
}

/**
 * What stands in a field, and what to say of it; `whole` once the reader has left it.
 * @param {HTMLInputElement} input
 * @param {Parameters<typeof readEntry>[1]} kind
 * @param {{ unit?: string, whole: boolean }} how
 * @returns {{ value?: number, words: string }} no value where it is none
 */
export function entered(input, kind, { unit, whole }) {
  const { value, error } = readEntry(input.value, kind, unit);
  return { value, words: marked(input, error, whole) };
}

/**
 * A field to type in: `typed` hears of every key, and when the reader has left it.
 * @param {string} label
 * @param {(input: HTMLInputElement, whole: boolean) => void} typed
 */
export const textField = (label, typed, attributes = {}) =>
  h("input", {
    type: "text",
    spellcheck: "false",
    autocomplete: "off",
    "aria-label": label,
    oninput: (event) => typed(event.target, false),
    onchange: (event) => typed(event.target, true),
    ...attributes,
  });

// Bring a field up to date, but for one that is being typed in.
export function refill(input, text) {
  if (input.getRootNode().activeElement !== input && input.value !== text) input.value = text;
}
