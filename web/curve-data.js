// The points of the room "Curve", and what the commands say about them.

import { digits, shortly } from "./numbers.js";

export const CURVE_START = [["1", "1"], ["2", "5.5"], ["5", "6"], ["5.5", "2.5"], ["8.5", "5"], ["9", "1"]];
export const CURVE_MAX = 100;

const COORDINATE = /^-?\d{1,6}(\.\d{1,3})?$/;

/** Points from lines `x, y`, also with `;` between the points, or an error that says what to write. */
export function curvePoints(text) {
  const lines = text.split(/[\n;]/).map((line) => line.trim()).filter((line) => line !== "");
  if (lines.length > CURVE_MAX) throw new Error(`there are ${lines.length} points, and this page takes at most ${CURVE_MAX}`);
  return lines.map((line, i) => {
    const found = line.split(/[\s,]+/);
    if (found.length !== 2 || !found.every((one) => COORDINATE.test(one))) {
      throw new Error(`point ${i + 1}: \`${line.slice(0, 40)}\` is not a point; write two numbers with at most 3 decimals, as 2.5, -1`);
    }
    return found;
  });
}

export const curveLines = (points) => points.map((point) => point.join(", ")).join("\n");
export const curveShort = (points) => points.map((point) => point.join(",")).join(";");

/** A coordinate of the picture as a short text. */
export function curveText(number, digits) {
  const held = Math.min(999_999, Math.max(-999_999, number));
  return String(Number(held.toFixed(digits)));
}

/** The polygon of a level, from the table of `oracle`: points, their exact texts, the first index and the arity. */
export function curveLevel(table) {
  const columns = { "refined-1": [], "refined-2": [] };
  const exact = { "refined-1": [], "refined-2": [] };
  for (const line of table.split("\n")) {
    const [quantity, , value, , nearest] = line.split(",");
    columns[quantity]?.push(Number(nearest));
    exact[quantity]?.push(value);
  }
  const pairs = ([x, y]) => x.map((one, i) => [one, y[i]]);
  const shapes = [...table.matchAll(/^# shape: .*$/gm)].map(([line]) => [...line.matchAll(/arity (\d+)/g)].map(([, arity]) => Number(arity))).flat();
  return {
    points: pairs(Object.values(columns)),
    exact: pairs(Object.values(exact)),
    first: Number(/^# first_index: (-?\d+)/m.exec(table)?.[1] ?? 0),
    // Where on the polygon a parameter lies is drawn for one mask only.
    arity: shapes.length === 1 ? shapes[0] : null,
  };
}

const ratio = (text) => {
  const [above, below = "1"] = String(text).split("/");
  return Number(above) / Number(below);
};

/** Where a parameter lies on a polygon of a level. This is for drawing only. */
export function curvePlace({ points, first = 0, step = 1 }, parameter, shift, closed) {
  const at = ratio(parameter) * step - ratio(shift) - first;
  const n = points.length;
  const before = Math.floor(at);
  if (!Number.isFinite(at) || (!closed && (before < 0 || at > n - 1))) return null;
  const [from, to] = closed
    ? [points[((before % n) + n) % n], points[(((before + 1) % n) + n) % n]]
    : [points[before], points[Math.min(before + 1, n - 1)]];
  const part = at - before;
  return [0, 1].map((i) => Number(from[i]) + part * (Number(to[i]) - Number(from[i])));
}

const levels = (count) => (count === 1 ? "1 level" : `${count} levels`);

/** What `depth` says of a polygon and a tolerance: lines, and what to mark. */
export function curveDepth(found, tolerance) {
  const { sets, natural, indexed } = found.polygon;
  // Where nothing is found for sets of points, the answer at equal parameters is sound too.
  const usable = sets && typeof sets.level === "number" ? sets : null;
  const chosen = usable ?? natural ?? indexed;
  if (!chosen) return { lines: ["Nothing is known about this polygon."], mark: null };
  const as = usable ? "" : ", compared at equal parameters";
  const few = usable ? sets.too_few : chosen.too_far?.level;
  const enough = chosen.level === null || chosen.level === undefined
    ? "No level was found that is surely enough"
    : chosen.level === 0 ? `The control polygon itself is within ${tolerance} of its limit` : `${levels(chosen.level)} for the tolerance ${tolerance}`;
  const lines = [`${enough}${as}${few === null || few === undefined ? "" : `; ${few} ${few === 1 ? "is" : "are"} too few`}.`];
  const far = chosen.too_far;
  if (!far) return { lines, level: chosen.level, mark: null };
  const distance = far.distance.decimal ?? far.distance;
  if (!usable) {
    lines.push(`Level ${far.level} is ${digits(distance)} from its limit at t = ${far.parameter}.`);
    return { lines, level: chosen.level, mark: null };
  }
  const whose = far.from === "polygon" ? `the polygon of level ${few}` : "the limit";
  const other = far.from === "polygon" ? "the limit" : `the polygon of level ${few}`;
  lines.push(`The point (${far.point.map((one) => digits(one)).join(", ")}) of ${whose} is at least ${digits(distance)} from ${other}.`);
  return { lines, level: chosen.level, mark: { point: far.point.map(Number), radius: Number(distance), text: `too far at level ${few}` } };
}

/** The distance of a polygon from its limit, and where it is attained. */
export function curveDistance(found) {
  const chosen = found.polygon.natural ?? found.polygon.indexed;
  // Coordinates are counted from 1.
  const { lower, upper, parameter, coordinate } = chosen?.distance ?? {};
  if (!lower) return null;
  const size = lower.exact === upper.exact
    ? `${lower.exact.length < 12 && lower.exact !== lower.decimal ? `${lower.exact} = ` : ""}${shortly(lower)}`
    : [...new Set([lower, upper].map((one) => shortly(one)))].join(" to ");
  const shown = found.polygon.natural ? found.natural : found.indexed;
  return { size, parameter, axis: coordinate === 1 ? "x" : "y", shift: shown?.shifts?.[0] ?? "0", exact: `${lower.exact} to ${upper.exact}` };
}
