//! Riesz bounds of the shifts of a basic limit function.

use super::integrals::InnerProducts;
use crate::exact::{Rational, RealCyclotomic, RealExpression, Scalar as _, value_at};
use crate::limit::LimitError;

/// The greatest degree of the cosine polynomial.
const MAX_DEGREE: usize = 48;

/// The least and the greatest value of Σ_k cos(kξ) ∫ φ(x) φ(x − k) dx for real ξ: the squares of the best constants A and B with
/// A‖c‖ ≤ ‖Σ c_k φ(· − k)‖ ≤ B‖c‖. `None` beyond the cap of the degree.
///
/// With t = cos ξ, this is a polynomial in t on [−1, 1], since cos(kξ) = T_k(t); its extremes are at the ends, or where the
/// derivative is 0.
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
    let mut polynomial = vec![Rational::zero(); last + 1];
    let (mut before, mut chebyshev) = (Vec::new(), vec![Rational::one()]);
    for k in 0..=last {
        let twice = Rational::from(if k == 0 { 1 } else { 2 });
        let value = products.at(&Rational::from(k))? * twice;
        for (sum, c) in polynomial.iter_mut().zip(&chebyshev) {
            *sum += &(&value * c);
        }
        (before, chebyshev) = (chebyshev.clone(), next(&chebyshev, &before));
    }
    let one = Rational::one();
    let ends = [-&one, one.clone()].map(|t| RealExpression::from(value_at(&polynomial, &t)));
    let [mut least, mut greatest] = ends.clone();
    if greatest < least {
        std::mem::swap(&mut least, &mut greatest);
    }
    let slope: Vec<RealCyclotomic> =
        (1..=last).map(|k| RealCyclotomic::from(&polynomial[k] * Rational::from(k))).collect();
    let ends = [-&one, one].map(RealExpression::from);
    // A constant has no roots that count.
    let roots = (1..=last).map_while(|i| RealExpression::root(&slope, i).ok());
    for root in roots.filter(|root| ends[0] < *root && *root < ends[1]) {
        let value = polynomial.iter().rev().fold(RealExpression::zero(), |sum, c| {
            sum.times(&root).plus(&RealExpression::from(c.clone()))
        });
        if value < least {
            least = value;
        } else if greatest < value {
            greatest = value;
        }
    }
    Ok(Some([least, greatest]))
}

/// T_{k+1} = 2t·T_k − T_{k−1}; T_1 = t.
fn next(now: &[Rational], before: &[Rational]) -> Vec<Rational> {
    let factor = Rational::from(if before.is_empty() { 1 } else { 2 });
    let mut next: Vec<Rational> =
        std::iter::once(Rational::zero()).chain(now.iter().map(|c| c * &factor)).collect();
    for (sum, c) in next.iter_mut().zip(before) {
        *sum -= c;
    }
    next
}
