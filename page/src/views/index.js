// The views by name; an explorer lists which it shows and in which order.

import * as branches from "./branches.js";
import * as homework from "./homework.js";
import * as jacobian from "./jacobian.js";
import * as pose from "./pose.js";
import * as table from "./table.js";
import * as torque from "./torque.js";
import * as trace from "./trace.js";

/**
 * A view has a `title` for its tab and `build(store, tools)`, which returns `root`, `update(state,
 * derived)` and optionally `summary(state, derived)`, a sentence for screen readers.
 */
export const VIEWS = {
  table,
  pose,
  jacobian,
  trace,
  torque,
  branches,
  homework,
};
