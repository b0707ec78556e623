// The views, one at a time, under tabs that arrow keys walk along; a single view needs no tab.

import { h } from "../dom.js";
import { VIEWS } from "../views/index.js";

export function makeTabs(store, views, tools) {
  const made = new Map();
  const open = (name) => store.dispatch({ type: "show", view: name });
  const several = views.length > 1;
  const tabs = views.map((name, i) =>
    h(
      "button",
      {
        type: "button",
        role: "tab",
        id: `${tools.id}-${name}`,
        "aria-controls": `${tools.id}-panel`,
        onclick: () => open(name),
        onkeydown: (e) => walk(e, i),
      },
      VIEWS[name].title,
    ),
  );
  const panel = h("div.view", {
    id: `${tools.id}-panel`,
    ...(several ? { role: "tabpanel" } : {}),
  });
  const strip = several ? h("div.tabs", { role: "tablist", "aria-label": "Views" }, tabs) : [];
  const root = h("div.views", {}, strip, panel);

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
    if (panel.firstChild !== view.root) {
      panel.replaceChildren(view.root);
      if (several) panel.setAttribute("aria-labelledby", `${tools.id}-${name}`);
      tabs.forEach((tab, i) => {
        tab.setAttribute("aria-selected", String(views[i] === name));
        tab.tabIndex = views[i] === name ? 0 : -1;
      });
    }
    view.update(state, derived, scale);
  }
  const summary = (state, derived) => made.get(state.view)?.summary?.(state, derived) ?? "";
  const dispose = () => made.forEach((view) => view.dispose?.());
  return { root, update, summary, dispose };
}
