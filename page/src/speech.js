// Announcements for screen readers: a summary once the explorer is still, only while it has the
// focus.

import { h } from "./dom.js";

const QUIET_TIME = 1000; // ms
const CLEAR_DELAY = 400; // ms until the text is cleared, so that it can be announced again

/**
 * Make a live region.
 * @param {HTMLElement | ShadowRoot} root announcements need the focus in here
 * @param {AbortSignal} signal
 */
export function makeAnnouncer(root, signal) {
  const region = h("p.hidden", { role: "status", "aria-live": "polite" });
  let timer = null;
  let emptier = null;
  const focused = () => /** @type {any} */ (root).activeElement !== null && document.hasFocus();

  // Announce the sentence that `message` returns after a second without another announcement.
  function announce(message, always = false) {
    clearTimeout(timer);
    timer = setTimeout(() => {
      if (!always && !focused()) return;
      region.textContent = message();
      clearTimeout(emptier);
      emptier = setTimeout(
        () => (region.textContent = ""),
        CLEAR_DELAY + 60 * region.textContent.length,
      );
    }, QUIET_TIME);
  }
  signal.addEventListener("abort", () => {
    clearTimeout(timer);
    clearTimeout(emptier);
  });
  return { region, announce };
}
