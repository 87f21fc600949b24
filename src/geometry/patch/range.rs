//! How large and how small what is computed in f64 may be.

use crate::exact::Rational;
use crate::mesh::Point;
use crate::patch::distance::surface::TooMuch;

/// Coordinates, and the greatest difference of them unless it is 0, are between 2 to the power of minus this and of this:
/// then squares, roundings and tolerances as small as 2^−100 of them have f64 too.
const BITS: i32 = 900;

/// Why points with these coordinates, and a greatest difference of them, are not computed in f64.
pub(super) fn beyond<'a>(
    mut coordinates: impl Iterator<Item = &'a Rational>,
    size: &Rational,
) -> Option<String> {
    let [least, most] = [-BITS, BITS].map(|bits| Rational::from(2).pow(bits));
    let small = *size < least && !size.is_zero();
    let is_beyond = small || *size > most || coordinates.any(|x| x.abs() > most);
    is_beyond.then(|| {
        format!(
            "the coordinates are beyond 2^{BITS}, or all nearer to each other than 2^-{BITS}; measure them in \
             another unit"
        )
    })
}

/// The power of two that is just above all differences of coordinates from those of the first point.
///
/// # Errors
/// When these, or the coordinates, are too large or too small for f64.
pub(super) fn scale<E: TooMuch>(points: &[Point<Rational>]) -> Result<Rational, E> {
    let bits = |x: &Rational| {
        let [p, q] = [x.numerator(), x.denominator()];
        i64::try_from(p.bits()).unwrap_or(i64::MAX) - i64::try_from(q.bits()).unwrap_or(0) + 1
    };
    let origin = &points[0];
    let differences = points.iter().flat_map(|point| (0..3).map(|i| &point[i] - &origin[i]));
    let greatest = differences.filter(|x| !x.is_zero()).map(|x| bits(&x)).max().unwrap_or(0);
    let scale = Rational::from(2).pow(i32::try_from(greatest).unwrap_or(0));
    match beyond(points.iter().flatten(), &scale) {
        Some(why) => Err(E::too_much(why)),
        None => Ok(scale),
    }
}
