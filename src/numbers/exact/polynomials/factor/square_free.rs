//! The square-free part of a polynomial.

use super::modular::is_square_free;
use super::reduced;
use crate::exact::IntegerPolynomial;

/// 2^31 − 1, a prime.
const PRIME: u32 = 2_147_483_647;

impl IntegerPolynomial {
    /// The primitive polynomial with the same roots, each of them simple; 0 for 0.
    #[must_use]
    pub fn square_free(&self) -> IntegerPolynomial {
        if self.degree().is_none_or(|degree| degree < 2) || self.has_unit_discriminant() {
            return self.primitive();
        }
        self.div_rem(&self.gcd(&self.derivative())).1.primitive()
    }

    /// Whether f keeps its degree modulo [`PRIME`] and is there coprime to its derivative. Then f is square-free: the
    /// prime does not divide its discriminant. Almost all square-free polynomials are seen so.
    fn has_unit_discriminant(&self) -> bool {
        let f = reduced(self, PRIME);
        f.last() != Some(&0) && is_square_free(&f, PRIME.into())
    }
}
