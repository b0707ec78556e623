// The long work by name, for the worker and for a page that allows none.

import { otherWays, traceCircle } from "./motion.js";

export const JOBS = {
  ways: ({ arm, q }) => otherWays(arm, q),
  circle: ({ arm, q, circle }) => traceCircle(arm, q, circle),
};
