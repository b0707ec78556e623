// The instrument: picture, sliders, and the views in tabs below, inside a shadow root of its own.

import css from "./panel.css";
import { calm, h, indexed } from "./dom.js";
import { joints } from "./kinematics.js";
import { outside, randomPose, range } from "./motion.js";
import { Stage } from "./scene.js";
import { fixed, isAngle, jointText, limitText, readEntry } from "./text.js";
import { watchTheme } from "./theme.js";
import * as pose from "./views/pose.js";
import * as jacobian from "./views/jacobian.js";
import * as torque from "./views/torque.js";
import * as trace from "./views/trace.js";
import * as branches from "./views/branches.js";
import * as table from "./views/table.js";

export const VIEWS = { table, pose, jacobian, trace, torque, branches };

let count = 0;

export function buildPanel(host, store, { views, arms, link }) {
  const root = host.shadowRoot ?? host.attachShadow({ mode: "open" });
  const id = `explorer-${++count}`;
  const stage = makeStage(store, goTo);
  const sliders = makeSliders(store);
  const tabs = makeTabs(store, views, { id, goTo, point: (row) => store.set({ lit: row }) });
  const head = makeHead(store, { arms, link, goTo, stage });
  const said = h("p.hidden", { role: "status" });
  const card = h("section.explorer", { "aria-label": `Explorer of the ${store.state.arm.name}` },
    head.root, h("div.bench", {}, stage.root, sliders.root), tabs.root, said);
  root.replaceChildren(h("style", {}, css), card, h("div.paper", {}, h("slot")));

  let theme = "light";
  const draw = () => stage.draw(store.state, store.derived, theme);
  const refresh = () => {
    head.update(store.state);
    sliders.update(store.state);
    draw();
    tabs.update(store.state, store.derived, stage.scale());
  };
  watchTheme((now) => {
    theme = now;
    card.dataset.theme = now;
    draw();
  });
  let speech;
  store.listen((changed) => {
    refresh();
    clearTimeout(speech);
    if (changed.has("q")) speech = setTimeout(() => (said.textContent = spoken(store)), 700);
  });

  // Move there at a pace the eye can follow, or at once where motion is unwelcome.
  let moving;
  function goTo(q) {
    cancelAnimationFrame(moving);
    if (calm()) return store.set({ q });
    const [from, start] = [store.state.q, performance.now()];
    const step = (now) => {
      const t = Math.min(1, Math.max(0, now - start) / 450);
      const ease = t * t * (3 - 2 * t);
      store.set({ q: t === 1 ? q : from.map((v, i) => v + ease * (q[i] - v)) });
      if (t < 1) moving = requestAnimationFrame(step);
    };
    moving = requestAnimationFrame(step);
  }
  refresh();
  return { root: card, refresh };
}

function spoken({ derived }) {
  const [x, y, z] = derived.frames.at(-1).o.map((v) => fixed(v, 3));
  return `Tip at x ${x}, y ${y}, z ${z} metres.`;
}

function makeHead(store, { arms, link, goTo, stage }) {
  const name = arms.length > 1
    ? h("select.name", { "aria-label": "Arm", onchange: (e) => choose(arms[e.target.selectedIndex]) }, arms.map((arm) => h("option", {}, arm.name)))
    : h("span.name", {}, store.state.arm.name);
  const units = [["deg", "degrees"], ["rad", "radians"]].map(([unit, title]) =>
    h("button", { type: "button", title, "data-unit": unit, onclick: () => store.set({ unit }) }, unit));
  const frames = h("button", { type: "button", title: "Draw the frame of every link, or the first and the last only", onclick: () => store.set({ frames: store.state.frames === "all" ? "ends" : "all" }) }, "Frames");
  const buttons = [
    h("span.pair", { role: "group", "aria-label": "Unit of angles" }, units), frames,
    h("button", { type: "button", onclick: () => goTo(home(store.state.arm)) }, "Home"),
    h("button", { type: "button", onclick: () => goTo(randomPose(store.state.arm)) }, "Random"),
    h("button.fit", { type: "button", onclick: () => stage.fit() }, "Fit"),
  ];
  if (link) buttons.push(h("button", { type: "button", onclick: (e) => link.copy(e.target) }, "Copy link"));

  function choose(arm) {
    store.set({ arm, reference: arm, q: home(arm), trace: null, ways: null, stray: 0 });
    stage.fit();
  }

  function update(state) {
    for (const button of units) button.setAttribute("aria-pressed", String(button.dataset.unit === state.unit));
    frames.setAttribute("aria-pressed", String(state.frames === "all"));
    if (arms.length > 1) name.selectedIndex = Math.max(0, arms.findIndex((arm) => arm.name === state.arm.name));
  }
  return { root: h("header", {}, name, h("div.buttons", { role: "group", "aria-label": "Settings" }, buttons)), update };
}

const home = (arm) => (arm.home?.length === joints(arm).length ? [...arm.home] : joints(arm).map(() => 0));

// The picture, or words in its place where the browser has no WebGL.
function makeStage(store, goTo) {
  const labels = h("div.labels", { "aria-hidden": true });
  const host = h("div.stage", { tabindex: 0, role: "application", "aria-label": "3D view of the arm. Arrow keys turn it, plus and minus bring it nearer and farther, 0 fits it.", onkeydown: keys, ondblclick: () => stage?.fit() }, labels);
  let stage = null;
  try {
    stage = new Stage(host, labels, {
      onForce: (force) => store.set({ wrench: [...force, ...store.state.wrench.slice(3)] }),
      onBranch: (i) => goTo(store.state.ways[i].q),
    });
  } catch {
    host.classList.add("flat");
    host.replaceChildren(h("slot"), h("p", {}, "The picture in 3D needs WebGL, which this browser does not give. Everything else here works."));
  }

  function keys(event) {
    const [turn, tilt, nearer] = { ArrowLeft: [-0.12, 0], ArrowRight: [0.12, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1], "+": [0, 0, 0.9], "=": [0, 0, 0.9], "-": [0, 0, 1.1] }[event.key] ?? [];
    if (event.key === "0") stage?.fit();
    else if (turn === undefined) return;
    else stage?.orbit(turn, tilt, nearer);
    event.preventDefault();
  }
  return {
    root: host,
    draw: (...state) => stage?.draw(...state),
    fit: () => stage?.fit(),
    scale: () => stage?.ellipsoidScale,
  };
}

// One line for each joint: its name, a slider over its range, a field to type in, its limits.
function makeSliders(store) {
  const root = h("div.sliders", { role: "group", "aria-label": "Joints" });
  const error = h("p.error", { role: "alert" });
  let [lines, shown] = [[], {}];

  const put = (i, value) => store.set({ q: store.state.q.map((v, k) => (k === i ? value : v)) });

  function typed(i, row, input, last) {
    const { value, error: wrong } = readEntry(input.value.replace(/(rad|m)\s*$/, ""), isAngle(row), store.state.unit);
    input.setAttribute("aria-invalid", String(Boolean(wrong)));
    error.textContent = wrong ? `${input.getAttribute("aria-label")}: ${wrong}.` : "";
    if (!wrong && last) put(i, value);
    if (last) input.value = jointText(row, store.state.q[i], store.state.unit), input.setAttribute("aria-invalid", "false"), (error.textContent = wrong ? error.textContent : "");
  }

  function lay({ arm, unit }) {
    lines = joints(arm).map((index, i) => line(arm.rows[index], index, i, unit));
    root.replaceChildren(...lines.map((l) => l.root), error);
    shown = { rows: arm.rows, unit };
  }

  function line(row, index, i, unit) {
    const [lower, upper] = range(row);
    const label = `Joint ${index + 1}, ${row.kind === "revolute" ? "angle" : "slide"}`;
    const slider = h("input", { type: "range", min: lower, max: upper, step: "any", "aria-label": label, "data-joint": index + 1, oninput: (e) => put(i, Number(e.target.value)), onkeydown: (e) => nudge(e, row, i) });
    const field = h("input.value", { type: "text", inputmode: "text", spellcheck: "false", "aria-label": `${label}, typed`, oninput: (e) => typed(i, row, e.target, false), onchange: (e) => typed(i, row, e.target, true) });
    const bounds = h("span.bounds", {}, h("span", {}, row.lower === null ? "" : limitText(row, lower, unit)), h("span.past", {}), h("span", {}, row.upper === null ? "" : limitText(row, upper, unit)));
    const light = (lit) => () => store.set({ lit });
    const root = h("div.joint", { onpointerenter: light(index), onpointerleave: light(null), onfocusin: light(index), onfocusout: light(null) }, h("span.label", {}, indexed("q", index + 1)), h("div.rail", {}, slider, bounds), field);
    return { root, slider, field, bounds, row, index };
  }

  // Native steps of a slider with step="any" are a hundredth of its range; these are whole degrees and millimetres.
  function nudge(event, row, i) {
    const step = (isAngle(row) ? Math.PI / 180 : 0.005) * (event.shiftKey ? 10 : 1);
    const sign = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1, PageUp: 10, PageDown: -10 }[event.key];
    if (!sign) return;
    event.preventDefault();
    const [lower, upper] = range(row);
    put(i, Math.min(upper, Math.max(lower, store.state.q[i] + sign * step)));
  }

  function update(state) {
    if (shown.rows !== state.arm.rows || shown.unit !== state.unit) lay(state);
    lines.forEach(({ root, slider, field, bounds, row, index }, i) => {
      root.classList.toggle("lit", state.lit === index);
      const value = state.q[i];
      const [lower, upper] = range(row);
      slider.value = value;
      slider.setAttribute("aria-valuetext", jointText(row, value, state.unit));
      const [at, zero] = [value, 0].map((v) => 100 * Math.min(1, Math.max(0, (v - lower) / (upper - lower))));
      slider.style.setProperty("--low", `${Math.min(at, zero)}%`);
      slider.style.setProperty("--high", `${Math.max(at, zero)}%`);
      if (field.getRootNode().activeElement !== field) field.value = jointText(row, value, state.unit);
      const past = outside(row, value);
      root.classList.toggle("past", past);
      bounds.children[1].textContent = past ? "past its limit" : "";
    });
  }

  return { root, update };
}

// The views, one at a time, under tabs that arrow keys walk along; a single view needs no tab.
function makeTabs(store, views, tools) {
  const made = new Map();
  const open = (name) => store.set({ view: name });
  const tabs = views.map((name, i) => h("button", { type: "button", role: "tab", id: `${tools.id}-${name}`, "aria-controls": `${tools.id}-panel`, onclick: () => open(name), onkeydown: (e) => walk(e, i) }, VIEWS[name].title));
  const panel = h("div.view", views.length > 1 ? { role: "tabpanel", id: `${tools.id}-panel` } : { id: `${tools.id}-panel` });
  const root = h("div.views", {}, views.length > 1 ? h("div.tabs", { role: "tablist", "aria-label": "Views" }, tabs) : [], panel);

  function walk(event, i) {
    const to = { ArrowRight: i + 1, ArrowLeft: i - 1, Home: 0, End: views.length - 1 }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    const next = (to + views.length) % views.length;
    open(views[next]);
    tabs[next].focus();
  }

  function update(state, derived, scale) {
    const name = state.view;
    if (!made.has(name)) made.set(name, VIEWS[name].build(store, tools));
    const view = made.get(name);
    if (panel.firstChild !== view.root) panel.replaceChildren(view.root);
    panel.setAttribute("aria-labelledby", `${tools.id}-${name}`);
    tabs.forEach((tab, i) => {
      tab.setAttribute("aria-selected", String(views[i] === name));
      tab.tabIndex = views[i] === name ? 0 : -1;
    });
    view.update(state, derived, scale);
  }
  return { root, update };
}
