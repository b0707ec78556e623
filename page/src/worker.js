// The worker's end of jobs.js.

import { JOBS } from "./work.js";

onmessage = ({ data: { id, job, given } }) => postMessage({ id, answer: JOBS[job](given) });
