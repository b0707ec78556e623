// The modules that the second script builds on, by their path in src/.

import * as arm from "./arm.js";
import * as common from "./common.js";
import * as dom from "./dom.js";
import * as figures from "./figures.js";
import * as grab from "./grab.js";
import * as jobs from "./jobs.js";
import * as kinematics from "./kinematics.js";
import * as linear from "./linear.js";
import * as motion from "./motion.js";
import * as rail from "./rail.js";
import * as renderer from "./renderer.js";
import * as runs from "./runs.js";
import * as same from "./same.js";
import * as scene from "./scene.js";
import * as shapes from "./shapes.js";
import * as state from "./state.js";
import * as still from "./still.js";
import * as text from "./text.js";
import * as theme from "./theme.js";
import * as verdicts from "./verdicts.js";
import * as plots from "./views/plots.js";
import * as transport from "./views/transport.js";

export const kit = {
  "arm.js": arm, "common.js": common, "dom.js": dom, "figures.js": figures, "grab.js": grab,
  "jobs.js": jobs, "kinematics.js": kinematics, "linear.js": linear, "motion.js": motion, "rail.js": rail,
  "renderer.js": renderer, "runs.js": runs, "same.js": same, "scene.js": scene, "shapes.js": shapes,
  "state.js": state, "still.js": still, "text.js": text, "theme.js": theme, "verdicts.js": verdicts,
  "views/plots.js": plots, "views/transport.js": transport,
}; // prettier-ignore
