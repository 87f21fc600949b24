// The room "Curve": control points that are drawn and dragged, with the polygon of a level, the limit, and their distance.

import { CurveCanvas, curveLegend } from "./curve-canvas.js";
import { CURVE_MAX, CURVE_START, curveDepth, curveDistance, curveLevel, curveLines, curvePlace, curvePoints, curveShort } from "./curve-data.js";
import { copyLink, el, field, later, save } from "./dom.js";
import { Stopped } from "./engine.js";

/** With this tolerance every polygon of the page is within it at level 0, and the answer is its distance there. */
const ANY = "100000000000";
/** A limit is drawn with so many points or more. */
const FINE = 700;
/** While points move, the depth is asked for again after so many milliseconds. */
const REST = 300;
/** While a point is dragged, a drawing that is younger than so many milliseconds does not turn grey: it follows. */
const FOLLOWS = 250;
const STOPPED = "Stopped: what is grey is of what was there before. Every change computes anew.";

class CurveRoom {
  points = CURVE_START;
  pending = false;
  drawing = false;
  depthTurned = 0;
  depthRun = 0;
  /** What the drawn polygons belong to, and since when they are there. */
  drawn = { level: null, limit: null };
  moving = false;
  typing = false;
  halted = false;
  arity = 2;
  marks = { far: null, greatest: null };
  lines = {};
  /** Of the schemes of the catalogue: `mask` for curves, `lattice`, `ring`. */
  kinds = new Map();

  constructor(place, { engine, state }) {
    this.engine = engine;
    this.state = state;
    this.build(place);
    this.restore();
  }

  build(place) {
    this.canvas = new CurveCanvas({
      moved: (i, point) => this.change(this.points.map((old, j) => (j === i ? point : old)), true),
      settled: (look) => this.settle(look),
      added: (point) => this.add(point),
      removed: (i) => this.edit(this.points.filter((_, j) => j !== i)),
    });
    const settle = later(() => this.settle(), 150);
    const readList = later(() => this.readList(), 200);
    // What is shown is old from the first key on, and not only when it is asked for anew.
    const changed = () => {
      this.freshen();
      settle();
    };
    const typed = () => {
      this.typing = true;
      this.freshen();
      readList();
    };
    this.names = el("datalist", { id: "curve-schemes" });
    this.scheme = el("input", { class: "curve-scheme mono", list: "curve-schemes", autocomplete: "off", spellcheck: "false", maxlength: 500, oninput: changed });
    this.closed = el("input", { type: "checkbox", id: "curve-closed", onchange: () => this.settle() });
    this.level = el("input", { type: "range", min: 0, max: 8, step: 1, oninput: () => this.slide() });
    this.levelText = el("output", {});
    this.tolerance = el("input", { class: "mono", size: 10, maxlength: 60, autocomplete: "off", spellcheck: "false", oninput: changed });
    this.list = el("textarea", { rows: 8, spellcheck: "false", oninput: typed });
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
        el("div", { class: "field" }, el("label", { for: "curve-closed" }, this.closed, " closed"),
          el("small", {}, "an open polygon has a limit where no point beyond its ends would have a weight"))),
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

  /** The names of schemes, which are asked for again after a failure. */
  async catalogue() {
    if (this.listing || this.kinds.size > 0) return;
    this.listing = true;
    try {
      const { schemes } = await this.engine.json(["schemes"]);
      for (const { name, kind } of schemes) this.kinds.set(name, kind);
      const masks = schemes.filter((one) => one.kind === "mask");
      this.names.replaceChildren(...masks.map((one) => {
        const needed = one.parameters.map(({ name, default: value }) => `${name}=${value ?? "…"}`).join(",");
        return el("option", { value: needed ? `${one.name}:${needed}` : one.name }, one.title);
      }));
    } catch (error) {
      if (!(error instanceof Stopped)) this.status.textContent = error.message;
    } finally {
      this.listing = false;
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
    this.look();
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
    this.typing = false;
    this.moving = moving;
    this.canvas.show(points, this.closed.checked);
    if (moving) this.ask(true);
  }

  /** The points of the list. Where there is an error, it is said, and what is shown is not about what stands there. */
  takeList() {
    this.moving = false;
    try {
      this.points = curvePoints(this.list.value);
      this.typing = false;
      this.listError.textContent = "";
      this.look();
    } catch (error) {
      this.typing = true;
      this.listError.textContent = error.message;
      this.freshen();
    }
  }

  readList() {
    this.takeList();
    if (this.typing) return;
    this.remember();
    this.ask();
  }

  slide() {
    this.levelText.value = this.level.value;
    this.settle();
  }

  /** Something is as it shall be: into the list and the address, and asks for all of it. */
  settle(look = false) {
    this.moving = false;
    // What is typed there counts, and stays when it is wrong.
    if (this.typing) this.takeList();
    if (!this.typing) {
      this.listError.textContent = "";
      this.list.value = curveLines(this.points);
    }
    if (look) this.look();
    this.remember();
    this.ask();
  }

  remember() {
    this.state.set({ scheme: this.scheme.value, points: curveShort(this.points), closed: this.closed.checked ? "" : "no", level: this.level.value, tolerance: this.tolerance.value });
  }

  leave() {
    if (this.typing) this.readList();
  }

  /** One round after the other; what changes in between is drawn by the next one. */
  async ask(moving = false) {
    this.levelText.value = this.level.value;
    this.canvas.show(this.points, this.closed.checked);
    this.pending = moving ? "moving" : "still";
    this.halted = false;
    this.freshen();
    if (this.drawing) return;
    this.drawing = true;
    while (this.pending) {
      const how = this.pending;
      this.pending = false;
      await this.round(how === "moving");
    }
    this.drawing = false;
    this.catalogue();
  }

  /** What is there now, with what each result belongs to: a result with another key is old. */
  now() {
    const [scheme, tolerance, level] = [this.scheme.value.trim(), this.tolerance.value.trim(), Number(this.level.value)];
    const closed = this.closed.checked;
    const text = curveLines(this.points);
    const limit = JSON.stringify([scheme, closed, text]);
    const keys = { limit, level: `${limit} ${level}`, depth: `${limit} ${tolerance}` };
    return { scheme, tolerance, level, closed, points: this.points, files: { "points.csv": text }, keys };
  }

  args({ scheme, closed }, command, ...more) {
    return [command, scheme, "--polygon", "points.csv", "--boundary", closed ? "closed" : "open", ...more];
  }

  /** Nothing is shown but the control points. */
  clear() {
    this.depthRun += 1;
    this.canvas.clear();
    this.lines = {};
    this.marks = { far: null, greatest: null };
    this.drawn = { level: null, limit: null };
    this.error.textContent = this.depthError.textContent = "";
  }

  /** The part of the plane that is shown, with all that is drawn there. */
  look() {
    this.canvas.look(this.points);
    for (const [which, drawn] of Object.entries(this.drawn)) if (drawn) this.canvas.draw(which, drawn.points, drawn.closed);
    this.mark();
  }

  draw(which, now, polygon) {
    this.canvas.draw(which, polygon.points, now.closed);
    this.drawn[which] = { key: now.keys[which], at: performance.now(), points: polygon.points, closed: now.closed };
    this.freshen();
  }

  async round(moving) {
    if (this.points.length < 2) {
      this.clear();
      this.results.replaceChildren(el("p", {}, "Draw at least two points."));
      this.freshen();
      return;
    }
    const now = this.now();
    const kind = this.kinds.get(now.scheme.split(":")[0].trim());
    const wrong = now.scheme.startsWith("-") ? "a scheme does not begin with -" : kind && kind !== "mask" && `${now.scheme} is a scheme of surfaces; take one of curves, as chaikin or four-point`;
    if (wrong) {
      this.depthRun += 1;
      this.depthError.textContent = "";
      this.error.textContent = wrong;
      this.freshen();
      return;
    }
    const oracle = (level, kind) => this.table(this.args(now, "oracle", "-c", "1", "--level", String(level), "--format", "csv"), now, kind);
    // Asked again, one that runs for long is stopped, so that the drawing goes on.
    const wantsDepth = !moving || performance.now() - this.depthTurned > REST;
    try {
      const refined = oracle(now.level, "curve-level");
      const limit = oracle(this.fine(now), "curve-limit");
      limit.catch(() => {});
      if (wantsDepth) this.depths(now, moving);
      now.refined = await refined;
      this.arity = now.refined.arity ?? 2;
      this.draw("level", now, now.refined);
      now.limit = await limit;
      this.draw("limit", now, now.limit);
      this.error.textContent = "";
      this.describe();
    } catch (error) {
      // No other round runs, so that nothing but the visitor stops one.
      if (error instanceof Stopped) this.halt();
      else {
        this.error.textContent = error.message;
        this.freshen();
      }
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
    const mine = ++this.depthRun;
    const { tolerance, keys } = now;
    const common = { files: now.files };
    this.depthTurned = performance.now();
    try {
      const depth = this.engine.json(this.args(now, "depth", `--tolerance=${tolerance}`), { ...common, kind: "curve-depth" });
      const own = this.engine.json(this.args(now, "depth", "--tolerance", ANY, "--width", "1/10000", "--distance", "parametric"), { ...common, kind: "curve-distance" });
      own.catch(() => {});
      const told = curveDepth(await depth, tolerance);
      const greatest = curveDistance(await own);
      if (mine !== this.depthRun) return;
      this.depthError.textContent = "";
      this.lines = { depth: { texts: told.lines, key: keys.depth }, own: greatest && { ...greatest, key: keys.limit }, level: null };
      this.marks = { far: told.mark, greatest, now };
      this.describe();
      if (!moving) this.levelDistance(now, mine);
    } catch (error) {
      if (mine !== this.depthRun) return;
      if (error instanceof Stopped) return this.halt();
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
      const found = await this.engine.json(this.args(now, "depth", "--tolerance", ANY, "--width", "1/1000000", "--distance", "parametric"), { files, kind: "curve-level-distance" });
      if (mine !== this.depthRun) return;
      const distance = curveDistance(found);
      // Its parameter counts points of the level, and not those of the control polygon.
      this.lines.level = distance && { ...distance, parameter: null, level: now.level, key: now.keys.level };
      this.describe();
    } catch (error) {
      if (mine === this.depthRun && error instanceof Stopped) this.halt();
    }
  }

  describe() {
    if (this.error.textContent && this.depthError.textContent === this.error.textContent) this.depthError.textContent = "";
    const { depth, own, level } = this.lines;
    const line = (of, text, more = {}) => el("p", { ...more, "data-key": of.key }, el("span", { class: "curve-word" }, "Old: "), text);
    const distance = (of, found) => found && line(found,
      `${of}: ${found.size} from its limit${found.parameter === null ? "" : `, attained near t = ${found.parameter} in ${found.axis}`}.`, { title: found.exact });
    this.results.replaceChildren(
      ...(depth?.texts ?? []).map((text, i) => line(depth, text, { class: i === 0 ? "curve-depth" : "" })),
      ...[distance("Control polygon", own), distance(`Level ${level?.level}`, level)].filter(Boolean),
      ...(own ? [el("p", { class: "soft" }, "The level for a tolerance compares polygon and limit as sets of points, unless it says otherwise. The distances compare points with the same parameter t, which grows by 1 from one point of the polygon to the next; they are the greater of those in x and y.")] : []),
    );
    this.mark();
    this.freshen();
  }

  /** The visitor has stopped a command. */
  halt() {
    this.halted = true;
    this.freshen();
  }

  /** What does not belong to the present scheme, points, level and tolerance is grey, and said to be old. */
  freshen() {
    const { keys } = this.now();
    const known = new Set(this.typing ? [] : Object.values(keys));
    const { depth, own } = this.lines;
    let any = false;
    const old = (key) => {
      const found = key !== undefined && !known.has(key);
      any ||= found;
      return found;
    };
    for (const part of this.results.querySelectorAll("[data-key]")) part.classList.toggle("curve-old", old(part.dataset.key));
    for (const which of ["level", "limit"]) {
      const { key, at } = this.drawn[which] ?? {};
      const follows = this.moving && performance.now() - at < FOLLOWS;
      this.canvas.root.classList.toggle(`curve-old-${which}`, old(key) && !follows);
    }
    this.canvas.root.classList.toggle("curve-old-far", old(depth?.key));
    this.canvas.root.classList.toggle("curve-old-greatest", old(own?.key));
    this.canvas.description.textContent = [any && "Some of this picture is old.", ...(depth?.texts ?? [])].filter(Boolean).join(" ");
    this.results.setAttribute("aria-busy", any && !this.halted && !this.error.textContent);
    if (this.halted) this.status.textContent = any ? STOPPED : "Stopped. Every change computes anew.";
    else if (this.status.textContent.startsWith("Stopped")) this.status.textContent = "";
    clearTimeout(this.soon);
    if (this.moving && any) this.soon = setTimeout(() => this.freshen(), FOLLOWS);
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
    this.status.textContent = await copyLink();
  }
}

export default {
  id: "curve",
  title: "Curve",
  mount(place, context) {
    const room = new CurveRoom(place, context);
    return { restore: () => room.restore(), leave: () => room.leave() };
  },
};
