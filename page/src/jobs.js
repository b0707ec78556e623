// Long work, done beside the page: a worker for each job.

import { JOBS } from "./work.js";

// Out of the bundle itself, so that a page from a file has one too.
let address = "";

// Do a job, and tell its answer; returns what gives it up.
function start(job, given, tell) {
  const here = () => tell(JOBS[job](given)); // where a page allows no worker
  try {
    address ||= URL.createObjectURL(new Blob([WORKER], { type: "text/javascript" }));
    const worker = new Worker(address);
    worker.onerror = here;
    worker.onmessage = ({ data }) => {
      worker.terminate();
      tell(data);
    };
    worker.postMessage({ job, given });
    return () => worker.terminate();
  } catch {
    here();
    return () => {};
  }
}

/**
 * The answer to a job, later.
 * @param {keyof typeof JOBS} job
 * @param {any} given plain data
 * @returns {Promise<any>}
 */
export const ask = (job, given) => new Promise((done) => start(job, given, done));

// Ask for what only the last request counts: the ones before are given up.
export function latest(job) {
  let giveUp = () => {};
  return (given, then) => {
    giveUp();
    giveUp = start(job, given, then);
  };
}
