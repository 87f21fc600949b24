// The room of schemes: type a mask, move its parameters, and see what holds.

import { el, field, frame, later, save } from "./dom.js";
import { Stopped } from "./engine.js";
import { SchemeControl } from "./scheme-controls.js";
import { schemeFacts, schemeHead, schemeLevels, schemePairs, schemeSaid } from "./scheme-facts.js";
import { schemeAsked, schemeParameter, schemeRefused, schemeSplit, schemeToml, schemeValues, schemeValuesText, schemeWith } from "./scheme-parse.js";
import { schemeImpulse, schemeQuick, schemeQuickEnd } from "./scheme-quick.js";

const SCHEME_EXAMPLES = [
  ["chaikin", "", "corner cutting"], ["four-point", "w=1/16", "interpolates"], ["six-point", "w=3/256", "smoother"],
  ["ternary-four-point", "mu=1/11", "three new points for each"], ["loop", "N=7", "a vertex of a mesh"], ["courant", "", "triangles of the plane"],
];

/** How long the visitor rests until the picture is complete, and until all facts are computed; and how long a redraw may take when another one waits. */
const [SCHEME_PAUSE, SCHEME_REST, SCHEME_PATIENCE] = [120, 400, 250];

/** How long the ranges of one order may take, in seconds, and up to which order they are asked for. */
const [SCHEME_RANGE_SECONDS, SCHEME_ORDERS] = [20, 4];

const schemeWords = (error) => error.message.trim();

class SchemeRoom {
  constructor(place, { engine, state }) {
    Object.assign(this, { engine, state, controls: [], catalogue: new Map(), ranges: new Map(), turn: 0, asked: 0, drawing: false, answers: {} });
    this.pause = later(() => this.paused(), SCHEME_PAUSE);
    this.rest = later(() => this.rested(), SCHEME_REST);
    this.typed = later(() => this.enter(), 600);
    this.build(place);
    this.list();
    this.restore();
  }

  build(place) {
    this.input = el("input", { type: "text", class: "mono", list: "scheme-catalogue", spellcheck: "false", autocapitalize: "off", autocomplete: "off", maxlength: 4000, oninput: () => this.typing(), onchange: () => this.enter() });
    this.input.addEventListener("keydown", ({ key }) => key === "Enter" && this.enter());
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
      this.alert, this.title, this.sliders,
      el("div", { class: "scheme-columns" }, this.head, el("div", { class: "scheme-left" }, this.figure, this.buttons(), this.copied, this.status), el("div", { class: "scheme-right" }, this.levels,
        el("p", { class: "soft" }, "T", sub(), ": neighbours that differ by at most 1 differ by at most this after c levels. Λ", sub(), ": points that are at most 1 away from 0 are at most this far away after c levels."), this.facts)));
  }

  buttons() {
    // What looks old is neither copied nor saved.
    const ready = (work) => () => this.held ? (this.status.textContent = "Not done: what is shown is not of the scheme and the values above.") : work();
    const button = (label, work) => el("button", { type: "button", onclick: ready(work) }, label);
    return el("div", { class: "row scheme-buttons" },
      button("Copy as TOML", () => this.copy(this.toml())),
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

  toml() {
    const { constants } = this.answers;
    const known = this.catalogue.has(schemeSplit(this.text).family);
    return schemeToml(this.text, this.values(), known, constants?.scheme === this.whole() ? constants : null);
  }

  async saveFacts() {
    const args = ["scheme", this.whole(), "--format", "json"];
    const { code, text, errors } = await this.engine.run(args, { kind: "scheme-facts" }).catch(() => ({ code: 2, errors: "" }));
    if (code < 2) save("scheme.json", text, "application/json");
    else if (errors) this.alert.textContent = errors.trim();
  }

  /** The names of the catalogue, to complete what is typed. After a failure they are asked for again. */
  list() {
    this.listed ??= this.engine.json(["schemes"]).then(({ schemes }) => {
      for (const one of schemes) this.catalogue.set(one.name, one);
      this.names.append(...schemes.map(({ name, title }) => el("option", { value: name }, title)));
    }, (error) => {
      this.listed = null;
      return error;
    });
    return this.listed;
  }

  restore() {
    const [name, start] = SCHEME_EXAMPLES[1];
    const { scheme = name, at = scheme === name ? start : "" } = this.state.get();
    if (scheme !== this.text || at !== schemeValuesText(this.values())) this.choose(scheme, at);
  }

  values() {
    return new Map(this.controls.map(({ parameter, value }) => [parameter.name, value]));
  }

  /** The scheme with all values, as the commands take it. */
  whole() {
    return schemeWith(this.text, this.values());
  }

  /** Ends what is computed: nothing that is shown is about what stands in the fields, and it looks old. */
  hold(...others) {
    Object.assign(this, { held: true, wanted: false, drawing: false, complete: null });
    this.endFacts();
    this.endDraw();
    this.status.textContent = "";
    for (const part of [this.head, this.figure, this.levels, this.facts, ...others]) part.classList.add("scheme-old");
  }

  /** A key is pressed in the field of the scheme. */
  typing() {
    this.doubted = true;
    this.asked += 1;
    this.hold(this.title, this.sliders, this.alert);
    this.typed();
  }

  /** What stands in the field is the scheme; the same one as before keeps its values. */
  enter() {
    const text = this.input.value.trim();
    if (text !== this.text) this.choose(text, "");
    else if (this.doubted) this.choose(text, this.at);
  }

  /** What stands in the field goes into the address, also where it has not been read yet. */
  leave() {
    const text = this.input.value.trim();
    if (text !== this.text) this.state.set({ scheme: text, at: "" });
  }

  /** Another scheme: finds its open parameters, and draws it. */
  async choose(text, at) {
    if (this.input.value.trim() !== text) this.input.value = text;
    if (text === this.text && at === "" && !this.doubted) return;
    const asked = ++this.asked;
    Object.assign(this, { text, at, choosing: true, doubted: false, answers: {} });
    this.hold(this.title, this.sliders, this.alert);
    const wrong = schemeRefused(text);
    if (wrong) return this.refuse(wrong);
    const parameters = await this.list() ?? await this.open(text, schemeValues(at)).catch((error) => error);
    if (asked !== this.asked) return;
    if (parameters instanceof Error) {
      // The names of the parameters are not known.
      this.doubted = true;
      this.alert.classList.remove("scheme-old");
      this.alert.textContent = parameters instanceof Stopped ? "Stopped. Press Enter in the field of the scheme to begin again." : schemeWords(parameters);
      return;
    }
    this.controls = parameters.map(({ value, ...parameter }) => new SchemeControl(parameter, value, () => this.moved()));
    this.sliders.replaceChildren(...this.controls.map(({ element }) => element));
    const known = this.catalogue.get(schemeSplit(text).family);
    this.title.replaceChildren(...(known ? [`${known.title} `, known.source && `(${known.source})`] : []).filter(Boolean));
    this.title.append(...this.freeing(text));
    for (const part of [this.title, this.sliders]) part.classList.remove("scheme-old");
    Object.assign(this, { choosing: false, fresh: true });
    this.moved();
  }

  /** Says why the program is not asked about a text. Nothing of the scheme before stays but its picture, in grey. */
  refuse(wrong) {
    this.controls = [];
    for (const part of [this.title, this.sliders, this.facts]) {
      part.replaceChildren();
      part.classList.remove("scheme-old");
    }
    Object.assign(this, { choosing: false, shown: null });
    this.state.set({ scheme: this.text, at: "" });
    this.failed(new Map(["plot", "smoothness", "constants"].map((command) => [command, wrong])));
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
      if (this.catalogue.has(family) && found.every(({ name }) => values.has(name))) break;
      const whole = schemeWith(text, values);
      const answer = await this.engine.run(["smoothness", whole], { kind: "scheme-open" });
      const asked = answer && schemeAsked(answer.errors, whole);
      if (!asked || values.has(asked.name)) break;
      if (!found.some(({ name }) => name === asked.name)) found.push(schemeParameter(asked));
      values.set(asked.name, wanted.get(asked.name) || asked.start || "1/4");
    }
    // A value that nobody has named may be replaced by one for which the limits are smooth.
    return found.map((parameter) => ({ ...parameter, value: values.get(parameter.name) ?? "1/4", guessed: !parameter.start && !wanted.has(parameter.name) }));
  }

  /** A value has changed: redraws, at once or when the redraw that runs has ended. */
  moved() {
    if (this.choosing || this.doubted) return;
    this.at = schemeValuesText(this.controls.filter(({ lacks }) => !lacks).map(({ parameter, value }) => [parameter.name, value]));
    this.state.set({ scheme: this.text, at: this.at });
    // The field says what it lacks.
    if (this.controls.some(({ lacks }) => lacks)) return this.hold();
    this.held = false;
    this.endFacts();
    for (const part of [this.head, this.figure, this.levels]) part.classList.add("scheme-old");
    this.facts.classList.toggle("scheme-old", this.shown !== this.whole());
    this.pause();
    this.rest();
    Object.assign(this, { wanted: true, still: false, complete: null });
    // What is quick does not wait for what is not.
    if (!this.drawing || (this.quick() && !this.drawsQuickly)) this.draw();
    else this.patience ??= setTimeout(() => this.wanted && this.draw(), SCHEME_PATIENCE);
  }

  /** No move for a while: what was drawn quickly is drawn in full. */
  paused() {
    if (this.held || this.drawing || this.complete === this.whole()) return;
    this.still = true;
    this.draw();
  }

  /** Whether a quick redraw is possible: for one mask of curves with rational coefficients, when there is a picture to lay it on. */
  quick() {
    return !this.still && Boolean(this.answers.plot) && this.answers.constants?.directions?.length === 1;
  }

  /** Ends what runs for a value that is gone, as a redraw cannot wait for it. */
  endFacts() {
    this.turn += 1;
    if (["scheme-facts", "scheme-range"].includes(this.engine.running?.kind)) this.engine.stop();
  }

  /** Ends what is drawn of another scheme or value, if it takes long: a command of the same kind that takes no time replaces it. */
  endDraw() {
    const kind = this.engine.running?.kind;
    if (["quick", "plot", "smoothness", "constants"].some((part) => kind === `scheme-${part}`)) this.engine.replace(kind);
  }

  /** The parts of a redraw: where each stands, how it is asked for and shown. */
  parts(whole) {
    const json = (command, ...args) => () => this.engine.json([command, whole, ...args], { kind: `scheme-${command}` });
    return {
      quick: [this.figure, () => this.impulse(whole), (answer) => schemeQuick(this.figure.shadowRoot, answer)],
      plot: [this.figure, () => this.plot(whole), (text) => frame(this.figure, text)],
      smoothness: [this.head, json("smoothness"), (answer) => this.head.replaceChildren(...[schemePairs("Smoothness", schemeHead(answer))].filter(Boolean))],
      constants: [this.levels, json("constants", "-c", "4"), (answer) => this.levels.replaceChildren(...schemeLevels(answer))],
    };
  }

  /** One redraw: the picture, the smoothness and the constants, one after the other, so that a move leaves out the rest; or what is quick. */
  async draw() {
    clearTimeout(this.patience);
    const quick = this.quick();
    const whole = this.whole();
    const turn = ++this.turn;
    const since = performance.now();
    Object.assign(this, { patience: null, wanted: false, drawing: turn, drawsQuickly: quick, complete: quick ? null : whole });
    const parts = this.parts(whole);
    const errors = new Map();
    for (const command of quick ? ["quick", "constants"] : ["plot", "smoothness", "constants"]) {
      const [place, ask, show] = parts[command];
      try {
        const answer = await ask();
        if (this.drawing !== turn) return;
        this.answers[command] = answer;
        place.classList.remove("scheme-old");
        show(answer);
      } catch (error) {
        if (this.drawing !== turn) return;
        errors.set(command, error instanceof Stopped ? "stopped" : schemeWords(error));
      }
    }
    this.drawing = false;
    this.figure.dataset.milliseconds = Math.round(performance.now() - since);
    if (quick) return this.drawnQuickly(errors);
    this.failed(errors);
    if (this.wanted) this.draw();
    else if (this.fresh || this.late) this.rested();
  }

  /** After a quick redraw: the next one, or the full one after a pause. What cannot be quick is drawn in full at once, and says itself what is wrong. */
  drawnQuickly(errors) {
    if (errors.size > 0) delete this.answers.constants;
    else this.alert.textContent = "";
    if (this.wanted || errors.size > 0) this.draw();
    else this.pause();
  }

  /** The scheme applied to the unit impulse. The polygon has room for the last mask; for a wider one, it is made longer. */
  async impulse(whole) {
    let [mask] = this.answers.constants.directions;
    for (;;) {
      const { points, level, text } = schemeImpulse(mask);
      const args = ["oracle", whole, "--polygon", "impulse.csv", "--level", String(level), "-c", "1"];
      const asked = this.engine.json(args, { kind: "scheme-quick", files: { "impulse.csv": text } });
      if (this.engine.running?.kind !== "scheme-quick") this.endDraw();
      const answer = await asked;
      [mask] = answer.header.masks;
      const needed = schemeImpulse(mask);
      if (needed.points <= points && needed.level === level) return answer;
    }
  }

  /** Says what went wrong: near the input, or where the part would stand if others are there. The last picture stays, in grey. */
  failed(errors) {
    const places = { smoothness: this.head, constants: this.levels, plot: null };
    const all = errors.size === Object.keys(places).length;
    const near = new Set([...errors].filter(([command]) => all || !places[command]).map(([, text]) => text));
    const said = [...near].join("\n");
    if (this.alert.textContent !== said) this.alert.textContent = said;
    this.alert.classList.remove("scheme-old");
    for (const [command, text] of errors) {
      delete this.answers[command];
      places[command]?.classList.remove("scheme-old");
      places[command]?.replaceChildren(...(near.has(text) ? [] : [el("p", { class: "error" }, text)]));
    }
    this.figure.classList.toggle("scheme-old", errors.has("plot"));
    if (errors.has("plot")) schemeQuickEnd(this.figure.shadowRoot);
  }

  async plot(whole) {
    const { code, text, errors } = await this.engine.run(["plot", whole], { kind: "scheme-plot" });
    if (code > 1) throw new Error(errors.trim() || `exit code ${code}`);
    return text;
  }

  /** After a rest: the ranges of each parameter, once for each family, and all facts. */
  async rested() {
    this.late = Boolean(this.drawing) || this.complete === null;
    if (this.late || this.held || this.restedTurn === this.turn) return;
    const turn = this.restedTurn = this.turn;
    this.fresh = false;
    const whole = this.whole();
    try {
      const real = this.controls.filter(({ parameter }) => !parameter.counts);
      // The first range gives the slider its ends; the others may come after the facts.
      for (const control of real) if (control.key !== this.known(control).key) await this.mark(control, turn);
      if (this.shown !== whole) await this.allFacts(whole, turn);
      for (const control of real) while (!this.known(control).done) await this.mark(control, turn);
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
    this.status.textContent = smoothness?.scheme === whole ? `${whole}: ${schemeSaid(smoothness)}` : "";
  }

  /** What is known of the ranges of a parameter, when the others have their values. */
  known(control) {
    const { name } = control.parameter;
    const others = this.values();
    others.delete(name);
    const family = schemeWith(this.text, others);
    const key = `${family} ${name}`;
    if (!this.ranges.has(key)) this.ranges.set(key, { key, family, name, orders: [], special: [], note: null, next: 0, done: false });
    return this.ranges.get(key);
  }

  /** Finds the range of the next order, and marks all that are found. What is found is kept when a move ends the search. */
  async mark(control, turn) {
    const found = this.known(control);
    // Around a vertex there is no range of order 0.
    do if (!found.done) await this.range(found, turn);
    while (!found.done && found.orders.length === 0 && turn === this.turn);
    if (turn !== this.turn) throw new Stopped();
    control.mark(found);
  }

  async range(found, turn) {
    const order = found.next;
    const args = ["range", found.family, "--param", found.name, "--smoothness", String(order), "--seconds", String(SCHEME_RANGE_SECONDS)];
    try {
      const answer = await this.engine.json(args, { kind: "scheme-range" });
      // Around a vertex there is one list of intervals for each valence.
      found.orders.push({ ...answer, ...answer.valences?.[0] });
      found.special = answer.special ?? found.special;
      found.note = null;
      found.done = Boolean(answer.valences) || order + 1 === SCHEME_ORDERS;
    } catch (error) {
      // A move may go on later; who presses Stop wants no more of it.
      if (error instanceof Stopped && turn !== this.turn) throw error;
      found.done = order > 0 || error instanceof Stopped;
      if (order === 0) found.note = error instanceof Stopped ? "stopped" : schemeWords(error).split("\n")[0].replace(/^error: /, "");
      if (error instanceof Stopped) throw error;
    }
    found.next = order + 1;
  }
}

export default { id: "scheme", title: "Scheme", mount(place, tools) { const room = new SchemeRoom(place, tools); return { restore: () => room.restore(), leave: () => room.leave() }; } };
