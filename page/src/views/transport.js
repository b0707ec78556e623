// Play, pause and scrub along the state's trace; each frame takes the arm on, and the state says
// when it stops.

import { attribute, calm, h, write } from "../dom.js";

const SECONDS = 8; // for the whole path; twice that where motion is unwelcome

/**
 * @param {import("../state.js").Store} store
 * @param {{ signal: AbortSignal, begin: (then: () => void) => void }} tools `begin` makes a trace
 *   where there is none
 */
export function makeTransport(store, { signal, begin }) {
  const play = h("button.main", { type: "button", onclick: toggle }, "Play");
  const scrub = h("input", {
    type: "range",
    min: 0,
    max: 1000,
    value: 0,
    "aria-label": "Place along the path",
    oninput: (e) => scrubTo(e.target.value / 1000),
  });
  const place = h("output.place");
  const root = h("div.row.transport", {}, play, scrub, place);
  let timer = null;
  let last = 0; // the time of the frame before, ms
  signal.addEventListener("abort", () => cancelAnimationFrame(timer));
  const start = () => store.dispatch({ type: "playing", on: true });

  function scrubTo(share) {
    store.dispatch({ type: "playing", on: false });
    store.dispatch({ type: "play", at: share });
  }

  function toggle() {
    const { trace, playing, at } = store.state;
    if (playing) return store.dispatch({ type: "playing", on: false });
    if (!trace) return begin(start);
    if (at >= 1) store.dispatch({ type: "play", at: 0 });
    return start();
  }

  function tick(now) {
    timer = null;
    const { playing, at } = store.state;
    if (!playing || !root.isConnected) return;
    const pace = 1000 * SECONDS * (calm() ? 2 : 1);
    const share = Math.min(1, at + Math.max(0, Math.min(100, now - last)) / pace);
    last = now;
    // before the state changes: who hears of that would ask for a frame too
    timer = requestAnimationFrame(tick);
    store.dispatch({ type: "play", at: share });
    if (share === 1) store.dispatch({ type: "playing", on: false });
  }

  function update({ playing, trace, at }) {
    write(play, playing ? "Pause" : "Play");
    scrub.disabled = !trace;
    scrub.value = String(Math.round(1000 * at));
    scrub.style.setProperty("--high", `${(100 * at).toFixed(1)}%`);
    attribute(scrub, "aria-valuetext", `${Math.round(100 * at)} percent`);
    write(place, `${Math.round(100 * at)} %`);
    if (!playing || timer) return;
    last = performance.now();
    timer = requestAnimationFrame(tick);
  }
  return { root, update };
}
