//! Polynomials in t and 1/t.

use crate::exact::{Rational, RationalPolynomial, Scalar, SturmSequence};

/// p(t)/t^m.
#[derive(Clone, Debug)]
pub(super) struct Laurent {
    polynomial: RationalPolynomial,
    power: usize,
}

impl Laurent {
    /// The polynomial Σ c_i t^i over t^m.
    pub(super) fn new(coefficients: &[Rational], power: usize) -> Laurent {
        Laurent { polynomial: RationalPolynomial::new(coefficients), power }
    }

    /// t.
    pub(super) fn variable() -> Laurent {
        Laurent { polynomial: RationalPolynomial::variable(), power: 0 }
    }

    /// p times t^by.
    fn raised(&self, by: usize) -> RationalPolynomial {
        let mut power = vec![Rational::zero(); by];
        power.push(Rational::one());
        self.polynomial.times(&RationalPolynomial::new(&power))
    }

    /// Both over the same power.
    fn common(&self, other: &Self) -> (RationalPolynomial, RationalPolynomial, usize) {
        let power = self.power.max(other.power);
        (self.raised(power - self.power), other.raised(power - other.power), power)
    }

    /// The sign on all of the closed interval; `None` where there is a zero. If m > 0, the interval has only
    /// positive t.
    pub(super) fn sign_on(&self, low: &Rational, high: &Rational) -> Option<i8> {
        if self.polynomial.is_zero() {
            return Some(0);
        }
        let at_low = self.polynomial.sign_at(low);
        let zeros = SturmSequence::new(self.polynomial.numerator()).count_roots(low, high);
        (at_low != 0 && zeros == 0).then_some(at_low)
    }
}

impl Scalar for Laurent {
    fn from_rational(value: &Rational) -> Self {
        Laurent { polynomial: RationalPolynomial::constant(value.clone()), power: 0 }
    }
    fn plus(&self, other: &Self) -> Self {
        let (a, b, power) = self.common(other);
        Laurent { polynomial: a.plus(&b), power }
    }
    fn minus(&self, other: &Self) -> Self {
        let (a, b, power) = self.common(other);
        Laurent { polynomial: a.minus(&b), power }
    }
    fn times(&self, other: &Self) -> Self {
        let polynomial = self.polynomial.times(&other.polynomial);
        Laurent { polynomial, power: self.power + other.power }
    }
}
