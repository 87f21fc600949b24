//! Values of the limits of masks on Z^d.

use super::powers::{Steps, convolved};
use super::values::values_at_integers;
use crate::cap::Cap;
use crate::exact::Rational;
use crate::scheme::{LatticeMask, Point};
use std::collections::BTreeMap;

/// The most products of two coefficients for the values of one level.
const MAX_PRODUCTS: usize = 1 << 22;

/// φ(M^{−k}α) for all α at which it is not 0: Σ_β φ(β) a_k(α − β), where (S^kp)_α = Σ_β a_k(α − M^kβ)p_β. The limit of data p is
/// Σ_β φ(α − β)p_β at α, so that φ at the integers is the limit stencil. φ is the limit where the scheme converges.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::lattice::limit_values;
/// use subcert::scheme::parse_lattice;
///
/// // The quartic box spline of Loop's scheme: 1/2 in the middle, and 1/12 at the six points around.
/// let mask = parse_lattice("(1+x)^2*(1+y)^2*(1+x*y)^2/16")?;
/// let values = limit_values(&mask, 0).expect("a small window").expect("it converges");
/// assert_eq!((values.len(), &values[&[2, 2, 0]]), (7, &Rational::new(1, 2)));
/// # Ok::<(), subcert::scheme::SchemeError>(())
/// ```
///
/// # Errors
/// When there are too many; `Ok(None)` where φ has no values at the integers, so that the scheme does not converge.
pub fn limit_values(
    mask: &LatticeMask,
    level: u32,
) -> Result<Option<BTreeMap<Point, Rational>>, Cap> {
    let Some(integers) = values_at_integers(mask)? else { return Ok(None) };
    let mut steps = Steps::none(mask);
    for _ in 0..level {
        if steps.coefficients().len() * mask.coefficients().len() > MAX_PRODUCTS {
            return Err(beyond());
        }
        steps = steps.next();
    }
    if steps.coefficients().len() * integers.len() > MAX_PRODUCTS {
        return Err(beyond());
    }
    let coefficients = steps.coefficients().iter().map(|(place, c)| (*place, c));
    let mut values = convolved(coefficients, &integers);
    values.retain(|_, value| !value.is_zero());
    Ok(Some(values))
}

fn beyond() -> Cap {
    Cap::new("the number of products for values of the limit", MAX_PRODUCTS as u64)
}
