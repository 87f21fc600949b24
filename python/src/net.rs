//! Nets.

use crate::error::{plain, with_remedy};
use crate::geometry::{
    Depth, Limit, Points, SurfaceDepth, depth_aside, points, rational_limit, rounded,
    surface_depth_aside,
};
use crate::number::rational;
use crate::run::aside;
use pyo3::prelude::*;
use subcert::mesh::Point;
use subcert::net::{Closed, Net, NetError, NetRules};
use subcert::patch::{LatticeNetDistances, NetDistances};

/// A net as Python has it: its points row by row, the number of columns, and the directions in which
/// it is closed.
type Given<'py> = (Points<'py>, usize, String);

fn net(scheme: &str, (given, columns, closed): Given<'_>) -> PyResult<(NetRules, Net)> {
    let scheme = NetRules::parse(scheme).map_err(plain)?;
    let closed = Closed::parse(&closed).ok_or_else(|| {
        with_remedy(&format!("closed is {closed:?}"), "it is \"none\", \"u\", \"v\" or \"uv\"")
    })?;
    Ok((scheme, Net::new(points(&given)?, columns, closed).map_err(plain)?))
}

/// The error, with the argument that would mend it.
fn refused(error: NetError) -> PyErr {
    match error {
        NetError::TooFew { direction, .. } => {
            let closed = if direction == 0 { "u" } else { "v" };
            with_remedy(&error.to_string(), &format!("closed=\"{closed}\" does so"))
        }
        error => plain(error),
    }
}

/// How many levels a net needs for a tolerance.
#[pyfunction]
pub fn net_depth(
    py: Python<'_>,
    scheme: &str,
    given: Given<'_>,
    tolerance: &Bound<'_, PyAny>,
) -> PyResult<Depth> {
    let (scheme, net) = net(scheme, given)?;
    let tolerance = rational(tolerance)?;
    depth_aside(py, move || match scheme {
        NetRules::Product(scheme) => {
            let distances = NetDistances::new(net, &scheme).map_err(refused)?;
            distances.depth(&tolerance).map_err(plain)
        }
        NetRules::Lattice(_, mask) => {
            let distances = LatticeNetDistances::new(&net, &mask).map_err(refused)?;
            distances.depth(&tolerance).map_err(plain)
        }
    })
}

/// How many levels a net needs for a tolerance, as a set of points.
#[pyfunction]
pub fn net_geometric_depth(
    py: Python<'_>,
    scheme: &str,
    given: Given<'_>,
    tolerance: &Bound<'_, PyAny>,
) -> PyResult<SurfaceDepth> {
    let (scheme, net) = net(scheme, given)?;
    let tolerance = rational(tolerance)?;
    let NetRules::Product(scheme) = scheme else {
        return Err(with_remedy(
            "nets with masks on Z^2 are compared with their limits at equal parameters only",
            "take net_depth",
        ));
    };
    surface_depth_aside(py, move || {
        let distances = NetDistances::new(net, &scheme).map_err(refused)?;
        distances.geometric_depth(&tolerance).map_err(plain)
    })
}

/// The net of a level: its points row by row, and the number of columns.
#[pyfunction]
pub fn net_refine(
    py: Python<'_>,
    scheme: &str,
    given: Given<'_>,
    levels: u32,
) -> PyResult<(Vec<Point<f64>>, usize)> {
    let (scheme, net) = net(scheme, given)?;
    aside(py, move || {
        let refined = scheme.refined(&net, levels).map_err(refused)?;
        Ok((rounded(refined.points()), refined.columns()))
    })
}

/// The limit of each point, row by row; `None` where the limit does not reach it.
#[pyfunction]
pub fn net_limit(py: Python<'_>, scheme: &str, given: Given<'_>) -> PyResult<Vec<Option<Limit>>> {
    let (scheme, net) = net(scheme, given)?;
    aside(py, move || {
        let limits = scheme.limits(&net).map_err(refused)?;
        Ok(limits.iter().map(|limit| limit.as_ref().map(rational_limit)).collect())
    })
}
