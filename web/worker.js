// Runs commands one after the other, away from the page.

import { Incomplete, run } from "./wasi.js";

const programs = {};
/** What waits for the second part of its program. */
let waiting = null;

function work({ id, program, args, files }) {
  try {
    const answer = run(programs[program], args, files, { onProgress: (progress) => self.postMessage({ id, progress }) });
    self.postMessage({ id, answer });
  } catch (error) {
    if (!(error instanceof Incomplete)) throw error;
    waiting = { id, program, args, files };
    self.postMessage({ id, needs: program });
  }
}

self.onmessage = ({ data }) => {
  if (data.module) {
    programs[data.program] = data;
    return;
  }
  if (data.rest) {
    programs[data.program].rest = data.rest;
    const job = waiting;
    waiting = null;
    if (job) work(job);
  } else work(data);
};
