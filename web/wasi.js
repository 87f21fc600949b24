// The part of WASI, the system interface of WebAssembly, that the program asks for: arguments, a clock, and files in memory.
// https://github.com/WebAssembly/WASI/blob/main/legacy/preview1/docs.md

const BAD_FILE = 8;
const INVALID = 28;
const NO_ENTRY = 44;
const NOT_SUPPORTED = 58;

const DIRECTORY = 3;
const REGULAR = 4;
const CHARACTERS = 2;

const CREATE = 1;
const TRUNCATE = 8;

/** The folder that the program sees; files in it are named without it. */
const ROOT = 3;

/** A program needs its second part, which is not there yet. */
export class Incomplete extends Error {}

class Exit extends Error {
  constructor(code) {
    super(`exit ${code}`);
    this.code = code;
  }
}

/** What may grow: bytes of a file, or of an output. */
class Bytes {
  constructor(start = new Uint8Array()) {
    this.bytes = start;
    this.length = start.length;
  }

  write(at, part) {
    const end = at + part.length;
    if (end > this.bytes.length) {
      const grown = new Uint8Array(Math.max(end, 2 * this.bytes.length, 4096));
      grown.set(this.bytes.subarray(0, this.length));
      this.bytes = grown;
    }
    this.bytes.set(part, at);
    this.length = Math.max(this.length, end);
  }

  all() {
    return this.bytes.subarray(0, this.length);
  }
}

/** What ended a program that did not end by itself. A fault of its own is an instruction that cannot be executed. */
function fault(error) {
  if (error instanceof RangeError) return "the work needs more memory or a deeper stack than a browser gives";
  if (error instanceof WebAssembly.RuntimeError) return `this is a fault of the program, or its memory is full (${error.message}); \`subcert serve\` may say more`;
  return error.message;
}

const plain = (path) => path.split("/").filter((part) => part !== "" && part !== ".").join("/");

/**
 * Runs a program once: `module`, and `rest` where it was divided and the second part is there. `files` has the bytes of files by their names. The result has the exit code, the text of the standard
 * output, that of the standard error without the lines of progress, which `onProgress` is told, and the files that were written.
 * `onStart` is told what the program exports.
 */
export function run({ module, rest = null }, args, files, { onProgress = () => {}, onStart = () => {} } = {}) {
  const encoder = new TextEncoder();
  const decoder = new TextDecoder();
  const texts = ["subcert", ...args].map((text) => encoder.encode(`${text}\0`));
  const known = new Map(Object.entries(files).map(([name, bytes]) => [plain(name), new Bytes(bytes)]));
  const written = new Map();
  const output = new Bytes();
  const errors = [];
  let line = "";
  const open = new Map();
  let next = ROOT + 1;
  let memory;

  const view = () => new DataView(memory.buffer);
  const bytes = (at, length) => new Uint8Array(memory.buffer, at, length);
  const name = (at, length) => plain(decoder.decode(bytes(at, length)));
  const isFolder = (path) => path === "" || [...known.keys(), ...written.keys()].some((other) => other.startsWith(`${path}/`));
  const folders = new Set();

  const tell = (text) => {
    line += text;
    const lines = line.split("\n");
    line = lines.pop();
    for (const one of lines) {
      const progress = /^progress: (.*)$/.exec(one);
      if (progress) onProgress(progress[1]);
      else errors.push(one);
    }
  };

  /** File type and size. */
  const describe = (at, type, size) => {
    bytes(at, 64).fill(0);
    view().setUint8(at + 16, type);
    view().setBigUint64(at + 32, BigInt(size), true);
    return 0;
  };

  const lists = (texts) => ({
    sizes(count, size) {
      view().setUint32(count, texts.length, true);
      view().setUint32(size, texts.reduce((sum, text) => sum + text.length, 0), true);
      return 0;
    },
    all(pointers, at) {
      texts.forEach((text, i) => {
        view().setUint32(pointers + 4 * i, at, true);
        bytes(at, text.length).set(text);
        at += text.length;
      });
      return 0;
    },
  });
  const argumentList = lists(texts);
  const environment = lists([]);

  /** Calls `each` with the buffers of a vector until one is not filled, and stores the sum. */
  const scatter = (vector, count, sum, each) => {
    let total = 0;
    for (let i = 0; i < count; i++) {
      const at = view().getUint32(vector + 8 * i, true);
      const length = view().getUint32(vector + 8 * i + 4, true);
      const done = each(bytes(at, length));
      total += done;
      if (done < length) break;
    }
    view().setUint32(sum, total, true);
    return 0;
  };

  const wasi = {
    args_sizes_get: argumentList.sizes,
    args_get: argumentList.all,
    environ_sizes_get: environment.sizes,
    environ_get: environment.all,
    clock_time_get(_id, _precision, at) {
      view().setBigUint64(at, BigInt(Math.round(performance.now() * 1e6)), true);
      return 0;
    },
    random_get(at, length) {
      crypto.getRandomValues(bytes(at, length));
      return 0;
    },
    fd_sync: () => 0,
    fd_close: (fd) => (open.delete(fd) ? 0 : BAD_FILE),
    fd_fdstat_get(fd, at) {
      bytes(at, 24).fill(0);
      view().setUint8(at, fd < ROOT ? CHARACTERS : fd === ROOT ? DIRECTORY : REGULAR);
      view().setBigUint64(at + 8, ~0n, true);
      view().setBigUint64(at + 16, ~0n, true);
      return 0;
    },
    fd_filestat_get(fd, at) {
      if (fd < ROOT) return describe(at, CHARACTERS, 0);
      if (fd === ROOT) return describe(at, DIRECTORY, 0);
      const file = open.get(fd);
      return file ? describe(at, file.bytes ? REGULAR : DIRECTORY, file.bytes?.length ?? 0) : BAD_FILE;
    },
    fd_prestat_get(fd, at) {
      if (fd !== ROOT) return BAD_FILE;
      view().setUint32(at, 0, true);
      view().setUint32(at + 4, 1, true);
      return 0;
    },
    fd_prestat_dir_name(fd, at) {
      if (fd !== ROOT) return BAD_FILE;
      bytes(at, 1)[0] = "/".charCodeAt(0);
      return 0;
    },
    fd_read(fd, vector, count, sum) {
      const file = open.get(fd);
      if (fd === 0) return scatter(vector, count, sum, () => 0);
      if (!file?.bytes) return BAD_FILE;
      return scatter(vector, count, sum, (buffer) => {
        const part = file.bytes.all().subarray(file.at, file.at + buffer.length);
        buffer.set(part);
        file.at += part.length;
        return part.length;
      });
    },
    fd_write(fd, vector, count, sum) {
      const file = open.get(fd);
      return scatter(vector, count, sum, (buffer) => {
        if (fd === 1) output.write(output.length, buffer);
        else if (fd === 2) tell(decoder.decode(buffer));
        else if (file?.bytes) {
          file.bytes.write(file.at, buffer);
          file.at += buffer.length;
        } else return 0;
        return buffer.length;
      });
    },
    fd_seek(fd, offset, whence, at) {
      const file = open.get(fd);
      if (!file?.bytes) return BAD_FILE;
      const from = [0, file.at, file.bytes.length][whence];
      file.at = Math.max(0, from + Number(offset));
      view().setBigUint64(at, BigInt(file.at), true);
      return 0;
    },
    path_open(_folder, _flags, path, length, how, _rights, _inherited, _more, at) {
      const file = name(path, length);
      let found = written.get(file) ?? known.get(file);
      if (!found && (isFolder(file) || folders.has(file))) {
        open.set(next, { at: 0 });
        view().setUint32(at, next++, true);
        return 0;
      }
      if (!found && !(how & CREATE)) return NO_ENTRY;
      if (!found || how & TRUNCATE) {
        found = new Bytes();
        written.set(file, found);
      }
      open.set(next, { bytes: found, at: 0 });
      view().setUint32(at, next++, true);
      return 0;
    },
    path_filestat_get(_folder, _flags, path, length, at) {
      const file = name(path, length);
      const found = written.get(file) ?? known.get(file);
      if (found) return describe(at, REGULAR, found.length);
      return isFolder(file) || folders.has(file) ? describe(at, DIRECTORY, 0) : NO_ENTRY;
    },
    path_create_directory(_folder, path, length) {
      folders.add(name(path, length));
      return 0;
    },
    path_rename(_folder, path, length, _other, to, toLength) {
      const [from, into] = [name(path, length), name(to, toLength)];
      const found = written.get(from) ?? known.get(from);
      if (!found) return NO_ENTRY;
      written.delete(from);
      known.delete(from);
      written.set(into, found);
      return 0;
    },
    path_unlink_file(_folder, path, length) {
      const file = name(path, length);
      return written.delete(file) || known.delete(file) ? 0 : NO_ENTRY;
    },
    path_readlink: () => INVALID,
    proc_exit(code) {
      throw new Exit(code);
    },
  };
  // What else the libraries name is not there. There are no threads.
  const absent = (what) => new Proxy(what, { get: (own, key) => own[key] ?? (() => NOT_SUPPORTED) });
  const attributes = { pthread_attr_init: () => 0, pthread_attr_setstacksize: () => 0, pthread_attr_destroy: () => 0, realpath: () => 0 };
  const system = { wasi_snapshot_preview1: absent(wasi), env: absent(attributes) };
  // Of a divided program, the first part calls functions of the second one through a table, where these stand before: they put
  // the second part there, and call what then stands in their place.
  let whole = false;
  const early = (place) => (...values) => {
    if (!rest) throw new Incomplete();
    if (!whole) new WebAssembly.Instance(rest, { ...system, primary: instance.exports });
    whole = true;
    return instance.exports["%table"].get(Number(place))(...values);
  };
  const instance = new WebAssembly.Instance(module, { ...system, placeholder: new Proxy({}, { get: (_, place) => early(place) }) });
  memory = instance.exports.memory;
  onStart(instance.exports);
  let code = 0;
  try {
    instance.exports._start();
  } catch (error) {
    if (error instanceof Incomplete) throw error;
    if (error instanceof Exit) code = error.code;
    else {
      code = 3;
      errors.push(`error: ${fault(error)}`);
    }
  }
  if (line) errors.push(line);
  return {
    code,
    text: decoder.decode(output.all()),
    errors: errors.join("\n"),
    files: Object.fromEntries([...written].map(([name, bytes]) => [name, bytes.all().slice()])),
  };
}
