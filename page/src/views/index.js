// The views by name, in no order: an explorer says which it shows.

import * as branches from "./branches.js";
import * as homework from "./homework.js";
import * as jacobian from "./jacobian.js";
import * as pose from "./pose.js";
import * as table from "./table.js";
import * as torque from "./torque.js";
import * as trace from "./trace.js";

/**
 * A view: `title` of its tab, and `build(store, tools)`, which gives its `root`, `update(state,
 * derived)`, and perhaps `summary(state, derived)`, a sentence for a screen reader.
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
