// Play, pause and scrub along the state's trace; each frame takes the arm on, and the state says
// when it stops.

import { attribute, calm, h, slider, write } from "../dom.js";

const SECONDS = 8; // for the whole path; twice that where motion is unwelcome

/**
 * @param {import("../state.js").Store} store
 * @param {{ signal: AbortSignal, begin: (then: () => void) => void }} tools `begin` makes a trace
 *   where there is none
 */
export function makeTransport(store, { signal, begin }) {
  const go = (on) => store.dispatch({ type: "playing", on });
  const play = h("button.main", { onclick: () => toggle(store, go, begin) }, "Play");
  const scrub = makeScrub((at) => (go(false), store.dispatch({ type: "play", at })));
  const place = h("output.place");
  const root = h("div.row.transport", {}, play, scrub, place);
  let timer = null;
  let last = 0; // the time of the frame before, ms
  signal.addEventListener("abort", () => cancelAnimationFrame(timer));

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
    if (share === 1) go(false);
  }

  function update({ playing, trace, at }) {
    write(play, playing ? "Pause" : "Play");
    scrub.disabled = !trace;
    showPlace({ scrub, place }, at);
    if (!playing || timer) return;
    last = performance.now();
    timer = requestAnimationFrame(tick);
  }
  return { root, update };
}

function showPlace({ scrub, place }, at) {
  scrub.value = String(Math.round(1000 * at));
  scrub.style.setProperty("--high", `${(100 * at).toFixed(1)}%`);
  attribute(scrub, "aria-valuetext", `${Math.round(100 * at)} percent`);
  write(place, `${Math.round(100 * at)} %`);
}

function toggle(store, go, begin) {
  const { trace, playing, at } = store.state;
  if (playing) return go(false);
  if (!trace) return begin(() => go(true));
  if (at >= 1) store.dispatch({ type: "play", at: 0 });
  return go(true);
}

const makeScrub = (put) =>
  slider("Place along the path", [0, 1000], {
    step: 1,
    value: 0,
    oninput: (e) => put(e.target.value / 1000),
  });
