// The judge's script of its own: loaded by a page that has an .arm-judge in it (book/assets/explorer-loader.js).

import css from "./judge.css";
import { kit } from "./kit.js";
import { mount } from "./page.js";

export { kit };
document.head.append(Object.assign(document.createElement("style"), { textContent: css }));
for (const stub of document.querySelectorAll(".arm-judge")) mount(/** @type {HTMLElement} */ (stub));
