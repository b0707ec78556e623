// The modules that the checkers' scripts share with the first one, by their path.

import * as digits from "../../../judge/digits.js";
import * as arm from "../../../judge/geometry/arm.js";
import * as kinematics from "../../../judge/geometry/kinematics.js";
import * as formula from "../../../judge/reading/formula.js";
import * as grid from "../../../judge/reading/grid.js";
import * as numbers from "../../../judge/reading/numbers.js";
import * as values from "../../../judge/reading/values.js";
import * as report from "../../../judge/report.js";
import * as sentences from "../../../judge/sentences.js";
import * as checkers from "./checkers.js";
import * as mounted from "./mounted.js";
import * as question from "./question.js";
import * as shown from "./shown.js";
import * as dom from "../dom.js";

export const kit = {
  "judge/digits.js": digits,
  "judge/geometry/arm.js": arm,
  "judge/geometry/kinematics.js": kinematics,
  "judge/reading/formula.js": formula,
  "judge/reading/grid.js": grid,
  "judge/reading/numbers.js": numbers,
  "judge/reading/values.js": values,
  "judge/report.js": report,
  "judge/sentences.js": sentences,
  "page/src/check/checkers.js": checkers,
  "page/src/check/mounted.js": mounted,
  "page/src/check/question.js": question,
  "page/src/check/shown.js": shown,
  "page/src/dom.js": dom,
};
