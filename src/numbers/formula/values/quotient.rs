//! Functions of a parameter at a place of it, as values of formulas.

use super::value::Value;
use crate::exact::{QuotientAt, Rational, Real as _};

impl Value for QuotientAt {
    fn as_rational(&self) -> Option<Rational> {
        self.as_constant()
    }
    fn at_place(&self) -> Option<QuotientAt> {
        Some(self.clone())
    }
    fn of_place(value: QuotientAt) -> Option<QuotientAt> {
        Some(value)
    }
    fn vanishes(&self) -> Option<bool> {
        Some(self.sign() == 0)
    }
    fn size(&self) -> u64 {
        // The time to isolate the roots grows about with the square of the degree.
        self.bits().saturating_mul(self.degree().pow(2).max(1) as u64)
    }
    fn quotient(&self, divisor: &Self) -> Option<Self> {
        Some(self.over(divisor))
    }
    fn absolute(&self) -> Option<Self> {
        Some(self.magnitude())
    }
    fn larger(&self, other: &Self) -> Option<Self> {
        Some(self.greater(other))
    }
}
