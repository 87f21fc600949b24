//! Intervals with rational ends, which enclose real numbers.

use crate::numbers::{Q, bits, capped, signum};
use crate::text::Stop;
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Zero};
use std::cmp::Ordering;

/// The most binary digits of a rational number.
const MAX_BITS: u64 = 500_000;

/// The greatest absolute value of the exponent of an interval.
const MAX_EXPONENT: i64 = 1 << 20;

/// What is known of a real number.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Interval {
    /// The number.
    Point(Q),
    /// It is from low·2^exponent to high·2^exponent, low < high.
    Between {
        /// The lower end.
        low: BigInt,
        /// The upper end.
        high: BigInt,
        /// The exponent of both.
        exponent: i64,
    },
}

/// n·2^exponent.
fn scaled(n: &BigInt, exponent: i64) -> Q {
    let size = exponent.unsigned_abs();
    if exponent < 0 { Q::new(n.clone(), BigInt::one() << size) } else { Q::from_integer(n << size) }
}

/// The number of binary digits.
fn length(n: &BigInt) -> i64 {
    i64::try_from(n.bits()).unwrap_or(i64::MAX)
}

impl From<i64> for Interval {
    fn from(value: i64) -> Interval {
        Interval::Point(Q::from_integer(value.into()))
    }
}

impl Interval {
    /// A rational number, if it is not too long.
    pub fn point(value: Q) -> Result<Interval, Stop> {
        if bits(&value) > MAX_BITS {
            return Err(Stop::Capped("the size of a number"));
        }
        Ok(Interval::Point(value))
    }

    /// The interval from low·2^exponent to high·2^exponent, rounded outward to so many binary digits.
    pub fn new(low: BigInt, high: BigInt, exponent: i64, bits: u64) -> Result<Interval, Stop> {
        let exponent =
            capped(exponent, MAX_EXPONENT).ok_or(Stop::Capped("the exponent of a number"))?;
        if low == high {
            return Interval::point(scaled(&low, exponent));
        }
        let excess = low.bits().max(high.bits()).saturating_sub(bits);
        let exponent = exponent + i64::try_from(excess).unwrap_or(MAX_EXPONENT);
        // A shift of a negative integer rounds down too.
        Ok(Interval::Between { low: low >> excess, high: -(-high >> excess), exponent })
    }

    /// Integers l and h and an exponent e: the number is from l·2^e to h·2^e.
    pub fn cover(&self, bits: u64) -> (BigInt, BigInt, i64) {
        match self {
            Interval::Between { low, high, exponent } => (low.clone(), high.clone(), *exponent),
            Interval::Point(value) if value.is_zero() => Default::default(),
            Interval::Point(value) => {
                let (top, bottom) = (value.numer(), value.denom());
                let bits = i64::try_from(bits).unwrap_or(0);
                let exponent = length(top) - length(bottom) - bits;
                let size = exponent.unsigned_abs();
                let (top, bottom) = if exponent < 0 {
                    (top << size, bottom.clone())
                } else {
                    (top.clone(), bottom << size)
                };
                (top.div_floor(&bottom), -(-top).div_floor(&bottom), exponent)
            }
        }
    }

    /// The integers of [`Interval::cover`] of two numbers, with one exponent for both.
    pub fn aligned(&self, other: &Interval, bits: u64) -> ([BigInt; 2], [BigInt; 2], i64) {
        let ((a, b, e), (c, d, f)) = (self.cover(bits), other.cover(bits));
        let least = e.min(f);
        let at = |n: BigInt, exponent: i64| n << (exponent - least).unsigned_abs();
        ([at(a, e), at(b, e)], [at(c, f), at(d, f)], least)
    }

    /// Both ends.
    pub fn ends(&self) -> (Q, Q) {
        match self {
            Interval::Point(value) => (value.clone(), value.clone()),
            Interval::Between { low, high, exponent } => {
                (scaled(low, *exponent), scaled(high, *exponent))
            }
        }
    }

    /// The number, if it is known.
    pub fn exact(&self) -> Option<&Q> {
        if let Interval::Point(value) = self { Some(value) } else { None }
    }

    /// The binary digits of the ends.
    pub fn size(&self) -> u64 {
        match self {
            Interval::Point(value) => bits(value),
            Interval::Between { low, high, .. } => low.bits() + high.bits(),
        }
    }

    /// The sign, if all points have the same.
    pub fn sign(&self) -> Option<i8> {
        let (low, high) = match self {
            Interval::Point(value) => (value.numer(), value.numer()),
            Interval::Between { low, high, .. } => (low, high),
        };
        let signs = [low, high].map(signum);
        (signs[0] == signs[1]).then_some(signs[0])
    }

    /// How two numbers compare, if that is decided.
    pub fn compare(&self, other: &Interval) -> Option<Ordering> {
        let ((a, b), (c, d)) = (self.ends(), other.ends());
        if b < c {
            Some(Ordering::Less)
        } else if a > d {
            Some(Ordering::Greater)
        } else {
            (a == b && c == d && a == c).then_some(Ordering::Equal)
        }
    }
}
