//! Planes of two parameters: maps of boxes, and polygons in which limits are C^m.

mod best;
mod map;
mod polygon;
mod region;

pub use best::{BestExponent, best_exponent};
pub(crate) use map::map_of;
pub use map::{MAX_BOXES, MapBox, SmoothMap, smooth_map};
pub use polygon::{RegionProof, polygon_contraction};
pub(crate) use region::Search as PlaneSearch;
pub use region::{Certain, Sides};

use crate::exact::{BivariatePolynomial, Polynomial};
use crate::scheme::Rules;

/// The rules with their coefficients as polynomials in two parameters.
///
/// # Errors
/// The first coefficient that is not a rational polynomial in them.
///
/// # Panics
/// Never.
pub fn plane_rules(
    rules: &Rules<Polynomial>,
    parameters: [&str; 2],
) -> Result<Rules<BivariatePolynomial>, Polynomial> {
    let polynomial = |entry: &Polynomial| entry.in_variables(parameters);
    let mut entries = rules.rows().iter().flatten();
    if let Some(entry) = entries.find(|entry| polynomial(entry).is_none()) {
        return Err(entry.clone());
    }
    Ok(rules.map(|entry| polynomial(entry).expect("a polynomial")))
}
