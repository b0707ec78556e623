// The form that the build has written into the page: what the reader did in it before the script
// loaded.

/** @typedef {HTMLInputElement | HTMLTextAreaElement | HTMLSelectElement} Control */
/** @typedef {{ key?: string, selection?: [number, number] }} Focus the focused field, if any */

/**
 * Return what the reader entered in the still form, and which field has the focus.
 * @param {HTMLElement} stub
 * @param {string[]} keys of the fields
 * @returns {{ focus: Focus, patch: Record<string, string> }}
 */
export function readStillForm(stub, keys) {
  const fields = keys
    .map((key) => ({ key, control: findControl(stub, key) }))
    .filter(({ control }) => control);
  const changed = fields.filter(({ control }) => control.value !== getDefault(control));
  const { key, control } = fields.find((field) => field.control === document.activeElement) ?? {};
  const isText = control && "selectionStart" in control;
  return {
    focus: { key, selection: isText && [control.selectionStart, control.selectionEnd] },
    patch: Object.fromEntries(changed.map((field) => [field.key, field.control.value])),
  };
}

/**
 * Give the focus to the field that replaces the focused one, with the same selection, so that the
 * reader types on.
 * @param {Record<string, Control>} fields
 * @param {Focus} focus
 */
export function restoreFocus(fields, { key, selection }) {
  const control = fields[key];
  control?.focus();
  if (selection && "selectionStart" in control) control.setSelectionRange(...selection);
}

/** @returns {Control | null} */
const findControl = (/** @type {HTMLElement} */ stub, /** @type {string} */ key) =>
  stub.querySelector(`[id$="-${key}"]`);

// Return the value that the build wrote into a field.
function getDefault(/** @type {Control} */ control) {
  if (!("options" in control)) return control.defaultValue;
  const selected = /** @type {HTMLOptionElement} */ (control.querySelector("[selected]"));
  return (selected ?? control.options[0])?.value ?? "";
}
