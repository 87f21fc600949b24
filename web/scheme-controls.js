// A slider for a parameter, with the ranges of smoothness beside it.

import { el } from "./dom.js";
import { shortly } from "./numbers.js";
import { schemeLacks, schemePlace } from "./scheme-parse.js";

/** `C²` for 2. */
export const schemeOrder = (m) => `C${String(m).replace(/\d/g, (digit) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[digit])}`;

/** How many valences, degrees and the like a slider offers. */
const SCHEME_COUNTS = 9;

let schemeNumbered = 0;

/** The end of an interval in few characters. */
function schemeEnd(value) {
  return value.exact.length <= 9 ? value.exact : shortly(value, 7);
}

/** An interval in words. */
function schemeInterval(name, { low, high }) {
  if (low && high) return `${schemeEnd(low)} < ${name} < ${schemeEnd(high)}`;
  if (low) return `${name} > ${schemeEnd(low)}`;
  return high ? `${name} < ${schemeEnd(high)}` : `all ${name}`;
}

/** What is known of one order, as a sentence. */
function schemeSentence(name, { smoothness, inside, outside, but_finitely_many: but }) {
  const list = (intervals) => intervals.map((one) => schemeInterval(name, one)).join(", ");
  const parts = [inside.length > 0 ? `for ${list(inside)}${but ? ", but for finitely many values" : ""}` : "on no interval is known"];
  if (outside.length > 0) parts.push(`not for ${list(outside)}`);
  return `${schemeOrder(smoothness)} ${parts.join("; ")}`;
}

/** The slider, the number field and the bars of one parameter. `changed` is called with each new value. */
export class SchemeControl {
  constructor(parameter, value, changed) {
    Object.assign(this, { parameter, value, changed, low: -1, high: 1 });
    const { name, about } = parameter;
    const id = `scheme-parameter-${++schemeNumbered}`;
    this.slider = el("input", { type: "range", id: `${id}-slider`, "aria-label": `${name}, slider`, "aria-describedby": `${id}-about`, oninput: () => this.slid() });
    this.number = el("input", { type: "text", id, class: "mono", size: 10, spellcheck: "false", autocomplete: "off", "aria-describedby": `${id}-lacks ${id}-about`, oninput: () => this.typed() });
    this.lack = el("small", { id: `${id}-lacks`, class: "error", role: "alert" });
    this.bars = el("div", { class: "scheme-bars", "aria-hidden": "true" });
    this.words = el("ul", { class: "scheme-words soft" });
    this.legend = el("small", { class: "scheme-legend soft", hidden: true }, el("i", { class: "scheme-inside" }), "proven ", el("i", { class: "scheme-outside" }), "refuted ", el("i", { class: "scheme-open" }), "open");
    this.ranges = el("details", { class: "scheme-ranges", hidden: true }, el("summary", {}, `The ranges of ${name} in numbers`), this.words);
    this.special = el("div", { class: "row scheme-special" });
    this.element = el("div", { class: "scheme-parameter" },
      el("label", { for: id }, "Parameter ", el("var", {}, name)), this.number,
      el("div", { class: "scheme-track" }, this.slider, this.bars, this.legend),
      this.lack, el("small", { id: `${id}-about`, class: "soft" }, about ?? "a free letter of the scheme: a decimal or a fraction"),
      this.special, this.ranges);
    if (parameter.counts) this.ends(parameter.least, Math.max(parameter.least + SCHEME_COUNTS * parameter.step, schemePlace(value) ?? 0), parameter.step);
    else this.reach([]);
    this.put(value);
  }

  /** Ends of the slider, and a step that is a power of ten, so that its values are short decimals. */
  ends(low, high, step = 10 ** Math.floor(Math.log10((high - low) / 200))) {
    this.digits = Math.max(0, -Math.floor(Math.log10(step)));
    this.low = Math.floor(low / step + 1e-9) * step;
    this.high = Math.ceil(high / step - 1e-9) * step;
    for (const [key, value] of [["min", this.low], ["max", this.high], ["step", step]]) this.slider.setAttribute(key, value.toFixed(this.digits));
  }

  /** Ends of the slider around these points, and the value, with a margin. */
  reach(points) {
    const place = schemePlace(this.value);
    const all = points.length > 1 ? points : [-1, 1];
    if (place !== null) all.push(place);
    const [low, high] = [Math.min(...all), Math.max(...all)];
    const margin = points.length > 1 ? (high - low || 1) / 8 : 0;
    this.ends(low - margin, high + margin);
    this.put(this.value);
  }

  slid() {
    const text = this.slider.valueAsNumber.toFixed(this.digits);
    this.put(this.digits > 0 ? text.replace(/\.?0+$/, "").replace(/^-0$/, "0") : text);
    this.changed();
  }

  typed() {
    this.value = this.number.value.trim();
    this.place();
    this.changed();
  }

  /** What the value lacks, or null. */
  get lacks() {
    return schemeLacks(this.parameter.name, this.value);
  }

  /** Shows a value. */
  put(value) {
    this.value = value;
    this.number.value = value;
    this.place();
  }

  place() {
    const place = schemePlace(this.value);
    const said = this.lacks ?? "";
    if (this.lack.textContent !== said) this.lack.textContent = said;
    this.number.setAttribute("aria-invalid", String(said !== ""));
    if (place !== null) this.slider.value = place;
    this.slider.setAttribute("aria-valuetext", this.value);
    this.element.style.setProperty("--place", `${place === null ? -10 : this.share(place)}%`);
  }

  /** How far along the slider a point is, in percent. */
  share(point) {
    return Math.min(100, Math.max(0, (100 * (point - this.low)) / (this.high - this.low)));
  }

  /** Marks the orders: each has intervals inside and outside, and is open elsewhere. */
  mark({ key, orders, special, note }) {
    if (this.key !== key) this.around(orders);
    this.key = key;
    this.bars.replaceChildren(...orders.map((order) => this.bar(order)));
    const lines = orders.map((order) => schemeSentence(this.parameter.name, order));
    this.words.replaceChildren(...[...lines, note].filter(Boolean).map((line) => el("li", {}, line)));
    this.special.replaceChildren(...this.buttons(special ?? []));
    this.legend.hidden = orders.length === 0;
    this.ranges.hidden = !this.words.hasChildNodes();
    // What there is instead of ranges is shown at once.
    if (orders.length === 0) this.ranges.open = true;
  }

  /** The slider shows all of the widest range, which is that of the first order. */
  around([first]) {
    const ends = first ? [...first.inside, ...first.outside].flatMap(({ low, high }) => [low, high]) : [];
    this.reach(ends.filter(Boolean).map(({ decimal }) => Number(decimal)));
    if (this.parameter.guessed) this.settle(first?.inside.find(({ low, high }) => low && high));
    this.parameter.guessed = false;
  }

  /** Moves a guess into an interval, if it is outside. */
  settle(interval) {
    if (!interval) return;
    const [low, high] = [Number(interval.low.decimal), Number(interval.high.decimal)];
    const place = schemePlace(this.value);
    if (place > low && place < high) return;
    this.slider.value = (low + high) / 2;
    this.slid();
  }

  bar({ smoothness, inside, outside }) {
    const piece = (kind) => ({ low, high }) => {
      const [left, right] = [low ? this.share(Number(low.decimal)) : 0, high ? this.share(Number(high.decimal)) : 100];
      return el("i", { class: `scheme-${kind}`, style: `left: ${left}%; width: ${right - left}%` });
    };
    return el("div", { class: "scheme-bar" }, el("span", {}, schemeOrder(smoothness)), el("b", {}, outside.map(piece("outside")), inside.map(piece("inside"))));
  }

  /** Single values with more sum rules than their neighbours, as buttons. */
  buttons(special) {
    const { name } = this.parameter;
    const short = special.filter(({ value }) => /^-?\d+(\/\d+)?$/.test(value.exact) && value.exact.length < 12);
    return short.slice(0, 6).map(({ value, continuity }) => {
      const more = continuity === null || continuity === undefined ? "" : `: ${schemeOrder(continuity)}`;
      return el("button", { type: "button", onclick: () => { this.put(value.exact); this.changed(); } }, `${name} = ${value.exact}${more}`);
    });
  }
}
