//! Integers of a few words.

use super::number::Number;
use crate::exact::Integer;
use std::cmp::Ordering;

/// An integer mod 2^{64K} in two's complement, the least word first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Wide<const K: usize>([u64; K]);

/// The lower and the upper word.
#[expect(clippy::cast_possible_truncation, reason = "a word is cut out")]
fn split(value: u128) -> (u64, u64) {
    (value as u64, (value >> 64) as u64)
}

impl<const K: usize> Number for Wide<K> {
    type Coefficient = i64;

    fn zero() -> Self {
        Wide([0; K])
    }

    fn one() -> Self {
        let mut words = [0; K];
        words[0] = 1;
        Wide(words)
    }

    fn coefficient(value: &Integer) -> Option<i64> {
        i128::coefficient(value)
    }

    fn add_product(&mut self, x: &Self, coefficient: &i64) {
        self.add_times(x, *coefficient);
    }

    // Mod 2^{64K} the sign of x needs no care.
    fn add_times(&mut self, x: &Self, factor: i64) {
        let size = u128::from(factor.unsigned_abs());
        let mut carry = 0_u64;
        if factor >= 0 {
            for (sum, word) in self.0.iter_mut().zip(&x.0) {
                let next = u128::from(*word) * size + u128::from(*sum) + u128::from(carry);
                (*sum, carry) = split(next);
            }
        } else {
            for (sum, word) in self.0.iter_mut().zip(&x.0) {
                let (low, high) = split(u128::from(*word) * size + u128::from(carry));
                let (rest, borrow) = sum.overflowing_sub(low);
                *sum = rest;
                carry = high + u64::from(borrow);
            }
        }
    }

    fn is_negative(&self) -> bool {
        self.0[K - 1] >> 63 == 1
    }

    fn negate(&mut self) {
        let mut carry = true;
        for word in &mut self.0 {
            (*word, carry) = (!*word).overflowing_add(u64::from(carry));
        }
    }

    fn to_integer(&self) -> Integer {
        let magnitude = self.magnitude().0.iter().rev().fold(Integer::zero(), |sum, word| {
            if sum.is_zero() {
                Integer::from(*word)
            } else {
                sum.shifted_left(64) + Integer::from(*word)
            }
        });
        if self.is_negative() { -magnitude } else { magnitude }
    }
}

impl<const K: usize> Ord for Wide<K> {
    fn cmp(&self, other: &Self) -> Ordering {
        let words = || self.0.iter().rev().cmp(other.0.iter().rev());
        other.is_negative().cmp(&self.is_negative()).then_with(words)
    }
}

impl<const K: usize> PartialOrd for Wide<K> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}
