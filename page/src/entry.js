// Makes text fields for a quantity, with a message about the text that is typed so far.

import { readEntry, unfinished } from "../../judge/reading/entry.js";
import { updateAttribute, h } from "./dom.js";

// Mark a field as invalid and return the message. While the reader types, an unfinished entry is no
// error.
export function markInvalid(input, error, whole) {
  const message = error && (whole || !unfinished(input.value)) ? error : "";
  updateAttribute(input, "aria-invalid", String(Boolean(message)));
  return message;
}

/**
 * Read a field and mark it if it is invalid.
 * @param {HTMLInputElement} input
 * @param {Parameters<typeof readEntry>[1]} kind
 * @param {{ unit?: string, whole: boolean }} options `whole` once the reader has left the field
 * @returns {{ value?: number, message: string }} `value` is missing if the entry is invalid
 */
export function readField(input, kind, { unit, whole }) {
  const { value, error } = readEntry(input.value, kind, unit);
  return { value, message: markInvalid(input, error, whole) };
}

/**
 * Make a text field.
 * @param {string} label
 * @param {(input: HTMLInputElement, whole: boolean) => void} typed called at every key, and with
 *   `whole` once the reader has left the field
 */
export const makeTextField = (label, typed, attributes = {}) =>
  h("input", {
    type: "text",
    spellcheck: "false",
    autocomplete: "off",
    "aria-label": label,
    oninput: (event) => typed(event.target, false),
    onchange: (event) => typed(event.target, true),
    ...attributes,
  });

// Set the text of a field unless the reader is typing in it.
export function refillField(input, text) {
  if (input.getRootNode().activeElement !== input && input.value !== text) input.value = text;
}
