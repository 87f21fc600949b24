//! Whether a polynomial has a root in an interval, without finding it.

use crate::exact::polynomials::descartes::bernstein;
use crate::exact::polynomials::sturm::changes;
use crate::exact::{Integer, IntegerPolynomial, Rational};

impl IntegerPolynomial {
    /// A quick test for roots between l = `lower` and u = `upper`. `false` means that there is
    /// none; `true` means only that there may be one. It uses a bound on the derivative and
    /// Descartes' rule of signs: the number of roots in (l, u) is at most the number of sign
    /// changes in the coefficients of (1 + x)^d f((l + ux)/(1 + x)).
    ///
    /// ```
    /// use subcert::exact::{IntegerPolynomial, Rational};
    ///
    /// let f = IntegerPolynomial::from([-2, 0, 1]);
    /// assert!(f.may_vanish_between(&Rational::from(1), &Rational::from(2)));
    /// assert!(!f.may_vanish_between(&Rational::from(2), &Rational::from(9)));
    /// ```
    #[must_use]
    pub fn may_vanish_between(&self, lower: &Rational, upper: &Rational) -> bool {
        if self.keeps_away(lower, upper) {
            return false;
        }
        let (a, b) = (lower.denominator(), upper.denominator());
        let (low, high) = (lower.numerator() * &b, upper.numerator() * &a);
        !self.is_zero()
            && changes(bernstein(&self.on(&low, &high, &(a * b))).iter().map(Integer::sign)) > 0
    }

    /// Whether |f(m)| > h·Σ i|c_i|b^(i−1), where m is the midpoint of the interval, h half
    /// its length, and b ≥ |x| on it. Then f has no root in the interval, as the right side
    /// bounds |f(x) − f(m)|. The test succeeds on most short intervals.
    fn keeps_away(&self, lower: &Rational, upper: &Rational) -> bool {
        let (middle, half) =
            ((lower + upper) / Rational::from(2), (upper - lower) / Rational::from(2));
        let most = lower.abs().max(upper.abs()).ceil();
        let terms = self.coefficients().iter().enumerate().skip(1).rev();
        let slope =
            terms.fold(Integer::zero(), |slope, (i, c)| slope * &most + c.abs() * Integer::from(i));
        let (value, scale) = self.scaled_value(&middle);
        value.abs() * half.denominator() > slope * half.numerator() * scale
    }
}
