//! Functions of an integer as values of formulas.

use super::value::Value;
use crate::exact::{Integer, IntegerFunction, Rational, Scalar as _};
use crate::formula::root_error::{RootError, rational_root};
use std::cmp::Ordering;

impl Value for IntegerFunction {
    fn as_rational(&self) -> Option<Rational> {
        self.as_constant()
    }
    fn size(&self) -> u64 {
        self.bits()
    }
    fn product_size(&self, other: &Self) -> u64 {
        let terms = |value: &Self| value.term_count() as u64;
        let (left, right) = (terms(self), terms(other));
        left.saturating_mul(other.bits()).saturating_add(right.saturating_mul(self.bits()))
    }
    fn quotient(&self, divisor: &Self) -> Option<Self> {
        Some(self.times(&divisor.inverse()?))
    }
    fn absolute(&self) -> Option<Self> {
        Some(match self.sign()? {
            Ordering::Less => IntegerFunction::zero().minus(self),
            _ => self.clone(),
        })
    }
    fn larger(&self, other: &Self) -> Option<Self> {
        Some(match self.minus(other).sign()? {
            Ordering::Less => other.clone(),
            _ => self.clone(),
        })
    }
    fn floor(&self) -> Option<Integer> {
        if let Some(value) = self.as_constant() {
            return Some(value.floor());
        }
        let between = |k: &i64| {
            let above = self.minus(&IntegerFunction::from(*k)).sign().is_some_and(Ordering::is_ge);
            above && IntegerFunction::from(k + 1).minus(self).sign().is_some_and(Ordering::is_gt)
        };
        (-2..=1).find(between).map(Integer::from)
    }
    fn vanishes(&self) -> Option<bool> {
        self.sign().map(Ordering::is_eq)
    }
    fn cosine_of(turn: &Self) -> Option<Self> {
        turn.cosine()
    }
    fn square_root(&self) -> Option<Self> {
        self.square_root()
    }
    /// Roots of polynomials whose coefficients are numbers, if they are rational.
    fn root(coefficients: &[Self], number: i64) -> Result<Self, RootError> {
        let numbers: Option<Vec<Rational>> =
            coefficients.iter().map(IntegerFunction::as_constant).collect();
        let root = rational_root(&numbers.ok_or(RootError::NotHere)?, number)?;
        Ok(IntegerFunction::from_rational(&root))
    }
}
