// The two ways in: a widget in a notebook that runs, and a stub in a page that does not.

import * as kinematics from "./kinematics.js";
import { keepLink } from "./link.js";
import { buildPanel, VIEWS } from "./panel.js";
import { derive, Store } from "./state.js";

export { derive, kinematics };

function initial(spec) {
  const [arm] = spec.arms;
  const views = spec.views.filter((name) => name in VIEWS);
  return {
    arm, reference: spec.reference ?? arm, q: spec.q, wrench: spec.wrench, unit: spec.unit, view: views[0],
    frames: views[0] === "table" ? "all" : "ends", trace: spec.trace ?? null, stray: 0, ways: spec.branches ?? null, highlighted: null, lit: null,
  };
}

// Bring a page's stub to life.
export function mount(stub) {
  const spec = JSON.parse(stub.querySelector("script[type='application/json']").textContent);
  const store = new Store(initial(spec));
  const link = spec.link ? keepLink(store, spec.arms, spec.views) : null;
  buildPanel(stub, store, { ...spec, link });
  return store;
}

// What goes over to Python when it changes here, and back: the state's field and the widget's trait.
const SYNCED = { q: "q", wrench: "wrench", trace: "trace", ways: "branches" };
const PACE = 50; // ms between two messages to the kernel

function render({ model, el }) {
  const store = new Store(initial({ ...model.get("spec"), ...fromModel(model) }));
  const host = document.createElement("div");
  el.append(host);
  buildPanel(host, store, { ...model.get("spec"), link: null });

  let timer = null;
  let sending = false;
  const send = () => {
    timer = null;
    sending = true;
    const { arm, reference } = store.state;
    model.set("arm_name", reference.name);
    model.set("rows", arm === reference ? [] : arm.rows);
    for (const [field, trait] of Object.entries(SYNCED)) model.set(trait, store.state[field]);
    sending = false;
    model.save_changes();
  };
  const told = ["arm", ...Object.keys(SYNCED)];
  store.listen((changed, by) => {
    if (by !== "python" && told.some((field) => changed.has(field))) timer ??= setTimeout(send, PACE);
  });
  const hear = () => {
    if (!sending) store.set(fromModel(model, store), "python");
  };
  for (const trait of Object.values(SYNCED)) model.on(`change:${trait}`, hear);
}

function fromModel(model, store) {
  const state = Object.fromEntries(Object.entries(SYNCED).map(([field, trait]) => [field, model.get(trait)]));
  return store ? state : { ...state, branches: state.ways };
}

export default { render };
