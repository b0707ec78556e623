// The long work by name, for the worker and for a page that allows none.

import { otherWays, traceCircle } from "./motion.js";
import { runCircle } from "./homework_run.js";

export const JOBS = {
  ways: ({ arm, q }) => otherWays(arm, q),
  circle: ({ arm, q, circle }) => traceCircle(arm, q, circle),
  run: ({ arm, q, run }) => runCircle(arm, q, run),
};
