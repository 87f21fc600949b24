//! Functions of an integer as values of formulas.

use super::value::Value;
use crate::exact::{Integer, IntegerFunction, Rational, Scalar as _};
use crate::formula::root_error::{RootError, rational_root};
use std::cmp::Ordering;

/// The bits that are counted for a term.
const TERM_BITS: u64 = 64;

impl Value for IntegerFunction {
    fn as_rational(&self) -> Option<Rational> {
        self.as_constant()
    }
    fn size(&self) -> u64 {
        (self.term_count() as u64).saturating_mul(TERM_BITS)
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
        let number = |k: i64| IntegerFunction::from_rational(&Rational::from(k));
        let between = |k: &i64| {
            let above = self.minus(&number(*k)).sign().is_some_and(Ordering::is_ge);
            above && number(k + 1).minus(self).sign().is_some_and(Ordering::is_gt)
        };
        (-2..=1).find(between).map(Integer::from)
    }
    fn vanishes(&self) -> Option<bool> {
        self.sign().map(Ordering::is_eq)
    }
    fn cosine_of(turn: &Self) -> Option<Self> {
        turn.cosine()
    }
    /// The greater root of x² − c; others where the coefficients are numbers and the root is rational.
    fn root(coefficients: &[Self], number: i64) -> Result<Self, RootError> {
        let numbers: Option<Vec<Rational>> =
            coefficients.iter().map(IntegerFunction::as_constant).collect();
        if let Some(Ok(root)) = numbers.map(|numbers| rational_root(&numbers, number)) {
            return Ok(IntegerFunction::from_rational(&root));
        }
        let is = |c: &IntegerFunction, n: i64| c.as_constant() == Some(Rational::from(n));
        match (coefficients, number) {
            ([negative, middle, leading], 2) if is(middle, 0) && is(leading, 1) => {
                let square = IntegerFunction::zero().minus(negative);
                square.square_root().ok_or(RootError::NotHere)
            }
            _ => Err(RootError::NotHere),
        }
    }
}
