// The drawing of the room "Curve": control points that are moved, and the polygons that the commands give.

import { el, svg } from "./dom.js";
import { curveText } from "./curve-data.js";

const WIDTH = 700;
const HEIGHT = 490;
const KEYS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

const pairs = (points, closed) => {
  const all = closed && points.length > 1 ? [...points, points[0]] : points;
  return all.map(([x, y]) => `${x.toFixed(2)},${y.toFixed(2)}`).join(" ");
};

/** A canvas that tells of points which are moved, added and removed. */
export class CurveCanvas {
  points = [];
  closed = true;
  dots = [];
  dragged = null;

  constructor({ moved, settled, added, removed }) {
    this.tell = { moved, settled, added, removed };
    this.control = svg("polyline", { class: "curve-control" });
    this.level = svg("polyline", { class: "curve-level" });
    this.limit = svg("polyline", { class: "curve-limit" });
    this.levelDots = svg("g", { class: "curve-level-dots" });
    this.marks = svg("g", { class: "curve-marks" });
    this.handles = svg("g", {});
    this.description = svg("desc", {});
    this.root = svg("svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, class: "curve-canvas", role: "group", "aria-label": "Control points and curve" },
      svg("title", {}, "Control points and curve"), this.description,
      this.control, this.limit, this.level, this.levelDots, this.marks, this.handles);
    this.root.addEventListener("click", (event) => this.press(event));
    this.root.addEventListener("pointermove", (event) => this.move(event));
    for (const end of ["pointerup", "pointercancel"]) this.root.addEventListener(end, () => this.drop());
    this.look([]);
  }

  /** Chooses the part of the plane that is shown; it stays while a point is dragged. */
  look(points) {
    const numbers = points.map((point) => point.map(Number));
    const range = (i, low, high) => {
      const all = numbers.map((point) => point[i]);
      const [least, most] = [Math.min(low, ...all), Math.max(high, ...all)];
      return least < low || most > high ? [least - (most - least) / 12, most + (most - least) / 12] : [low, high];
    };
    const [[left, right], [bottom, top]] = [range(0, 0, 10), range(1, 0, 7)];
    this.scale = Math.min(WIDTH / (right - left), HEIGHT / (top - bottom));
    this.left = (left + right) / 2 - WIDTH / this.scale / 2;
    this.bottom = (bottom + top) / 2 - HEIGHT / this.scale / 2;
    this.digits = Math.min(3, Math.max(0, 3 - Math.ceil(Math.log10(WIDTH / this.scale))));
  }

  toScreen = ([x, y]) => [(Number(x) - this.left) * this.scale, HEIGHT - (Number(y) - this.bottom) * this.scale];

  toPlane(event) {
    const box = this.root.getBoundingClientRect();
    const x = ((event.clientX - box.left) / box.width) * WIDTH;
    const y = ((event.clientY - box.top) / box.height) * HEIGHT;
    return this.texts([x / this.scale + this.left, (HEIGHT - y) / this.scale + this.bottom]);
  }

  texts = (point) => point.map((number) => curveText(number, this.digits));

  /** Shows the control polygon. */
  show(points, closed) {
    this.points = points;
    this.closed = closed;
    while (this.dots.length > points.length) this.dots.pop().remove();
    while (this.dots.length < points.length) this.addDot(this.dots.length);
    const places = points.map(this.toScreen);
    this.control.setAttribute("points", pairs(places, closed));
    places.forEach(([x, y], i) => {
      this.dots[i].setAttribute("transform", `translate(${x.toFixed(2)} ${y.toFixed(2)})`);
      this.dots[i].setAttribute("aria-label", `Point ${i + 1} of ${points.length}: ${points[i].join(", ")}`);
    });
  }

  /** Shows polygons of a level. */
  draw(which, points, closed) {
    const places = points.map(this.toScreen);
    this[which].setAttribute("points", pairs(places, closed));
    if (which !== "level") return;
    // Many dots hide the line.
    const dots = places.length > 200 ? [] : places;
    this.levelDots.replaceChildren(...dots.map(([x, y]) => svg("circle", { cx: x.toFixed(2), cy: y.toFixed(2), r: 2.2 })));
  }

  clear() {
    for (const one of [this.limit, this.level]) one.setAttribute("points", "");
    this.levelDots.replaceChildren();
    this.marks.replaceChildren();
  }

  /** Marks places: discs with a radius of the plane, and lines between two points. */
  mark(discs, lines) {
    this.marks.replaceChildren(
      ...discs.map(({ point, radius, text }) => {
        const [x, y] = this.toScreen(point);
        return svg("g", { class: "curve-far" }, svg("circle", { cx: x, cy: y, r: radius * this.scale }),
          svg("path", { d: `M${x - 6} ${y - 6}l12 12m0 -12l-12 12` }), svg("title", {}, text));
      }),
      ...lines.map(({ from, to, text }) => {
        const [[x1, y1], [x2, y2]] = [from, to].map(this.toScreen);
        return svg("g", { class: "curve-greatest" }, svg("line", { x1, y1, x2, y2 }), svg("title", {}, text));
      }),
    );
  }

  addDot(i) {
    // The outer circle is for fingers.
    const dot = svg("g", { class: "curve-dot", tabindex: 0, role: "button", "aria-roledescription": "control point" },
      svg("circle", { r: 20, class: "curve-touch" }), svg("circle", { r: 7 }));
    dot.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      this.dragged = i;
      dot.setPointerCapture?.(event.pointerId);
      dot.focus();
      event.preventDefault();
    });
    dot.addEventListener("keydown", (event) => this.key(event, i));
    this.dots.push(dot);
    this.handles.append(dot);
  }

  key(event, i) {
    const step = KEYS[event.key];
    if (step) {
      const unit = (event.shiftKey ? 1 : 10) * 10 ** -this.digits;
      this.tell.moved(i, this.texts(this.points[i].map((text, axis) => Number(text) + step[axis] * unit)));
      this.tell.settled(false);
    } else if (event.key === "Delete" || event.key === "Backspace") {
      this.tell.removed(i);
      this.dots[Math.min(i, this.dots.length - 1)]?.focus();
    } else return;
    event.preventDefault();
  }

  move(event) {
    if (this.dragged !== null) this.tell.moved(this.dragged, this.toPlane(event));
  }

  drop() {
    if (this.dragged === null) return;
    this.dragged = null;
    this.dropped = performance.now();
    this.tell.settled(true);
  }

  /** A click beside all points adds one; the click that ends a drag does not. */
  press(event) {
    if (event.target.closest(".curve-dot") || performance.now() - (this.dropped ?? -1000) < 300) return;
    this.tell.added(this.toPlane(event));
  }

  /** The picture alone, with its colours. */
  saved() {
    const copy = this.root.cloneNode(true);
    const all = [this.root, ...this.root.querySelectorAll("*")];
    [copy, ...copy.querySelectorAll("*")].forEach((one, i) => {
      const style = getComputedStyle(all[i]);
      for (const name of ["fill", "stroke", "stroke-width", "stroke-dasharray", "fill-opacity", "opacity"]) one.setAttribute(name, style.getPropertyValue(name));
      for (const name of ["tabindex", "class", "role", "aria-roledescription"]) one.removeAttribute(name);
    });
    copy.querySelectorAll("circle[r='20']").forEach((one) => one.remove());
    copy.setAttribute("width", WIDTH);
    copy.setAttribute("height", HEIGHT);
    return new XMLSerializer().serializeToString(copy);
  }
}

/** What the lines and marks of the drawing mean. */
export function curveLegend() {
  const line = (name, text) => el("li", {}, svg("svg", { viewBox: "0 0 36 12", width: 36, height: 12, "aria-hidden": "true" },
    svg("line", { x1: 1, y1: 6, x2: 35, y2: 6, class: name })), ` ${text}`);
  return el("ul", { class: "curve-legend" },
    line("curve-control", "control polygon"), line("curve-level", "polygon of the level"), line("curve-limit", "limit, as a fine level"),
    line("curve-greatest-line", "where the control polygon is farthest from its limit"),
    line("curve-far-line", "a point that is too far at the level before"));
}
