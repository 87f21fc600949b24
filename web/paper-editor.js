// A text area with the numbers of its lines, marks beside them, and bands behind lines that the program refuses.

import { el } from "./dom.js";
import { paperLineAt } from "./paper-places.js";

/** The editor. `changed()` is called when the visitor types, `moved(offset)` when the cursor moves. */
export function paperEditor({ changed, moved }) {
  const area = el("textarea", { id: "paper-text", wrap: "off", spellcheck: "false", autocapitalize: "off", autocomplete: "off", "aria-describedby": "paper-here" });
  const numbers = el("div", { class: "paper-numbers mono" });
  const bands = el("div", { class: "paper-bands" });
  const node = el("div", { class: "paper-editor" },
    el("div", { class: "paper-side", "aria-hidden": "true" }, numbers),
    el("div", { class: "paper-behind", "aria-hidden": "true" }, bands),
    area);
  let marks = new Map();
  let refused = [];

  const follow = () => {
    for (const layer of [numbers, bands]) layer.style.transform = `translateY(${-area.scrollTop}px)`;
  };
  const height = () => Number.parseFloat(getComputedStyle(area).lineHeight);
  const draw = () => {
    const count = area.value.split("\n").length;
    numbers.replaceChildren(...Array.from({ length: count }, (_, i) => {
      const mark = refused.includes(i + 1) ? { kind: "bad", sign: "!" } : marks.get(i + 1);
      return el("div", { class: mark?.kind ?? null }, `${mark?.sign ?? ""} ${i + 1}`);
    }));
    bands.replaceChildren(...refused.map((line) => el("div", { style: `top: ${(line - 1) * height()}px` })));
    follow();
  };
  const tell = () => document.activeElement === area && moved(area.selectionStart);

  area.addEventListener("scroll", follow);
  area.addEventListener("input", () => {
    draw();
    changed();
  });
  for (const event of ["keyup", "click", "select"]) area.addEventListener(event, tell);

  return {
    node,
    area,
    get text() {
      return area.value;
    },
    set text(text) {
      area.value = text;
      area.scrollTo(0, 0);
      [marks, refused] = [new Map(), []];
      draw();
    },
    /** Marks beside lines: { kind, sign } by number. */
    mark(found) {
      marks = found;
      draw();
    },
    /** The lines that are refused. */
    refuse(lines) {
      refused = lines;
      draw();
    },
    /** Puts the cursor there, in view. */
    select(from, to) {
      area.focus({ preventScroll: true });
      area.setSelectionRange(from, to);
      const line = paperLineAt(area.value, from);
      const before = from - (area.value.lastIndexOf("\n", from - 1) + 1);
      const wide = Number.parseFloat(getComputedStyle(area).fontSize) * 0.6;
      area.scrollTop = (line - 1) * height() - area.clientHeight / 2;
      area.scrollLeft = before * wide > area.clientWidth * 0.7 ? before * wide - area.clientWidth / 2 : 0;
      node.scrollIntoView({ block: "nearest" });
      moved(from);
    },
  };
}
