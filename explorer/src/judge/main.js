// The judge's script of its own: loaded by a page that has an .arm-judge in it (book/assets/explorer-loader.js).

import sentences from "../../../helpers/reading/sentences.json";
import css from "./judge.css";
import { mount } from "./page.js";
import { learn } from "./say.js";

learn(sentences);
document.head.append(Object.assign(document.createElement("style"), { textContent: css }));
for (const stub of document.querySelectorAll(".arm-judge")) mount(/** @type {HTMLElement} */ (stub));
