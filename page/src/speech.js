// What a screen reader hears of an explorer: one summary once all is still, the last one only,
// while the explorer has the focus.

import { h } from "./dom.js";

const STILL = 1000; // ms
const HEARD = 400; // ms that a sentence stands, so that the same one can be said again

/**
 * @param {HTMLElement | ShadowRoot} root whose focus counts
 * @param {AbortSignal} signal
 */
export function makeSpeech(root, signal) {
  const region = h("p.hidden", { role: "status", "aria-live": "polite" });
  let timer = null;
  let emptier = null;
  const focused = () => /** @type {any} */ (root).activeElement !== null && document.hasFocus();

  // Say the sentence that `words` gives when all has been still for a second.
  function say(words, always = false) {
    clearTimeout(timer);
    timer = setTimeout(() => {
      if (!always && !focused()) return;
      region.textContent = words();
      clearTimeout(emptier);
      emptier = setTimeout(() => (region.textContent = ""), HEARD + 60 * region.textContent.length);
    }, STILL);
  }
  signal.addEventListener("abort", () => {
    clearTimeout(timer);
    clearTimeout(emptier);
  });
  return { region, say };
}
