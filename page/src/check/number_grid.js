// A small field for each number of a list, to type in on a phone beside the field for the list.

import { h, makeIndexedSymbol } from "../dom.js";

const SEPARATORS = /[\s,;]+/;
const BRACKETS = /^[[({]|[\])}]$/g;
const SIMPLE = /^[^a-z=:_"'|&]*$/i; // a list without names

/**
 * Make the grid.
 * @param {string} label
 * @param {boolean} open whether it is unfolded at first
 */
export function makeNumberGrid(label, open) {
  const cells = h("div.cells", { role: "group", "aria-label": label });
  const root = h("details.numbers", { open, hidden: true }, h("summary", {}, label), cells);
  let inputs = [];
  let shownNames = "";

  function rebuild(names) {
    shownNames = names.join();
    inputs = names.map((name) => makeNumberField(name, () => grid.onChange(joinNumbers(inputs))));
    cells.replaceChildren(...inputs.map(({ root: part }) => part));
  }

  /**
   * Show a list of numbers; one that is more than a plain list has no grid.
   * @param {string[]} names of the numbers; empty for no grid
   * @param {string} text
   */
  function update(names, text) {
    if (names.join() !== shownNames) rebuild(names);
    const values = splitNumbers(text);
    root.hidden = !names.length || values === null || values.length > names.length;
    if (root.hidden) return;
    inputs.forEach(({ input }, i) => {
      const value = values[i] ?? "";
      if (input !== document.activeElement && input.value !== value) input.value = value;
    });
  }
  const grid = {
    root,
    update,
    /** Called with the list whenever a number changes. */
    onChange: (/** @type {string} */ _text) => {},
  };
  return grid;
}

/**
 * Split a plain list of numbers; null if the text is more than that.
 * @param {string} text
 */
export function splitNumbers(text) {
  const list = text.trim().replace(BRACKETS, "").trim();
  if (!SIMPLE.test(list.replace(/pi/gi, ""))) return null;
  return list ? list.split(SEPARATORS) : [];
}

// The list, as far as it is filled in.
function joinNumbers(inputs) {
  const values = inputs.map(({ input }) => input.value.trim().replace(",", "."));
  const count = values.findLastIndex(Boolean) + 1;
  return values
    .slice(0, count)
    .map((value) => value || "?")
    .join(", ");
}

// A number with its name and a key for its sign, which many phones' number keys lack.
function makeNumberField(name, onChange) {
  const [letter, index] = name.split("_");
  const input = h("input", {
    inputmode: "decimal",
    autocomplete: "off",
    "aria-label": `${letter} ${index}`,
    oninput: (event) => {
      event.stopPropagation(); // the form listens for its own fields
      onChange();
    },
  });
  const negate = () => {
    input.value = /^[-−]/.test(input.value) ? input.value.slice(1) : `-${input.value}`;
    onChange();
    input.focus();
  };
  const sign = h("button", { onclick: negate, "aria-label": `Sign of ${letter} ${index}` }, "±");
  const symbol = h("span", { "aria-hidden": "true" }, makeIndexedSymbol(letter, index));
  return { input, root: h("span.cell", {}, symbol, input, sign) };
}
