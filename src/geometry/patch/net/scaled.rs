//! Nets in f64.

use crate::exact::Rational;
use crate::net::{Net, NetError};
use crate::patch::mesh::model::moved;
use crate::patch::range::scale;

/// A net moved so that the first point is the origin, and divided by a power of two, so that
/// coordinates are below 1; with that power.
pub(super) fn scaled(net: &Net) -> Result<(Net<f64>, Rational), NetError> {
    let scale = scale::<NetError>(net.points())?;
    let rounded = Net::new(moved(net.points(), &scale), net.columns(), net.closed())?;
    Ok((rounded, scale))
}
