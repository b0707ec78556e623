// Lists the long computations by name, for the worker and for pages that allow no worker.

import { findBranches } from "./motion.js";
import { simulateCircle, traceCircle } from "./homework_run.js";

export const JOBS = {
  branches: ({ arm, q }) => findBranches(arm, q),
  circle: ({ arm, q, circle }) => traceCircle(arm, q, circle),
  run: ({ arm, q, run }) => simulateCircle(arm, q, run),
};
