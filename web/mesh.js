// The room "Mesh": a mesh of the visitor or an example, refined, turned, and coloured by its distance from the limit.

import { copyLink, el, field, later, save } from "./dom.js";
import { Stopped } from "./engine.js";
import { meshDepth, meshInherit, meshObj, meshPerFace, meshSolid } from "./mesh-data.js";
import { MESH_EXAMPLES } from "./mesh-examples.js";
import { digits } from "./numbers.js";
import { MESH_TRIANGLES, MeshView, meshColour, meshCss } from "./mesh-view.js";

/** A name in which letters from right to left change nothing beside it. */
const isolated = (name) => `\u2068${name}\u2069`;

const MEGABYTES = 20;
/** Of larger meshes the depth may take long, and is asked for by a button. */
const SMALL = 300;
const OTHER = "another";
/** How long a search for the depth may take. */
const SECONDS = "60";

const SCHEMES = [
  ["Polygon meshes", ["catmull-clark", "doo-sabin", "loop", "loop-warren"]],
  ["Nets (CSV, JSON)", ["bicubic", "biquadratic"]],
  ["Solids (VTK, MEDIT)", ["bajaj"]],
];

class MeshRoom {
  /** The mesh that is shown: its file for the program, and how it is called. */
  source = null;
  /** What raises one of these numbers makes void what is on its way: a mesh or scheme, a level, a depth, a file. */
  round = 0;
  step = 0;
  depthRound = 0;
  reading = 0;
  searching = false;

  constructor(place, { engine, state }) {
    this.engine = engine;
    this.state = state;
    this.view = new MeshView();
    this.build(place);
    this.restore();
  }

  build(place) {
    const group = ([label, names]) => el("optgroup", { label }, names.map((name) => el("option", { value: name }, name)));
    // What is shown is old from the first key on, and not only when it is asked for anew.
    const after = (begin, restart) => () => {
      begin();
      restart();
    };
    const named = after(() => this.clear(), later(() => this.begin(), 400));
    const bounded = after(() => this.unknown(), later(() => this.bounded(), 500));
    this.scheme = el("select", { onchange: () => this.chosen() }, SCHEMES.map(group), el("option", { value: OTHER }, "another …"));
    this.name = el("input", { class: "mono", autocomplete: "off", spellcheck: "false", maxlength: 500, oninput: named });
    this.nameField = field("Scheme of a net", this.name, "of a curve, or two: chaikin x four-point");
    this.level = el("input", { type: "range", min: 0, max: 4, step: 1, oninput: () => this.slide() });
    this.levelText = el("output", {});
    this.tolerance = el("input", { class: "mono", size: 10, maxlength: 60, autocomplete: "off", spellcheck: "false", oninput: bounded });
    this.seconds = el("input", { inputmode: "numeric", size: 6, maxlength: 6, autocomplete: "off", oninput: bounded });
    this.file = el("input", { type: "file", accept: ".obj,.off,.ply,.stl,.usda,.vtk,.mesh,.csv,.json", onchange: () => this.read(this.file.files[0]) });
    this.drop = el("div", { class: "mesh-drop" },
      field("A file of yours", this.file, `OBJ, OFF, PLY, STL, USDA, VTK, MEDIT; a net as CSV or JSON; at most ${MEGABYTES} MB. Drop it here, or choose it. It is read on this machine only.`));
    this.error = el("p", { class: "error", role: "alert" });
    this.depthError = el("p", { class: "error", role: "alert" });
    this.status = el("p", { role: "status", "aria-live": "polite" });
    this.results = el("div", { class: "mesh-results" });
    this.legend = el("div", {});
    this.compute = el("button", { type: "button", onclick: () => this.askDepth() }, "Compute the depth");
    this.saving = el("button", { type: "button", disabled: true, onclick: () => this.saveMesh() }, "Save the refined mesh");
    const level = field("Level", this.level);
    level.append(this.levelText);
    const button = (text, onclick) => el("button", { type: "button", onclick }, text);
    place.append(
      this.drop, this.error,
      el("div", { class: "row", role: "group", "aria-label": "Examples" }, MESH_EXAMPLES.map((one) => button(one.title, () => this.example(one)))),
      el("div", { class: "row" }, field("Scheme", this.scheme), this.nameField, level, field("Tolerance", this.tolerance, "an exact number, as 1/100"),
        field("Seconds", this.seconds, "then the search for the depth ends")),
      el("div", { class: "columns" },
        el("div", {}, this.view.root, this.legend),
        el("div", {}, this.status, this.results, this.depthError,
          el("div", { class: "row" }, this.compute, this.saving, button("Copy link", () => this.copy())),
          el("p", { class: "soft" }, "The link holds scheme, level, tolerance and the name of an example. It never holds a file of yours."))),
    );
    this.listen(place);
  }

  /** Files may be dropped anywhere in the room. */
  listen(place) {
    const over = (event, on) => {
      if (![...(event.dataTransfer?.types ?? [])].includes("Files")) return;
      event.preventDefault();
      this.drop.classList.toggle("mesh-over", on);
    };
    place.addEventListener("dragover", (event) => over(event, true));
    place.addEventListener("dragleave", (event) => over(event, false));
    place.addEventListener("drop", (event) => {
      over(event, false);
      if (!event.dataTransfer.files[0]) return;
      this.file.value = "";
      this.read(event.dataTransfer.files[0]);
    });
  }

  restore() {
    const { scheme, level = "2", tolerance = "1/100", seconds = SECONDS, example } = this.state.get();
    this.tolerance.value = tolerance;
    this.seconds.value = seconds;
    this.level.value = /^[0-4]$/.test(level) ? level : "2";
    this.levelText.value = this.level.value;
    const found = MESH_EXAMPLES.find((one) => one.id === example);
    const known = this.source !== null;
    if (found || !known) this.source = this.fromExample(found ?? MESH_EXAMPLES[0]);
    // A file of the visitor's is gone, and its scheme may not be one for the example that is shown instead.
    this.choose((example === "" && !known ? null : scheme) ?? this.source.scheme ?? this.schemeName);
    this.reading += 1;
    this.begin();
    if (example && !found) this.error.textContent = `The address names an example that is not here; this is ${this.source.title}.`;
  }

  fromExample = ({ id, title, file, scheme, text }) => ({ example: id, title, file, called: file, scheme, content: text });

  choose(scheme) {
    const known = SCHEMES.some(([, names]) => names.includes(scheme));
    this.scheme.value = known ? scheme : OTHER;
    if (!known) this.name.value = scheme;
    this.nameField.hidden = known;
  }

  get schemeName() {
    return this.scheme.value === OTHER ? this.name.value.trim() : this.scheme.value;
  }

  example(one) {
    this.reading += 1;
    this.source = this.fromExample(one);
    this.choose(one.scheme);
    this.file.value = "";
    this.error.textContent = "";
    this.begin();
  }

  async read(file) {
    if (!file) return;
    const mine = ++this.reading;
    if (file.size > MEGABYTES * 1024 * 1024) {
      this.error.textContent = `${file.name} has ${(file.size / 1024 / 1024).toFixed(1)} MB; this page takes files of at most ${MEGABYTES} MB. The program on the command line takes 64 MB.${this.mesh ? ` ${this.source.title} is still the mesh here.` : ""}`;
      this.file.value = "";
      return;
    }
    // The ending says what the file is. Its own name might be that of a file that the command writes.
    const ending = /\.\w{1,8}$/.exec(file.name)?.[0].toLowerCase() ?? "";
    const called = file.name.replace(/[^\w.]+/g, "_").replace(/^\.+/, "").slice(-60) || "mesh";
    try {
      const content = new Uint8Array(await file.arrayBuffer());
      if (mine !== this.reading) return;
      this.source = { example: "", title: file.name, file: `mesh${ending}`, called, content };
    } catch (error) {
      this.file.value = "";
      this.error.textContent = `${file.name} cannot be read: ${error.message}`;
      return;
    }
    this.error.textContent = "";
    if (/\.(csv|json)$/.test(ending) && this.scheme.selectedOptions[0].parentElement.label === SCHEMES[0][0]) this.choose("bicubic");
    this.begin();
  }

  chosen() {
    this.nameField.hidden = this.scheme.value !== OTHER;
    if (this.scheme.value === OTHER && this.name.value === "") this.name.focus();
    else this.begin();
  }

  slide() {
    this.levelText.value = this.level.value;
    this.remember();
    // After a stop there is no mesh to refine.
    if (!this.control) this.begin();
    else {
      this.error.textContent = "";
      this.interrupt();
      this.whole();
    }
  }

  /** Another tolerance: the depth for it. */
  bounded() {
    this.remember();
    // The button may have begun it already.
    if (this.control && !this.searching && !this.found) this.depth(false);
  }

  /** The button of the depth, which after a stop begins with the mesh. */
  async askDepth() {
    if (!this.control) await this.begin();
    if (this.control && !this.searching) this.depth(true);
  }

  /** The depth is not known: a search for it ends, its answer is void, and there are no colours. */
  unknown() {
    this.interrupt();
    this.again = false;
    this.depthRound += 1;
    this.searching = false;
    this.found = null;
    this.depthError.textContent = "";
    this.results.replaceChildren();
    this.legend.replaceChildren();
    this.paint();
  }

  /** Nothing is known of what is chosen, and the picture, if it stays for a moment, is old. */
  clear() {
    this.round += 1;
    this.control = null;
    this.noMesh();
    this.unknown();
    const { shown } = this.view;
    if (shown?.colours || shown?.mark) this.view.show({ ...shown, colours: null, mark: null });
  }

  old(is) {
    this.view.old(is);
    this.legend.classList.toggle("mesh-stale", is);
  }

  noMesh() {
    this.step += 1;
    this.mesh = null;
    this.saving.disabled = true;
    this.old(true);
    this.status.textContent = `${isolated(this.source.title)}, level ${this.level.value}, is on its way.`;
  }

  remember() {
    this.state.set({ scheme: this.schemeName, level: this.level.value, tolerance: this.tolerance.value, seconds: this.seconds.value === SECONDS ? "" : this.seconds.value, example: this.source.example });
  }

  /** A search for the depth makes way, and is taken up again afterwards. */
  interrupt() {
    if (!this.searching) return;
    this.again = true;
    this.engine.end("mesh-depth");
  }

  /** A new mesh or scheme: its control mesh, its level, its depth. */
  async begin() {
    this.remember();
    this.clear();
    this.error.textContent = "";
    const mine = this.round;
    try {
      const control = await this.level0();
      if (mine !== this.round) return;
      this.control = control;
    } catch (error) {
      if (mine === this.round) this.fail(error);
      return;
    }
    await this.whole();
  }

  /** The level, and the depth where nothing is said of it. */
  async whole() {
    const mine = this.round;
    const stopped = await this.refine();
    if (mine !== this.round || stopped || this.searching || this.results.hasChildNodes() || this.depthError.textContent) return;
    this.depth(false);
  }

  args(command, ...more) {
    if (this.schemeName.startsWith("-")) throw new Error("a scheme does not begin with -");
    return [command, this.schemeName, "--mesh", this.source.file, ...more];
  }

  level0 = () => this.load(0, "mesh-control");

  async load(level, kind) {
    const solid = this.schemeName === "bajaj";
    const files = { [this.source.file]: this.source.content };
    const answer = await this.engine.run(this.args("refine", "--level", String(level), "--format", solid ? "json" : "obj"), { files, kind });
    if (answer.code > 1) throw new Error(this.said(answer));
    return { ...(solid ? meshSolid(JSON.parse(answer.text)) : meshObj(answer.text)), text: answer.text, level, notes: answer.errors.trim() };
  }

  /** What the program says, which has its own name for a file of the visitor. */
  said({ errors, code }) {
    const text = errors.trim() || `exit code ${code}`;
    const { example, title, file } = this.source;
    return !example && title !== file && text.includes(file) ? `${title} is called ${file} here.\n${text}` : text;
  }

  /** There is no mesh, and so there is no picture. */
  fail(error) {
    const stopped = error instanceof Stopped;
    this.mesh = null;
    this.saving.disabled = true;
    this.view.clear();
    this.old(false);
    this.legend.replaceChildren();
    if (!stopped) this.error.textContent = error.message;
    this.status.textContent = stopped ? "Stopped: no mesh is shown. The level and the button of the depth begin anew." : "";
  }

  /** The mesh of the level; the answer says whether the visitor has stopped it. */
  async refine() {
    const level = Number(this.level.value);
    this.noMesh();
    const mine = this.step;
    let stopped = false;
    try {
      const mesh = level === 0 ? this.control : await this.load(level, "mesh-refine");
      if (mine !== this.step) return false;
      this.mesh = mesh;
      this.saving.disabled = false;
      this.old(false);
      const notes = this.control.notes ? ` ${this.control.notes}` : "";
      this.status.textContent = `${isolated(this.source.title)}, level ${level}: ${mesh.points.length} points, ${mesh.faces.length} faces.${notes}`;
      if (!this.drawable(mesh)) {
        this.status.textContent += " That is too much to draw here; it can be saved.";
        this.view.clear();
        this.legend.replaceChildren();
      } else this.paint();
    } catch (error) {
      if (mine !== this.step) return false;
      stopped = error instanceof Stopped;
      this.fail(error);
    }
    if (this.again) {
      this.again = false;
      if (stopped) this.endSearch();
      else this.depth(true);
    }
    return stopped;
  }

  endSearch() {
    this.searching = false;
    this.results.replaceChildren(el("p", { class: "soft" }, "The search for the depth was stopped."));
  }

  drawable = ({ faces }) => faces.reduce((sum, face) => sum + face.length - 2, 0) <= MESH_TRIANGLES;

  /** The mesh with the colours that are known. */
  paint() {
    const { mesh, control, found } = this;
    if (!mesh || !control || !this.drawable(mesh)) return;
    const values = found?.faces && meshInherit(found.faces.map((row) => row.lower), mesh.faces.length, control.faces, this.schemeName, mesh.level);
    const numbers = values?.map(Number);
    const most = numbers?.length ? numbers.reduce((a, b) => Math.max(a, b), 0) : 0;
    const steps = numbers && numbers.map((value) => meshColour(most > 0 ? value / most : 0));
    this.view.show({ points: mesh.points, faces: mesh.faces, colours: steps, mark: found?.mark ?? null, box: control.points });
    this.explain(values, numbers, most);
  }

  explain(values, numbers, most) {
    this.legend.replaceChildren();
    const { found } = this;
    if (!found) return;
    const parts = [];
    if (values && found.level !== null) {
      const greatest = values[numbers.indexOf(most)] ?? "0";
      const stops = [0, 0.25, 0.5, 0.75, 1].map((part) => meshCss(meshColour(part))).join(", ");
      parts.push(el("p", { class: "mesh-legend" }, "0", el("span", { class: "mesh-bar", role: "img", "aria-label": "colours from 0 to the greatest of these lower bounds, each of a whole control face", style: `background: linear-gradient(to right, ${stops})` }), digits(greatest)),
        el("p", { class: "soft" }, `All faces that come from one face of the control mesh have its colour. It says: at level ${found.level}, mesh and limit surface are somewhere on this control face at least so far apart. It does not say where, and nothing of a single small face. The greatest of these numbers is ${digits(greatest)}; nowhere are they farther apart than the tolerance.`));
    } else if (found.faces) parts.push(el("p", { class: "soft" }, "The distances of the control faces colour level 0 only; the faces of this level belong to no single one of them."));
    else if (found.plain) parts.push(el("p", { class: "soft" }, "The distances of single faces could not be written here; there are no colours."));
    if (found.mark) parts.push(el("p", { class: "soft" }, "The red mark is the point that is too far at the level before."));
    this.legend.replaceChildren(...parts);
  }

  /** How many levels the tolerance needs; of large meshes only if the visitor asks. */
  async depth(asked) {
    if (!this.control) return;
    if (!asked && this.control.faces.length > SMALL) {
      this.results.replaceChildren(el("p", { class: "soft" }, `The depth of a mesh of ${this.control.faces.length} faces may take long; the button computes it.`));
      return;
    }
    this.unknown();
    this.searching = true;
    const mine = this.depthRound;
    this.results.replaceChildren(el("p", { class: "soft" }, "The depth is being computed."));
    try {
      const { answer, plain } = await this.search();
      if (mine !== this.depthRound) return;
      if (answer.code > 1) throw new Error(this.said(answer));
      const json = JSON.parse(answer.text);
      const { lines, mark } = meshDepth(json);
      const rows = answer.files?.["faces.csv"];
      this.searching = this.again = false;
      this.found = { level: json.level ?? null, mark, plain, faces: rows ? meshPerFace(rows) : null };
      this.results.replaceChildren(...lines.map((line, i) => el("p", { class: i === 0 ? "mesh-depth" : "" }, line)));
      this.paint();
    } catch (error) {
      // It is void, or makes way for a level and is taken up again.
      if (mine !== this.depthRound || (error instanceof Stopped && this.again)) return;
      if (error instanceof Stopped) return this.endSearch();
      this.searching = false;
      this.unknown();
      this.depthError.textContent = error.message;
    }
  }

  async search() {
    const seconds = this.seconds.value.trim();
    if (!/^[1-9]\d{0,4}$/.test(seconds)) throw new Error("the seconds are a whole number from 1 to 99999");
    const files = { [this.source.file]: this.source.content };
    const args = this.args("depth", `--tolerance=${this.tolerance.value.trim()}`, `--seconds=${seconds}`, "--format", "json");
    const options = { files, kind: "mesh-depth" };
    const answer = await this.engine.run([...args, "--per-face", "faces.csv"], options);
    // Where the program cannot write files, it can still answer.
    if (answer.code < 2 || !/panicked|cannot write `faces\.csv`/.test(answer.errors)) return { answer, plain: false };
    return { answer: await this.engine.run(args, options), plain: true };
  }

  saveMesh() {
    if (!this.mesh) return;
    const solid = this.schemeName === "bajaj";
    save(`${this.source.called.replace(/\.\w+$/, "")}-level-${this.mesh.level}.${solid ? "json" : "obj"}`, this.mesh.text);
  }

  async copy() {
    this.remember();
    this.status.textContent = await copyLink(this.source.example ? "" : " It does not hold your file.");
  }
}

export default {
  id: "mesh",
  title: "Mesh",
  mount(place, context) {
    const room = new MeshRoom(place, context);
    return { restore: () => room.restore() };
  },
};
