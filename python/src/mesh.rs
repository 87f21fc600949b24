//! Polygon meshes.

use crate::error::{plain, with_remedy};
use crate::geometry::{
    Depth, Limit, Points, SurfaceDepth, depth_aside, limit, points, rounded, surface_depth_aside,
};
use crate::number::{Fraction, rational};
use crate::run::aside;
use crate::tags::{Said, said, tags};
use pyo3::prelude::*;
use subcert::exact::Rational;
use subcert::mesh::{MeshScheme, Point, PolygonMesh, limit_points, refine_mesh};
use subcert::patch::{FaceSurface, MeshDistances};

/// The f64 vertices of a mesh, half a unit in the last place from the exact ones, its faces, and what is sharp.
type Rounded = (Vec<Point<f64>>, Vec<Vec<usize>>, Said<Fraction>);

fn mesh(
    scheme: &str,
    vertices: &Points<'_>,
    faces: Vec<Vec<usize>>,
    said: &Said<Bound<'_, PyAny>>,
) -> PyResult<(MeshScheme, PolygonMesh<Rational>)> {
    let scheme = MeshScheme::parse(scheme).map_err(plain)?;
    let mesh = PolygonMesh::new(points(vertices)?, faces).map_err(plain)?;
    let tags = tags(said, mesh.connectivity())?;
    Ok((scheme, mesh.with_tags(tags)))
}

/// How many levels a mesh needs for a tolerance.
#[pyfunction]
pub fn mesh_depth(
    py: Python<'_>,
    scheme: &str,
    vertices: Points<'_>,
    faces: Vec<Vec<usize>>,
    tags: Said<Bound<'_, PyAny>>,
    tolerance: &Bound<'_, PyAny>,
) -> PyResult<Depth> {
    let (scheme, mesh) = mesh(scheme, &vertices, faces, &tags)?;
    let tolerance = rational(tolerance)?;
    depth_aside(py, move || {
        let distances = MeshDistances::new(mesh, scheme).map_err(plain)?;
        distances.depth(&tolerance).map_err(plain)
    })
}

/// How many levels a mesh needs for a tolerance, as a set of points.
#[pyfunction]
pub fn mesh_geometric_depth(
    py: Python<'_>,
    scheme: &str,
    vertices: Points<'_>,
    faces: Vec<Vec<usize>>,
    tags: Said<Bound<'_, PyAny>>,
    tolerance: &Bound<'_, PyAny>,
    faces_are: &str,
) -> PyResult<SurfaceDepth> {
    let (scheme, mesh) = mesh(scheme, &vertices, faces, &tags)?;
    let tolerance = rational(tolerance)?;
    let all = [FaceSurface::Bilinear, FaceSurface::Fan];
    let surface = all.into_iter().find(|surface| surface.name() == faces_are).ok_or_else(|| {
        with_remedy(&format!("faces_are is {faces_are:?}"), "it is \"bilinear\" or \"fan\"")
    })?;
    surface_depth_aside(py, move || {
        let distances = MeshDistances::new(mesh, scheme).map_err(plain)?;
        distances.geometric_depth(&tolerance, surface).map_err(plain)
    })
}

/// The mesh of a level.
#[pyfunction]
pub fn mesh_refine(
    py: Python<'_>,
    scheme: &str,
    vertices: Points<'_>,
    faces: Vec<Vec<usize>>,
    tags: Said<Bound<'_, PyAny>>,
    levels: u32,
) -> PyResult<Rounded> {
    let (scheme, mesh) = mesh(scheme, &vertices, faces, &tags)?;
    aside(py, move || {
        let exact = mesh.map(|x| subcert::exact::RealCyclotomic::from(x.clone()));
        let refined = refine_mesh(&exact, scheme, levels).map_err(plain)?;
        let tags = said(refined.tags(), refined.connectivity());
        Ok((rounded(refined.points()), refined.faces().to_vec(), tags))
    })
}

/// The f64 limit points of the vertices, and the exact ones where they are rational; `None` where the
/// surface does not reach a vertex.
#[pyfunction]
pub fn mesh_limit(
    py: Python<'_>,
    scheme: &str,
    vertices: Points<'_>,
    faces: Vec<Vec<usize>>,
    tags: Said<Bound<'_, PyAny>>,
) -> PyResult<Vec<Option<Limit>>> {
    let (scheme, mesh) = mesh(scheme, &vertices, faces, &tags)?;
    aside(py, move || {
        let exact = mesh.map(|x| subcert::exact::RealCyclotomic::from(x.clone()));
        let limits = limit_points(&exact, scheme).map_err(plain)?;
        Ok(limits.iter().map(|found| found.as_ref().map(|it| limit(&it.position))).collect())
    })
}
