// The modules that the second script builds on, by their path.

import * as arm from "../../judge/geometry/arm.js";
import * as kinematics from "../../judge/geometry/kinematics.js";
import * as linear from "../../judge/geometry/linear.js";
import * as reading from "../../judge/reading/entry.js";
import * as common from "./common.js";
import * as dom from "./dom.js";
import * as entry from "./entry.js";
import * as figures from "./figures.js";
import * as grab from "./grab.js";
import * as jobs from "./jobs.js";
import * as look from "./look.js";
import * as motion from "./motion.js";
import * as rail from "./rail.js";
import * as renderer from "./renderer.js";
import * as runs from "./runs.js";
import * as sameArm from "./same_arm.js";
import * as scene from "./scene.js";
import * as shapes from "./shapes.js";
import * as state from "./state.js";
import * as text from "./text.js";
import * as theme from "./theme.js";
import * as verdicts from "./verdicts.js";

export const kit = {
  "judge/geometry/arm.js": arm,
  "judge/geometry/kinematics.js": kinematics,
  "judge/geometry/linear.js": linear,
  "judge/reading/entry.js": reading,
  "page/src/common.js": common,
  "page/src/dom.js": dom,
  "page/src/entry.js": entry,
  "page/src/figures.js": figures,
  "page/src/grab.js": grab,
  "page/src/jobs.js": jobs,
  "page/src/look.js": look,
  "page/src/motion.js": motion,
  "page/src/rail.js": rail,
  "page/src/renderer.js": renderer,
  "page/src/runs.js": runs,
  "page/src/same_arm.js": sameArm,
  "page/src/scene.js": scene,
  "page/src/shapes.js": shapes,
  "page/src/state.js": state,
  "page/src/text.js": text,
  "page/src/theme.js": theme,
  "page/src/verdicts.js": verdicts,
};
