//! Whether a polynomial has a root in an interval, without finding it.

use super::{Integer, IntegerPolynomial, Rational};

impl IntegerPolynomial {
    /// Whether a bound on the derivative and the rule of Descartes leave a root between
    /// `lower` and `upper`: an inexpensive test, that is right when it says no. The roots in
    /// between are at most the sign changes of the coefficients of (1 + x)^d f((l + ux)/(1 + x)).
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
        // f((low + high·x)/(ab(1 + x))), its denominator cleared.
        let top = IntegerPolynomial::new(vec![low, high]);
        let bottom = IntegerPolynomial::new(vec![&a * &b, a * b]);
        let mut scale = IntegerPolynomial::from([1]);
        let mut sum = IntegerPolynomial::default();
        for coefficient in self.coefficients().iter().rev() {
            sum = &(&sum * &top) + &(&scale * &IntegerPolynomial::new(vec![coefficient.clone()]));
            scale = &scale * &bottom;
        }
        let signs = sum.coefficients().iter().map(Integer::sign).filter(|&sign| sign != 0);
        let signs: Vec<i8> = signs.collect();
        signs.windows(2).any(|pair| pair[0] != pair[1])
    }

    /// Whether |f(m)| > h·Σ i|c_i|b^(i−1), with m the middle of an interval, h half its
    /// length and b ≥ |x| in it: that is more than f can fall by. True for most short ones.
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
