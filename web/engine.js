// Runs commands of `subcert` and `subcert-check`: in a worker with WebAssembly, or by the program that serves this page.

/** A command that another one of the same kind has replaced, or that was stopped. */
export class Stopped extends Error {}

/** How long a command may run when another one of its kind waits, in milliseconds. */
const PATIENCE = 250;

/** How often a program that serves this page is asked how far it is, in milliseconds. */
const ASKING = 700;

/** The bytes of a program: part of the page, or a file beside it. */
async function bytesOf(name) {
  const inside = document.getElementById(`${name}.wasm`);
  if (!inside) {
    const response = await fetch(`./${name}.wasm`);
    if (!response.ok) throw new Error(`${name}.wasm is not there: ${response.status} ${response.statusText}`);
    return new Uint8Array(await response.arrayBuffer());
  }
  const packed = Uint8Array.from(atob(inside.textContent.trim()), (character) => character.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** A program, whose text in the page is needed no more. */
async function compiled(name) {
  const module = await WebAssembly.compile(await bytesOf(name));
  document.getElementById(`${name}.wasm`)?.remove();
  return module;
}

/** Commands in a worker, which is replaced when one is stopped. A program may be in two parts; the second one is loaded when a command needs it. */
class Local {
  loading = {};
  parts = {};
  worker = null;
  busy = null;

  start() {
    const inside = document.getElementById("worker.js");
    this.worker = inside
      ? new Worker(URL.createObjectURL(new Blob([inside.textContent], { type: "text/javascript" })))
      : new Worker("./worker.js", { type: "module" });
    this.worker.onmessage = ({ data }) => {
      if (data.id !== this.busy?.id) return;
      if (data.answer) this.busy.done(data.answer);
      else if (data.needs) this.complete(data.needs);
      else this.busy.progress(data.progress);
    };
    this.worker.onerror = (event) => {
      // The next command begins with a new one.
      this.worker?.terminate();
      this.worker = null;
      this.fail(event.message || "the worker of this page could not be started");
    };
    this.sent = new Set();
  }

  fail(why) {
    this.busy?.done({ code: 3, text: "", errors: `error: ${why}`, files: {} });
  }

  /** Gives the worker the second part of a program. */
  async complete(program) {
    const { worker } = this;
    try {
      const rest = await this.part(`${program}-rest`);
      worker.postMessage({ program, rest });
    } catch (error) {
      if (worker === this.worker) this.fail(error.message);
    }
  }

  /** A part of a program, which is loaded once; after a failure the next command tries again. */
  part(name) {
    this.loading[name] ??= compiled(name).then((module) => (this.parts[name] = module), (error) => {
      delete this.loading[name];
      throw error;
    });
    return this.loading[name];
  }

  run(job) {
    return new Promise((resolve, reject) => {
      this.busy = { id: job.id, done: resolve, progress: job.progress, reject };
      this.begin(job).catch(reject);
    });
  }

  async begin({ id, program, args, files }) {
    const module = await this.part(program);
    // It may have been stopped while its program was loaded.
    if (this.busy?.id !== id) return;
    if (!this.worker) this.start();
    if (!this.sent.has(program)) {
      this.worker.postMessage({ program, module, rest: this.parts[`${program}-rest`] ?? null });
      this.sent.add(program);
    }
    this.worker.postMessage({ id, program, args, files });
  }

  stop() {
    this.worker?.terminate();
    this.worker = null;
    this.busy?.reject(new Stopped());
    this.busy = null;
  }
}

const toText = (bytes) => btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));
const toBytes = (text) => Uint8Array.from(atob(text), (character) => character.charCodeAt(0));

/** Commands by the program that serves this page. Each run has a name that nobody can guess, by which it alone is stopped. */
class Remote {
  constructor() {
    // Nobody waits for a command of a page that is closed.
    addEventListener("pagehide", () => this.controller && navigator.sendBeacon("./stop", JSON.stringify({ id: this.id })));
  }

  async run(job) {
    this.controller = new AbortController();
    this.id = crypto.randomUUID();
    const files = Object.fromEntries(Object.entries(job.files).map(([name, bytes]) => [name, toText(bytes)]));
    const body = JSON.stringify({ id: this.id, program: job.program, args: job.args, files });
    const asking = setInterval(() => this.ask(job, this.id), ASKING);
    try {
      const response = await fetch("./run", { method: "POST", body, signal: this.controller.signal });
      const answer = await response.json();
      const written = Object.entries(answer.files ?? {}).map(([name, text]) => [name, toBytes(text)]);
      return { ...answer, files: Object.fromEntries(written) };
    } catch (error) {
      if (error.name === "AbortError") throw new Stopped();
      return { code: 3, text: "", errors: `error: the program that serves this page does not answer: ${error.message}`, files: {} };
    } finally {
      clearInterval(asking);
      this.controller = this.id = null;
    }
  }

  /** Asks how far a run is. */
  async ask(job, id) {
    const response = await fetch("./progress", { method: "POST", body: JSON.stringify({ id }) }).catch(() => null);
    const progress = response?.ok && await response.json().catch(() => "");
    if (progress && this.id === id) job.progress(progress);
  }

  stop() {
    if (!this.controller) return;
    this.controller.abort();
    fetch("./stop", { method: "POST", body: JSON.stringify({ id: this.id }) }).catch(() => {});
  }
}

/** What a program cannot be given: an argument ends at a NUL. */
function refusal(args) {
  const wrong = args.find((one) => String(one).includes("\0"));
  return wrong === undefined ? null : new Error(`a text with a NUL character cannot be given to the program: ${String(wrong).replaceAll("\0", "␀").slice(0, 80)}`);
}

/** The JSON that a program wrote. */
function parsed({ text, errors, code }) {
  try {
    return JSON.parse(text);
  } catch {
    const [first] = (text.trim() || errors.trim() || `nothing, exit code ${code}`).split("\n", 1);
    throw new Error(`the program wrote no JSON, but: ${first.slice(0, 200)}`);
  }
}

/**
 * One command at a time. A command with a `kind` replaces one of the same kind that waits, and stops one that has run for a while.
 */
export class Engine {
  waiting = [];
  running = null;
  count = 0;
  /** Told of the command that runs, its progress and its end: { running, since, progress }. */
  onChange = () => {};

  constructor(remote = document.documentElement.dataset.served === "yes") {
    this.system = remote ? new Remote() : new Local();
  }

  /** Runs `subcert ARGS`; `files` are texts or bytes by name. The answer: { code, text, errors, files }. */
  run(args, { files = {}, kind = null, program = "subcert", onProgress = () => {} } = {}) {
    const wrong = refusal([...args, ...Object.keys(files)]);
    if (wrong) return Promise.reject(wrong);
    const encoder = new TextEncoder();
    const bytes = Object.entries(files).map(([name, file]) => [name, typeof file === "string" ? encoder.encode(file) : file]);
    return new Promise((resolve, reject) => {
      const job = { id: ++this.count, args, files: Object.fromEntries(bytes), kind, program, resolve, reject };
      job.progress = (text) => {
        if (this.running !== job) return;
        onProgress(text);
        this.onChange({ running: job, since: job.since, progress: text });
      };
      if (kind !== null) this.replace(kind);
      this.waiting.push(job);
      this.next();
    });
  }

  /** The same, with its JSON; an answer with another exit code than 0 or 1 is an error with its text. */
  async json(args, options = {}) {
    const answer = await this.run([...args, "--format", "json"], options);
    if (answer.code > 1) throw new Error(answer.errors.trim() || `exit code ${answer.code}`);
    return parsed(answer);
  }

  async next() {
    if (this.running || this.waiting.length === 0) return;
    const job = this.waiting.shift();
    this.running = job;
    job.since = performance.now();
    this.onChange({ running: job, since: job.since, progress: "" });
    try {
      job.resolve(await this.system.run(job));
    } catch (error) {
      job.reject(error);
    }
    this.running = null;
    this.onChange({ running: null });
    this.next();
  }

  /** Drops the commands of a kind that wait. */
  forget(kind) {
    this.waiting.filter((job) => job.kind === kind).forEach((job) => job.reject(new Stopped()));
    this.waiting = this.waiting.filter((job) => job.kind !== kind);
  }

  /** Drops them, and stops one of this kind that has run for a while, or when it has. */
  replace(kind) {
    this.forget(kind);
    const old = this.running;
    if (old?.kind !== kind) return;
    const left = Math.max(0, PATIENCE - (performance.now() - old.since));
    setTimeout(() => this.running === old && this.stop(), left);
  }

  /** Drops them, and stops one of this kind at once. */
  end(kind) {
    this.forget(kind);
    if (this.running?.kind === kind) this.stop();
  }

  /** Stops the command that runs. */
  stop() {
    if (this.running) this.system.stop();
  }
}
