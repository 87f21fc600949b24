//! Riesz bounds of the shifts of a basic limit function.

use super::extremes::{MAX_DEGREE, extremes};
use super::integrals::InnerProducts;
use crate::exact::{Rational, RealCyclotomic, RealExpression};
use crate::limit::LimitError;

/// The least and the greatest value of Σ_k cos(kξ) ∫ φ(x) φ(x − k) dx for real ξ: the squares of the best constants A and B with
/// A‖c‖ ≤ ‖Σ c_k φ(· − k)‖ ≤ B‖c‖. `None` beyond the cap of the degree.
///
/// # Errors
/// As [`InnerProducts::at`].
///
/// ```
/// use subcert::exact::{Rational, RealExpression};
/// use subcert::scheme::parse_scheme;
/// use subcert::smoothness::{InnerProducts, riesz_bounds};
///
/// let hats = parse_scheme("b-spline:degree=1")?;
/// let products = InnerProducts::new(hats.masks()[0], hats.masks()[0])?;
/// let bounds = riesz_bounds(&products, 1)?.expect("a low degree");
/// assert_eq!(bounds, [Rational::new(1, 3), Rational::from(1)].map(RealExpression::from));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn riesz_bounds(
    products: &InnerProducts,
    last: usize,
) -> Result<Option<[RealExpression; 2]>, LimitError> {
    if last > MAX_DEGREE {
        return Ok(None);
    }
    let product = |k: usize| products.at(&Rational::from(k)).map(RealCyclotomic::from);
    Ok(extremes(&(0..=last).map(product).collect::<Result<Vec<_>, LimitError>>()?))
}
