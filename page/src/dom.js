// Make an HTML element from one line, as in h("button.quiet", { onclick }, "Home").

export function h(name, attributes = {}, ...children) {
  const [tag, ...classes] = name.split(".");
  const element = document.createElement(tag);
  if (tag === "button") element.type = "button"; // so that it does not submit a form
  if (classes.length) element.className = classes.join(" ");
  for (const [key, value] of Object.entries(attributes)) {
    if (key.startsWith("on")) element.addEventListener(key.slice(2), value);
    else if (value !== undefined && value !== false)
      element.setAttribute(key, value === true ? "" : value);
  }
  element.append(...children.flat());
  return element;
}

export function svg(name, attributes = {}, ...children) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  element.append(...children);
  return element;
}

/**
 * Make a slider between two values.
 * @param {string} label
 * @param {number[]} bounds
 */
export const makeRangeInput = (label, [min, max], attributes = {}) =>
  h("input", { type: "range", min, max, step: "any", "aria-label": label, ...attributes });

// Set the text of an element if it differs. While an arm moves, most text stays the same.
export function setText(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

export function updateAttribute(element, name, value) {
  if (element.getAttribute(name) !== value) element.setAttribute(name, value);
}

// Make the nodes of a symbol with an index, such as q₂.
export const makeIndexedSymbol = (letter, index) => [
  h("i", {}, letter),
  h("sub", {}, String(index)),
];

// Copy text to the clipboard. Returns false if the page has no access to it.
export async function copyToClipboard(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    return false;
  }
}

// Wrap a table so that it can be scrolled sideways, also by keyboard.
export const makeScrollRegion = (label, table) =>
  h("div.scroll", { tabindex: 0, role: "region", "aria-label": label }, table);

export const prefersReducedMotion = () => matchMedia("(prefers-reduced-motion: reduce)").matches;

/**
 * Make a drop-down list.
 * @param {string} label
 * @param {Record<string, string>} options text of each option by its value
 * @param {(value: string) => void} onchoice
 */
export function makeSelect(label, options, onchoice) {
  const list = Object.entries(options).map(([value, text]) => h("option", { value }, text));
  return h("select", { "aria-label": label, onchange: (e) => onchoice(e.target.value) }, list);
}
