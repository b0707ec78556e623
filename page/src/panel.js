// The explorer: picture, sliders, and tabs of views below them, in a shadow root.

import css from "./panel.css";
import common from "./common.css";
import { updateAttribute, prefersReducedMotion, h } from "./dom.js";
import { makeHeader } from "./panel/head.js";
import { makeSliders } from "./panel/sliders.js";
import { makeStage } from "./panel/stage.js";
import { makeTabs } from "./panel/tabs.js";
import { makeAnnouncer } from "./speech.js";
import { formatFixed } from "./text.js";
import { watchTheme } from "./theme.js";

const GLIDE_TIME = 450; // ms that the arm takes to glide to another configuration
// ms between updates of the numbers while the picture is dragged, as fast as anyone can read
const UPDATE_INTERVAL = 100;

// changes of these fields are announced to screen readers
const ANNOUNCED_FIELDS = ["q", "arm", "wrench", "branches", "trace", "dragging"];

let panelCount = 0;

/**
 * Build the explorer into a host; returns a function that removes it.
 * @param {HTMLElement} host
 * @param {import("./state.js").Store} store
 * @typedef {import("../../judge/geometry/arm.js").Arm} Arm
 * @param {{ views: string[], arms: Arm[], makeLink?: Function }} options
 */
export function buildPanel(host, store, { views, arms, makeLink }) {
  const root = host.shadowRoot ?? host.attachShadow({ mode: "open" });
  const abort = new AbortController();
  const { signal } = abort;
  const { region, announce } = makeAnnouncer(root, signal);
  const notice = makeNotice();
  const tools = {
    id: `explorer-${++panelCount}`,
    goTo: makeGlider(store, signal),
    announce,
    signal,
    notify: notice.notify,
    point: (row) => store.dispatch({ type: "setFields", highlightedRow: row }),
  };
  const link = makeLink?.(notice.notify, signal);
  const stage = makeStage(store, tools);
  const sliders = makeSliders(store, tools);
  const tabs = makeTabs(store, views, { ...tools, arms, fit: stage.fit });
  const card = h("section.explorer");
  const head = makeHeader(store, { ...tools, arms, link, stage, card });
  const bench = h("div.bench", {}, stage.root, sliders.root);
  card.append(head.root, notice.root, bench, tabs.root, region);
  root.replaceChildren(h("style", {}, common, css), card);
  keepUpdated(store, { card, head, stage, sliders, tabs }, { announce, signal });
  if (link && isComparison(store.state)) tabs.root.scrollIntoView({ block: "nearest" });
  return () => {
    abort.abort();
    stage.dispose();
    root.replaceChildren();
  };
}

// Return whether a link brought numbers to compare, which stand below the picture. Runs are in it.
const isComparison = ({ answer, arm, base }) => Boolean(answer) || arm !== base;

// Make the notice above the picture.
function makeNotice() {
  const root = h("p.notice", { role: "status", hidden: true });
  const notify = (message) => {
    root.hidden = !message;
    root.textContent = message;
  };
  return { root, notify };
}

// Redraw the picture at every change, and update the numbers at a readable pace.
function keepUpdated(store, { card, head, stage, sliders, tabs }, { announce, signal }) {
  let theme = "light";
  let timer = null;
  const draw = () => stage.draw(store.state, store.derived, theme);
  const update = () => {
    clearTimeout(timer);
    timer = null;
    const { state, derived } = store;
    const name = `Explorer of the ${state.arm.name}`.replace("the Your", "your");
    updateAttribute(card, "aria-label", name);
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
      timer ??= setTimeout(update, UPDATE_INTERVAL);
      return;
    }
    update();
    if (ANNOUNCED_FIELDS.some((key) => changed.has(key)) && !store.state.playing)
      announce(() => describeState(store, tabs));
  }, signal);
  update();
}

// Describe where the tip is, followed by the summary of the open view.
function describeState({ state, derived }, tabs) {
  const [x, y, z] = derived.frames.at(-1).o.map((v) => formatFixed(v, 3).replace("−", "minus "));
  return `Tip at x ${x}, y ${y}, z ${z} metres. ${tabs.summary(state, derived)}`.trim();
}

// Return a function that glides to joint values, or jumps there if the reader prefers reduced
// motion.
function makeGlider(store, signal) {
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
    if (prefersReducedMotion() || q.length !== from.length) {
      go(q);
      return;
    }
    const start = performance.now();
    const step = (now) => {
      moving = null;
      if (store.state.arm !== arm) return;
      const t = Math.min(1, Math.max(0, now - start) / GLIDE_TIME);
      const ease = t * t * (3 - 2 * t);
      go(t === 1 ? q : from.map((v, i) => v + ease * (q[i] - v)));
      if (t < 1) moving = requestAnimationFrame(step);
    };
    moving = requestAnimationFrame(step);
  };
}
