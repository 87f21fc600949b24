//! Real numbers of any kind as values of formulas: known exactly, or enclosed.

use super::value::Value;
use crate::exact::{
    CosineError, Enclosure, Integer, Rational, RealCyclotomic, RealExpression, Scalar,
};
use crate::formula::root_error::RootError;
use std::cmp::Ordering;
use std::fmt;

/// How many binary digits are computed to compare two numbers that are known exactly.
const BITS: u64 = 10_000;

/// The enclosures of exact numbers that are combined with others are about 2^−256 wide.
const LEVEL: u32 = 2;

/// A real number.
///
/// ```
/// use std::cmp::Ordering;
/// use subcert::exact::{Enclosure, Rational, Scalar};
/// use subcert::formula::{Parameters, RealValue, evaluate, parse};
///
/// let none = Parameters::<RealValue>::default();
/// let value = |text| evaluate(&parse(text).unwrap(), &none).unwrap();
/// assert_eq!(value("sqrt(5 + 2*sqrt(6))").compare(&value("sqrt(2) + √3")), Some(Ordering::Equal));
///
/// // A number from 1 to 2 is less than 3, and may be 3/2.
/// let enclosed = RealValue::enclosed(Enclosure::new(Rational::from(1), Rational::from(2)));
/// assert_eq!(enclosed.compare(&value("3")), Some(Ordering::Less));
/// assert_eq!(enclosed.times(&value("2")).compare(&value("3")), None);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum RealValue {
    /// It is this number.
    Exact(RealExpression),
    /// It is in this interval, which is no point.
    Enclosed(Enclosure),
}

impl From<RealExpression> for RealValue {
    fn from(value: RealExpression) -> RealValue {
        RealValue::Exact(value)
    }
}

impl RealValue {
    /// A number in this interval.
    #[must_use]
    pub fn enclosed(interval: Enclosure) -> RealValue {
        if interval.width().is_zero() {
            return RealValue::from_rational(interval.lower());
        }
        RealValue::Enclosed(interval)
    }

    /// An interval with the number; a point for a rational one that is written as such.
    #[must_use]
    pub fn interval(&self) -> Enclosure {
        match self {
            RealValue::Exact(value) => match Value::as_rational(value) {
                Some(value) => Enclosure::exact(value),
                None => value.near(LEVEL),
            },
            RealValue::Enclosed(interval) => interval.clone(),
        }
    }

    /// The number, if it is known exactly.
    #[must_use]
    pub fn exact(&self) -> Option<&RealExpression> {
        match self {
            RealValue::Exact(value) => Some(value),
            RealValue::Enclosed(_) => None,
        }
    }

    /// How two numbers compare; `None` where that is not decided.
    #[must_use]
    pub fn compare(&self, other: &RealValue) -> Option<Ordering> {
        if let (RealValue::Exact(a), RealValue::Exact(b)) = (self, other) {
            let sign = a.minus(b).sign_within(BITS).map(|sign| sign.cmp(&0));
            // Each number alone may lie in a small field where both together do not.
            return sign.or_else(|| Some(a.to_algebraic()?.cmp(&b.to_algebraic()?)));
        }
        let (a, b) = (self.interval(), other.interval());
        if a.upper() < b.lower() {
            return Some(Ordering::Less);
        }
        (b.upper() < a.lower()).then_some(Ordering::Greater)
    }

    /// Whether this is at most the other; `None` where that is not decided.
    #[must_use]
    pub fn is_at_most(&self, other: &RealValue) -> Option<bool> {
        // Enclosures that meet at one end decide this, though not the order.
        if self.interval().upper() <= other.interval().lower() {
            return Some(true);
        }
        self.compare(other).map(Ordering::is_le)
    }

    /// The number that both operations give: exactly, or in an interval.
    fn joined(
        &self,
        other: &RealValue,
        exact: fn(&RealExpression, &RealExpression) -> RealExpression,
        interval: fn(&Enclosure, &Enclosure) -> Enclosure,
    ) -> RealValue {
        match (self, other) {
            (RealValue::Exact(a), RealValue::Exact(b)) => RealValue::Exact(exact(a, b)),
            _ => RealValue::enclosed(interval(&self.interval(), &other.interval())),
        }
    }
}

impl fmt::Display for RealValue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            RealValue::Exact(value) => value.fmt(f),
            RealValue::Enclosed(interval) => {
                write!(f, "a number from {} to {}", interval.lower(), interval.upper())
            }
        }
    }
}

impl Scalar for RealValue {
    fn from_rational(value: &Rational) -> Self {
        RealValue::Exact(RealExpression::from(value.clone()))
    }
    fn plus(&self, other: &Self) -> Self {
        self.joined(other, RealExpression::plus, |a, b| a + b)
    }
    fn minus(&self, other: &Self) -> Self {
        self.joined(other, RealExpression::minus, |a, b| a - b)
    }
    fn times(&self, other: &Self) -> Self {
        self.joined(other, RealExpression::times, |a, b| a * b)
    }
}

impl Value for RealValue {
    fn as_rational(&self) -> Option<Rational> {
        Value::as_rational(self.exact()?)
    }
    fn number(&self) -> Option<RealCyclotomic> {
        self.exact()?.as_number().cloned()
    }
    fn of_number(number: &RealCyclotomic) -> Option<Self> {
        Some(RealExpression::from(number.clone()).into())
    }
    fn size(&self) -> u64 {
        match self {
            RealValue::Exact(value) => value.size(),
            RealValue::Enclosed(interval) => interval.lower().bits() + interval.upper().bits(),
        }
    }
    fn product_size(&self, other: &Self) -> u64 {
        match (self, other) {
            (RealValue::Exact(a), RealValue::Exact(b)) => a.product_size(b),
            _ => self.size().saturating_add(other.size()),
        }
    }
    fn quotient_size(&self, divisor: &Self) -> u64 {
        match (self, divisor) {
            (RealValue::Exact(a), RealValue::Exact(b)) => a.quotient_size(b),
            _ => self.product_size(divisor),
        }
    }
    fn quotient(&self, divisor: &Self) -> Option<Self> {
        if let (RealValue::Exact(a), RealValue::Exact(b)) = (self, divisor) {
            return a.quotient(b).map(RealValue::Exact);
        }
        let divisor = divisor.interval();
        divisor.sign().filter(|sign| *sign != 0)?;
        let inverse = Enclosure::new(divisor.upper().recip(), divisor.lower().recip());
        Some(RealValue::enclosed(&self.interval() * &inverse))
    }
    fn absolute(&self) -> Option<Self> {
        match self {
            RealValue::Exact(value) => value.absolute().map(RealValue::Exact),
            RealValue::Enclosed(_) => self.larger(&Self::zero().minus(self)),
        }
    }
    fn larger(&self, other: &Self) -> Option<Self> {
        if let (RealValue::Exact(a), RealValue::Exact(b)) = (self, other) {
            return a.larger(b).map(RealValue::Exact);
        }
        let (a, b) = (self.interval(), other.interval());
        let greater = |a: &Rational, b: &Rational| a.max(b).clone();
        let both = Enclosure::new(greater(a.lower(), b.lower()), greater(a.upper(), b.upper()));
        Some(RealValue::enclosed(both))
    }
    fn floor(&self) -> Option<Integer> {
        match self {
            RealValue::Exact(value) => Value::floor(value),
            RealValue::Enclosed(interval) => {
                let floor = interval.lower().floor();
                (floor == interval.upper().floor()).then_some(floor)
            }
        }
    }
    fn vanishes(&self) -> Option<bool> {
        match self {
            RealValue::Exact(value) => value.vanishes(),
            RealValue::Enclosed(interval) => interval.sign().map(|sign| sign == 0),
        }
    }
    fn cosine(turn: &Rational) -> Result<Self, CosineError> {
        RealExpression::cosine(turn).map(RealValue::Exact)
    }
    fn root(coefficients: &[Self], number: i64) -> Result<Self, RootError> {
        let exact: Option<Vec<RealExpression>> =
            coefficients.iter().map(|c| c.exact().cloned()).collect();
        let exact = exact.ok_or(RootError::Enclosed)?;
        <RealExpression as Value>::root(&exact, number).map(RealValue::Exact)
    }
}
