// What the commands write about a mesh, read for the drawing and for the text.

import { digits } from "./numbers.js";

/** Points and faces of an OBJ file that `refine` has written. */
export function meshObj(text) {
  const points = [];
  const faces = [];
  for (const line of text.split("\n")) {
    const words = line.split(" ");
    if (words[0] === "v") points.push(words.slice(1, 4).map(Number));
    else if (words[0] === "f") faces.push(words.slice(1).map((word) => parseInt(word, 10) - 1));
  }
  return { points, faces };
}

/** Corners of the faces of a hexahedron, in the order of VTK. */
const SIDES = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];

/** Of a solid, the faces that one cell has: they are what is seen of it. */
export function meshSolid(found) {
  const points = found.points.map((point) => point.f64.map(Number));
  const seen = new Map();
  for (const cell of found.cells) {
    for (const side of SIDES) {
      const face = side.map((i) => cell[i]);
      const key = [...face].sort((a, b) => a - b).join(" ");
      seen.set(key, seen.has(key) ? null : face);
    }
  }
  return { points, faces: [...seen.values()].filter((face) => face !== null) };
}

/** Rows of `--per-face`: numbers by face. */
export function meshPerFace(bytes) {
  const [head, ...rows] = new TextDecoder().decode(bytes).trim().split("\n");
  const names = head.split(",");
  return rows.map((row) => Object.fromEntries(row.split(",").map((value, i) => [names[i], value])));
}

/**
 * The value of each face of a level from those of the control faces, or null: the faces that come from one control face follow
 * each other in these two schemes, and no other knows one control face for each.
 */
export function meshInherit(values, faces, control, scheme, level) {
  if (level === 0) return values.length === faces ? values : null;
  const parts = scheme === "catmull-clark" ? (face) => face.length * 4 ** (level - 1) : scheme.startsWith("loop") ? () => 4 ** level : null;
  if (!parts || values.length !== control.length) return null;
  const found = control.flatMap((face, i) => Array.from({ length: parts(face) }, () => values[i]));
  return found.length === faces ? found : null;
}

const place = (point) => `(${point.map((one) => digits(one)).join(", ")})`;
const known = (number) => number !== null && number !== undefined;

/** What `depth` says: lines of text. */
export function meshDepth(found) {
  const { level, too_few: few, too_far: far, distance, measure, a_priori: priori, formula } = found;
  const sets = measure === "hausdorff";
  const too = known(few) ? `; ${few} ${few === 1 ? "is" : "are"} too few` : "";
  const first = known(level)
    ? level === 0 ? `The control mesh itself is within ${found.tolerance} of its limit.` : `${level} ${level === 1 ? "level" : "levels"} for the tolerance ${found.tolerance}${too}.`
    : `No level was found that is surely enough for ${found.tolerance}${too}.`;
  const lines = [first];
  if (found.ended) lines.push(`The search ended early: ${found.ended}.`);
  if (distance) lines.push(`The distance at level ${level} is ${digits(distance.lower)} to ${digits(distance.upper)}.`);
  if (far) {
    const point = far.point ?? far.on_limit;
    const size = far.distance?.lower ?? far.distance;
    const whose = far.from === "mesh" ? `the mesh of level ${few}` : "the limit";
    const other = far.from === "mesh" ? "the limit" : `the mesh of level ${few}`;
    const where = `It belongs to face ${far.face}${known(far.vertex) ? `, near vertex ${far.vertex}` : ""} of the control mesh, counted from 0.`;
    if (point) lines.push(`The point ${place(point)} of ${whose} ${known(size) ? `is at least ${digits(size)} from ${other}` : "is too far"}. ${where}`);
  }
  lines.push(sets
    ? "Mesh and limit are compared as sets of points, from both sides."
    : "Mesh and limit are compared point by point, at equal parameters.");
  if (priori && known(priori.level)) lines.push(`Valences and longest edge alone guarantee ${priori.level} levels.`);
  if (formula) lines.push(`The formula of ${formula.paper} gives ${known(formula.level) ? formula.level : "no"} levels: ${formula.verdict}.`);
  return { lines, mark: far ? (far.point ?? far.on_limit)?.map(Number) : null };
}
