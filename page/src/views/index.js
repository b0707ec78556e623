// The views by name, in no order: an explorer says which it shows.

import * as branches from "./branches.js";
import * as jacobian from "./jacobian.js";
import { later } from "./later.js";
import * as pose from "./pose.js";
import * as table from "./table.js";
import * as torque from "./torque.js";

/**
 * A view: `title` of its tab, and `build(store, tools)`, which gives its `root`, `update(state,
 * derived, scale)`, and perhaps `summary(state, derived)`, a sentence for a screen reader.
 */
export const VIEWS = {
  table,
  pose,
  jacobian,
  trace: later("trace", "Circle trace"),
  torque,
  branches,
  homework: later("homework", "Play the homework"),
};
