// Long work, done beside the page. Requests are numbered and an answer that came too late is
// dropped.

import { JOBS } from "./work.js";

let worker = null;
let count = 0;
const waiting = new Map();

// One worker for all explorers of a page, out of the bundle itself, so that a page from a file has
// one too.
function start() {
  const address = URL.createObjectURL(new Blob([WORKER], { type: "text/javascript" }));
  worker = new Worker(address);
  URL.revokeObjectURL(address);
  worker.onmessage = ({ data: { id, answer } }) => {
    waiting.get(id)?.done(answer);
    waiting.delete(id);
  };
  worker.onerror = () => {
    worker = false; // a page that allows no worker does the work itself
    for (const { job, given, done } of waiting.values()) done(JOBS[job](given));
    waiting.clear();
  };
}

/**
 * The answer to a job, later.
 * @param {keyof typeof JOBS} job
 * @param {any} given plain data
 * @returns {Promise<any>}
 */
export function ask(job, given) {
  if (worker === null) {
    try {
      start();
    } catch {
      worker = false;
    }
  }
  if (!worker) return Promise.resolve().then(() => JOBS[job](given));
  return new Promise((done) => {
    waiting.set(++count, { job, given, done });
    worker.postMessage({ id: count, job, given });
  });
}

// Ask for what only the last request counts: earlier answers never come.
export function latest(job) {
  let last = 0;
  return async (given, then) => {
    const mine = ++last;
    const answer = await ask(job, given);
    if (mine === last) then(answer);
  };
}
