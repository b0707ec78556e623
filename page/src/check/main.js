// Entry point of the judge's bundle. Python calls `ask`; a page mounts a form in each of its
// .arm-judge stubs (book/assets/explorer-loader.js loads the bundle there).

import { mount } from "./mount.js";

export { mount };
export { ask } from "../../../judge/index.js";

const script = /** @type {HTMLScriptElement} */ (globalThis.document?.currentScript);
if (script) {
  const book = new URL("..", script.src).href;
  for (const [i, stub] of document.querySelectorAll(".arm-judge").entries())
    mount(/** @type {HTMLElement} */ (stub), book, `judge-${i}`);
}
