// The room "Curve": control points that are drawn and dragged, with the polygon of a level, the limit, and their distance.

import { CurveCanvas, curveLegend } from "./curve-canvas.js";
import { CURVE_MAX, CURVE_START, curveDepth, curveDistance, curveLevel, curveLines, curvePlace, curvePoints, curveShort } from "./curve-data.js";
import { el, field, later, save } from "./dom.js";
import { Stopped } from "./engine.js";

/** With this tolerance every polygon of the page is within it at level 0, and the answer is its distance there. */
const ANY = "100000000000";
/** A limit is drawn with so many points or more. */
const FINE = 700;
/** While points move, the depth is asked for again after so many milliseconds. */
const REST = 300;

class CurveRoom {
  points = CURVE_START;
  pending = false;
  drawing = false;
  depthTurned = 0;
  arity = 2;
  marks = { far: null, greatest: null };
  lines = {};

  constructor(place, { engine, state }) {
    this.engine = engine;
    this.state = state;
    this.build(place);
    this.restore();
    this.catalogue();
  }

  build(place) {
    this.canvas = new CurveCanvas({
      moved: (i, point) => this.change(this.points.map((old, j) => (j === i ? point : old)), true),
      settled: (look) => this.settle(look),
      added: (point) => this.add(point),
      removed: (i) => this.edit(this.points.filter((_, j) => j !== i)),
    });
    const changed = () => this.settle();
    this.names = el("datalist", { id: "curve-schemes" });
    this.scheme = el("input", { class: "curve-scheme mono", list: "curve-schemes", autocomplete: "off", spellcheck: "false", maxlength: 500, oninput: later(changed, 150) });
    this.closed = el("input", { type: "checkbox", id: "curve-closed", onchange: changed });
    this.level = el("input", { type: "range", min: 0, max: 8, step: 1, oninput: () => this.slide() });
    this.levelText = el("output", {});
    this.tolerance = el("input", { class: "mono", size: 10, maxlength: 60, autocomplete: "off", spellcheck: "false", oninput: later(changed, 150) });
    this.list = el("textarea", { rows: 8, spellcheck: "false", oninput: later(() => this.readList(), 200) });
    this.error = el("p", { class: "error", role: "alert" });
    this.depthError = el("p", { class: "error", role: "alert" });
    this.listError = el("p", { class: "error", role: "alert" });
    this.results = el("div", { class: "curve-results" });
    this.status = el("p", { class: "soft", role: "status", "aria-live": "polite" });
    const button = (text, onclick) => el("button", { type: "button", onclick }, text);
    const level = field("Level", this.level);
    level.append(this.levelText);
    place.classList.add("curve-room");
    place.append(
      this.names,
      el("div", { class: "row" },
        field("Scheme", this.scheme, "a name, or a mask as [1, 3, 3, 1]/4"), level,
        field("Tolerance", this.tolerance, "an exact number, as 1/100"),
        el("label", { for: "curve-closed" }, this.closed, " closed")),
      this.error, this.depthError,
      el("div", { class: "columns" },
        el("div", {},
          el("p", { class: "soft" }, "Drag a point. Click on an empty place to add one at the end. By keyboard: Tab to a point, arrow keys move it (with Shift by less), Delete removes it."),
          this.canvas.root, curveLegend(),
          el("div", { class: "row" },
            button("Add a point", () => this.add(null)), button("Remove the last point", () => this.edit(this.points.slice(0, -1))),
            button("Remove all", () => this.edit([])), button("Save as SVG", () => this.savePicture()), button("Copy link", () => this.copy()))),
        el("div", {}, this.results, this.status,
          field("Control points", this.list, "one on a line: x, y"), this.listError)),
    );
  }

  async catalogue() {
    try {
      const { schemes } = await this.engine.json(["schemes"]);
      const masks = schemes.filter((one) => one.kind === "mask");
      this.names.replaceChildren(...masks.map((one) => {
        const needed = one.parameters.map(({ name, default: value }) => `${name}=${value ?? "…"}`).join(",");
        return el("option", { value: needed ? `${one.name}:${needed}` : one.name }, one.title);
      }));
    } catch (error) {
      if (!(error instanceof Stopped)) this.status.textContent = error.message;
    }
  }

  /** From the address, where anything may stand. */
  restore() {
    const { scheme = "four-point", points, closed, level = "2", tolerance = "1/100" } = this.state.get();
    this.scheme.value = scheme;
    this.tolerance.value = tolerance;
    this.closed.checked = closed !== "no";
    this.level.value = /^[0-8]$/.test(level) ? level : "2";
    this.listError.textContent = "";
    this.points = CURVE_START;
    try {
      if (points) this.points = curvePoints(points);
    } catch (error) {
      this.listError.textContent = `The points of the address are not shown: ${error.message}`;
    }
    this.list.value = curveLines(this.points);
    this.canvas.look(this.points);
    this.ask();
  }

  add(point) {
    if (this.points.length >= CURVE_MAX) {
      this.status.textContent = `There are ${CURVE_MAX} points already.`;
      return;
    }
    const last = (this.points.at(-1) ?? ["4", "3"]).map(Number);
    const next = point ?? this.canvas.texts([last[0] + 1, last[1] + 0.5]);
    this.edit([...this.points, next]);
    if (!point) this.canvas.dots.at(-1)?.focus();
  }

  edit(points) {
    this.change(points, false);
    this.settle(true);
  }

  change(points, moving) {
    this.points = points;
    this.canvas.show(points, this.closed.checked);
    if (moving) this.ask(true);
  }

  readList() {
    try {
      const points = curvePoints(this.list.value);
      this.listError.textContent = "";
      this.points = points;
      this.canvas.look(points);
      this.remember();
      this.ask();
    } catch (error) {
      this.listError.textContent = error.message;
    }
  }

  slide() {
    this.levelText.value = this.level.value;
    this.settle();
  }

  /** Something is as it shall be: into the list and the address, and asks for all of it. */
  settle(look = false) {
    this.listError.textContent = "";
    this.list.value = curveLines(this.points);
    if (look) this.canvas.look(this.points);
    this.remember();
    this.ask();
  }

  remember() {
    this.state.set({ scheme: this.scheme.value, points: curveShort(this.points), closed: this.closed.checked ? "" : "no", level: this.level.value, tolerance: this.tolerance.value });
  }

  /** One round after the other; what changes in between is drawn by the next one. */
  async ask(moving = false) {
    this.levelText.value = this.level.value;
    this.canvas.show(this.points, this.closed.checked);
    this.pending = moving ? "moving" : "still";
    if (this.drawing) return;
    this.drawing = true;
    while (this.pending) {
      const how = this.pending;
      this.pending = false;
      await this.round(how === "moving");
    }
    this.drawing = false;
  }

  args(command, ...more) {
    return [command, this.scheme.value.trim(), "--polygon", "points.csv", "--boundary", this.closed.checked ? "closed" : "open", ...more];
  }

  async round(moving) {
    if (this.points.length < 2) {
      this.canvas.clear();
      this.lines = {};
      this.error.textContent = this.depthError.textContent = "";
      this.results.replaceChildren(el("p", {}, "Draw at least two points."));
      return;
    }
    const now = { files: { "points.csv": curveLines(this.points) }, closed: this.closed.checked, level: Number(this.level.value), points: this.points };
    const oracle = (level, kind) => this.table(this.args("oracle", "-c", "1", "--level", String(level), "--format", "csv"), now, kind);
    // Asked again, one that runs for long is stopped, so that the drawing goes on.
    const wantsDepth = !moving || performance.now() - this.depthTurned > REST;
    try {
      const refined = oracle(now.level, "curve-level");
      const limit = oracle(this.fine(now), "curve-limit");
      limit.catch(() => {});
      if (wantsDepth) this.depths(now, moving);
      now.refined = await refined;
      this.arity = now.refined.arity ?? 2;
      this.canvas.draw("level", now.refined.points, now.closed);
      now.limit = await limit;
      this.canvas.draw("limit", now.limit.points, now.closed);
      this.latest = now;
      this.error.textContent = "";
      this.canvas.root.classList.remove("curve-stale");
      this.describe();
    } catch (error) {
      if (error instanceof Stopped) return;
      this.error.textContent = error.message;
      this.canvas.root.classList.add("curve-stale");
    }
  }

  /** The least level with enough points for a smooth drawing, and not below the one that is shown. */
  fine({ points, level }) {
    const arity = Math.max(2, this.arity);
    const needed = Math.ceil(Math.log(FINE / points.length) / Math.log(arity));
    return Math.min(9, Math.max(3, level, needed));
  }

  async table(args, { files }, kind) {
    const level = Number(args[args.indexOf("--level") + 1]);
    const answer = await this.engine.run(args, { files, kind });
    if (answer.code > 1) throw new Error(answer.errors.trim());
    const found = curveLevel(answer.text);
    if (found.points.length === 0) throw new Error("this scheme refines no polygons; take one of curves, as chaikin or four-point");
    return { ...found, level };
  }

  /** The depth for the tolerance, the distance of the control polygon, and when all is still that of the level. */
  async depths(now, moving) {
    const mine = (this.depthRun = (this.depthRun ?? 0) + 1);
    const tolerance = this.tolerance.value.trim();
    const common = { files: now.files };
    this.depthTurned = performance.now();
    try {
      const depth = this.engine.json(this.args("depth", `--tolerance=${tolerance}`), { ...common, kind: "curve-depth" });
      const own = this.engine.json(this.args("depth", "--tolerance", ANY, "--width", "1/10000", "--distance", "parametric"), { ...common, kind: "curve-distance" });
      own.catch(() => {});
      const told = curveDepth(await depth, tolerance);
      const greatest = curveDistance(await own);
      if (mine !== this.depthRun) return;
      this.depthError.textContent = "";
      this.lines = { depth: told.lines, own: greatest, level: null };
      this.marks = { far: told.mark, greatest, now };
      this.describe();
      if (!moving) this.levelDistance(now, mine);
    } catch (error) {
      if (error instanceof Stopped || mine !== this.depthRun) return;
      // An unknown scheme is said once.
      this.depthError.textContent = error.message;
      this.lines = {};
      this.marks = { far: null, greatest: null };
      this.describe();
    } finally {
      this.depthTurned = performance.now();
    }
  }

  /** The polygon of the level is a control polygon too: its distance from the same limit is asked for in this way. */
  async levelDistance(now, mine) {
    const refined = now.refined;
    if (!refined || now.level === 0 || refined.points.length > 3000) return;
    try {
      const files = { "points.csv": refined.exact.map((point) => point.join(", ")).join("\n") };
      const found = await this.engine.json(this.args("depth", "--tolerance", ANY, "--width", "1/1000000", "--distance", "parametric"), { files, kind: "curve-level-distance" });
      if (mine !== this.depthRun) return;
      this.lines.level = { ...curveDistance(found), level: now.level };
      this.describe();
    } catch (error) {
      if (!(error instanceof Stopped)) this.lines.level = null;
    }
  }

  describe() {
    if (this.error.textContent && this.depthError.textContent === this.error.textContent) this.depthError.textContent = "";
    const { depth = [], own, level } = this.lines;
    const distance = (of, found) => found && el("p", { title: found.exact },
      `${of}: ${found.size} from its limit${found.parameter === null ? "" : `, attained near t = ${found.parameter} in ${found.axis}`}.`);
    this.results.replaceChildren(
      ...depth.map((line, i) => el("p", { class: i === 0 ? "curve-depth" : "" }, line)),
      ...[distance("Control polygon", own), distance(`Level ${level?.level}`, level)].filter(Boolean),
      ...(own ? [el("p", { class: "soft" }, "The level for a tolerance compares polygon and limit as sets of points, unless it says otherwise. The distances compare points with the same parameter t, which grows by 1 from one point of the polygon to the next; they are the greater of those in x and y.")] : []),
    );
    this.canvas.description.textContent = depth.join(" ");
    this.mark();
  }

  mark() {
    const { far, greatest, now } = this.marks;
    const lines = [];
    if (greatest && greatest.parameter !== null && now?.limit?.arity) {
      const from = curvePlace(now, greatest.parameter, greatest.shift, now.closed);
      const step = now.limit.arity ** now.limit.level;
      const to = curvePlace({ ...now.limit, step }, greatest.parameter, greatest.shift, now.closed);
      if (from && to) lines.push({ from, to, text: `greatest distance of the control polygon: ${greatest.size}` });
    }
    this.canvas.mark(far ? [far] : [], lines);
  }

  savePicture() {
    save("subcert-curve.svg", `${this.canvas.saved()}\n`, "image/svg+xml");
    this.status.textContent = "The picture is saved as subcert-curve.svg.";
  }

  async copy() {
    this.remember();
    try {
      await navigator.clipboard.writeText(location.href);
      this.status.textContent = "The link is copied.";
    } catch {
      this.status.textContent = "The browser does not let this page copy; the link is in the address bar.";
    }
  }
}

export default {
  id: "curve",
  title: "Curve",
  mount(place, context) {
    const room = new CurveRoom(place, context);
    return { restore: () => room.restore() };
  },
};
