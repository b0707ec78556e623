// The judge: asked by Python, and in a page by the forms of its .arm-judge places
// (book/assets/explorer-loader.js loads it there).

import { mount } from "./page.js";

export { mount };
export { ask } from "../../../judge/index.js";

const script = /** @type {any} */ (globalThis.document?.currentScript);
if (script) {
  const book = new URL("..", script.src).href;
  for (const [i, stub] of document.querySelectorAll(".arm-judge").entries())
    mount(/** @type {HTMLElement} */ (stub), book, `judge-${i}`);
}
