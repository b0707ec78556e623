// The instrument: picture, sliders, and the views in tabs below, inside a shadow root of its own.

import css from "./panel.css";
import common from "./common.css";
import { attribute, calm, h } from "./dom.js";
import { makeHead } from "./panel/head.js";
import { makeSliders } from "./panel/sliders.js";
import { makeStage } from "./panel/stage.js";
import { makeTabs } from "./panel/tabs.js";
import { makeSpeech } from "./speech.js";
import { fixed } from "./text.js";
import { watchTheme } from "./theme.js";

const GLIDE = 450; // ms that the arm takes to another place
// ms in which the numbers follow while the picture is dragged: nobody reads faster
const READ = 100;

// a change of these is worth a word
const SAID = ["q", "arm", "wrench", "ways", "trace", "dragging"];

let count = 0;

/**
 * Build the instrument into a host; returns what takes it away again.
 * @param {HTMLElement} host
 * @param {import("./state.js").Store} store
 * @typedef {import("../../judge/geometry/arm.js").Arm} Arm
 * @param {{ views: string[], arms: Arm[], makeLink?: Function }} options
 */
export function buildPanel(host, store, { views, arms, makeLink }) {
  const root = host.shadowRoot ?? host.attachShadow({ mode: "open" });
  const abort = new AbortController();
  const { signal } = abort;
  const { region, say } = makeSpeech(root, signal);
  const notice = makeNotice();
  const tools = {
    id: `explorer-${++count}`,
    goTo: glider(store, signal),
    say,
    signal,
    tell: notice.tell,
    point: (row) => store.dispatch({ type: "show", lit: row }),
  };
  const link = makeLink?.(notice.tell, signal);
  const stage = makeStage(store, tools);
  const sliders = makeSliders(store, tools);
  const tabs = makeTabs(store, views, tools);
  const card = h("section.explorer");
  const head = makeHead(store, { ...tools, arms, link, stage, card });
  const bench = h("div.bench", {}, stage.root, sliders.root);
  card.append(head.root, notice.root, bench, tabs.root, region);
  root.replaceChildren(h("style", {}, common, css), card);
  keepShown(store, { card, head, stage, sliders, tabs }, { say, signal });
  return () => {
    abort.abort();
    stage.dispose();
    tabs.dispose();
    root.replaceChildren();
  };
}

// What is to be said to every reader, above the picture.
function makeNotice() {
  const root = h("p.notice", { role: "status", hidden: true });
  const tell = (words) => {
    root.hidden = !words;
    root.textContent = words;
  };
  return { root, tell };
}

// All that is shown follows the state: the picture at once, the numbers at a pace that can be read.
function keepShown(store, { card, head, stage, sliders, tabs }, { say, signal }) {
  let theme = "light";
  let timer = null;
  const draw = () => stage.draw(store.state, store.derived, theme);
  const update = () => {
    clearTimeout(timer);
    timer = null;
    const { state, derived } = store;
    const name = `Explorer of the ${state.arm.name}`.replace("the Your", "your");
    attribute(card, "aria-label", name);
    for (const part of [head, stage, sliders, tabs]) part.update(state, derived);
  };
  signal.addEventListener("abort", () => clearTimeout(timer));
  watchTheme((now) => {
    theme = now;
    card.dataset.theme = now;
    draw();
  }, signal);
  store.listen((changed) => {
    draw();
    if (store.state.dragging && !changed.has("dragging")) {
      timer ??= setTimeout(update, READ);
      return;
    }
    update();
    if (SAID.some((key) => changed.has(key)) && !store.state.playing)
      say(() => summary(store, tabs));
  }, signal);
  update();
}

// Where the tip is, and what the open view says of it.
function summary({ state, derived }, tabs) {
  const [x, y, z] = derived.frames.at(-1).o.map((v) => fixed(v, 3).replace("−", "minus "));
  return `Tip at x ${x}, y ${y}, z ${z} metres. ${tabs.summary(state, derived)}`.trim();
}

// Move to a joint vector at a pace the eye can follow, or at once where motion is unwelcome.
function glider(store, signal) {
  let moving = null;
  const stop = () => {
    if (moving) cancelAnimationFrame(moving);
    moving = null;
  };
  signal.addEventListener("abort", stop);
  store.listen(
    (changed, by) => by !== "glide" && (changed.has("q") || changed.has("arm")) && stop(),
    signal,
  );
  return (q) => {
    stop();
    const { q: from, arm } = store.state;
    const gesture = `glide ${performance.now()}`;
    const go = (to) => store.dispatch({ type: "glide", q: to, gesture }, "glide");
    if (calm() || q.length !== from.length) return go(q);
    const start = performance.now();
    const step = (now) => {
      moving = null;
      if (store.state.arm !== arm) return;
      const t = Math.min(1, Math.max(0, now - start) / GLIDE);
      const ease = t * t * (3 - 2 * t);
      go(t === 1 ? q : from.map((v, i) => v + ease * (q[i] - v)));
      if (t < 1) moving = requestAnimationFrame(step);
    };
    moving = requestAnimationFrame(step);
    return true;
  };
}
