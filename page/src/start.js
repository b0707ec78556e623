// When the live pictures begin. Compiling their shaders takes longer than all else on a page, so
// the still pictures stand until a reader shows an interest in them.

const IDLE_TIME = 3000; // ms after which a picture in view begins by itself
const REST_TIME = 200; // ms without scrolling after which the page rests
const SIGNS = ["pointermove", "pointerdown", "touchstart", "wheel", "keydown", "focusin"];
const TOUCHES = ["pointerdown", "touchstart", "keydown"];

/**
 * Call a function at the first sign that the reader uses a picture: an event on its card, a
 * scrolled page that rests with the picture in view, or three seconds with the picture in view.
 * Readers who save data must touch it.
 * @param {HTMLElement} host element of the picture
 * @param {() => boolean} isInView
 * @param {() => void} start
 * @param {AbortSignal} signal stops the waiting
 */
export function waitForReader(host, isInView, start, signal) {
  const waiting = new AbortController();
  const options = { signal: waiting.signal, passive: true, capture: true };
  const begin = () => (waiting.abort(), start());
  const beginInView = () => isInView() && begin();
  const beginIfNear = (event) => {
    const root = /** @type {any} */ (host.getRootNode());
    if (event.composedPath().includes(root.host ?? host)) begin();
  };
  signal.addEventListener("abort", () => waiting.abort());
  const savesData = /** @type {any} */ (navigator).connection?.saveData === true;
  for (const type of savesData ? TOUCHES : SIGNS)
    document.addEventListener(type, beginIfNear, options);
  if (savesData) return;
  let timer = setTimeout(beginInView, IDLE_TIME);
  const restart = () => {
    clearTimeout(timer);
    timer = setTimeout(beginInView, REST_TIME);
  };
  document.addEventListener("scroll", restart, options);
  waiting.signal.addEventListener("abort", () => clearTimeout(timer));
}
