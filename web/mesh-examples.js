// Small meshes to begin with.

const CUBE = `v -1 -1 -1
v 1 -1 -1
v 1 1 -1
v -1 1 -1
v -1 -1 1
v 1 -1 1
v 1 1 1
v -1 1 1
f 4 3 2 1
f 5 6 7 8
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 4 1 5 8
`;

/** A flat net of 5 × 4 squares with one point raised. */
function tent() {
  const lines = [];
  for (let y = 0; y < 5; y++) for (let x = 0; x < 6; x++) lines.push(`v ${x} ${y} ${x === 2 && y === 2 ? 3 : 0}`);
  for (let y = 0; y < 4; y++) {
    for (let x = 1; x < 6; x++) lines.push(`f ${6 * y + x} ${6 * y + x + 1} ${6 * y + x + 7} ${6 * y + x + 6}`);
  }
  return `${lines.join("\n")}\n`;
}

/** Three cubes, of which the one in the corner has no inner face. */
function ell() {
  const places = [[0, 0], [1, 0], [2, 0], [0, 1], [1, 1], [2, 1], [0, 2], [1, 2]];
  const squares = [[0, 1, 4, 3], [1, 2, 5, 4], [3, 4, 7, 6]];
  const around = [0, 1, 2, 5, 4, 7, 6, 3];
  const faces = [
    ...squares.map((face) => face.map((i) => i + 8)),
    ...squares.map((face) => [...face].reverse()),
    ...around.map((i, at) => [i, around[(at + 1) % 8], around[(at + 1) % 8] + 8, i + 8]),
  ];
  const points = [0, 1].flatMap((z) => places.map(([x, y]) => `v ${x} ${y} ${z}`));
  return `${points.join("\n")}\n${faces.map((face) => `f ${face.map((i) => i + 1).join(" ")}`).join("\n")}\n`;
}

const OCTAHEDRON = `OFF
6 8 0
1 0 0
-1 0 0
0 1 0
0 -1 0
0 0 1
0 0 -1
3 0 2 4
3 2 1 4
3 1 3 4
3 3 0 4
3 2 0 5
3 1 2 5
3 3 1 5
3 0 3 5
`;

const ROOF = `# a roof: six rows of seven points
0 0 1.225, 0.5 0 1.725, 1 0 2.025, 1.5 0 2.125, 2 0 2.025, 2.5 0 1.725, 3 0 1.225
0 0.5 0.825, 0.5 0.5 1.325, 1 0.5 1.625, 1.5 0.5 1.725, 2 0.5 1.625, 2.5 0.5 1.325, 3 0.5 0.825
0 1 0.625, 0.5 1 1.125, 1 1 1.425, 1.5 1 1.525, 2 1 1.425, 2.5 1 1.125, 3 1 0.625
0 1.5 0.625, 0.5 1.5 1.125, 1 1.5 1.425, 1.5 1.5 1.525, 2 1.5 1.425, 2.5 1.5 1.125, 3 1.5 0.625
0 2 0.825, 0.5 2 1.325, 1 2 1.625, 1.5 2 1.725, 2 2 1.625, 2.5 2 1.325, 3 2 0.825
0 2.5 1.225, 0.5 2.5 1.725, 1 2.5 2.025, 1.5 2.5 2.125, 2 2.5 2.025, 2.5 2.5 1.725, 3 2.5 1.225
`;

const STAR = `# vtk DataFile Version 3.0
three hexahedra around an edge, in two layers
ASCII
DATASET UNSTRUCTURED_GRID
POINTS 21 double
0 0 0
1.2 0 0
0.9 0.8 0
-0.5 1 0
-0.9 0.1 0
-0.6 -1 0
0.8 -0.9 0
0.1 0 0.7
1.3 0 0.7
1 0.8 0.7
-0.4 1 0.7
-0.8 0.1 0.7
-0.5 -1 0.7
0.9 -0.9 0.7
-0.1 0 1.5
1.1 0 1.5
0.8 0.8 1.5
-0.6 1 1.5
-1 0.1 1.5
-0.7 -1 1.5
0.7 -0.9 1.5
CELLS 6 54
8 0 1 2 3 7 8 9 10
8 0 3 4 5 7 10 11 12
8 0 5 6 1 7 12 13 8
8 7 8 9 10 14 15 16 17
8 7 10 11 12 14 17 18 19
8 7 12 13 8 14 19 20 15
CELL_TYPES 6
12
12
12
12
12
12
`;

export const MESH_EXAMPLES = [
  { id: "cube", title: "Cube", file: "cube.obj", scheme: "catmull-clark", text: CUBE },
  { id: "creased", title: "Cube with a sharp rim", file: "creased.obj", scheme: "catmull-clark", text: `${CUBE}t crease 2/1/0 4 5 10\nt crease 2/1/0 5 6 10\nt crease 2/1/0 6 7 10\nt crease 2/1/0 7 4 10\n` },
  { id: "tent", title: "Tent", file: "tent.obj", scheme: "catmull-clark", text: tent() },
  { id: "ell", title: "L", file: "ell.obj", scheme: "catmull-clark", text: ell() },
  { id: "octahedron", title: "Octahedron", file: "octahedron.off", scheme: "loop", text: OCTAHEDRON },
  { id: "roof", title: "Roof, a net", file: "roof.csv", scheme: "bicubic", text: ROOF },
  { id: "star", title: "Star, a solid", file: "star.vtk", scheme: "bajaj", text: STAR },
];
