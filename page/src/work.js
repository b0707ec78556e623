// The long work by name, for the worker and for a page that allows none.

import { otherWays } from "./motion.js";
import { runCircle, traceCircle } from "./homework_run.js";

export const JOBS = {
  ways: ({ arm, q }) => otherWays(arm, q),
  circle: ({ arm, q, circle }) => traceCircle(arm, q, circle),
  run: ({ arm, q, run }) => runCircle(arm, q, run),
};
