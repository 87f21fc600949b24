// Divides web/subcert.wasm: functions that the rooms Scheme, Curve and Mesh use stay there, all others go to web/subcert-rest.wasm, which the page loads
// when a command needs it. What is used is counted while the commands of these rooms run. With `--quick`, only some run, so that less stays.
//
//     node .ci/split.mjs [--quick]

import { spawnSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { compiled, run } from "./wasi.mjs";

const quick = process.argv.includes("--quick");
process.chdir(path.resolve(path.dirname(process.argv[1]), ".."));

const PROGRAM = "web/subcert.wasm";
const FEATURES = ["bulk-memory", "sign-ext", "nontrapping-float-to-int", "mutable-globals", "reference-types", "multivalue"].map((name) => `--enable-${name}`);

const [CHAIKIN, FOUR] = ["chaikin", "four-point:w=1/16"];
const SCHEMES = [CHAIKIN, FOUR, "[1, 3, 3, 1]/4", "(1+z)^3/4", "loop:N=7"];
const MORE = [
  "four-point:w=0.07", "four-point:w=1/20", "six-point:w=3/256", "ternary-four-point:mu=1/11", "b-spline:degree=4", "dual-four-point", "corner-cutting:w=0.2",
  "daubechies-4", "[1, 2, 3, 2, 1]/3", "[1, 2, 3]/3", "courant", "butterfly-regular", "zwart-powell", "trilinear", "chaikin x four-point:w=1/16",
  "doo-sabin:n=5", "catmull-clark:N=6", "butterfly:N=5", "sqrt3:N=5",
];
const RANGES = [["four-point", "w"], ["six-point", "w"], ["ternary-four-point", "mu"], ["[w, 1-w, 1-w, w]", "w"]];
const MESHES = [["catmull-clark", "cube.obj"], ["catmull-clark", "tent.obj"], ["doo-sabin", "cube.obj"], ["loop", "octahedron.obj"], ["loop-warren", "octahedron.obj"], ["bicubic", "roof.csv"], ["bajaj", "star.vtk"]];
const OCTAHEDRON = "v 1 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\nf 2 1 6\nf 3 2 6\nf 4 3 6\nf 1 4 6\n";

/** The commands of these rooms, as lists of words. */
function commands() {
  const json = ["--format", "json"];
  const found = [["schemes", ...json], ["smoothness", "four-point"], ["smoothness", "four-pont"], ["constants", "[1, 3, 3]/4", ...json]];
  for (const scheme of quick ? SCHEMES : [...SCHEMES, ...MORE]) {
    found.push(["smoothness", scheme, ...json], ["constants", scheme, "-c", "4", ...json], ["scheme", scheme, ...json], ["plot", scheme]);
    found.push(["depth", scheme, "--polygon", "polygon.csv", "--boundary", "open", "--tolerance=1/100", ...json]);
  }
  for (const [family, name] of quick ? RANGES.slice(0, 1) : RANGES) {
    for (const order of ["0", "1", "2"]) found.push(["range", family, "--param", name, "--smoothness", order, "--seconds", "20", ...json]);
  }
  for (const scheme of [CHAIKIN, FOUR]) {
    for (const boundary of ["open", "closed"]) {
      const polygon = [scheme, "--polygon", "polygon.csv", "--boundary", boundary];
      found.push(["oracle", ...polygon, "-c", "1", "--level", "4", "--format", "csv"], ["oracle", ...polygon, "-c", "1", "--level", "4", ...json]);
      found.push(["depth", ...polygon, "--tolerance=1/100", ...json]);
      found.push(["depth", ...polygon, "--tolerance=1000000", "--width", "1/10000", "--distance", "parametric", ...json]);
    }
  }
  for (const [scheme, mesh] of quick ? MESHES.slice(0, 1) : MESHES) {
    found.push(["refine", scheme, "--mesh", mesh, "--level", "2", "--format", scheme === "bajaj" ? "json" : "obj"]);
    found.push(["depth", scheme, "--mesh", mesh, "--tolerance=1/10", "--per-face", "faces.csv", ...json]);
  }
  return found;
}

function tool(...args) {
  const { status, error, stderr } = spawnSync("wasm-split", [...args, ...FEATURES], { encoding: "utf8" });
  if (status !== 0) throw new Error(`wasm-split ${args[0]}: ${error?.message ?? stderr}`);
}

const files = { "octahedron.obj": Buffer.from(OCTAHEDRON) };
for (const name of ["polygon.csv", "cube.obj", "tent.obj", "roof.csv", "star.vtk"]) files[name] = fs.readFileSync(`examples/${name}`);

const folder = fs.mkdtempSync(path.join(os.tmpdir(), "subcert-"));
const inside = (name) => path.join(folder, name);
tool("--instrument", PROGRAM, "-o", inside("counting.wasm"));
const module = await compiled(inside("counting.wasm"));
const PAGE = 65536;
const profiles = [];
for (const args of commands()) {
  let memory, write;
  const { code, errors } = run({ module }, args, files, { onStart: (exports) => ({ memory, __write_profile: write } = exports) });
  if (code > 2) throw new Error(`${args.join(" ")}: ${errors}`);
  // The profile is written behind everything else.
  const pages = Math.ceil(write(0, 0) / PAGE);
  const at = PAGE * memory.grow(pages);
  profiles.push(inside(`${profiles.length}.profile`));
  fs.writeFileSync(profiles.at(-1), new Uint8Array(memory.buffer, at, write(at, PAGE * pages)));
}
tool("--merge-profiles", ...profiles, "-o", inside("all.profile"));
tool(PROGRAM, `--profile=${inside("all.profile")}`, "-o1", inside("first.wasm"), "-o2", "web/subcert-rest.wasm", "--export-prefix=%");
fs.copyFileSync(inside("first.wasm"), PROGRAM);
fs.rmSync(folder, { recursive: true });
