// The judge's script of its own: loaded by a page that has an .arm-judge in it
// (book/assets/explorer-loader.js).

import css from "./check.css";
import { mount } from "./page.js";
import { loaded } from "../scripts.js";

/** @type {import("./page.js").Judge[]} */
export const judges = [];

document.head.append(Object.assign(document.createElement("style"), { textContent: css }));
for (const stub of document.querySelectorAll(".arm-judge"))
  judges.push(mount(/** @type {HTMLElement} */ (stub)));

// What a whole page of it has besides comes at once, for a small one when it is used.
if (judges.some(({ given }) => !given)) loaded("judge-page.js");
else
  for (const { stub } of judges)
    stub.addEventListener("focusin", () => loaded("judge-page.js"), { once: true });
