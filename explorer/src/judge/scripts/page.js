// What a judge has besides its form and its verdict.

import { judges } from "../judges.js";
import { addArm } from "../page/beside.js";
import { addFiles } from "../page/files.js";
import { addFilling } from "../page/filling.js";
import { addPoses } from "../page/poses.js";
import { addPractice } from "../page/practice.js";
import { addTools } from "../page/tools.js";
import { ready } from "../registry.js";

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
