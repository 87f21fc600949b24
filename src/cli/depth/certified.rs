//! The certificate of a depth as a set of points.

use crate::cli::console::output::{Failure, Outcome};
use crate::cli::console::save::save;
use std::path::Path;
use subcert::certificate::{DepthDirection, DepthFar, depth_certificate};
use subcert::exact::Rational;
use subcert::net::{Net, NetScheme};
use subcert::patch::{CurveDepth, CurveSets, GeometricDepth, NetDistances, SetKind};
use subcert::scheme::Mask;

fn far(places: impl Iterator<Item = (u32, SetKind, Vec<Rational>)>) -> Vec<DepthFar> {
    let far = |(level, from, parameters)| DepthFar {
        level,
        of_limit: from == SetKind::Limit,
        parameters,
    };
    places.map(far).collect()
}

fn write(path: &Path, text: &str) -> Outcome {
    let shown = path.display();
    save(path, text).map_err(|error| Failure::Input(format!("cannot write `{shown}`: {error}")))
}

/// Refuses a certificate where there is none.
pub(super) fn none(of: &str) -> Failure {
    Failure::Input(format!(
        "--certificate is for the depth of a control polygon or a net as a set of points; {of}"
    ))
}

/// Writes the certificate of a control polygon; `coordinates` has all x, then all y, and so on.
pub(super) fn of_polygon(
    path: &Path,
    mask: &Mask,
    sets: &CurveSets,
    found: &CurveDepth,
    coordinates: &[Vec<Rational>],
    tolerance: &Rational,
) -> Outcome {
    let count = coordinates.first().map_or(0, Vec::len);
    let direction = DepthDirection { mask, count, range: sets.range().cloned() };
    let point = |i: usize| coordinates.iter().map(|own| own[i].clone()).collect();
    let points: Vec<Vec<Rational>> = (0..count).map(point).collect();
    shows(found)?;
    let places = found.places();
    let far = far(places.map(|(level, at)| (level, at.from, vec![at.parameter.clone()])));
    write(path, &depth_certificate(tolerance, &[direction], &points, found.level, &far))
}

/// Refuses where nothing is known that a certificate could show.
fn shows<P>(found: &GeometricDepth<P>) -> Outcome {
    match &found.ended {
        Some(why) if found.level.is_none() && found.too_few.is_none() => {
            Err(none(&format!("there is none here: {why}")))
        }
        _ => Ok(()),
    }
}

/// Writes the certificate of a net.
pub(super) fn of_net(
    path: &Path,
    net: &Net,
    scheme: &NetScheme,
    distances: &NetDistances,
    found: &GeometricDepth,
    tolerance: &Rational,
) -> Outcome {
    shows(found)?;
    let ranges = distances.ranges();
    let direction = |((mask, count), range)| DepthDirection { mask, count, range };
    let directions = scheme.masks().iter().zip(net.sizes()).zip(ranges);
    let directions: Vec<DepthDirection<'_>> = directions.map(direction).collect();
    let points: Vec<Vec<Rational>> = net.points().iter().map(|point| point.to_vec()).collect();
    let places = found
        .places()
        .filter_map(|(level, at)| Some((level, at.from, at.parameters.clone()?.to_vec())));
    write(path, &depth_certificate(tolerance, &directions, &points, found.level, &far(places)))
}
