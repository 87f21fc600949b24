// The room "Mesh": a mesh of the visitor or an example, refined, turned, and coloured by its distance from the limit.

import { el, field, later, save } from "./dom.js";
import { Stopped } from "./engine.js";
import { meshDepth, meshDigits, meshInherit, meshObj, meshPerFace, meshSolid } from "./mesh-data.js";
import { MESH_EXAMPLES } from "./mesh-examples.js";
import { MESH_TRIANGLES, MeshView, meshColour, meshCss } from "./mesh-view.js";

const MEGABYTES = 20;
/** Of larger meshes the depth may take long, and is asked for by a button. */
const SMALL = 300;
const OTHER = "another";

const SCHEMES = [
  ["Polygon meshes", ["catmull-clark", "doo-sabin", "loop", "loop-warren"]],
  ["Nets (CSV, JSON)", ["bicubic", "biquadratic"]],
  ["Solids (VTK, MEDIT)", ["bajaj"]],
];

class MeshRoom {
  /** The mesh that is shown: its file for the program, and how it is called. */
  source = null;
  round = 0;

  constructor(place, { engine, state }) {
    this.engine = engine;
    this.state = state;
    this.view = new MeshView();
    this.build(place);
    this.restore();
  }

  build(place) {
    const group = ([label, names]) => el("optgroup", { label }, names.map((name) => el("option", { value: name }, name)));
    this.scheme = el("select", { onchange: () => this.chosen() }, SCHEMES.map(group), el("option", { value: OTHER }, "another …"));
    this.name = el("input", { class: "mono", autocomplete: "off", spellcheck: "false", maxlength: 500, oninput: later(() => this.changed(), 400) });
    this.nameField = field("Scheme of a net", this.name, "of a curve, or two: chaikin x four-point");
    this.level = el("input", { type: "range", min: 0, max: 4, step: 1, oninput: () => this.slide() });
    this.levelText = el("output", {});
    this.tolerance = el("input", { class: "mono", size: 10, maxlength: 60, autocomplete: "off", spellcheck: "false", oninput: later(() => this.changed(true), 500) });
    this.file = el("input", { type: "file", accept: ".obj,.off,.ply,.stl,.usda,.vtk,.mesh,.csv,.json", onchange: () => this.read(this.file.files[0]) });
    this.drop = el("div", { class: "mesh-drop" },
      field("A file of yours", this.file, `OBJ, OFF, PLY, STL, USDA, VTK, MEDIT; a net as CSV or JSON; at most ${MEGABYTES} MB. Drop it here, or choose it. It is read on this machine only.`));
    this.error = el("p", { class: "error", role: "alert" });
    this.depthError = el("p", { class: "error", role: "alert" });
    this.status = el("p", { role: "status", "aria-live": "polite" });
    this.results = el("div", { class: "mesh-results" });
    this.legend = el("div", {});
    this.compute = el("button", { type: "button", onclick: () => this.depth(true) }, "Compute the depth");
    const level = field("Level", this.level);
    level.append(this.levelText);
    const button = (text, onclick) => el("button", { type: "button", onclick }, text);
    place.append(
      this.drop, this.error,
      el("div", { class: "row", role: "group", "aria-label": "Examples" }, MESH_EXAMPLES.map((one) => button(one.title, () => this.example(one)))),
      el("div", { class: "row" }, field("Scheme", this.scheme), this.nameField, level, field("Tolerance", this.tolerance, "an exact number, as 1/100")),
      el("div", { class: "columns" },
        el("div", {}, this.view.root, this.legend),
        el("div", {}, this.status, this.results, this.depthError,
          el("div", { class: "row" }, this.compute, button("Save the refined mesh", () => this.saveMesh()), button("Copy link", () => this.copy())),
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
      if (event.dataTransfer.files[0]) this.read(event.dataTransfer.files[0]);
    });
  }

  restore() {
    const { scheme, level = "2", tolerance = "1/100", example } = this.state.get();
    this.tolerance.value = tolerance;
    this.level.value = /^[0-4]$/.test(level) ? level : "2";
    this.levelText.value = this.level.value;
    const found = MESH_EXAMPLES.find((one) => one.id === example);
    if (found || !this.source) this.source = this.fromExample(found ?? MESH_EXAMPLES[0]);
    this.choose(scheme ?? this.source.scheme);
    this.error.textContent = example && !found ? "The address names an example that is not here; this is the first one." : "";
    this.begin();
  }

  fromExample = ({ id, title, file, scheme, text }) => ({ example: id, title, file, scheme, content: text });

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
    this.source = this.fromExample(one);
    this.choose(one.scheme);
    this.file.value = "";
    this.error.textContent = "";
    this.begin();
  }

  async read(file) {
    if (!file) return;
    if (file.size > MEGABYTES * 1024 * 1024) {
      this.error.textContent = `${file.name} has ${(file.size / 1024 / 1024).toFixed(1)} MB; this page takes files of at most ${MEGABYTES} MB. The program on the command line takes 64 MB.`;
      return;
    }
    // The ending says what the file is; the rest of the name is for messages only.
    const name = file.name.replace(/[^\w.]+/g, "_").replace(/^\.+/, "").slice(-60) || "mesh";
    try {
      this.source = { example: "", title: file.name, file: name, content: new Uint8Array(await file.arrayBuffer()) };
    } catch (error) {
      this.error.textContent = `${file.name} cannot be read: ${error.message}`;
      return;
    }
    this.error.textContent = "";
    if (/\.(csv|json)$/i.test(name) && this.scheme.selectedOptions[0].parentElement.label === SCHEMES[0][0]) this.choose("bicubic");
    this.begin();
  }

  chosen() {
    this.nameField.hidden = this.scheme.value !== OTHER;
    if (this.scheme.value === OTHER && this.name.value === "") this.name.focus();
    else this.changed();
  }

  slide() {
    this.levelText.value = this.level.value;
    this.remember();
    this.interrupt();
    this.refine();
  }

  changed(sameMesh = false) {
    if (sameMesh && this.control) {
      this.remember();
      this.forget();
      this.paint();
      this.depth(false);
    } else this.begin();
  }

  forget() {
    this.found = null;
    this.depthError.textContent = "";
    this.results.replaceChildren();
  }

  remember() {
    this.state.set({ scheme: this.schemeName, level: this.level.value, tolerance: this.tolerance.value, example: this.source.example });
  }

  /** A search for the depth makes way, and is taken up again afterwards. */
  interrupt() {
    if (this.engine.running?.kind !== "mesh-depth") return;
    this.again = true;
    this.engine.stop();
  }

  /** A new mesh or scheme: its control mesh, its level, its depth. */
  async begin() {
    this.remember();
    this.interrupt();
    this.again = false;
    this.forget();
    this.control = null;
    const mine = ++this.round;
    try {
      const control = await this.level0();
      if (mine !== this.round) return;
      this.control = control;
      await this.refine();
      if (mine === this.round && this.control) this.depth(false);
    } catch (error) {
      this.fail(error);
    }
  }

  args(command, ...more) {
    return [command, this.schemeName, "--mesh", this.source.file, ...more];
  }

  level0 = () => this.load(0, "mesh-control");

  async load(level, kind) {
    const solid = this.schemeName === "bajaj";
    const files = { [this.source.file]: this.source.content };
    const answer = await this.engine.run(this.args("refine", "--level", String(level), "--format", solid ? "json" : "obj"), { files, kind });
    if (answer.code > 1) throw new Error(answer.errors.trim() || `exit code ${answer.code}`);
    return { ...(solid ? meshSolid(JSON.parse(answer.text)) : meshObj(answer.text)), text: answer.text, level, notes: answer.errors.trim() };
  }

  fail(error) {
    if (error instanceof Stopped) return;
    this.error.textContent = error.message;
    this.status.textContent = "";
    this.view.root.classList.add("mesh-stale");
  }

  async refine() {
    if (!this.control) return;
    const level = Number(this.level.value);
    const mine = this.round;
    const again = this.again;
    try {
      const mesh = level === 0 ? this.control : await this.load(level, "mesh-refine");
      if (mine !== this.round) return;
      this.mesh = mesh;
      this.error.textContent = "";
      this.view.root.classList.remove("mesh-stale");
      const { points, faces } = mesh;
      const triangles = faces.reduce((sum, face) => sum + face.length - 2, 0);
      const notes = this.control.notes ? ` ${this.control.notes}` : "";
      this.status.textContent = `${this.source.title}, level ${level}: ${points.length} points, ${faces.length} faces.${notes}`;
      if (triangles > MESH_TRIANGLES) this.status.textContent += " That is too much to draw here; it can be saved.";
      else this.paint();
      if (again && !this.found) {
        this.again = false;
        this.depth(true);
      }
    } catch (error) {
      this.fail(error);
    }
  }

  /** The mesh with the colours that are known. */
  paint() {
    const { mesh, control, found } = this;
    if (!mesh || !control) return;
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
      parts.push(el("p", { class: "mesh-legend" }, "0", el("span", { class: "mesh-bar", role: "img", "aria-label": "colours from the least to the greatest distance", style: `background: linear-gradient(to right, ${stops})` }), meshDigits(greatest)),
        el("p", { class: "soft" }, `The colour of a face says how far it is at least from the limit at level ${found.level}. The greatest such number is ${meshDigits(greatest)}; no face is farther than the tolerance.`));
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
    const mine = this.round;
    this.depthError.textContent = "";
    this.results.replaceChildren(el("p", { class: "soft" }, "The depth is being computed."));
    try {
      const { answer, plain } = await this.search();
      if (mine !== this.round) return;
      if (answer.code > 1) throw new Error(answer.errors.trim() || `exit code ${answer.code}`);
      const json = JSON.parse(answer.text);
      const { lines, mark } = meshDepth(json);
      const rows = answer.files?.["faces.csv"];
      this.found = { level: json.level ?? null, mark, plain, faces: rows ? meshPerFace(rows) : null };
      this.results.replaceChildren(...lines.map((line, i) => el("p", { class: i === 0 ? "mesh-depth" : "" }, line)));
      this.paint();
    } catch (error) {
      if (error instanceof Stopped) {
        // Replaced by a newer one, or stopped to make way, or by the visitor.
        if (mine === this.round && !this.again && !this.engine.waiting.some((job) => job.kind === "mesh-depth")) this.results.replaceChildren(el("p", { class: "soft" }, "The search for the depth was stopped."));
        return;
      }
      this.results.replaceChildren();
      this.depthError.textContent = error.message;
    }
  }

  async search() {
    const files = { [this.source.file]: this.source.content };
    const args = this.args("depth", `--tolerance=${this.tolerance.value.trim()}`, "--format", "json");
    const options = { files, kind: "mesh-depth" };
    const answer = await this.engine.run([...args, "--per-face", "faces.csv"], options);
    // Where the program cannot write files, it can still answer.
    if (answer.code < 2 || !/panicked|cannot write `faces\.csv`/.test(answer.errors)) return { answer, plain: false };
    return { answer: await this.engine.run(args, options), plain: true };
  }

  saveMesh() {
    if (!this.mesh) return;
    const solid = this.schemeName === "bajaj";
    save(`${this.source.file.replace(/\.\w+$/, "")}-level-${this.mesh.level}.${solid ? "json" : "obj"}`, this.mesh.text);
  }

  async copy() {
    this.remember();
    try {
      await navigator.clipboard.writeText(location.href);
      this.status.textContent = this.source.example ? "The link is copied." : "The link is copied. It does not hold your file.";
    } catch {
      this.status.textContent = "The browser does not let this page copy; the link is in the address bar.";
    }
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
