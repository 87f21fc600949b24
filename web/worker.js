// Runs commands one after the other, away from the page.

import { run } from "./wasi.js";

const programs = {};

self.onmessage = ({ data }) => {
  if (data.module) {
    programs[data.program] = data.module;
    return;
  }
  const { id, program, args, files } = data;
  const answer = run(programs[program], args, files, (progress) => self.postMessage({ id, progress }));
  self.postMessage({ id, answer });
};
