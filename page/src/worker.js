// The worker's end of jobs.js.

import { JOBS } from "./work.js";

onmessage = ({ data: { job, given } }) => postMessage(JOBS[job](given));
