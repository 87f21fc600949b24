// The program in WebAssembly, in Node: `run` of web/wasi.js, and programs from files.

import { webcrypto } from "node:crypto";
import fs from "node:fs";

// Node 18 has it under another name.
globalThis.crypto ??= webcrypto;
// The module is a module without a package that says so.
const source = fs.readFileSync(new URL("../web/wasi.js", import.meta.url));
export const { run } = await import(`data:text/javascript;base64,${source.toString("base64")}`);

export const compiled = (file) => WebAssembly.compile(fs.readFileSync(file));
