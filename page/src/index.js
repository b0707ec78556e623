// Entry points of the bundle: widgets for a running notebook and `mount` for the stubs of a page.

import { isJointVector, TYPED_ARM_NAME } from "../../judge/geometry/arm.js";
import { linkFrames } from "../../judge/geometry/kinematics.js";
import { hasTaskOrientation } from "../../judge/geometry/task_rows.js";
import { syncWithAddress } from "./link.js";
import { FIGURES } from "./more/kinds.js";
import { buildPanel } from "./panel.js";
import { getUsage, getContextLoser } from "./renderer.js";
import { makeInitialState, Store } from "./state.js";

// Used by the tests.
export { getUsage, getContextLoser };

// Return a branch set for branches that Python or a page lists; their pose is that of the first.
function makeBranchSet(arm, branches) {
  if (!branches) return null;
  const list = branches.filter(({ q }) => isJointVector(arm, q));
  const target = linkFrames(arm, list[0]?.q ?? arm.rows.map(() => 0)).at(-1);
  return { list, families: [], lockedJoint: -1, target, hasOrientation: hasTaskOrientation(arm) };
}

/** @returns {import("./state.js").State} */
function makeStateFromSpec(spec) {
  const [arm] = spec.arms;
  return makeInitialState({
    arm,
    reference: spec.reference ?? arm,
    q: spec.q,
    wrench: spec.wrench,
    unit: spec.unit,
    view: spec.views[0],
    frames: spec.views[0] === "table" ? "all" : "ends",
    trace: spec.trace,
    branches: makeBranchSet(arm, spec.branches),
  });
}

// Mount the explorer or figure that a stub describes. Mounting the same stub again has no effect.
export function mount(stub) {
  stub.explorer ??= bringToLife(stub);
  return stub.explorer;
}

function bringToLife(stub) {
  const { figure } = stub.dataset;
  const spec = JSON.parse(stub.querySelector("script").textContent);
  if (figure) return { dispose: FIGURES[figure](stub, spec) };
  const store = new Store(makeStateFromSpec(spec));
  const makeLink = spec.link
    ? (notify, signal) => syncWithAddress(store, spec.arms, spec.views, notify, signal)
    : undefined;
  const dispose = buildPanel(stub, store, { ...spec, makeLink });
  return { store, dispose };
}

// Traits that are kept equal in Python and in the store: how each is read from the state, and the
// state field that it belongs to.
const TRAITS = {
  q: { from: (state) => state.q, field: "q" },
  wrench: { from: (state) => state.wrench, field: "wrench" },
  trace: { from: (state) => state.trace, field: "trace" },
  branches: { from: (state) => state.branches?.list ?? null, field: "branches" },
  arm_name: { from: (state) => state.base.name, field: "arm" },
  rows: { from: (state) => (state.arm === state.base ? [] : state.arm.rows), field: "arm" },
};
const SEND_INTERVAL = 50; // ms between two messages to the kernel

// Return the patch that makes the state agree with the model. The arm comes first because the other
// fields depend on it.
function makePatchFromModel(model, state) {
  const { arms } = model.get("_spec");
  const base = arms.find((arm) => arm.name === model.get("arm_name")) ?? state.base;
  const same = state.base.name === base.name;
  const rows = model.get("rows");
  const arm = rows.length ? getTypedArm(rows, state.arm) : same ? state.base : base;
  const sent = model.get("branches");
  const syncModel = isEqualJson(sent, state.branches?.list ?? null) && state.arm === arm;
  const trace = model.get("trace");
  return {
    arm,
    base: same ? state.base : base,
    reference: same ? state.reference : base,
    q: [...model.get("q")],
    wrench: [...model.get("wrench")],
    trace: isEqualJson(trace, state.trace) ? state.trace : trace,
    branches: syncModel ? state.branches : makeBranchSet(arm, sent),
  };
}

// Return the arm with rows typed in Python. If these are the rows of the shown arm, its limits and
// masses are kept.
const getTypedArm = (rows, shown) =>
  isEqualJson(rows, shown.rows) ? shown : { name: TYPED_ARM_NAME, home: [], rows };

const isEqualJson = (a, b) => JSON.stringify(a) === JSON.stringify(b);

// Make a widget whose views, in whichever cells, share one store.
export function widget() {
  let store = null;

  function initialize({ model }) {
    const spec = model.get("_spec");
    const given = Object.fromEntries(
      ["q", "wrench", "trace", "branches"].map((name) => [name, model.get(name)]),
    );
    store = new Store(makeStateFromSpec({ ...spec, ...given }));
    return kept(model, store);
  }

  const render = ({ model, el }) =>
    renderOutput(el, (host) => buildPanel(host, store, model.get("_spec")));
  return { initialize, render };
}

// Build into the output of a notebook's cell, and return a function that removes what was built.
// `build` returns such a function too.
function renderOutput(el, build) {
  const host = document.createElement("div");
  // Keys typed here must not trigger JupyterLab's commands.
  host.dataset.lmSuppressShortcuts = "true";
  el.append(host);
  const showStill = hideStill(el);
  const dispose = build(host);
  return () => {
    showStill();
    dispose();
    host.remove();
  };
}

// Hide the still picture that JupyterLab shows in the output before a live figure; returns a
// function that shows it again. The figure is drawn before its element stands in the notebook.
function hideStill(el) {
  let still = null;
  let frame = requestAnimationFrame(function hide() {
    if (!el.isConnected) frame = requestAnimationFrame(hide);
    else {
      still = el.closest(".jp-OutputArea-child")?.previousElementSibling;
      if (!still?.querySelector(".jp-RenderedSVG")) still = null;
      still?.style.setProperty("display", "none");
    }
  });
  return () => {
    cancelAnimationFrame(frame);
    still?.style.removeProperty("display");
  };
}

// Keep a model and a store equal; returns a function that stops this.
function kept(model, store) {
  const fields = new Set(Object.values(TRAITS).map(({ field }) => field));
  const abort = new AbortController();
  let [timer, hearing, sending] = [null, null, false];
  const send = () => {
    timer = null;
    sending = true;
    for (const [trait, { from }] of Object.entries(TRAITS)) {
      const value = from(store.state);
      if (!isEqualJson(model.get(trait), value)) model.set(trait, value);
    }
    sending = false;
    model.save_changes();
  };
  store.listen((changed, by) => {
    if (by !== "python" && [...changed].some((key) => fields.has(key)))
      timer ??= setTimeout(send, SEND_INTERVAL);
  }, abort.signal);
  // Python may set several traits one after another. They are applied together once the last one
  // has arrived.
  const hear = () => {
    if (sending) return;
    hearing ??= setTimeout(() => {
      hearing = null;
      store.dispatch({ type: "replaceState", ...makePatchFromModel(model, store.state) }, "python");
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

// A small figure as the output of a notebook cell. JupyterLab runs no scripts in a text cell, so a
// stub there would stay still.
export const figureWidget = () => ({
  render({ model, el }) {
    const spec = model.get("_spec");
    return renderOutput(el, (host) => FIGURES[spec.figure](host, spec));
  },
});
