// The program in WebAssembly and the program of this machine answer alike: the same text, messages and exit code for every example of the
// documentation, and for these commands as JSON.
//
//     node .ci/answers.mjs target/release/subcert web/subcert.wasm

import { spawnSync } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import { compiled, run } from "./wasi.mjs";

const root = path.resolve(path.dirname(process.argv[1]), "..");
const [program, wasm] = process.argv.slice(2).map((file) => path.resolve(file));
process.chdir(root);

/** What differs for a reason: the program measures time, the answer is what was found until the time was over, or it is about the machine. */
const LEFT_OUT = [/^certify /, /--seconds/, /^serve/];

/** What takes more than a minute there. */
LEFT_OUT.push(/^range butterfly-regular/, /^audit --full/);

/** More commands than the documentation has, as JSON. */
const MORE = [
  "schemes", "scheme chaikin", "scheme four-point:w=1/16", "scheme loop:N=7", "scheme courant", "smoothness six-point:w=3/256",
  "constants ternary-four-point -c 3", "range four-point w --smoothness 1", "range six-point w -c 2", "smoothness kobbelt",
  "depth chaikin --polygon examples/polygon.csv --tolerance 1/100", "depth catmull-clark --mesh examples/cube.obj --tolerance 1/100",
  "range butterfly-regular --param w --smoothness 1 --seconds 1", "audit examples/first-paper.toml",
  "audit examples/my-paper.toml --certified", "explain doe2026-corner:eq-3 examples/my-paper.toml",
  "jsr examples/pair.txt", "spectrum doo-sabin --valence 5", "constants [1,3,3,1]/5", "constants nonsense", "depth chaikin --mesh examples/none.obj",
].map((line) => `${line} --format json`);

const texts = ["README.md", ...fs.readdirSync("docs").filter((name) => name.endsWith(".md")).map((name) => `docs/${name}`)];
const lines = texts.flatMap((file) => [...fs.readFileSync(file, "utf8").matchAll(/<!-- run[^:]*: subcert ([^\n]*?) -->/g)].map((found) => found[1]));
const files = {};
for (const folder of ["examples", "proofs/claims", "proofs/projects"]) {
  for (const name of fs.readdirSync(folder, { recursive: true })) {
    const file = path.join(folder, name);
    if (fs.statSync(file).isFile()) files[file] = fs.readFileSync(file);
  }
}

/** The words of a line as a shell reads them, without variables. */
const words = (line) => [...line.matchAll(/'([^']*)'|"([^"]*)"|(\S+)/g)].map((found) => found[1] ?? found[2] ?? found[3]);

const rest = wasm.replace(/\.wasm$/, "-rest.wasm");
const parts = { module: await compiled(wasm), rest: fs.existsSync(rest) ? await compiled(rest) : null };
let [count, different, slowest] = [0, 0, [0, ""]];
for (const line of new Set([...lines.filter((line) => !LEFT_OUT.some((pattern) => pattern.test(line))), ...MORE])) {
  const own = spawnSync(program, words(line), { encoding: "utf8", env: { PATH: process.env.PATH }, maxBuffer: 1 << 28 });
  const start = performance.now();
  const there = run(parts, words(line), files);
  const time = performance.now() - start;
  if (time > slowest[0]) slowest = [time, line];
  count += 1;
  const same = own.status === there.code && own.stdout === there.text && own.stderr.trim() === there.errors.trim();
  if (!same) {
    different += 1;
    console.log(`!! subcert ${line}: exit codes ${own.status} and ${there.code}`);
    const [a, b] = own.stdout === there.text ? [own.stderr, there.errors] : [own.stdout, there.text];
    const at = [...a].findIndex((character, i) => character !== b[i]);
    console.log(`   ${JSON.stringify(a.slice(Math.max(0, at - 40), at + 80))}\n   ${JSON.stringify(b.slice(Math.max(0, at - 40), at + 80))}`);
  }
}
console.log(`${count} answers, ${different} different; the slowest takes ${(slowest[0] / 1000).toFixed(1)} s: ${slowest[1]}`);
if (count < 50 || different > 0) process.exit(1);
