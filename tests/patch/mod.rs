//! How far meshes are from their limit surfaces, and how many levels they need.

mod creases;
mod curve;
mod exactness;
mod geometric;
mod laws;
mod naive;
mod nets;
mod open;
mod solids;
mod stopped;
mod tensor;
mod worst;

use crate::common::meshes::{grid_faces, prism_faces};
use crate::common::r;
use proptest::prelude::*;
use subcert::exact::Rational;
use subcert::mesh::{MeshScheme, Point, PolygonMesh};
use subcert::patch::{MeshDepth, MeshDistances};

type Mesh = PolygonMesh<Rational>;

fn mesh(points: &[[i64; 3]], faces: Vec<Vec<usize>>) -> Mesh {
    let points = points.iter().map(|point| point.map(Rational::from)).collect();
    PolygonMesh::new(points, faces).expect("a surface")
}

fn cube() -> Mesh {
    let corner = |k: i64| [k & 1, k >> 1 & 1, k >> 2 & 1].map(|bit| 2 * bit - 1);
    let faces =
        [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
    let points: Vec<[i64; 3]> = (0..8).map(corner).collect();
    mesh(&points, faces.map(|face| face.to_vec()).to_vec())
}

fn tetrahedron() -> Mesh {
    let points = [[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]];
    mesh(&points, vec![vec![0, 1, 2], vec![0, 3, 1], vec![0, 2, 3], vec![1, 3, 2]])
}

fn octahedron() -> Mesh {
    let points = [[1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]];
    let faces = (0..4).flat_map(|i| [vec![i, (i + 1) % 4, 4], vec![(i + 1) % 4, i, 5]]);
    mesh(&points, faces.collect())
}

/// Two polygons of n vertices with squares between them.
fn prism(n: usize) -> Mesh {
    let points: Vec<[i64; 3]> = (0..2 * n)
        .map(|k| {
            let i = i64::try_from(k % n).expect("small");
            let height = i64::try_from(k * k % 7).expect("small");
            [i * i - 3 * i, 2 * i, height + if k < n { 0 } else { 11 }]
        })
        .collect();
    let faces = prism_faces(n);
    mesh(&points, faces)
}

/// An open grid with these heights.
fn grid(
    rows: usize,
    columns: usize,
    triangles: bool,
    height: impl Fn(usize, usize) -> Rational,
) -> Mesh {
    let place = |k: usize| (k / columns, k % columns);
    let point = |k: usize| -> Point<Rational> {
        let (i, j) = place(k);
        [Rational::from(j), Rational::from(i), height(i, j)]
    };
    let faces = grid_faces(rows, columns, triangles);
    PolygonMesh::new((0..rows * columns).map(point).collect(), faces).expect("a surface")
}

fn bumpy(rows: usize, columns: usize, triangles: bool) -> Mesh {
    let height = |i: usize, j: usize| {
        let k = i * columns + j;
        Rational::from((7 * i * i + 5 * i * j + 3 * j * j * j + k) % 11)
    };
    grid(rows, columns, triangles, height)
}

/// A fan of faces around a boundary vertex, closed (`inner`) or not.
fn fan(n: usize, triangles: bool, inner: bool) -> Mesh {
    let spokes = if inner { n } else { n + 1 };
    let mut points = vec![[0, 0, 3]];
    for k in 0..2 * spokes {
        let k = i64::try_from(k).expect("small");
        points.push([(k * 5) % 13 - 6, (k * k + 2) % 11 - 5, k % 4]);
    }
    let face = |i: usize| {
        let (a, b) = (1 + 2 * i, 1 + 2 * ((i + 1) % spokes));
        if triangles { vec![0, a, b] } else { vec![0, a, a + 1, b] }
    };
    let faces: Vec<Vec<usize>> = (0..n).map(face).collect();
    let used: Vec<usize> =
        (0..points.len()).filter(|point| faces.iter().flatten().any(|x| x == point)).collect();
    let number = |point: &usize| used.iter().position(|x| x == point).expect("it is used");
    let faces = faces.iter().map(|face| face.iter().map(number).collect()).collect();
    mesh(&used.iter().map(|&point| points[point]).collect::<Vec<_>>(), faces)
}

/// Meshes of all kinds that a scheme takes.
fn examples(scheme: MeshScheme) -> Vec<Mesh> {
    let mut all = vec![tetrahedron(), octahedron(), bumpy(4, 5, true)];
    match scheme {
        MeshScheme::CatmullClark | MeshScheme::Bajaj => {
            all.extend([cube(), prism(5), bumpy(4, 4, false), bumpy(2, 2, false)]);
            all.extend([fan(1, false, false), fan(4, false, false), fan(7, false, true)]);
        }
        MeshScheme::DooSabin => {
            all.extend([cube(), prism(5), bumpy(5, 4, false), fan(6, false, true)]);
        }
        MeshScheme::Loop | MeshScheme::LoopWarren => {
            all.extend([
                fan(1, true, false),
                fan(2, true, false),
                fan(5, true, false),
                fan(7, true, true),
            ]);
        }
    }
    all
}

fn distances(mesh: &Mesh, scheme: MeshScheme) -> MeshDistances {
    MeshDistances::new(mesh.clone(), scheme).expect("a mesh within the caps")
}

/// The depth, without what few tests ask for and most of the time goes to.
fn depth(mesh: &Mesh, scheme: MeshScheme, tolerance: &Rational) -> MeshDepth {
    distances(mesh, scheme).without_apart().depth(tolerance).expect("a depth")
}

/// Any small rational points in place of those of the mesh.
fn moved(mesh: Mesh) -> impl Strategy<Value = Mesh> {
    let coordinate = || (-20_i64..20, 1_i64..5).prop_map(|(p, q)| r(p, q));
    let point = (coordinate(), coordinate(), coordinate()).prop_map(|(x, y, z)| [x, y, z]);
    let points = prop::collection::vec(point, mesh.points().len());
    points.prop_map(move |points| mesh.with_points(points))
}
