// What a judge has besides its form and its verdict.

import { judges } from "../main.js";
import { addFiles } from "../extras/files.js";
import { addTools } from "../extras/tools.js";
import { ready } from "../checkers.js";

const script = /** @type {HTMLScriptElement} */ (document.currentScript);
const root = new URL("..", script.src).href;
for (const judge of judges) {
  addTools(judge, root);
  addFiles(judge);
  ready(judge.question().ask).catch(() => {}); // said when something is typed
}
