//! Maps of two parameters of masks on Z^d.

use super::error::LatticeRangeError;
use super::order_above;
use super::steps::{PlaneMatrix, Steps, at, products, scale};
use crate::exact::{BivariatePolynomial, Rational};
use crate::joint::{MatrixSet, radius_of_blocks};
use crate::lattice::constants::LatticeConstants;
use crate::lattice::shape::is_interpolating;
use crate::scheme::LatticeMask;
use crate::smoothness::{PlaneSearch, Sides, SmoothMap, map_of};
use crate::stop::Stop;
use std::sync::atomic::AtomicUsize;

/// The boxes of a map that are looked at if nobody says how many.
pub const MAP_BOXES: usize = 250;

/// A map of where the limits of a mask on Z^d in two parameters are C^m, by halving both sides of open boxes until `most` boxes have been looked at. `done`
/// counts them.
///
/// As for [one parameter](super::lattice_range), the steps near a tile are split into blocks for all parameters at once. Inside, a hull is invariant under the
/// matrices of which those of the box are means, for each block, or T_1 < 1 at the corners, for m = 0; outside, a product of one block has an eigenvalue of s^{−m} or more in the whole box.
/// `proofs/THEOREMS.md`, 122 and 150.
///
/// # Errors
/// As of [`lattice_range`](super::lattice_range).
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::lattice::lattice_map;
/// use subcert::scheme::parse_lattice_in_parameters;
///
/// // A quincunx scheme that keeps the data, with two weights.
/// let text = "1+a*(x+1/x)+(1/2-a)*(y+1/y)+b*(x*y^2+1/(x*y^2)-y-1/y):dilation=[[1,1],[1,-1]]";
/// let mask = parse_lattice_in_parameters(text, ["a", "b"])?;
/// let near = |x: (i64, i64)| [Rational::new(x.0, x.1) - Rational::new(1, 64), Rational::new(x.0, x.1)];
/// let map = lattice_map(&mask, 0, &[near((1, 4)), near((1, 64))], 1, &Default::default())?;
/// assert_eq!(map.looked_at, 1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn lattice_map(
    mask: &LatticeMask<BivariatePolynomial>,
    m: u32,
    region: &Sides,
    most: usize,
    done: &AtomicUsize,
) -> Result<SmoothMap, LatticeRangeError> {
    let order = order_above(mask, m)?;
    let steps = Steps::near_tile(mask, order)?;
    let (count, scale) = scale(mask.dilation(), m);
    let blocks = steps.blocks.iter().map(|block| products(block, count, &scale));
    let open = blocks.filter(|block| !always_contracts(block));
    let searches: Result<Vec<PlaneSearch>, _> =
        open.map(|block| PlaneSearch::balanced(block, region)).collect();
    // T_1 is greatest at a corner, if the coefficients are linear in each parameter: it is a maximum of norms.
    let linear = mask.coefficients().values().all(|c| c.degrees().iter().all(|d| *d <= 1));
    let inside = |[[a, b], [c, d]]: &Sides| {
        let corners = [[a, c], [a, d], [b, c], [b, d]];
        m == 0 && linear && corners.into_iter().all(|corner| contracts(mask, corner))
    };
    // Where data are kept, steps are those of differences of φ itself; and divergence needs no more.
    let sure = m == 0 || is_interpolating(mask);
    let map = map_of(searches?, &inside, region, (most, done))?;
    if sure || steps.spans(order) {
        return Ok(SmoothMap { but_exceptions: !sure, ..map });
    }
    Ok(map.without_outside())
}

/// Whether T_1 < 1 at values of the parameters.
fn contracts(mask: &LatticeMask<BivariatePolynomial>, values: [&Rational; 2]) -> bool {
    let Some(mask) = at(mask, values) else { return false };
    let mut constants = LatticeConstants::new(&mask);
    let found = constants.advance().ok().and_then(|()| constants.contraction().ok());
    found.is_some_and(|found| found.value < Rational::one())
}

/// Whether matrices depend on no parameter, and have a radius below 1.
fn always_contracts(block: &[PlaneMatrix]) -> bool {
    let entries = || block.iter().flatten().flatten();
    if entries().any(|p| p.degrees() != [0, 0]) {
        return false;
    }
    let zero = Rational::zero();
    let row =
        |row: &Vec<BivariatePolynomial>| row.iter().map(|p| p.value_at([&zero, &zero])).collect();
    let all = block.iter().map(|matrix| matrix.iter().map(row).collect()).collect();
    radius_of_blocks(&MatrixSet::of_any_size(all), &Stop::default()).upper() < Rational::one()
}
