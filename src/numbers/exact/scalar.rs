//! The operations that the algorithms require of a number type. Each algorithm is written
//! once for all types.

use super::{Integer, Rational, common_denominator};
use std::cmp::Ordering;

/// A commutative ring that contains the rationals: exact numbers, polynomials,
/// and, up to rounding, machine floats.
pub trait Scalar: Clone {
    /// The image of a rational number.
    fn from_rational(value: &Rational) -> Self;
    /// self + other.
    #[must_use]
    fn plus(&self, other: &Self) -> Self;
    /// self becomes self + other.
    fn accumulate(&mut self, other: &Self) {
        *self = self.plus(other);
    }
    /// self − other.
    #[must_use]
    fn minus(&self, other: &Self) -> Self;
    /// self becomes self − other.
    fn lessen(&mut self, other: &Self) {
        *self = self.minus(other);
    }
    /// self · other.
    #[must_use]
    fn times(&self, other: &Self) -> Self;

    /// Some q > 0 such that q·x has no denominator for each of these numbers x, so that
    /// sums of such multiples need no common denominator. 1 for types that do not profit
    /// from this.
    #[must_use]
    fn common_denominator(_: &[Self]) -> Integer {
        Integer::one()
    }

    /// 0.
    #[must_use]
    fn zero() -> Self {
        Self::from_rational(&Rational::zero())
    }

    /// The sum of `terms`, added from left to right.
    #[must_use]
    fn total<'a>(terms: impl IntoIterator<Item = &'a Self>) -> Self
    where
        Self: 'a,
    {
        terms.into_iter().fold(Self::zero(), |mut sum, term| {
            sum.accumulate(term);
            sum
        })
    }

    /// wᵀM for the [`Matrix`](super::Matrix) M with the entries m_{a,b} =
    /// values\[names_{a,b}\], where `w` has one coordinate for each row: the sums Σ_a w_a
    /// m_{a,b} over the nonzero entries, with a increasing. Exact types may compute the same
    /// sums in another way.
    #[must_use]
    fn left_product(w: &[Self], values: &[Self], names: &[Vec<u32>]) -> Vec<Self> {
        let mut sums = vec![Self::zero(); names.first().map_or(0, Vec::len)];
        for (w, names) in w.iter().zip(names) {
            for (sum, &name) in sums.iter_mut().zip(names).filter(|(_, name)| **name != 0) {
                *sum = sum.plus(&w.times(&values[name as usize]));
            }
        }
        sums
    }
}

/// An ordered [`Scalar`] with absolute values and division.
pub trait Real: Scalar {
    /// |self|.
    #[must_use]
    fn magnitude(&self) -> Self;
    /// The greater of the two.
    #[must_use]
    fn greater(&self, other: &Self) -> Self;
    /// self / other, for other ≠ 0.
    #[must_use]
    fn over(&self, other: &Self) -> Self;

    /// Integers of at most about 50 bits near c·x for the given numbers x, with one
    /// factor c > 0 for all. `None` where exact arithmetic is as quick.
    #[must_use]
    fn rounded(_: &[Self]) -> Option<Vec<i64>> {
        None
    }

    /// Σ |t| over `terms`.
    #[must_use]
    fn sum_of_magnitudes<'a>(terms: impl IntoIterator<Item = &'a Self>) -> Self
    where
        Self: 'a,
    {
        terms.into_iter().fold(Self::zero(), |sum, term| sum.plus(&term.magnitude()))
    }

    /// The greatest of `values`, or 0 when there are none or all are negative.
    #[must_use]
    fn maximum(values: impl IntoIterator<Item = Self>) -> Self {
        values.into_iter().fold(Self::zero(), |best, value| best.greater(&value))
    }
}

impl Scalar for Rational {
    fn from_rational(value: &Rational) -> Self {
        value.clone()
    }
    fn plus(&self, other: &Self) -> Self {
        self + other
    }
    fn accumulate(&mut self, other: &Self) {
        *self += other;
    }
    fn minus(&self, other: &Self) -> Self {
        self - other
    }
    fn times(&self, other: &Self) -> Self {
        self * other
    }
    fn common_denominator(values: &[Self]) -> Integer {
        common_denominator(values)
    }
}

impl Real for Rational {
    fn magnitude(&self) -> Self {
        self.abs()
    }
    fn greater(&self, other: &Self) -> Self {
        if self.cmp(other) == Ordering::Less { other.clone() } else { self.clone() }
    }
    fn over(&self, other: &Self) -> Self {
        self / other
    }
}
