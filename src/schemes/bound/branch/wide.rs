//! Integers of a few words.

use super::number::Number;
use crate::exact::Integer;
use std::cmp::Ordering;

/// An integer mod 2^{64K} in two's complement, the least word first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Wide<const K: usize>([u64; K]);

impl<const K: usize> Wide<K> {
    /// The words without the upper ones that are 0.
    fn used(&self) -> &[u64] {
        let length = self.0.iter().rposition(|&word| word != 0).map_or(0, |last| last + 1);
        &self.0[..length]
    }
}

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

    // Modulo 2^{64K}, the sign of x plays no role.
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

    fn product(&self, x: &Self) -> Self {
        let (a, b) = (self.magnitude(), x.magnitude());
        let mut sum = Self::zero();
        for (shift, &word) in a.used().iter().enumerate() {
            let mut carry = 0;
            let words = b.used().iter().chain(std::iter::repeat(&0));
            for (sum, other) in sum.0[shift..].iter_mut().zip(words).take(b.used().len() + 1) {
                let next = u128::from(word) * u128::from(*other);
                (*sum, carry) = split(next + u128::from(*sum) + u128::from(carry));
            }
        }
        if self.is_negative() != x.is_negative() {
            sum.negate();
        }
        sum
    }

    fn quarter(&self) -> Self {
        let mut sum = self.plus(&Self::times(&Self::one(), 3));
        let mut upper = 0;
        for word in sum.0.iter_mut().rev() {
            (*word, upper) = (*word >> 2 | upper << 62, *word);
        }
        sum
    }

    fn from_integer(value: &Integer) -> Self {
        let mut rest = value.abs();
        let mut words = [0; K];
        let base = Integer::one().shifted_left(64);
        for word in &mut words {
            let (high, low) = rest.div_rem_floor(&base);
            *word = low.to_i128().and_then(|low| u64::try_from(low).ok()).expect("below 2^64");
            rest = high;
        }
        assert!(rest.is_zero(), "the width was chosen for it");
        let mut wide = Wide(words);
        if value.sign() < 0 {
            wide.negate();
        }
        wide
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
        let magnitude = Integer::from_words(&self.magnitude().0);
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
