//! Where the points of a net go.

use super::error::NetError;
use super::grid::Net;
use super::scheme::NetScheme;
use crate::exact::Rational;
use crate::limit::{Functional, Limit, natural_shift};
use crate::mesh::{Point, combination};
use crate::scheme::Mask;

/// The limit point of every point of a net, row by row: the point of the surface at its natural
/// parameters. `None` where an open net does not determine it.
///
/// With the limit functional l of the curve of u at its shift s, and that of v, the limit point of
/// x_{i,j} is Σ_{p,q} l_p l'_q x_{i+p,j+q}.
///
/// Source: `proofs/THEOREMS.md`, 80, 82 and 98.
///
/// # Errors
/// When one of the curves is not shown to converge.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::net::{Closed, Net, NetScheme, net_limits};
///
/// // Heights 0 but for one 36 in the middle.
/// let height = |k: i64| if k == 4 { 36 } else { 0 };
/// let points = (0..9).map(|k| [k % 3, k / 3, height(k)].map(Rational::from));
/// let net = Net::new(points.collect(), 3, Closed::default())?;
/// let limits = net_limits(&net, &NetScheme::parse("bicubic")?)?;
/// assert_eq!(limits[4], Some([1, 1, 16].map(Rational::from)));
/// assert_eq!(limits[3], None);
/// # Ok::<(), subcert::net::NetError>(())
/// ```
pub fn net_limits(net: &Net, scheme: &NetScheme) -> Result<Vec<Option<Point<Rational>>>, NetError> {
    let [u, v] = scheme.masks();
    let [u, v] = [functional(u)?, functional(v)?];
    let weights: Vec<(i64, i64, Rational)> =
        u.terms().flat_map(|(p, x)| v.terms().map(move |(q, y)| (p, q, x * y))).collect();
    let limit = |i: i64, j: i64| -> Option<Point<Rational>> {
        let terms: Option<Vec<(&Rational, &Point<Rational>)>> =
            weights.iter().map(|(p, q, weight)| Some((weight, net.at(i + p, j + q)?))).collect();
        Some(combination(terms?))
    };
    let [rows, columns] = net.sizes().map(|size| i64::try_from(size).unwrap_or(i64::MAX));
    Ok((0..rows)
        .flat_map(|i| (0..columns).map(move |j| (i, j)))
        .map(|(i, j)| limit(i, j))
        .collect())
}

/// The net of the limit points that exist, of those of a net, row by row.
///
/// # Errors
/// When there are too few of them for a net.
pub fn net_of_limits(net: &Net, limits: Vec<Option<Point<Rational>>>) -> Result<Net, NetError> {
    // Those that exist are a rectangle.
    let columns = limits.chunks(net.columns()).map(|row| row.iter().flatten().count()).max();
    let points: Vec<_> = limits.into_iter().flatten().collect();
    match columns {
        Some(columns) if columns > 0 => Net::new(points, columns, net.closed()),
        _ => Err(NetError::TooMuch(
            "the net determines no limit point: the surface ends before all of its points"
                .to_owned(),
        )),
    }
}

/// P^∞(s) for the natural shift s.
fn functional(mask: &Mask) -> Result<Functional, NetError> {
    Ok(Limit::new(mask)?.at(&natural_shift(mask).shift)?)
}
