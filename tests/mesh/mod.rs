//! Polygon meshes: files, validity, refinement and limits of whole meshes.

mod connectivity;
mod creases;
mod files;
mod laws;
mod limit;
mod naive;
mod read;
mod refine;
mod write;

use crate::common::meshes::{grid_faces, prism_faces};
use crate::common::r;
use proptest::prelude::*;
use subcert::diagnostic::SourceText;
use subcert::exact::{Rational, RealCyclotomic};
use subcert::mesh::{MeshFile, MeshFormat, MeshScheme, Point, PolygonMesh, read_mesh};

type Mesh = PolygonMesh<RealCyclotomic>;

/// The mesh in this OBJ text.
fn file(text: &str) -> MeshFile {
    read_mesh(&SourceText::new("test.obj", text), MeshFormat::Obj).unwrap_or_else(|e| panic!("{e}"))
}

fn number(value: &Rational) -> RealCyclotomic {
    value.clone().into()
}

fn point(coordinates: [i64; 3]) -> Point<RealCyclotomic> {
    coordinates.map(RealCyclotomic::from)
}

/// A mesh of integer points.
fn mesh(points: &[[i64; 3]], faces: &[&[usize]]) -> Mesh {
    let points = points.iter().copied().map(point).collect();
    PolygonMesh::new(points, faces.iter().map(|face| face.to_vec()).collect()).expect("a surface")
}

fn cube() -> Mesh {
    file(include_str!("../../examples/cube.obj")).mesh().map(number)
}

fn tetrahedron() -> Mesh {
    let points = [[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]];
    mesh(&points, &[&[0, 1, 2], &[0, 3, 1], &[0, 2, 3], &[1, 3, 2]])
}

fn octahedron() -> Mesh {
    let points = [[1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]];
    let faces: Vec<Vec<usize>> =
        (0..4).flat_map(|i| [vec![i, (i + 1) % 4, 4], vec![(i + 1) % 4, i, 5]]).collect();
    PolygonMesh::new(points.map(point).to_vec(), faces).expect("a surface")
}

/// A prism over a regular polygon's worth of vertices, with points on no circle.
fn prism(n: usize) -> Mesh {
    let height = |k: usize| i64::try_from(k * k % 7).expect("small");
    let points: Vec<[i64; 3]> = (0..2 * n)
        .map(|k| {
            let i = i64::try_from(k % n).expect("small");
            [i * i - 3 * i, 2 * i, height(k) + if k < n { 0 } else { 11 }]
        })
        .collect();
    let faces = prism_faces(n);
    PolygonMesh::new(points.into_iter().map(point).collect(), faces).expect("a surface")
}

/// A grid of quadrilaterals, or of triangles, with points of any height.
fn grid(rows: usize, columns: usize, triangles: bool) -> Mesh {
    let points = (0..rows * columns).map(|k| {
        let (i, j) = (k / columns, k % columns);
        let height = (7 * i * i + 5 * i * j + 3 * j * j * j + k) % 11;
        point([j, i, height].map(|x| i64::try_from(x).expect("small")))
    });
    let faces = grid_faces(rows, columns, triangles);
    PolygonMesh::new(points.collect(), faces).expect("a surface")
}

/// The mesh of the points around a vertex, as the catalogue numbers them.
fn star_mesh(scheme: MeshScheme, n: usize, points: &[Point<RealCyclotomic>]) -> Mesh {
    let faces: Vec<Vec<usize>> = match scheme {
        MeshScheme::CatmullClark | MeshScheme::Bajaj => {
            (0..n).map(|i| vec![0, 1 + i, 1 + n + i, 1 + (i + 1) % n]).collect()
        }
        MeshScheme::DooSabin => vec![(0..n).collect()],
        _ => (0..n).map(|i| vec![0, 1 + i, 1 + (i + 1) % n]).collect(),
    };
    PolygonMesh::new(points.to_vec(), faces).expect("a surface")
}

/// Any points.
fn points(count: usize) -> impl Strategy<Value = Vec<Point<RealCyclotomic>>> {
    let coordinate = || (-20_i64..20, 1_i64..5).prop_map(|(p, q)| RealCyclotomic::from(r(p, q)));
    let point = (coordinate(), coordinate(), coordinate()).prop_map(|(x, y, z)| [x, y, z]);
    prop::collection::vec(point, count)
}

/// Meshes with and without boundary, of all kinds of faces and valences that the scheme takes.
fn examples(scheme: MeshScheme) -> Vec<Mesh> {
    let mut all = vec![tetrahedron(), octahedron(), grid(4, 5, true)];
    if ![MeshScheme::Loop, MeshScheme::LoopWarren].contains(&scheme) {
        all.extend([cube(), prism(3), prism(5), grid(4, 4, false), grid(2, 2, false)]);
    }
    all
}
