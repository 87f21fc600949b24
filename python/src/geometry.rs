//! What meshes, nets and solids have in common: points, and depths.

use crate::error::plain;
use crate::number::{Fraction, fraction, rational};
use crate::run::aside;
use pyo3::prelude::*;
use subcert::exact::{Enclosed, Rational, RealCyclotomic};
use subcert::float::nearest;
use subcert::mesh::Point;
use subcert::patch::{FarPlace, GeometricDepth, MeshDepth};

/// Points as Python has them.
pub(crate) type Points<'py> = Vec<[Bound<'py, PyAny>; 3]>;

/// Level, the greatest level that is too few, bounds of the distance, the face where it is, the point
/// on the mesh and on the limit, a lower bound of the Hausdorff distance.
pub(crate) type Depth = (u32, Option<u32>, [f64; 2], Option<(usize, Point<f64>, Point<f64>)>, f64);

/// Level, the greatest level that is too few, and a point that shows it: its set, its face, where it is, a lower bound of
/// its distance from the other set.
pub(crate) type SurfaceDepth = (u32, Option<u32>, Option<(String, usize, Point<f64>, f64)>);

/// The f64 of a limit point, and the exact one where it is rational.
pub(crate) type Limit = (Point<f64>, Option<Point<Fraction>>);

pub(crate) fn points(points: &Points<'_>) -> PyResult<Vec<Point<Rational>>> {
    points.iter().map(|[x, y, z]| Ok([rational(x)?, rational(y)?, rational(z)?])).collect()
}

fn depth(found: MeshDepth) -> Depth {
    let place = |place: FarPlace| (place.face, place.on_mesh, place.on_limit);
    (found.level, found.too_few, found.distance, found.worst.map(place), found.apart)
}

/// Each coordinate half a unit in the last place from the exact one.
pub(crate) fn rounded(points: &[Point<impl Enclosed>]) -> Vec<Point<f64>> {
    points.iter().map(|point| point.each_ref().map(nearest)).collect()
}

/// The limit of a point.
pub(crate) fn limit(position: &Point<RealCyclotomic>) -> Limit {
    let rounded = position.each_ref().map(nearest);
    let [x, y, z] = position.each_ref().map(|x| x.as_rational().map(fraction));
    (rounded, x.zip(y).zip(z).map(|((x, y), z)| [x, y, z]))
}

/// The limit of a point that is rational.
pub(crate) fn rational_limit(position: &Point<Rational>) -> Limit {
    (position.each_ref().map(nearest), Some(position.each_ref().map(fraction)))
}

/// The level that is sufficient as a set of points; an error says why none is known, and which levels are too few.
pub(crate) fn known_level<P>(found: &GeometricDepth<P>) -> PyResult<u32> {
    found.level.ok_or_else(|| {
        let why = found.ended.as_deref().unwrap_or("open");
        let few = found.too_few.map(|few| format!("; level {few} is too few")).unwrap_or_default();
        plain(format!("{why}{few}"))
    })
}

/// A depth as sets of points that is found beside Python.
pub(crate) fn surface_depth_aside(
    py: Python<'_>,
    find: impl FnOnce() -> PyResult<GeometricDepth> + Send + 'static,
) -> PyResult<SurfaceDepth> {
    let surface = move || {
        let found = find()?;
        let level = known_level(&found)?;
        let place = found
            .beyond
            .map(|place| (place.from.name().to_owned(), place.face, place.point, place.distance));
        Ok((level, found.too_few, place))
    };
    aside(py, surface)
}

/// A depth that is found beside Python.
pub(crate) fn depth_aside(
    py: Python<'_>,
    find: impl FnOnce() -> PyResult<MeshDepth> + Send + 'static,
) -> PyResult<Depth> {
    aside(py, move || Ok(depth(find()?)))
}
