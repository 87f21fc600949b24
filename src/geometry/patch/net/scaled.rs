//! Nets in f64.

use crate::exact::Rational;
use crate::net::{Net, NetError};
use crate::patch::mesh::model::{moved, scale};

/// Coordinates, and differences of them that are not 0, are between these powers of two.
const BITS: [i32; 2] = [-900, 900];

/// A net moved so that the first point is the origin, and divided by a power of two, so that
/// coordinates are below 1; with that power.
pub(super) fn scaled(net: &Net) -> Result<(Net<f64>, Rational), NetError> {
    let scale = scale(net.points());
    let [least, most] = BITS.map(|bits| Rational::from(2).pow(bits));
    let large = |x: &Rational| x.abs() > most;
    if scale < least || scale > most || net.points().iter().flatten().any(large) {
        let [least, most] = BITS;
        return Err(NetError::TooMuch(format!(
            "the coordinates are beyond 2^{most}, or all nearer to each other than 2^{least}; measure them in \
             another unit"
        )));
    }
    let rounded = Net::new(moved(net.points(), &scale), net.columns(), net.closed())?;
    Ok((rounded, scale))
}
