//! The sign of a polynomial at a point.

use crate::exact::{IntegerPolynomial, Rational};

impl IntegerPolynomial {
    /// The sign of the value at `point`: −1, 0 or 1.
    #[must_use]
    pub fn sign_at(&self, point: &Rational) -> i8 {
        self.sign_in_words(point).unwrap_or_else(|| self.scaled_value(point).0.sign())
    }

    /// The sign of Σ c_i p^i q^(d−i) at p/q, if all of its partial sums fit in 128 bits: none exceeds
    /// (d + 1)·max |c_i|·max(|p|, q)^d.
    fn sign_in_words(&self, point: &Rational) -> Option<i8> {
        let degree = self.degree()?;
        let (p, q) = point.as_words()?;
        let size = |word: i64| 64 - word.unsigned_abs().leading_zeros() as usize;
        // Binary digits that are left for a coefficient.
        let room = 126 - (usize::BITS - degree.leading_zeros()) as usize;
        let room = room.checked_sub(degree.checked_mul(size(p).max(size(q)))?)?;
        let (p, q) = (i128::from(p), i128::from(q));
        let (mut value, mut scale) = (0_i128, 1_i128);
        for (i, coefficient) in self.coefficients().iter().rev().enumerate() {
            let coefficient = coefficient.to_i64().filter(|&word| size(word) <= room)?;
            if i > 0 {
                scale *= q;
            }
            value = value * p + i128::from(coefficient) * scale;
        }
        Some(value.signum() as i8)
    }
}
