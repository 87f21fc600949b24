//! Entries of matrices: fractions, or numbers of one real field.

use super::field::Field;
use crate::decimal::{Q, bits, int};
use crate::polynomial::signum;
use std::rc::Rc;

/// A real number that is computed with exactly.
pub trait Number: Clone {
    /// The number with these coordinates.
    fn of(coordinates: &[Q], field: Option<&Rc<Field>>) -> Self;
    /// The sum.
    fn plus(&self, other: &Self) -> Self;
    /// The product.
    fn times(&self, other: &Self) -> Self;
    /// The product with a fraction.
    fn scaled(&self, factor: &Q) -> Self;
    /// 1/x for x ≠ 0.
    fn inverse(&self) -> Self;
    /// −1, 0 or 1.
    fn sign(&self) -> i8;
    /// As a certificate writes it.
    fn text(&self) -> String;
    /// The steps of an operation with it.
    fn cost(&self) -> u64;

    /// A fraction.
    fn fraction(value: &Q) -> Self {
        Self::of(std::slice::from_ref(value), None)
    }
    /// An integer.
    fn whole(value: i64) -> Self {
        Self::fraction(&int(value))
    }
    /// The difference.
    fn minus(&self, other: &Self) -> Self {
        self.plus(&other.scaled(&int(-1)))
    }
    /// The absolute value.
    fn size(&self) -> Self {
        if self.sign() < 0 { self.scaled(&int(-1)) } else { self.clone() }
    }
}

/// The steps of an operation with a number of so many binary digits. Multiplication and division are quadratic.
pub fn steps(bits: u64) -> u64 {
    let blocks = bits / 512;
    1 + blocks + blocks * blocks
}

impl Number for Q {
    fn of(coordinates: &[Q], _: Option<&Rc<Field>>) -> Q {
        coordinates.first().cloned().unwrap_or_else(|| int(0))
    }
    fn plus(&self, other: &Q) -> Q {
        self + other
    }
    fn minus(&self, other: &Q) -> Q {
        self - other
    }
    fn times(&self, other: &Q) -> Q {
        self * other
    }
    fn scaled(&self, factor: &Q) -> Q {
        self * factor
    }
    fn inverse(&self) -> Q {
        self.recip()
    }
    fn sign(&self) -> i8 {
        signum(self)
    }
    fn text(&self) -> String {
        self.to_string()
    }
    fn cost(&self) -> u64 {
        steps(bits(self))
    }
}
