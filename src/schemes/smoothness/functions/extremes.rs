//! Cosine polynomials: their extremes, and the absolute value of a symbol on the unit circle.

use crate::exact::{
    CosineError, Integer, IntegerPolynomial, MAX_ROOT_DEGREE, Rational, RealAlgebraic,
    RealCyclotomic, RealExpression, Scalar,
};
use crate::smoothness::symbol::Symbol;

/// The greatest degree of a cosine polynomial whose extremes are computed.
pub(super) const MAX_DEGREE: usize = 48;

/// The least and the greatest value of c_0 + 2·Σ_{k≥1} c_k cos(kξ) for real ξ; `None` beyond degree 48, or where
/// a zero of the derivative has a degree above 16.
///
/// With t = cos ξ, this is a polynomial in t on [−1, 1], since cos(kξ) = T_k(t); its extremes are at the ends, or where the
/// derivative is 0.
pub(super) fn extremes(cosines: &[RealCyclotomic]) -> Option<[RealExpression; 2]> {
    if cosines.len() > MAX_DEGREE + 1 {
        return None;
    }
    let mut polynomial = vec![RealCyclotomic::zero(); cosines.len()];
    let (mut before, mut chebyshev) = (Vec::new(), vec![Rational::one()]);
    for (k, value) in cosines.iter().enumerate() {
        let twice = Rational::from(if k == 0 { 1 } else { 2 });
        for (sum, c) in polynomial.iter_mut().zip(&chebyshev) {
            sum.accumulate(&value.times(&RealCyclotomic::from(c * &twice)));
        }
        (before, chebyshev) = (chebyshev.clone(), next(&chebyshev, &before));
    }
    let value_at = |t: &RealExpression| {
        polynomial.iter().rev().fold(RealExpression::zero(), |sum, c| {
            sum.times(t).plus(&RealExpression::from(c.clone()))
        })
    };
    let ends = [-1, 1].map(|end| RealExpression::from(Rational::from(end)));
    let [mut least, mut greatest] = ends.each_ref().map(&value_at);
    if greatest < least {
        std::mem::swap(&mut least, &mut greatest);
    }
    let slope: Vec<RealCyclotomic> = (1_i64..)
        .zip(polynomial.iter().skip(1))
        .map(|(k, c)| c.times(&RealCyclotomic::from(k)))
        .collect();
    let roots = roots(&slope)?.into_iter();
    for root in roots.filter(|root| ends[0] < *root && *root < ends[1]) {
        let value = value_at(&root);
        if value < least {
            least = value;
        } else if greatest < value {
            greatest = value;
        }
    }
    Some([least, greatest])
}

/// The real roots of a polynomial between −1 and 1, and perhaps others.
fn roots(polynomial: &[RealCyclotomic]) -> Option<Vec<RealExpression>> {
    if polynomial.len() <= MAX_ROOT_DEGREE + 1 {
        return RealExpression::roots(polynomial).ok();
    }
    let rational = polynomial.iter().map(|c| c.as_rational().cloned());
    let whole =
        IntegerPolynomial::over_common_denominator(&rational.collect::<Option<Vec<Rational>>>()?);
    if whole.degree().is_none() {
        return Some(Vec::new());
    }
    let ends = [-1, 1].map(|end| RealAlgebraic::from(Rational::from(end)));
    let of = |root: RealAlgebraic| {
        let minimal = root.minimal_polynomial()?;
        let place = RealAlgebraic::roots_of(&minimal).iter().position(|other| *other == root)?;
        let integer = |c: &Integer| RealCyclotomic::from(Rational::from(c.clone()));
        let coefficients: Vec<RealCyclotomic> =
            minimal.coefficients().iter().map(integer).collect();
        RealExpression::root(&coefficients, place + 1).ok()
    };
    let all = RealAlgebraic::roots_of(&whole.square_free()).into_iter();
    all.filter(|root| ends[0] < *root && *root < ends[1]).map(of).collect()
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

/// The c_k, k = 0, 1, …, with |a(e^{iξ})|² = c_0 + 2·Σ_{k≥1} c_k cos(kξ): c_k = Σ_j a_j a_{j+k}.
fn cosines(symbol: &Symbol<RealCyclotomic>) -> Vec<RealCyclotomic> {
    let all = symbol.coefficients();
    let products = |k: usize| all[k..].iter().zip(all).map(|(a, b)| a.times(b));
    let sum = |k| products(k).fold(RealCyclotomic::zero(), |sum, term| sum.plus(&term));
    (0..all.len()).map(sum).collect()
}

/// |a(e^{2πit})| for a rational t.
///
/// # Errors
/// When cos 2πt is in no field within the caps.
///
/// # Panics
/// Never: a square of an absolute value is not negative.
///
/// ```
/// use subcert::exact::{Rational, RealCyclotomic, RealExpression};
/// use subcert::scheme::parse_scheme;
/// use subcert::smoothness::{Symbol, modulus};
///
/// let mask = parse_scheme("chaikin")?.masks()[0].map(|c| RealCyclotomic::from(c.clone()));
/// // (1 + i)³/4 has the absolute value 2√2/4.
/// let found = modulus(&Symbol::of(&mask), &Rational::new(1, 4))?;
/// assert_eq!(found, RealExpression::from(Rational::new(1, 2)).sqrt()?);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn modulus(
    symbol: &Symbol<RealCyclotomic>,
    t: &Rational,
) -> Result<RealExpression, CosineError> {
    let mut square = RealCyclotomic::zero();
    for (k, c) in (0_i64..).zip(cosines(symbol)) {
        let twice = RealCyclotomic::from(if k == 0 { 1 } else { 2 });
        let cosine = RealCyclotomic::cosine(&(t * Rational::from(k)))?;
        square.accumulate(&c.times(&twice).times(&cosine));
    }
    Ok(root(&RealExpression::from(square)))
}

/// The least and the greatest value of |a(z)| on the unit circle; `None` beyond degree 48, or where a place of an extreme has a
/// cosine of a degree above 16.
///
/// # Panics
/// Never: a square of an absolute value is not negative.
///
/// ```
/// use subcert::exact::{Rational, RealCyclotomic, RealExpression};
/// use subcert::scheme::parse_scheme;
/// use subcert::smoothness::{Symbol, modulus_extremes};
///
/// let mask = parse_scheme("chaikin")?.masks()[0].map(|c| RealCyclotomic::from(c.clone()));
/// let extremes = modulus_extremes(&Symbol::of(&mask)).expect("a low degree");
/// assert_eq!(extremes, [0, 2].map(|x| RealExpression::from(Rational::from(x))));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn modulus_extremes(symbol: &Symbol<RealCyclotomic>) -> Option<[RealExpression; 2]> {
    Some(extremes(&cosines(symbol))?.each_ref().map(root))
}

fn root(square: &RealExpression) -> RealExpression {
    square.sqrt().expect("a square of an absolute value")
}
