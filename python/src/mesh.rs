//! Polygon meshes.

use crate::error::plain;
use crate::number::{Fraction, fraction, rational};
use crate::run::aside;
use pyo3::prelude::*;
use subcert::exact::Rational;
use subcert::float::nearest;
use subcert::mesh::{MeshScheme, Point, PolygonMesh, limit_points, refine_mesh};
use subcert::patch::{FarPlace, MeshDistances};

/// The vertices of a mesh as Python has them.
type Vertices<'py> = Vec<[Bound<'py, PyAny>; 3]>;

/// The f64 vertices of a mesh, half a unit in the last place from the exact ones, and its faces.
type Rounded = (Vec<Point<f64>>, Vec<Vec<usize>>);

/// Level, the greatest level that is too few, bounds of the distance, the face where it is, the point
/// on the mesh and on the limit, a lower bound of the Hausdorff distance.
type Depth = (u32, Option<u32>, [f64; 2], Option<(usize, Point<f64>, Point<f64>)>, f64);

fn mesh(
    scheme: &str,
    vertices: &Vertices<'_>,
    faces: Vec<Vec<usize>>,
) -> PyResult<(MeshScheme, PolygonMesh<Rational>)> {
    let scheme = MeshScheme::parse(scheme).map_err(plain)?;
    let mut points: Vec<Point<Rational>> = Vec::with_capacity(vertices.len());
    for [x, y, z] in vertices {
        points.push([rational(x)?, rational(y)?, rational(z)?]);
    }
    Ok((scheme, PolygonMesh::new(points, faces).map_err(plain)?))
}

/// How many levels a mesh needs for a tolerance.
#[pyfunction]
pub fn mesh_depth(
    py: Python<'_>,
    scheme: &str,
    vertices: Vertices<'_>,
    faces: Vec<Vec<usize>>,
    tolerance: &Bound<'_, PyAny>,
) -> PyResult<Depth> {
    let (scheme, mesh) = mesh(scheme, &vertices, faces)?;
    let tolerance = rational(tolerance)?;
    aside(
        py,
        || (),
        move || {
            let distances = MeshDistances::new(mesh, scheme).map_err(plain)?;
            let found = distances.depth(&tolerance).map_err(plain)?;
            let place = |place: FarPlace| (place.face, place.on_mesh, place.on_limit);
            Ok((found.level, found.too_few, found.distance, found.worst.map(place), found.apart))
        },
    )
}

/// The mesh of a level.
#[pyfunction]
pub fn mesh_refine(
    py: Python<'_>,
    scheme: &str,
    vertices: Vertices<'_>,
    faces: Vec<Vec<usize>>,
    levels: u32,
) -> PyResult<Rounded> {
    let (scheme, mesh) = mesh(scheme, &vertices, faces)?;
    aside(
        py,
        || (),
        move || {
            let exact = mesh.map(|x| subcert::exact::RealCyclotomic::from(x.clone()));
            let refined = refine_mesh(&exact, scheme, levels).map_err(plain)?;
            let points = refined.points().iter().map(|point| point.each_ref().map(nearest));
            Ok((points.collect(), refined.faces().to_vec()))
        },
    )
}

/// The f64 limit points of the vertices, and the exact ones where they are rational; `None` where the
/// surface does not reach a vertex.
#[pyfunction]
#[expect(clippy::type_complexity, reason = "a pair for each vertex")]
pub fn mesh_limit(
    py: Python<'_>,
    scheme: &str,
    vertices: Vertices<'_>,
    faces: Vec<Vec<usize>>,
) -> PyResult<Vec<Option<(Point<f64>, Option<Point<Fraction>>)>>> {
    let (scheme, mesh) = mesh(scheme, &vertices, faces)?;
    aside(
        py,
        || (),
        move || {
            let exact = mesh.map(|x| subcert::exact::RealCyclotomic::from(x.clone()));
            let limits = limit_points(&exact, scheme).map_err(plain)?;
            let point = |limit: subcert::mesh::LimitPoint| {
                let rounded = limit.position.each_ref().map(nearest);
                let [x, y, z] = limit.position.each_ref().map(|x| x.as_rational().map(fraction));
                (rounded, x.zip(y).zip(z).map(|((x, y), z)| [x, y, z]))
            };
            Ok(limits.into_iter().map(|limit| limit.map(point)).collect())
        },
    )
}
