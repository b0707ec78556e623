// The views under tabs; arrow keys move between tabs. A single view has no tab.

import { h } from "../dom.js";
import { VIEWS } from "../views/index.js";

export function makeTabs(store, views, tools) {
  const builtViews = new Map();
  const several = views.length > 1;
  const tabs = views.map((name) => makeTab(name, tools.id));
  tabs.forEach((tab, i) => {
    tab.addEventListener("click", () => open(i));
    tab.addEventListener("keydown", (event) => {
      const next = getTabAfterKey(event.key, i, views.length);
      if (next === null) return;
      event.preventDefault();
      open(next);
      tabs[next].focus();
    });
  });
  const open = (i) => store.dispatch({ type: "setFields", view: views[i] });
  const role = several ? { role: "tabpanel" } : {};
  const panel = h("div.view", { id: `${tools.id}-panel`, ...role });
  const strip = several ? h("div.tabs", { role: "tablist", "aria-label": "Views" }, tabs) : [];

  function show(name, view) {
    panel.replaceChildren(view.root);
    if (several) panel.setAttribute("aria-labelledby", `${tools.id}-${name}`);
    tabs.forEach((tab, i) => {
      tab.setAttribute("aria-selected", String(views[i] === name));
      tab.tabIndex = views[i] === name ? 0 : -1;
    });
  }

  function update(state, derived) {
    const name = state.view;
    if (!builtViews.has(name)) builtViews.set(name, VIEWS[name].build(store, tools));
    const view = builtViews.get(name);
    if (panel.firstChild !== view.root) show(name, view);
    view.update(state, derived);
  }
  const summary = (state, derived) => builtViews.get(state.view)?.summary?.(state, derived) ?? "";
  return { root: h("div.views", {}, strip, panel), update, summary };
}

const makeTab = (name, id) =>
  h(
    "button",
    { role: "tab", id: `${id}-${name}`, "aria-controls": `${id}-panel` },
    VIEWS[name].title,
  );

// Return the index of the tab that a key leads to, or null for other keys.
function getTabAfterKey(key, i, count) {
  const to = { ArrowRight: i + 1, ArrowLeft: i - 1, Home: 0, End: count - 1 }[key];
  return to === undefined ? null : (to + count) % count;
}
