// The worker's side of jobs.js.

import { JOBS } from "./work.js";

onmessage = ({ data: { job, input } }) => postMessage(JOBS[job](input));
