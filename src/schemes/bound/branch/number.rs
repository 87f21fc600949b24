//! The integers that a search runs on.

use crate::exact::Integer;

/// Signed integers of a width that is chosen once for a search.
///
/// Integers of fixed width do not check for overflow. A search uses a width only if all
/// of its numbers provably fit.
pub(super) trait Number: Clone + Ord + Send + Sync {
    /// The type of the coefficients of the operator.
    type Coefficient: Send + Sync;

    fn zero() -> Self;

    fn one() -> Self;

    /// The coefficient, if it fits.
    fn coefficient(value: &Integer) -> Option<Self::Coefficient>;

    /// self += x·coefficient.
    fn add_product(&mut self, x: &Self, coefficient: &Self::Coefficient);

    /// self += x·factor, for |factor| < 2^63.
    fn add_times(&mut self, x: &Self, factor: i64);

    /// self·x.
    fn product(&self, x: &Self) -> Self;

    /// ⌈self/4⌉, for self ≥ 0.
    fn quarter(&self) -> Self;

    /// Converts an integer that is known to fit.
    fn from_integer(value: &Integer) -> Self;

    fn is_negative(&self) -> bool;

    fn negate(&mut self);

    fn to_integer(&self) -> Integer;

    fn magnitude(&self) -> Self {
        let mut magnitude = self.clone();
        if magnitude.is_negative() {
            magnitude.negate();
        }
        magnitude
    }

    /// self += |x|.
    fn add_magnitude(&mut self, x: &Self) {
        self.add_times(x, if x.is_negative() { -1 } else { 1 });
    }

    /// self + x.
    fn plus(mut self, x: &Self) -> Self {
        self.add_times(x, 1);
        self
    }

    /// self − x.
    fn minus(mut self, x: &Self) -> Self {
        self.add_times(x, -1);
        self
    }

    /// x·factor.
    fn times(x: &Self, factor: i64) -> Self {
        let mut product = Self::zero();
        product.add_times(x, factor);
        product
    }
}

impl Number for i128 {
    type Coefficient = i64;

    fn zero() -> i128 {
        0
    }

    fn one() -> i128 {
        1
    }

    fn coefficient(value: &Integer) -> Option<i64> {
        value.to_i64().filter(|value| *value > i64::MIN)
    }

    fn add_product(&mut self, x: &i128, coefficient: &i64) {
        self.add_times(x, *coefficient);
    }

    fn add_times(&mut self, x: &i128, factor: i64) {
        *self += x * i128::from(factor);
    }

    fn product(&self, x: &i128) -> i128 {
        self * x
    }

    fn quarter(&self) -> i128 {
        (self + 3) >> 2
    }

    fn from_integer(value: &Integer) -> i128 {
        value.to_i128().expect("the width was chosen for it")
    }

    fn is_negative(&self) -> bool {
        *self < 0
    }

    fn negate(&mut self) {
        *self = -*self;
    }

    fn to_integer(&self) -> Integer {
        Integer::from(*self)
    }
}

impl Number for Integer {
    type Coefficient = Integer;

    fn zero() -> Integer {
        Integer::zero()
    }

    fn one() -> Integer {
        Integer::one()
    }

    fn coefficient(value: &Integer) -> Option<Integer> {
        Some(value.clone())
    }

    fn add_product(&mut self, x: &Integer, coefficient: &Integer) {
        if !x.is_zero() {
            Integer::add_product(self, x, coefficient);
        }
    }

    fn add_times(&mut self, x: &Integer, factor: i64) {
        match factor {
            1 => *self += x,
            -1 => *self -= x,
            _ => self.add_product(x, &Integer::from(factor)),
        }
    }

    fn product(&self, x: &Integer) -> Integer {
        self * x
    }

    fn quarter(&self) -> Integer {
        (self + &Integer::from(3)).shifted_right(2)
    }

    fn from_integer(value: &Integer) -> Integer {
        value.clone()
    }

    fn is_negative(&self) -> bool {
        self.sign() < 0
    }

    fn negate(&mut self) {
        *self = -std::mem::replace(self, Integer::zero());
    }

    fn to_integer(&self) -> Integer {
        self.clone()
    }
}
