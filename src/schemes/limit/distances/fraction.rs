//! Unreduced fractions, for numbers that are mostly compared.

use crate::exact::{Integer, Rational};
use std::cmp::Ordering;

/// p/q with q > 0, not reduced to lowest terms: the products of a comparison cost less
/// than a greatest common divisor.
#[derive(Clone, Debug)]
pub(super) struct Fraction {
    pub(super) p: Integer,
    pub(super) q: Integer,
}

impl Fraction {
    /// The value as a rational number, in lowest terms.
    pub(super) fn reduced(self) -> Rational {
        Rational::new(self.p, self.q)
    }
}

impl From<&Rational> for Fraction {
    fn from(value: &Rational) -> Fraction {
        Fraction { p: value.numerator(), q: value.denominator() }
    }
}

impl Ord for Fraction {
    fn cmp(&self, other: &Fraction) -> Ordering {
        if self.q == other.q {
            return self.p.cmp(&other.p);
        }
        (&self.p * &other.q).cmp(&(&other.p * &self.q))
    }
}

impl PartialOrd for Fraction {
    fn partial_cmp(&self, other: &Fraction) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Fraction {
    fn eq(&self, other: &Fraction) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Fraction {}
