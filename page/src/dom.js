// Elements from one line: h("button.quiet", { onclick }, "Home").

export function h(name, attributes = {}, ...children) {
  const [tag, ...classes] = name.split(".");
  const element = document.createElement(tag);
  if (tag === "button") element.type = "button"; // which sends no form
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
 * A slider between two values.
 * @param {string} label
 * @param {number[]} bounds
 */
export const slider = (label, [min, max], attributes = {}) =>
  h("input", { type: "range", min, max, step: "any", "aria-label": label, ...attributes });

// Write only what differs: most of what a moving arm shows stays the same from frame to frame.
export function write(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

export function attribute(element, name, value) {
  if (element.getAttribute(name) !== value) element.setAttribute(name, value);
}

// A symbol with an index, as q₂.
export const indexed = (letter, index) => [h("i", {}, letter), h("sub", {}, String(index))];

// Whether a text could be put on the clipboard, which some pages have no access to.
export async function copied(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    return false;
  }
}

// A table that scrolls sideways where it is too wide, by keys too.
export const scrolled = (label, table) =>
  h("div.scroll", { tabindex: 0, role: "region", "aria-label": label }, table);

export const calm = () => matchMedia("(prefers-reduced-motion: reduce)").matches;

/**
 * A choice by its options' values and words.
 * @param {string} label
 * @param {Record<string, string>} options
 * @param {(value: string) => void} onchoice
 */
export function select(label, options, onchoice) {
  const list = Object.entries(options).map(([value, text]) => h("option", { value }, text));
  return h("select", { "aria-label": label, onchange: (e) => onchoice(e.target.value) }, list);
}
