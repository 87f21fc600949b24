//! Monic polynomials over Q(2cos(2π/n)), from the constant term upwards.

use crate::exact::{IntegerPolynomial, Rational, RealCyclotomic, divided};

pub(super) type Polynomial = Vec<RealCyclotomic>;

/// The quotient by a monic polynomial, if there is no remainder.
pub(super) fn quotient(polynomial: &Polynomial, divisor: &Polynomial) -> Option<Polynomial> {
    let (quotient, rest) = divided(polynomial, divisor);
    rest.is_empty().then_some(quotient)
}

/// The greatest polynomial over the rationals that divides this one. A polynomial over the rationals
/// divides Σ_k p_k(x) b_k, with b_k that are linearly independent over the rationals, if and only if it
/// divides all p_k.
pub(super) fn rational_part(polynomial: &Polynomial) -> IntegerPolynomial {
    let coordinates = RealCyclotomic::coordinates(polynomial);
    let count = coordinates.first().map_or(0, Vec::len);
    let part = |k: usize| {
        let column: Vec<Rational> = coordinates.iter().map(|row| row[k].clone()).collect();
        IntegerPolynomial::over_common_denominator(&column)
    };
    (0..count).map(part).fold(IntegerPolynomial::default(), |gcd, part| gcd.gcd(&part))
}

/// The monic multiple of a polynomial over the integers.
pub(super) fn monic(polynomial: &IntegerPolynomial) -> Polynomial {
    let leading = polynomial.leading();
    let over = |c: &crate::exact::Integer| Rational::new(c.clone(), leading.clone());
    polynomial.coefficients().iter().map(|c| RealCyclotomic::from(over(c))).collect()
}
