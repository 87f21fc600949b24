// A text area with the numbers of its lines, marks beside them, and bands behind lines that the program refuses.

import { el } from "./dom.js";
import { PAPER_BYTES, paperLineAt, paperTooLong } from "./paper-places.js";

/** Longer texts have plain numbers beside them, without colours; and more lines than that have no bands. */
const [PAPER_COLOURED, PAPER_BANDS] = [2000, 100];

/**
 * The editor. `changed()` is called when the visitor types, `moved(offset)` when the cursor moves, and `declined(why)` when what is typed or
 * pasted would be too long: the text then stays as it was.
 */
export function paperEditor({ changed, moved, declined }) {
  const area = el("textarea", { id: "paper-text", maxlength: PAPER_BYTES, wrap: "off", spellcheck: "false", autocapitalize: "off", autocomplete: "off", "aria-describedby": "paper-here" });
  const numbers = el("div", { class: "paper-numbers mono" });
  const bands = el("div", { class: "paper-bands" });
  const node = el("div", { class: "paper-editor" },
    el("div", { class: "paper-side", "aria-hidden": "true" }, numbers),
    el("div", { class: "paper-behind", "aria-hidden": "true" }, bands),
    area);
  // On paper, each line stands beside its number and mark, however long it is.
  const printed = el("ol", { class: "paper-printed mono" });
  let marks = new Map();
  let refused = [];
  let good = "";
  let drawn = null;

  const follow = () => {
    for (const layer of [numbers, bands]) layer.style.transform = `translateY(${-area.scrollTop}px)`;
  };
  const height = () => Number.parseFloat(getComputedStyle(area).lineHeight);
  /** The colour of a line, and its number behind its sign. */
  const numbering = () => {
    const bad = new Set(refused);
    return (line) => {
      const mark = bad.has(line) ? { kind: "bad", sign: "!" } : marks.get(line);
      return [mark?.kind ?? null, `${mark?.sign ?? ""} ${line}`];
    };
  };
  const draw = () => {
    const count = paperLineAt(area.value, area.value.length);
    // Most keys change no number of a line.
    const same = drawn?.count === count && drawn.marks === marks && drawn.refused === refused;
    drawn = { count, marks, refused };
    if (same) return follow();
    const numbered = numbering();
    const lines = Array.from({ length: count }, (_, i) => numbered(i + 1));
    if (count > PAPER_COLOURED) numbers.textContent = lines.map(([, text]) => text).join("\n");
    else numbers.replaceChildren(...lines.map(([kind, text]) => el("div", { class: kind }, text)));
    bands.replaceChildren(...refused.slice(0, PAPER_BANDS).map((line) => el("div", { style: `top: ${(line - 1) * height()}px` })));
    follow();
  };
  addEventListener("beforeprint", () => {
    const numbered = numbering();
    printed.replaceChildren(...area.value.split("\n").map((line, i) => {
      const [kind, number] = numbered(i + 1);
      return el("li", { class: kind }, el("span", {}, number), el("code", {}, line));
    }));
  });
  addEventListener("afterprint", () => printed.replaceChildren());
  const tell = () => document.activeElement === area && moved(area.selectionStart);

  area.addEventListener("scroll", follow);
  area.addEventListener("beforeinput", (event) => {
    const more = event.data ?? event.dataTransfer?.getData("text/plain") ?? "";
    if (more.length < 2) return;
    const why = paperTooLong(area.value.slice(0, area.selectionStart) + more + area.value.slice(area.selectionEnd));
    if (!why) return;
    event.preventDefault();
    declined(why);
  });
  area.addEventListener("input", () => {
    const why = area.value === good ? null : paperTooLong(area.value);
    if (why) {
      area.value = good;
      return declined(why);
    }
    good = area.value;
    draw();
    changed();
  });
  for (const event of ["keyup", "click", "select"]) area.addEventListener(event, tell);

  return {
    node,
    printed,
    area,
    get text() {
      return area.value;
    },
    set text(text) {
      area.value = text;
      good = area.value;
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
