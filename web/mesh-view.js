// A view of a mesh that turns: WebGL, or SVG where there is none.

import { el, svg } from "./dom.js";

/** More triangles are not drawn; the buffers would be larger than 200 MB. */
export const MESH_TRIANGLES = 1_500_000;
const SVG_FACES = 4000;
const WIRES = 60_000;
const SIZE = [640, 480];
const STEP = Math.PI / 12;

const VERTEX = `attribute vec3 place, normal, colour; uniform mat3 turn; uniform vec4 fit; uniform vec2 aspect; varying vec3 shade;
void main() { vec3 p = turn * (place - fit.xyz) * fit.w; vec3 n = turn * normal; float light = 0.55 + 0.45 * abs(n.z * 0.9 + n.y * 0.35 - n.x * 0.25) / 1.0;
shade = colour * mix(1.0, light, step(0.01, dot(normal, normal))); gl_Position = vec4(p.xy * aspect, -p.z * 0.02, 1.0); }`;
const FRAGMENT = "precision mediump float; varying vec3 shade; void main() { gl_FragColor = vec4(shade, 1.0); }";

const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

function unitNormal(points, face) {
  // Newell's sum, for faces that are not planar too.
  const sum = [0, 0, 0];
  for (let i = 1; i + 1 < face.length; i++) {
    cross(minus(points[face[i]], points[face[0]]), minus(points[face[i + 1]], points[face[0]])).forEach((x, k) => (sum[k] += x));
  }
  const length = Math.hypot(...sum) || 1;
  return sum.map((x) => x / length);
}

/** Colours from low to high that differ in brightness too. */
export function meshColour(part) {
  const stops = [[0.27, 0.3, 0.62], [0.15, 0.55, 0.6], [0.35, 0.72, 0.4], [0.9, 0.78, 0.2], [0.87, 0.35, 0.15]];
  const at = Math.min(0.9999, Math.max(0, part)) * (stops.length - 1);
  const i = Math.floor(at);
  return stops[i].map((x, k) => x + (at - i) * (stops[i + 1][k] - x));
}

export const meshCss = (colour) => `rgb(${colour.map((x) => Math.round(255 * x)).join(" ")})`;

/** The colour that a name of the style sheet means here. */
function named(place, name) {
  const probe = el("span", { style: `color: var(${name})` });
  place.append(probe);
  const found = getComputedStyle(probe).color.match(/[\d.]+/g)?.slice(0, 3).map((x) => Number(x) / 255) ?? [0.5, 0.5, 0.5];
  probe.remove();
  return found;
}

export class MeshView {
  yaw = -0.6;
  pitch = -1.0;
  zoom = 1;
  shown = null;

  constructor() {
    this.canvas = el("canvas", { width: SIZE[0], height: SIZE[1] });
    this.place = el("div", { class: "mesh-view", tabindex: 0, role: "img", "aria-label": "The mesh; arrow keys turn it, + and - zoom", "aria-roledescription": "view that turns" }, this.canvas);
    this.notice = el("p", { class: "soft" });
    const button = (label, text, action) => el("button", { type: "button", "aria-label": label, title: label, onclick: action }, text);
    this.buttons = el("div", { class: "row mesh-turns" },
      button("Turn left", "←", () => this.turn(-STEP, 0)), button("Turn right", "→", () => this.turn(STEP, 0)),
      button("Turn up", "↑", () => this.turn(0, -STEP)), button("Turn down", "↓", () => this.turn(0, STEP)),
      button("Nearer", "+", () => this.zooms(1.25)), button("Farther", "−", () => this.zooms(0.8)),
      button("As at the beginning", "reset", () => this.reset()));
    this.root = el("div", {}, this.place, this.buttons, this.notice);
    this.listen();
    this.start();
    this.colours = matchMedia("(prefers-color-scheme: dark)");
    this.colours.addEventListener("change", () => this.shown && this.show(this.shown));
    new ResizeObserver(() => this.draw()).observe(this.place);
  }

  listen() {
    const { place } = this;
    place.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      this.from = [event.clientX, event.clientY];
      place.setPointerCapture?.(event.pointerId);
    });
    place.addEventListener("pointermove", (event) => {
      if (!this.from) return;
      this.turn((event.clientX - this.from[0]) / 120, (event.clientY - this.from[1]) / 120);
      this.from = [event.clientX, event.clientY];
    });
    for (const end of ["pointerup", "pointercancel"]) place.addEventListener(end, () => (this.from = null));
    place.addEventListener("wheel", (event) => {
      // Who scrolls past it means the page.
      if (document.activeElement !== place && !event.ctrlKey) return;
      this.zooms(Math.exp(-event.deltaY / 500));
      event.preventDefault();
    }, { passive: false });
    place.addEventListener("keydown", (event) => {
      const act = {
        ArrowLeft: () => this.turn(-STEP, 0), ArrowRight: () => this.turn(STEP, 0), ArrowUp: () => this.turn(0, -STEP), ArrowDown: () => this.turn(0, STEP),
        "+": () => this.zooms(1.25), "=": () => this.zooms(1.25), "-": () => this.zooms(0.8), Home: () => this.reset(),
      }[event.key];
      if (!act || event.ctrlKey || event.metaKey || event.altKey) return;
      act();
      event.preventDefault();
    });
    this.canvas.addEventListener("webglcontextlost", (event) => {
      event.preventDefault();
      this.fall("The graphics of the browser have stopped");
    });
  }

  start() {
    const gl = this.canvas.getContext("webgl", { antialias: true, preserveDrawingBuffer: true });
    if (!gl) return this.fall("This browser has no WebGL");
    const program = gl.createProgram();
    for (const [type, text] of [[gl.VERTEX_SHADER, VERTEX], [gl.FRAGMENT_SHADER, FRAGMENT]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) return this.fall("The graphics of this browser do not work");
    gl.useProgram(program);
    this.uniforms = Object.fromEntries(["turn", "fit", "aspect"].map((name) => [name, gl.getUniformLocation(program, name)]));
    this.attributes = ["place", "normal", "colour"].map((name) => gl.getAttribLocation(program, name));
    this.attributes.forEach((at) => gl.enableVertexAttribArray(at));
    this.buffers = { faces: gl.createBuffer(), wires: gl.createBuffer(), mark: gl.createBuffer() };
    this.counts = { faces: 0, wires: 0, mark: 0 };
    this.gl = gl;
  }

  fall(why) {
    this.gl = null;
    this.picture = svg("svg", { viewBox: `0 0 ${SIZE.join(" ")}`, "aria-hidden": "true" });
    this.place.replaceChildren(this.picture);
    this.notice.textContent = `${why}. The mesh is drawn as a flat projection instead, of at most ${SVG_FACES} faces.`;
    this.draw();
  }

  turn(x, y) {
    this.yaw += x;
    this.pitch = Math.max(-Math.PI, Math.min(0, this.pitch + y));
    this.draw();
  }

  zooms(factor) {
    this.zoom = Math.max(0.2, Math.min(30, this.zoom * factor));
    this.draw();
  }

  reset() {
    Object.assign(this, { yaw: -0.6, pitch: -1.0, zoom: 1 });
    this.draw();
  }

  /** Says that the picture is of what was there before, or that it is new again. */
  old(is) {
    this.place.classList.toggle("mesh-stale", is);
    this.place.setAttribute("aria-busy", is);
    this.name();
  }

  name() {
    const what = !this.shown ? "No mesh is shown" : this.place.classList.contains("mesh-stale") ? "Old: the mesh that was shown before" : "The mesh";
    this.place.setAttribute("aria-label", `${what}; arrow keys turn it, + and - zoom`);
  }

  /** Shows nothing. */
  clear() {
    this.shown = null;
    this.old(false);
    if (this.gl) {
      this.gl.clearColor(0, 0, 0, 0);
      this.gl.clear(this.gl.COLOR_BUFFER_BIT | this.gl.DEPTH_BUFFER_BIT);
    } else this.picture.replaceChildren();
  }

  /** Shows points and faces with a colour for each face (or null), and marks a point; `box` keeps the size of the control mesh. */
  show(mesh) {
    this.shown = mesh;
    this.name();
    const [low, high] = [[Infinity, Infinity, Infinity], [-Infinity, -Infinity, -Infinity]];
    for (const point of mesh.box ?? mesh.points) {
      for (let i = 0; i < 3; i++) {
        low[i] = Math.min(low[i], point[i]);
        high[i] = Math.max(high[i], point[i]);
      }
    }
    this.middle = low.map((x, i) => (x + high[i]) / 2);
    this.size = 2 / (Math.hypot(...minus(high, low)) || 1);
    if (this.gl) this.fill(mesh);
    this.draw();
  }

  fill({ points, faces, colours, mark }) {
    const plain = named(this.root, "--accent").map((x) => 0.6 * x + 0.35);
    const edge = named(this.root, "--text");
    const triangles = faces.reduce((sum, face) => sum + face.length - 2, 0);
    const data = new Float32Array(27 * triangles);
    let at = 0;
    const put = (point, normal, colour) => {
      data.set(minus(point, this.middle), at);
      data.set(normal, at + 3);
      data.set(colour, at + 6);
      at += 9;
    };
    faces.forEach((face, f) => {
      const normal = unitNormal(points, face);
      const colour = colours?.[f] ?? plain;
      for (let i = 1; i + 1 < face.length; i++) for (const j of [0, i, i + 1]) put(points[face[j]], normal, colour);
    });
    this.send("faces", data, 9 * 4);
    const ends = faces.reduce((sum, face) => sum + face.length, 0);
    const wires = ends <= WIRES ? new Float32Array(faces.flatMap((face) => face.flatMap((p, i) => [p, face[(i + 1) % face.length]].flatMap((q) => [...minus(points[q], this.middle), 0, 0, 0, ...edge])))) : new Float32Array();
    this.send("wires", wires);
    this.send("mark", new Float32Array(mark ? this.octahedron(minus(mark, this.middle)) : []));
  }

  octahedron(point) {
    const r = 0.018 / this.size;
    const red = named(this.root, "--bad");
    const corner = (axis, sign) => point.map((x, i) => x + (i === axis ? sign * r : 0));
    const signs = [-1, 1].flatMap((a) => [-1, 1].flatMap((b) => [-1, 1].map((c) => [a, b, c])));
    return signs.flatMap((three) => three.flatMap((sign, axis) => [...corner(axis, sign), 0, 0, 0, ...red]));
  }

  send(name, data) {
    const { gl } = this;
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffers[name]);
    gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
    this.counts[name] = data.length / 9;
  }

  /** The rotation, row by row. */
  rotation() {
    const [c, s, d, t] = [Math.cos(this.yaw), Math.sin(this.yaw), Math.cos(this.pitch), Math.sin(this.pitch)];
    return [[c, -s, 0], [d * s, d * c, -t], [t * s, t * c, d]];
  }

  draw() {
    if (!this.shown || this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      if (!this.shown) return;
      if (this.gl) this.paint();
      else this.project();
    });
  }

  paint() {
    const { gl, canvas, uniforms } = this;
    const width = Math.max(1, Math.round(this.place.clientWidth * Math.min(2, devicePixelRatio)));
    const height = Math.round((width * SIZE[1]) / SIZE[0]);
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
    gl.viewport(0, 0, width, height);
    const rows = this.rotation();
    gl.uniformMatrix3fv(uniforms.turn, false, [0, 1, 2].flatMap((column) => rows.map((row) => row[column])));
    gl.uniform4f(uniforms.fit, 0, 0, 0, this.size);
    gl.uniform2f(uniforms.aspect, (this.zoom * height) / width, this.zoom);
    gl.clearColor(0, 0, 0, 0);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.POLYGON_OFFSET_FILL);
    gl.polygonOffset(1, 1);
    this.strokes("faces", gl.TRIANGLES);
    gl.disable(gl.POLYGON_OFFSET_FILL);
    this.strokes("wires", gl.LINES);
    gl.disable(gl.DEPTH_TEST);
    this.strokes("mark", gl.TRIANGLES);
  }

  strokes(name, how) {
    const { gl } = this;
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffers[name]);
    this.attributes.forEach((at, i) => gl.vertexAttribPointer(at, 3, gl.FLOAT, false, 36, 12 * i));
    gl.drawArrays(how, 0, this.counts[name]);
  }

  /** Without WebGL: faces from far to near. */
  project() {
    const { points, faces, colours, mark } = this.shown;
    const rows = this.rotation();
    const factor = (this.zoom * this.size * SIZE[1]) / 2;
    const turned = points.map((point) => rows.map((row) => row.reduce((sum, x, i) => sum + x * (point[i] - this.middle[i]), 0)));
    const place = ([x, y]) => [SIZE[0] / 2 + factor * x, SIZE[1] / 2 - factor * y];
    const far = (face) => face.reduce((sum, i) => sum + turned[i][2], 0) / face.length;
    const plain = [0.55, 0.65, 0.8];
    const order = faces.map((face, i) => [far(face), i]).sort((a, b) => a[0] - b[0]).slice(-SVG_FACES);
    this.picture.replaceChildren(...order.map(([, i]) => {
      const light = 0.55 + 0.45 * Math.abs(unitNormal(turned, faces[i])[2]);
      const fill = meshCss((colours?.[i] ?? plain).map((x) => x * light));
      return svg("polygon", { points: faces[i].map((p) => place(turned[p]).map((x) => x.toFixed(1)).join(",")).join(" "), fill, stroke: "currentColor", "stroke-width": 0.5 });
    }));
    if (!mark) return;
    const [x, y] = place(rows.map((row) => row.reduce((sum, value, i) => sum + value * (mark[i] - this.middle[i]), 0)));
    this.picture.append(svg("circle", { cx: x, cy: y, r: 5, class: "mesh-mark" }));
  }
}
