//! Hexahedral solids.

use crate::error::plain;
use crate::geometry::{
    Depth, Limit, Points, SurfaceDepth, depth_aside, points, rational_limit, rounded,
    surface_depth_aside,
};
use crate::number::rational;
use crate::run::aside;
use pyo3::prelude::*;
use subcert::exact::Rational;
use subcert::mesh::{MeshScheme, Point};
use subcert::patch::{FaceSurface, MeshDistances};
use subcert::solid::{HexMesh, refine_solid, solid_limit_points};

/// The f64 points of a solid, half a unit in the last place from the exact ones, and its cells.
type Rounded = (Vec<Point<f64>>, Vec<[usize; 8]>);

fn solid(given: &Points<'_>, cells: &[[usize; 8]]) -> PyResult<HexMesh<Rational>> {
    HexMesh::new(points(given)?, cells).map_err(plain)
}

/// How many levels a solid needs for a tolerance.
#[pyfunction]
pub fn solid_depth(
    py: Python<'_>,
    given: Points<'_>,
    cells: Vec<[usize; 8]>,
    tolerance: &Bound<'_, PyAny>,
) -> PyResult<Depth> {
    let solid = solid(&given, &cells)?;
    let tolerance = rational(tolerance)?;
    depth_aside(py, move || {
        let distances = MeshDistances::of_solid(solid).map_err(plain)?;
        distances.depth(&tolerance).map_err(plain)
    })
}

/// How many levels the boundary of a solid needs for a tolerance, as a set of points; the face of the far
/// place is a cell.
#[pyfunction]
pub fn solid_geometric_depth(
    py: Python<'_>,
    given: Points<'_>,
    cells: Vec<[usize; 8]>,
    tolerance: &Bound<'_, PyAny>,
) -> PyResult<SurfaceDepth> {
    let boundary = solid(&given, &cells)?.boundary().map_err(plain)?;
    let tolerance = rational(tolerance)?;
    surface_depth_aside(py, move || {
        let distances = MeshDistances::new(boundary.mesh, MeshScheme::Bajaj).map_err(plain)?;
        let mut depth =
            distances.geometric_depth(&tolerance, FaceSurface::Bilinear).map_err(plain)?;
        if let Some(place) = &mut depth.beyond {
            place.face = boundary.cells[place.face];
        }
        Ok(depth)
    })
}

/// The solid of a level.
#[pyfunction]
pub fn solid_refine(
    py: Python<'_>,
    given: Points<'_>,
    cells: Vec<[usize; 8]>,
    levels: u32,
) -> PyResult<Rounded> {
    let solid = solid(&given, &cells)?;
    aside(py, move || {
        let refined = refine_solid(&solid, levels).map_err(plain)?;
        Ok((rounded(refined.points()), refined.cells()))
    })
}

/// The limit of each point.
#[pyfunction]
pub fn solid_limit(
    py: Python<'_>,
    given: Points<'_>,
    cells: Vec<[usize; 8]>,
) -> PyResult<Vec<Limit>> {
    let solid = solid(&given, &cells)?;
    aside(py, move || Ok(solid_limit_points(&solid).iter().map(rational_limit).collect()))
}
