// The arm beside a judge: the explorer's picture, which comes when it is near.

import { h } from "../../dom.js";
import { pictureOf } from "./picture.js";

/**
 * At once beside a whole judge, on demand beside a small one.
 * @param {import("../page.js").Judge} judge
 */
export function addArm(judge) {
  const host = /** @type {any} */ (
    h(
      "div.arm-explorer.beside",
      { "data-figure": "answer" },
      h("p.about", {}, "A live picture of the arm."),
    )
  );
  let there = false;
  const show = () => {
    there = true;
    judge.parts.taken.after(host);
    host.dispatchEvent(new Event("arm-explorer", { bubbles: true }));
  };
  if (judge.given) {
    const button = h(
      "button",
      { type: "button", onclick: () => (button.remove(), show()) },
      "Show the arm",
    );
    judge.parts.tools.append(button);
  }
  judge.follow((question, verdict) => {
    const shown = pictureOf(question, verdict);
    if (!shown || same(shown, host.answer)) return;
    host.answer = shown;
    if (!there && !judge.given) show();
    host.dispatchEvent(new Event("answer"));
  });
}

// Whether nothing has changed that the picture shows.
const same = (one, other) => JSON.stringify(one) === JSON.stringify(other);
