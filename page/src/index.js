// The ways in: a widget in a notebook that runs, and a stub in a page that does not.

import { isJointVector, TYPED_ARM_NAME } from "../../judge/geometry/arm.js";
import { linkFrames } from "../../judge/geometry/kinematics.js";
import { keepLink } from "./link.js";
import { asked } from "./verdicts.js";
import { FIGURES } from "./more/kinds.js";
import { buildPanel } from "./panel.js";
import { inUse, loseContext } from "./renderer.js";
import { startingState, Store } from "./state.js";

// For the tests.
export { inUse, loseContext };

// Ways that Python or a page gives, with the pose that they lead to.
function waysFrom(arm, branches) {
  if (!branches) return null;
  const list = branches.filter(({ q }) => isJointVector(arm, q));
  const target = linkFrames(arm, list[0]?.q ?? arm.rows.map(() => 0)).at(-1);
  return { list, families: [], held: -1, target, whole: asked(arm) === 6 };
}

/** @returns {import("./state.js").State} */
function initial(spec) {
  const [arm] = spec.arms;
  return startingState({
    arm,
    reference: spec.reference ?? arm,
    q: spec.q,
    wrench: spec.wrench,
    unit: spec.unit,
    view: spec.views[0],
    frames: spec.views[0] === "table" ? "all" : "ends",
    trace: spec.trace,
    ways: waysFrom(arm, spec.branches),
  });
}

// Bring a page's stub to life; the stub knows then its store and what takes it away.
export function mount(stub) {
  stub.explorer ??= brought(stub);
  return stub.explorer;
}

function brought(stub) {
  const { figure } = stub.dataset;
  const spec = JSON.parse(stub.querySelector("script").textContent);
  if (figure) return { dispose: FIGURES[figure](stub, spec) };
  const store = new Store(initial(spec));
  const makeLink = spec.link
    ? (tell, signal) => keepLink(store, spec.arms, spec.views, tell, signal)
    : undefined;
  const dispose = buildPanel(stub, store, { ...spec, makeLink });
  return { store, dispose };
}

// What goes over to Python when it changes here, and back: the trait, how it is read from the
// state, and the patch that it makes of a state.
const TRAITS = {
  q: { from: (state) => state.q, field: "q" },
  wrench: { from: (state) => state.wrench, field: "wrench" },
  trace: { from: (state) => state.trace, field: "trace" },
  branches: { from: (state) => state.ways?.list ?? null, field: "ways" },
  arm_name: { from: (state) => state.base.name, field: "arm" },
  rows: { from: (state) => (state.arm === state.base ? [] : state.arm.rows), field: "arm" },
};
const PACE = 50; // ms between two messages to the kernel

// The state that the model asks for; arm first, since the others are said of it.
function asModel(model, state) {
  const { arms } = model.get("_spec");
  const base = arms.find((arm) => arm.name === model.get("arm_name")) ?? state.base;
  const same = state.base.name === base.name;
  const rows = model.get("rows");
  const arm = rows.length ? typedBy(rows, state.arm) : same ? state.base : base;
  const sent = model.get("branches");
  const kept = sameJson(sent, state.ways?.list ?? null) && state.arm === arm;
  const trace = model.get("trace");
  return {
    arm,
    base: same ? state.base : base,
    reference: same ? state.reference : base,
    q: [...model.get("q")],
    wrench: [...model.get("wrench")],
    trace: sameJson(trace, state.trace) ? state.trace : trace,
    ways: kept ? state.ways : waysFrom(arm, sent),
  };
}

// The arm of rows that Python typed: the one that is shown, where they are its own.
const typedBy = (rows, shown) =>
  sameRows(rows, shown.rows) ? shown : { name: TYPED_ARM_NAME, home: [], rows };

const sameJson = (a, b) => JSON.stringify(a) === JSON.stringify(b);
const sameRows = (a, b) => a === b || sameJson(a, b);

// One store for each model: all its views, in whichever cells, show the same.
export function widget() {
  let store = null;

  function initialize({ model }) {
    const spec = model.get("_spec");
    const given = Object.fromEntries(
      ["q", "wrench", "trace", "branches"].map((name) => [name, model.get(name)]),
    );
    store = new Store(initial({ ...spec, ...given }));
    return kept(model, store);
  }

  function render({ model, el }) {
    const host = hostIn(el);
    const dispose = buildPanel(host, store, model.get("_spec"));
    return () => {
      dispose();
      host.remove();
    };
  }
  return { initialize, render };
}

function hostIn(el) {
  const host = document.createElement("div");
  host.dataset.lmSuppressShortcuts = "true"; // keys typed here are no commands of JupyterLab's
  el.append(host);
  return host;
}

// Keep a model and a store in step, until what is returned is called.
function kept(model, store) {
  const fields = new Set(Object.values(TRAITS).map(({ field }) => field));
  const abort = new AbortController();
  let [timer, hearing, sending] = [null, null, false];
  const send = () => {
    timer = null;
    sending = true;
    for (const [trait, { from }] of Object.entries(TRAITS)) {
      const value = from(store.state);
      if (!sameJson(model.get(trait), value)) model.set(trait, value);
    }
    sending = false;
    model.save_changes();
  };
  store.listen((changed, by) => {
    if (by !== "python" && [...changed].some((key) => fields.has(key)))
      timer ??= setTimeout(send, PACE);
  }, abort.signal);
  // Python may set several traits one after the other: they are taken together once the last has
  // come.
  const hear = () => {
    if (sending) return;
    hearing ??= setTimeout(() => {
      hearing = null;
      store.dispatch({ type: "set", ...asModel(model, store.state) }, "python");
    });
  };
  const traits = Object.keys(TRAITS).map((trait) => `change:${trait}`);
  for (const change of traits) model.on(change, hear);
  return () => {
    abort.abort();
    clearTimeout(timer);
    clearTimeout(hearing);
    for (const change of traits) model.off(change, hear);
  };
}

// A small figure as an object of a notebook, where a text cell's stub would stay what it is.
export const figureWidget = () => ({
  render({ model, el }) {
    const host = hostIn(el);
    const spec = model.get("_spec");
    const dispose = FIGURES[spec.figure](host, spec);
    return () => {
      dispose();
      host.remove();
    };
  },
});
