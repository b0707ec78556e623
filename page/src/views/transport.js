// Play, pause and scrub along the state's trace. Each frame moves the arm, and the state stops the
// play.

import { updateAttribute, prefersReducedMotion, h, makeRangeInput, setText } from "../dom.js";

const PLAY_TIME = 8; // s for the whole path; twice as long with reduced motion

/**
 * Make the play button and the scrubber.
 * @param {import("../state.js").Store} store
 * @param {{ signal: AbortSignal, makeTrace: (onReady: () => void) => void }} tools `makeTrace`
 *   is called if there is no trace to play
 */
export function makeTransport(store, { signal, makeTrace }) {
  const go = (on) => store.dispatch({ type: "setPlaying", on });
  const play = h("button.main", { onclick: () => togglePlay(store, go, makeTrace) }, "Play");
  const scrub = makeScrubber((progress) => (go(false), store.dispatch({ type: "seek", progress })));
  const place = h("output.place");
  const root = h("div.row.transport", {}, play, scrub, place);
  let timer = null;
  let last = 0; // time of the previous frame, ms
  signal.addEventListener("abort", () => cancelAnimationFrame(timer));

  function tick(now) {
    timer = null;
    const { playing, progress } = store.state;
    if (!playing || !root.isConnected) return;
    const pace = 1000 * PLAY_TIME * (prefersReducedMotion() ? 2 : 1);
    const share = Math.min(1, progress + Math.max(0, Math.min(100, now - last)) / pace);
    last = now;
    // The next frame is requested before the state changes, because a listener would request one
    // too.
    timer = requestAnimationFrame(tick);
    store.dispatch({ type: "seek", progress: share });
    if (share === 1) go(false);
  }

  function update({ playing, trace, progress }) {
    setText(play, playing ? "Pause" : "Play");
    scrub.disabled = !trace;
    showProgress({ scrub, place }, progress);
    if (!playing || timer) return;
    last = performance.now();
    timer = requestAnimationFrame(tick);
  }
  return { root, update };
}

function showProgress({ scrub, place }, progress) {
  scrub.value = String(Math.round(1000 * progress));
  scrub.style.setProperty("--high", `${(100 * progress).toFixed(1)}%`);
  updateAttribute(scrub, "aria-valuetext", `${Math.round(100 * progress)} percent`);
  setText(place, `${Math.round(100 * progress)} %`);
}

function togglePlay(store, go, makeTrace) {
  const { trace, playing, progress } = store.state;
  if (playing) return go(false);
  if (!trace) return makeTrace(() => go(true));
  if (progress >= 1) store.dispatch({ type: "seek", progress: 0 });
  return go(true);
}

const makeScrubber = (put) =>
  makeRangeInput("Place along the path", [0, 1000], {
    step: 1,
    value: 0,
    oninput: (e) => put(e.target.value / 1000),
  });
