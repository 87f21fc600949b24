//! Expressions with square roots and roots of polynomials as values of formulas.

use super::value::Value;
use crate::exact::{
    self, CosineError, FieldError, Integer, Rational, Real as _, RealCyclotomic, RealExpression,
    Scalar as _,
};
use crate::formula::root_error::RootError;

/// How many binary digits are computed to find a sign. Where they do not decide, a formula has no value.
const SIGN_BITS: u64 = 10_000;

/// The size that counts for a number with roots: enclosures of it are short, but all of its operations are done
/// again for each. This is the size of four nested operations.
const ROOT_BITS: u64 = 512;

/// The most nested operations in a number with roots: its functions call themselves for the inner ones.
const MAX_DEPTH: u32 = 600;

impl Value for RealExpression {
    fn as_rational(&self) -> Option<Rational> {
        // Whether a number with roots is rational is not asked: it may take very long.
        self.as_number()?.as_rational().cloned()
    }
    fn size(&self) -> u64 {
        match (self.as_number(), self.depth()) {
            (Some(number), _) => number.bits(),
            (None, depth) if depth <= MAX_DEPTH => ROOT_BITS * (1 + u64::from(depth) / 4),
            (None, _) => u64::MAX,
        }
    }
    fn product_size(&self, other: &Self) -> u64 {
        match (self.as_number(), other.as_number()) {
            (Some(a), Some(b)) => a.product_size(b),
            _ => self.size().saturating_add(other.size()),
        }
    }
    fn quotient_size(&self, divisor: &Self) -> u64 {
        match (self.as_number(), divisor.as_number()) {
            (Some(a), Some(b)) => a.quotient_size(b),
            _ => self.product_size(divisor),
        }
    }
    fn quotient(&self, divisor: &Self) -> Option<Self> {
        (divisor.sign_within(SIGN_BITS)? != 0).then(|| self.over(divisor))
    }
    fn absolute(&self) -> Option<Self> {
        let negative = self.sign_within(SIGN_BITS)? < 0;
        Some(if negative { RealExpression::zero().minus(self) } else { self.clone() })
    }
    fn larger(&self, other: &Self) -> Option<Self> {
        let less = self.minus(other).sign_within(SIGN_BITS)? < 0;
        Some(if less { other.clone() } else { self.clone() })
    }
    fn floor(&self) -> Option<Integer> {
        if let Some(number) = self.as_number() {
            return Some(number.floor());
        }
        let floor = self.near(1).lower().floor();
        let next = Rational::from(&floor + Integer::one());
        let at_least = |bound: &Rational| Some(self.compare_within(bound, SIGN_BITS)?.is_ge());
        let below = at_least(&Rational::from(floor.clone()))? && !at_least(&next)?;
        below.then_some(floor)
    }
    fn vanishes(&self) -> Option<bool> {
        self.sign_within(SIGN_BITS).map(|sign| sign == 0)
    }
    fn cosine(turn: &Rational) -> Result<Self, CosineError> {
        RealCyclotomic::cosine(turn).map(RealExpression::from)
    }
    fn root(coefficients: &[Self], number: i64) -> Result<Self, RootError> {
        if let [constant, linear, square] = coefficients
            && number == 2
            && Value::as_rational(linear) == Some(Rational::zero())
            && Value::as_rational(square) == Some(Rational::one())
        {
            return square_root(&RealExpression::zero().minus(constant));
        }
        let numbers: Option<Vec<RealCyclotomic>> =
            coefficients.iter().map(|one| one.as_number().cloned()).collect();
        let numbers = numbers.ok_or(RootError::Coefficients)?;
        let place = usize::try_from(number).unwrap_or(0);
        RealExpression::root(&numbers, place).map_err(|error| match error {
            exact::RootError::Constant => RootError::Field(FieldError::Zero),
            exact::RootError::Degree(_) => RootError::Degree,
            exact::RootError::Index { count, .. } => missing(count, number),
            _ => missing(0, number),
        })
    }
}

fn missing(found: usize, asked: i64) -> RootError {
    RootError::Field(FieldError::NoSuchRoot { found, asked })
}

/// √x, if x is known not to be negative.
fn square_root(x: &RealExpression) -> Result<RealExpression, RootError> {
    match x.sign_within(SIGN_BITS) {
        Some(0) => Ok(RealExpression::zero()),
        Some(1) => x.sqrt().map_err(|_| missing(0, 2)),
        Some(_) => Err(missing(0, 2)),
        None => Err(RootError::Undecided),
    }
}
