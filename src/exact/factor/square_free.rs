//! The square-free part of a polynomial.

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
        let derivative = (0_u64..).zip(&f).skip(1).map(|(i, c)| i * c % P).collect();
        f.last() != Some(&0) && are_coprime(f, derivative)
    }
}

const P: u64 = PRIME as u64;

/// Whether two polynomials modulo [`PRIME`] have no common root, by Euclid's algorithm without quotients: b_m·a −
/// a_n·x^(n−m)·b takes the place of the longer one, a.
fn are_coprime(mut a: Vec<u64>, mut b: Vec<u64>) -> bool {
    loop {
        for one in [&mut a, &mut b] {
            while one.last() == Some(&0) {
                one.pop();
            }
        }
        if a.len() < b.len() {
            std::mem::swap(&mut a, &mut b);
        }
        let (Some(&a_n), Some(&b_m)) = (a.last(), b.last()) else { return a.len() == 1 };
        if b.len() == 1 {
            return true;
        }
        let shift = a.len() - b.len();
        for c in &mut a {
            *c = *c * b_m % P;
        }
        for (c, d) in a[shift..].iter_mut().zip(&b) {
            *c = (*c + (P - a_n) * d) % P;
        }
        a.pop();
    }
}
