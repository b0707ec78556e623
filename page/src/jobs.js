// Runs long computations, each in a worker of its own.

import { JOBS } from "./work.js";

// The worker's script is part of the bundle, because a page opened from a file may not load
// another.
let workerUrl = "";

// Start a job, and return a function that cancels it.
function startJob(job, input, onResult) {
  const runHere = () => onResult(JOBS[job](input)); // fallback for pages that allow no worker
  try {
    workerUrl ||= URL.createObjectURL(new Blob([WORKER], { type: "text/javascript" }));
    const worker = new Worker(workerUrl);
    worker.onerror = runHere;
    worker.onmessage = ({ data }) => {
      worker.terminate();
      onResult(data);
    };
    worker.postMessage({ job, input });
    return () => worker.terminate();
  } catch {
    runHere();
    return () => {};
  }
}

/**
 * Run a job in a worker.
 * @param {keyof typeof JOBS} job
 * @param {any} input plain data
 * @returns {Promise<any>}
 */
export const runJob = (job, input) => new Promise((done) => startJob(job, input, done));

// Make a function that runs a job and cancels the previous one if it is still running.
export function makeLatestJob(job) {
  let giveUp = () => {};
  return (input, then) => {
    giveUp();
    giveUp = startJob(job, input, then);
  };
}
