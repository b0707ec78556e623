// What a judge has besides its form and its verdict.

import { judges } from "../judges.js";
import { addArm } from "../page/beside.js";
import { addFilling } from "../page/filling.js";
import { addTools } from "../page/tools.js";
import { ready } from "../registry.js";

const script = /** @type {HTMLScriptElement} */ (document.currentScript);
const root = new URL("..", script.src).href;
for (const judge of judges) {
  addTools(judge, root);
  addFilling(judge);
  addArm(judge);
  ready(judge.question().ask).catch(() => {}); // said when something is typed
}
