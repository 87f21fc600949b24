// The room of schemes: type a mask, move its parameters, and see what holds.

import { el, field, later, picture, save } from "./dom.js";
import { Stopped } from "./engine.js";
import { SchemeControl } from "./scheme-controls.js";
import { schemeFacts, schemeHead, schemeLevels, schemeLimits, schemePairs } from "./scheme-facts.js";
import { schemeAsked, schemeParameter, schemePlace, schemeSplit, schemeToml, schemeValues, schemeValuesText, schemeWith } from "./scheme-parse.js";

const SCHEME_EXAMPLES = [
  ["chaikin", "", "corner cutting"], ["four-point", "w=1/16", "interpolates"], ["six-point", "w=3/256", "smoother"],
  ["ternary-four-point", "mu=1/11", "three new points for each"], ["loop", "N=7", "a vertex of a mesh"], ["courant", "", "triangles of the plane"],
];

/** How long the visitor rests until all facts are computed, and how long a redraw may take when another one waits. */
const [SCHEME_REST, SCHEME_PATIENCE] = [400, 250];

/** How long the ranges of one order may take, in seconds, and up to which order they are asked for. */
const [SCHEME_RANGE_SECONDS, SCHEME_ORDERS] = [20, 4];

const schemeWords = (error) => error.message.trim();

class SchemeRoom {
  constructor(place, { engine, state }) {
    Object.assign(this, { engine, state, controls: [], catalogue: new Map(), ranges: new Map(), turn: 0, asked: 0, drawing: false, answers: {} });
    this.rest = later(() => this.rested(), SCHEME_REST);
    this.typed = later(() => this.choose(this.input.value.trim(), ""), 600);
    this.build(place);
    this.list();
    this.restore();
  }

  build(place) {
    this.input = el("input", { type: "text", class: "mono", list: "scheme-catalogue", spellcheck: "false", autocapitalize: "off", autocomplete: "off", maxlength: 4000, oninput: () => this.typed(), onchange: () => this.choose(this.input.value.trim(), "") });
    this.input.addEventListener("keydown", ({ key }) => key === "Enter" && this.choose(this.input.value.trim(), ""));
    this.names = el("datalist", { id: "scheme-catalogue" });
    this.title = el("p", { class: "soft scheme-title" });
    this.alert = el("div", { class: "error", role: "alert" });
    this.status = el("p", { class: "scheme-status", role: "status", "aria-live": "polite" });
    this.sliders = el("div", { class: "scheme-parameters" });
    this.head = el("div", { class: "scheme-head" });
    this.figure = el("div", { class: "scheme-figure" });
    this.figure.attachShadow({ mode: "open" });
    this.levels = el("div", {});
    this.facts = el("div", {});
    this.copied = el("div", {});
    const examples = SCHEME_EXAMPLES.map(([name, at, about]) => el("button", { type: "button", class: "scheme-example", onclick: () => this.choose(name, at) }, name, el("small", {}, about)));
    const sub = () => el("sub", {}, "c");
    place.append(
      field("Scheme", this.input, "Type a mask such as [1, 3, 3, 1]/4, a symbol such as (1+z)^3/4, or a name such as four-point; a letter without a value, as in [w, 1-w, 1-w, w], gets a slider."),
      this.names, el("div", { class: "row scheme-examples", role: "group", "aria-label": "Examples" }, examples),
      this.alert, this.title, this.sliders, this.head,
      el("div", { class: "columns scheme-columns" }, el("div", {}, this.figure, this.buttons(), this.copied, this.status), el("div", {}, this.levels,
        el("p", { class: "soft" }, "T", sub(), ": neighbours that differ by at most 1 differ by at most this after c levels. Λ", sub(), ": points that are at most 1 away from 0 are at most this far away after c levels."), this.facts)));
  }

  buttons() {
    const button = (label, work) => el("button", { type: "button", onclick: work }, label);
    return el("div", { class: "row scheme-buttons" },
      button("Copy as TOML", () => this.copy(schemeToml(this.text, this.values(), this.catalogue.get(schemeSplit(this.text).family), this.answers.constants))),
      button("Copy link", () => this.copy(location.href)),
      button("Save SVG", () => this.answers.plot && save("scheme.svg", this.answers.plot, "image/svg+xml")),
      button("Save JSON", () => this.saveFacts()));
  }

  async copy(text) {
    this.copied.replaceChildren();
    try {
      await navigator.clipboard.writeText(text);
      this.status.textContent = "Copied.";
    } catch {
      // Without the clipboard, the text is there to be copied by hand.
      const box = el("textarea", { readonly: true, rows: 6, "aria-label": "To copy" });
      box.value = text;
      this.copied.append(box);
      box.select();
    }
  }

  async saveFacts() {
    const args = ["scheme", this.whole(), "--format", "json"];
    const { code, text, errors } = await this.engine.run(args, { kind: "scheme-facts" }).catch(() => ({ code: 2, errors: "" }));
    if (code < 2) save("scheme.json", text, "application/json");
    else if (errors) this.alert.textContent = errors.trim();
  }

  /** The names of the catalogue, to complete what is typed. */
  async list() {
    this.listed = this.engine.json(["schemes"]).then(({ schemes }) => {
      for (const one of schemes) this.catalogue.set(one.name, one);
      this.names.append(...schemes.map(({ name, title }) => el("option", { value: name }, title)));
    }, () => {});
  }

  restore() {
    const { scheme = SCHEME_EXAMPLES[1][0], at = SCHEME_EXAMPLES[1][1] } = this.state.get();
    if (scheme !== this.text || at !== schemeValuesText(this.values())) this.choose(scheme, at);
  }

  values() {
    return new Map(this.controls.map(({ parameter, value }) => [parameter.name, value]));
  }

  /** The scheme with all values, as the commands take it. */
  whole() {
    return schemeWith(this.text, this.values());
  }

  /** Another scheme: finds its open parameters, and draws it. */
  async choose(text, at) {
    if (this.input.value.trim() !== text) this.input.value = text;
    if (text === this.text && at === "") return;
    this.text = text;
    const asked = ++this.asked;
    Object.assign(this, { choosing: true, wanted: false });
    this.endFacts();
    await this.listed;
    const parameters = await this.open(text, schemeValues(at));
    if (asked !== this.asked) return;
    this.controls = parameters.map(({ value, ...parameter }) => new SchemeControl(parameter, value, () => this.moved()));
    this.sliders.replaceChildren(...this.controls.map(({ element }) => element));
    const known = this.catalogue.get(schemeSplit(text).family);
    this.title.replaceChildren(...(known ? [`${known.title} `, known.source && `(${known.source})`] : []).filter(Boolean));
    this.title.append(...this.freeing(text));
    Object.assign(this, { choosing: false, fresh: true });
    this.moved();
  }

  /** A button for each value in the text, which gives its parameter a slider. */
  freeing(text) {
    const { family, given } = schemeSplit(text);
    return [...given].map(([name, value]) => {
      const others = new Map([...given].filter(([other]) => other !== name));
      return el("button", { type: "button", onclick: () => this.choose(schemeWith(family, others), `${name}=${value}`) }, `Move ${name}`);
    });
  }

  /** The parameters without a value: those of the catalogue, or those that the program asks for. */
  async open(text, wanted) {
    const { family, given } = schemeSplit(text);
    const found = (this.catalogue.get(family)?.parameters ?? []).filter(({ name }) => !given.has(name)).map(schemeParameter);
    const values = new Map(found.map(({ name, start }) => [name, wanted.get(name) || start]).filter(([, value]) => value !== null && value !== undefined));
    for (let count = 0; count < 8; count++) {
      if (found.length > 0 && found.every(({ name }) => values.has(name))) break;
      const whole = schemeWith(text, values);
      const answer = await this.engine.run(["smoothness", whole], { kind: "scheme-open" }).catch(() => null);
      const asked = answer && schemeAsked(answer.errors, whole);
      if (!asked || values.has(asked.name)) break;
      if (!found.some(({ name }) => name === asked.name)) found.push(schemeParameter(asked));
      values.set(asked.name, wanted.get(asked.name) || asked.start || "1/4");
    }
    return found.map((parameter) => ({ ...parameter, value: values.get(parameter.name) ?? "1/4" }));
  }

  /** A value has changed: redraws, at once or when the redraw that runs has ended. */
  moved() {
    this.state.set({ scheme: this.text, at: schemeValuesText(this.values()) });
    this.endFacts();
    this.rest();
    this.wanted = true;
    if (!this.drawing) this.draw();
    else this.patience ??= setTimeout(() => this.wanted && this.draw(), SCHEME_PATIENCE);
  }

  /** Ends what runs for a value that is gone, as a redraw cannot wait for it. */
  endFacts() {
    this.turn += 1;
    if (["scheme-facts", "scheme-range"].includes(this.engine.running?.kind)) this.engine.stop();
  }

  /** One redraw: the picture, the smoothness and the constants. */
  async draw() {
    clearTimeout(this.patience);
    Object.assign(this, { patience: null, wanted: false });
    const turn = ++this.turn;
    const since = performance.now();
    this.drawing = turn;
    const whole = this.whole();
    const errors = [];
    const part = async (command, args, show) => {
      const kind = `scheme-${command}`;
      try {
        const answer = command === "plot" ? await this.plot(whole, kind) : await this.engine.json([command, whole, ...args], { kind });
        if (this.drawing !== turn) return;
        this.answers[command] = answer;
        show(answer);
      } catch (error) {
        if (this.drawing === turn) errors.push(error instanceof Stopped ? "stopped" : schemeWords(error));
      }
    };
    await Promise.all([
      part("smoothness", [], (answer) => this.head.replaceChildren(...[schemePairs("Smoothness", schemeHead(answer))].filter(Boolean))),
      part("plot", [], (text) => this.show(text)),
      part("constants", ["-c", "4"], (answer) => this.levels.replaceChildren(...schemeLevels(answer))),
    ]);
    if (this.drawing !== turn) return;
    this.drawing = false;
    const said = [...new Set(errors)].join("\n");
    if (this.alert.textContent !== said) this.alert.textContent = said;
    this.figure.classList.toggle("scheme-old", errors.length > 0);
    this.figure.dataset.milliseconds = Math.round(performance.now() - since);
    if (this.wanted) this.draw();
    else if (this.fresh || this.late) this.rested();
  }

  async plot(whole, kind) {
    const { code, text, errors } = await this.engine.run(["plot", whole], { kind });
    if (code > 1) throw new Error(errors.trim());
    return text;
  }

  /** The picture has colours of its own; in a shadow they cannot change those of the page. */
  show(text) {
    this.figure.shadowRoot.replaceChildren(picture(text.replaceAll(":root", ":host")));
  }

  /** After a rest: the ranges of each parameter, once for each family, and all facts. */
  async rested() {
    this.late = Boolean(this.drawing);
    if (this.late || this.choosing || this.restedTurn === this.turn) return;
    const turn = this.restedTurn = this.turn;
    const fresh = this.fresh;
    this.fresh = false;
    const whole = this.whole();
    try {
      if (!fresh || this.shown !== whole) await this.allFacts(whole, turn);
      for (const control of this.controls) await this.marked(control, turn);
    } catch (error) {
      if (!(error instanceof Stopped)) throw error;
      if (turn === this.turn) this.status.textContent = "Stopped.";
    }
  }

  async allFacts(whole, turn) {
    try {
      const answer = await this.engine.json(["scheme", whole], { kind: "scheme-facts" });
      if (turn !== this.turn) throw new Stopped();
      this.shown = whole;
      this.facts.replaceChildren(...schemeFacts(answer));
    } catch (error) {
      if (error instanceof Stopped) throw error;
      // What the redraw has said already is not said again.
      this.facts.replaceChildren(...(this.alert.textContent.includes(schemeWords(error)) ? [] : [el("p", { class: "error" }, schemeWords(error))]));
    }
    this.facts.classList.remove("scheme-old");
    const { smoothness } = this.answers;
    const limits = smoothness?.scheme === whole ? (smoothness.valences ? smoothness.valences.map(({ verdict }) => verdict).join(", ") : schemeLimits(smoothness)) : "";
    this.status.textContent = limits ? `${whole}: ${limits}` : "";
  }

  /** Marks the ranges of a parameter, when the others have their values. */
  async marked(control, turn) {
    const { parameter } = control;
    if (parameter.counts) return;
    const others = this.values();
    others.delete(parameter.name);
    const family = schemeWith(this.text, others);
    const key = `${family} ${parameter.name}`;
    if (control.key === key) return;
    if (!this.ranges.has(key)) this.ranges.set(key, await this.range(family, parameter.name, turn));
    if (turn !== this.turn) return;
    control.key = key;
    control.mark(this.ranges.get(key));
  }

  async range(family, name, turn) {
    const found = { orders: [], special: [], note: null };
    for (let order = 0; order < SCHEME_ORDERS; order++) {
      const args = ["range", family, "--param", name, "--smoothness", String(order), "--seconds", String(SCHEME_RANGE_SECONDS)];
      try {
        const answer = await this.engine.json(args, { kind: "scheme-range" });
        if (turn !== this.turn) throw new Stopped();
        // Around a vertex there is one list of intervals for each valence.
        found.orders.push({ ...answer, ...answer.valences?.[0] });
        found.special = answer.special ?? found.special;
        if (answer.valences) break;
      } catch (error) {
        if (error instanceof Stopped) throw error;
        if (order > 0) break;
        found.note = schemeWords(error).split("\n")[0].replace(/^error: /, "");
      }
    }
    if (found.orders.length > 0) found.note = null;
    return found;
  }
}

export default { id: "scheme", title: "Scheme", mount(place, tools) { const room = new SchemeRoom(place, tools); return { restore: () => room.restore() }; } };
