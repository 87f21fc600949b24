//! What a formula can be computed over.

use crate::exact::{Parametric, PiecewiseLinear, Polynomial, Rational, Real, Scalar};

/// Values of formulas. Operations that a type does not have give `None`.
pub trait Value: Scalar + std::fmt::Display {
    /// This as a rational number, if it is one.
    fn as_rational(&self) -> Option<Rational>;
    /// What an operation on this costs, in bits; 0 when it stays small.
    fn size(&self) -> u64;
    /// What self · other costs, at least the size of the product.
    fn product_size(&self, other: &Self) -> u64 {
        self.size().saturating_add(other.size())
    }
    /// self / divisor, for divisor ≠ 0.
    fn quotient(&self, divisor: &Self) -> Option<Self>;
    /// |self|.
    fn absolute(&self) -> Option<Self>;
    /// The greater of the two.
    fn larger(&self, other: &Self) -> Option<Self>;
}

/// What a term of a polynomial counts for, beside its coefficient.
const TERM_BITS: u64 = 10;

impl Value for Rational {
    fn as_rational(&self) -> Option<Rational> {
        Some(self.clone())
    }
    fn size(&self) -> u64 {
        self.bits()
    }
    fn quotient(&self, divisor: &Self) -> Option<Self> {
        Some(self / divisor)
    }
    fn absolute(&self) -> Option<Self> {
        Some(self.abs())
    }
    fn larger(&self, other: &Self) -> Option<Self> {
        Some(self.max(other).clone())
    }
}

impl Value for Polynomial {
    fn as_rational(&self) -> Option<Rational> {
        self.as_constant()
    }
    fn size(&self) -> u64 {
        (self.term_count() as u64 * TERM_BITS + self.bits()).max(self.degree())
    }
    fn product_size(&self, other: &Self) -> u64 {
        let (left, right) = (self.term_count() as u64, other.term_count() as u64);
        let bits = left.saturating_mul(right.saturating_mul(TERM_BITS) + other.bits());
        let bits = bits.saturating_add(right.saturating_mul(self.bits()));
        bits.max(self.degree() + other.degree())
    }
    fn quotient(&self, divisor: &Self) -> Option<Self> {
        Some(self * &Polynomial::constant(divisor.as_constant()?.recip()))
    }
    fn absolute(&self) -> Option<Self> {
        Some(Polynomial::constant(self.as_constant()?.abs()))
    }
    fn larger(&self, other: &Self) -> Option<Self> {
        Some(Polynomial::constant(self.as_constant()?.max(other.as_constant()?)))
    }
}

/// Products and quotients that are not piecewise linear are
/// [`Parametric::Outside`], which the caller of an evaluation has to look for.
impl Value for Parametric {
    fn as_rational(&self) -> Option<Rational> {
        self.function()?.as_constant()
    }
    fn size(&self) -> u64 {
        self.function().map_or(0, PiecewiseLinear::bits)
    }
    fn product_size(&self, other: &Self) -> u64 {
        let pieces = |value: &Parametric| value.function().map_or(1, |f| f.piece_count() as u64);
        let (left, right) = (self.size(), other.size());
        left.saturating_mul(pieces(other)).saturating_add(right.saturating_mul(pieces(self)))
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
