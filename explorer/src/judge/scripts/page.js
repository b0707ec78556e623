// What a judge has besides its form and its verdict.

import { judges } from "../judges.js";
import { addTools } from "../page/tools.js";

const script = /** @type {HTMLScriptElement} */ (document.currentScript);
const root = new URL("..", script.src).href;
for (const judge of judges) addTools(judge, root);
