//! Sign, equality and order of expressions, and whether one is rational.

use super::node::{Operation, RealExpression};
use super::rounded::power_of_half;
use crate::exact::{Rational, Scalar};
use std::cmp::Ordering;
use std::sync::Arc;

impl RealExpression {
    /// −1, 0 or 1.
    ///
    /// # Panics
    /// Never.
    #[must_use]
    pub fn sign(&self) -> i8 {
        if let Operation::Number(value) = &self.0.operation {
            return value.sign();
        }
        let mut least = None;
        let decided = |level: u32| {
            let near = self.approximation(level);
            near.sign().or_else(|| {
                let least = least.get_or_insert_with(|| power_of_half(self.separation()));
                (near.width() < *least).then_some(0)
            })
        };
        (0..).find_map(decided).expect("the enclosures shrink to a point")
    }

    /// b such that this number is 0 or at least 2^−b in absolute value. To find that two equal numbers
    /// are equal takes about b binary digits, where b is that of their difference.
    #[must_use]
    pub fn separation(&self) -> u64 {
        self.0.size.separation(self.0.field.degree())
    }

    /// This as a rational number, if it is one.
    ///
    /// If it is p/q, then q ≤ 2^b for a b that follows from its size. An interval narrower than 2^−2b has
    /// at most one such fraction, which is that with the least denominator in the interval.
    ///
    /// # Panics
    /// Never.
    #[must_use]
    pub fn as_rational(&self) -> Option<&Rational> {
        if let Operation::Number(value) = &self.0.operation {
            return value.as_rational();
        }
        let find = || {
            let bits = self.0.size.denominator_bits(self.0.field.degree());
            let width = power_of_half(bits.saturating_mul(2).saturating_add(1));
            let mut near = (0..).map(|level| self.approximation(level));
            let near = near.find(|near| near.width() < width).expect("they shrink to a point");
            let candidate = near.simplest();
            let difference = self.minus(&RealExpression::from(candidate.clone()));
            (difference.sign() == 0).then_some(candidate)
        };
        self.0.rational.get_or_init(find).as_ref()
    }
}

impl Ord for RealExpression {
    /// # Panics
    /// Never.
    fn cmp(&self, other: &RealExpression) -> Ordering {
        if Arc::ptr_eq(&self.0, &other.0) {
            return Ordering::Equal;
        }
        let (a, b) = (self.approximation(0), other.approximation(0));
        if a.upper() < b.lower() {
            return Ordering::Less;
        }
        if b.upper() < a.lower() {
            return Ordering::Greater;
        }
        self.minus(other).sign().cmp(&0)
    }
}

impl PartialOrd for RealExpression {
    fn partial_cmp(&self, other: &RealExpression) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for RealExpression {
    fn eq(&self, other: &RealExpression) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for RealExpression {}
