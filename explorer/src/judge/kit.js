// The modules that the checkers' scripts share with the first one, by their path in src/.

import * as arm from "../arm.js";
import * as dom from "../dom.js";
import * as kinematics from "../kinematics.js";
import * as ask from "./ask.js";
import * as digits from "./digits.js";
import * as door from "./door.js";
import * as formula from "./formula.js";
import * as grid from "./grid.js";
import * as judges from "./judges.js";
import * as ownValues from "./own_values.js";
import * as ranking from "./ranking.js";
import * as registry from "./registry.js";
import * as say from "./say.js";
import * as shown from "./shown.js";

export const kit = {
  "arm.js": arm, "dom.js": dom, "kinematics.js": kinematics, "judge/ask.js": ask, "judge/digits.js": digits,
  "judge/door.js": door, "judge/formula.js": formula, "judge/grid.js": grid, "judge/judges.js": judges,
  "judge/own_values.js": ownValues, "judge/ranking.js": ranking, "judge/registry.js": registry,
  "judge/say.js": say, "judge/shown.js": shown,
}; // prettier-ignore
