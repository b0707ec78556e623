// What a judge has besides its form and its verdict.

import { judges } from "../mounted.js";
import { addArm } from "../extras/beside.js";
import { addFiles } from "../extras/files.js";
import { addFilling } from "../extras/filling.js";
import { addPoses } from "../extras/poses.js";
import { addPractice } from "../extras/practice.js";
import { addTools } from "../extras/tools.js";
import { ready } from "../checkers.js";

const script = /** @type {HTMLScriptElement} */ (document.currentScript);
const root = new URL("..", script.src).href;
for (const judge of judges) {
  addTools(judge, root);
  addFilling(judge);
  addFiles(judge);
  addPoses(judge);
  addArm(judge);
  if (!judge.given) addPractice(judge);
  ready(judge.question().ask).catch(() => {}); // said when something is typed
}
