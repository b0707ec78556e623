// A view that comes with the second script: until then its tab says so.

import { h } from "../dom.js";
import { late } from "../figures.js";

/**
 * @param {string} name
 * @param {string} title
 */
export const later = (name, title) => ({
  title,
  build(store, tools) {
    const words = h("p.words", { role: "status" }, "Loading …");
    const root = h("div", {}, words);
    let view = null;
    late(name).then(
      (found) => {
        if (tools.signal.aborted) return;
        view = found.build(store, tools);
        root.replaceChildren(view.root);
        if (store.state.view === name) view.update(store.state, store.derived);
      },
      () =>
        (words.textContent = "This part could not be loaded; opening the page anew tries again."),
    );
    return {
      root,
      update: (...now) => view?.update(...now),
      summary: (...now) => view?.summary(...now) ?? "",
    };
  },
});
