//! The four operations.

use super::node::{Generator, Operation, RealExpression};
use super::size::Size;
use crate::exact::{CosineError, Rational, Real, RealCyclotomic, Scalar, common_conductor};
use std::sync::Arc;

impl RealExpression {
    /// The number in one field Q(2cos(2π/n)), if both are in one within the cap.
    fn in_field(
        &self,
        other: &RealExpression,
        operate: impl FnOnce(&RealCyclotomic, &RealCyclotomic) -> RealCyclotomic,
    ) -> Option<RealExpression> {
        let (a, b) = (self.as_number()?, other.as_number()?);
        let fits: Result<u32, CosineError> = common_conductor(a.conductor(), b.conductor());
        fits.ok().map(|_| RealExpression::from(operate(a, b)))
    }

    fn is(&self, value: i64) -> bool {
        let number = self.as_number().and_then(RealCyclotomic::as_rational);
        number.is_some_and(|number| *number == Rational::from(value))
    }

    fn radicand(&self) -> Option<&RealExpression> {
        match &self.0.operation {
            Operation::Root(generator) => match &**generator {
                Generator::Square(radicand) => Some(radicand),
                Generator::Isolated(_) => None,
            },
            _ => None,
        }
    }

    /// self·other, written as a product also where both are in one field Q(2cos(2π/n)): the product of two
    /// sums of cosines may be a much longer sum.
    #[must_use]
    pub fn times_apart(&self, other: &RealExpression) -> RealExpression {
        let plain = |one: &RealExpression| {
            one.as_number().is_none_or(|number| number.as_rational().is_some())
        };
        if plain(self) || plain(other) {
            return self.times(other);
        }
        let size = self.0.size.times(&other.0.size);
        self.joined(other, Operation::Product(self.clone(), other.clone()), size)
    }

    fn joined(&self, other: &RealExpression, operation: Operation, size: Size) -> RealExpression {
        RealExpression::node(operation, size, self.0.field.with(&other.0.field))
    }
}

impl Scalar for RealExpression {
    fn from_rational(value: &Rational) -> Self {
        RealExpression::from(value.clone())
    }
    fn plus(&self, other: &Self) -> Self {
        if self.is(0) {
            return other.clone();
        }
        if other.is(0) {
            return self.clone();
        }
        self.in_field(other, |a, b| a + b).unwrap_or_else(|| {
            let size = self.0.size.plus(&other.0.size);
            self.joined(other, Operation::Sum(self.clone(), other.clone()), size)
        })
    }
    fn minus(&self, other: &Self) -> Self {
        if other.is(0) {
            return self.clone();
        }
        self.in_field(other, |a, b| a - b).unwrap_or_else(|| {
            let size = self.0.size.plus(&other.0.size);
            self.joined(other, Operation::Difference(self.clone(), other.clone()), size)
        })
    }
    fn times(&self, other: &Self) -> Self {
        if self.is(0) || other.is(1) {
            return self.clone();
        }
        if other.is(0) || self.is(1) {
            return other.clone();
        }
        if let Some(radicand) = self.radicand().filter(|_| Arc::ptr_eq(&self.0, &other.0)) {
            return radicand.clone();
        }
        self.in_field(other, |a, b| a * b).unwrap_or_else(|| {
            let size = self.0.size.times(&other.0.size);
            self.joined(other, Operation::Product(self.clone(), other.clone()), size)
        })
    }
}

impl Real for RealExpression {
    fn magnitude(&self) -> Self {
        if self.sign() < 0 { RealExpression::zero().minus(self) } else { self.clone() }
    }
    fn greater(&self, other: &Self) -> Self {
        if self < other { other.clone() } else { self.clone() }
    }
    /// # Panics
    /// When `other` is 0.
    fn over(&self, other: &Self) -> Self {
        assert_ne!(other.sign(), 0, "division by zero");
        if other.is(1) {
            return self.clone();
        }
        self.in_field(other, |a, b| a / b).unwrap_or_else(|| {
            let size = self.0.size.over(&other.0.size);
            self.joined(other, Operation::Quotient(self.clone(), other.clone()), size)
        })
    }
}
