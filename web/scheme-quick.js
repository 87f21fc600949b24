// What is drawn while a slider moves: the unit impulse after some levels, which needs no search, above the last picture.

import { svg } from "./dom.js";

/** At most so many points for each interval of level 0. */
const SCHEME_DENSE = 40;

/** The classes and places of the first chart in a picture of the program, so that nothing jumps. */
const SCHEME_CHART = { width: 640, height: 232, top: 44, left: 56, right: 624, up: 22, down: 150 };

/** The parameters between which a mask puts what it makes of an impulse at 0. */
function schemeReach({ arity, width, offset }) {
  return [(-arity * (offset + width - 1)) / (arity - 1), (arity - 1 - arity * offset) / (arity - 1)];
}

/** A closed polygon that is 1 at 0 and long enough that what comes of it does not meet itself, and how often it is refined. */
export function schemeImpulse(mask) {
  const [low, high] = schemeReach(mask);
  const points = Math.floor(high - low) + 1;
  const level = Math.max(2, Math.floor(Math.log(SCHEME_DENSE) / Math.log(mask.arity)));
  return { points, level, text: `1\n${"0\n".repeat(points - 1)}` };
}

/** The points of an answer of `oracle` in order, with point i at i/nᵏ, and the support, whose ends the outermost ones tell. */
function schemeResponse({ header, groups }) {
  const [mask] = header.masks;
  const dense = mask.arity ** header.level;
  const values = groups.find(({ quantity }) => quantity === "refined").values.map(({ f64 }) => Number(f64));
  const at = (i) => values[((i % values.length) + values.length) % values.length];
  let [first, last] = schemeReach(mask).map((end) => Math.round(end * dense));
  while (first < last && at(first) === 0) first += 1;
  while (first < last && at(last) === 0) last -= 1;
  const [low, high] = [first / (dense - 1), last / (dense - 1)];
  const points = [];
  for (let i = Math.ceil(low * dense); i <= high * dense; i++) points.push([i / dense, at(i)]);
  return { points, low, high, dense };
}

/** Round numbers between two ends. */
function schemeTicks(low, high) {
  const rough = (high - low) / 7;
  const ten = 10 ** Math.floor(Math.log10(rough));
  const step = ten * [1, 2, 5, 10].find((factor) => factor * ten >= rough);
  const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const found = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + step * 1e-9; i++) found.push([i * step, (i * step).toFixed(digits).replace(/^-(0\.?0*)$/, "$1")]);
  return found;
}

function schemeChart(answer) {
  const { points, low, high, dense } = schemeResponse(answer);
  const { width, height, top, left, right, up, down } = SCHEME_CHART;
  const values = points.map(([, value]) => value);
  const [least, most] = [Math.min(0, ...values), Math.max(...values)];
  const x = (place) => (left + ((right - left) * (place - low)) / (high - low || 1)).toFixed(1);
  const y = (value) => (down - ((down - up) * (value - least)) / (most - least || 1)).toFixed(1);
  const levels = schemeTicks(least, most || 1).map(([value, text]) => [
    svg("line", { class: "axis", x1: left, x2: right, y1: y(value), y2: y(value) }),
    svg("text", { class: "soft", x: left - 6, y: Number(y(value)) + 4, "text-anchor": "end" }, text)]);
  const places = schemeTicks(low, high > low ? high : low + 1).map(([place, text]) => [
    svg("line", { class: "axis", x1: x(place), x2: x(place), y1: 160, y2: 164 }),
    svg("text", { class: "soft", x: x(place), y: 178, "text-anchor": "middle" }, text)]);
  const title = `The unit impulse after ${answer.header.level} levels, while you move`;
  return svg("svg", { viewBox: `0 0 ${width} ${height}`, width, height, role: "img", "aria-label": title, style: "position: absolute; inset: 0 auto auto 0" },
    svg("rect", { class: "paper", width, height }),
    svg("text", { class: "title", x: 12, y: 32 }, title),
    svg("g", { transform: `translate(0 ${top})` }, ...levels.flat(), ...places.flat(),
      svg("rect", { class: "frame", x: left, y: 12, width: right - left, height: 148 }),
      svg("line", { class: "frame", x1: left, x2: right, y1: y(0), y2: y(0) }),
      svg("g", { class: "c1" },
        svg("polyline", { class: "line", points: points.map(([place, value]) => `${x(place)},${y(value)}`).join(" ") }),
        svg("text", { class: "name over", x: right - 8, y: 32, "text-anchor": "end" }, `point i at i/${dense}`))));
}

/** Lays the chart over the first one of the last picture. The rest stays in grey, or where it would stand half behind the chart, only its place. */
export function schemeQuick(root, answer) {
  const [picture, before] = root.children;
  const next = [...picture.querySelectorAll(":scope > .title")][1];
  picture.style.opacity = next && Number(next.getAttribute("y")) < SCHEME_CHART.height + 20 ? 0 : 0.45;
  picture.setAttribute("aria-hidden", "true");
  before?.remove();
  root.append(schemeChart(answer));
}

/** The last picture alone, as it was. */
export function schemeQuickEnd(root) {
  const [picture, chart] = root.children;
  chart?.remove();
  picture?.style.removeProperty("opacity");
  picture?.removeAttribute("aria-hidden");
}
