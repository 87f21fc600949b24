//! Arithmetic of intervals: the result encloses the results for all numbers in them.

use super::interval::Interval;
use crate::numbers::{Q, capped};
use crate::text::Stop;
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Pow, Signed, Zero};
use std::cmp::Ordering;

/// The most binary digits of a power of a rational number.
const MAX_BITS: u64 = 500_000;

impl Interval {
    /// −x.
    pub fn negated(&self) -> Interval {
        match self {
            Interval::Point(value) => Interval::Point(-value),
            Interval::Between { low, high, exponent } => {
                Interval::Between { low: -high, high: -low, exponent: *exponent }
            }
        }
    }

    /// |x|.
    pub fn absolute(&self) -> Interval {
        match (self.sign(), self) {
            (Some(1 | 0), _) => self.clone(),
            (Some(_), _) => self.negated(),
            (None, Interval::Between { low, .. }) if !low.is_negative() => self.clone(),
            (None, Interval::Between { low, high, exponent }) => Interval::Between {
                low: BigInt::zero(),
                high: low.abs().max(high.clone()),
                exponent: *exponent,
            },
            (None, Interval::Point(value)) => Interval::Point(value.abs()),
        }
    }

    /// The greater of two numbers.
    pub fn max(&self, other: &Interval, bits: u64) -> Result<Interval, Stop> {
        match self.compare(other) {
            Some(Ordering::Less) => return Ok(other.clone()),
            Some(_) => return Ok(self.clone()),
            None => {}
        }
        let ([a, b], [c, d], exponent) = self.aligned(other, bits);
        Interval::new(a.max(c), b.max(d), exponent, bits)
    }

    /// self + other.
    pub fn plus(&self, other: &Interval, bits: u64) -> Result<Interval, Stop> {
        match (self, other) {
            (Interval::Point(x), Interval::Point(y)) => Interval::point(x + y),
            (Interval::Point(x), _) if x.is_zero() => Ok(other.clone()),
            (_, Interval::Point(y)) if y.is_zero() => Ok(self.clone()),
            _ => {
                let ([a, b], [c, d], exponent) = self.aligned(other, bits);
                Interval::new(a + c, b + d, exponent, bits)
            }
        }
    }

    /// self − other.
    pub fn minus(&self, other: &Interval, bits: u64) -> Result<Interval, Stop> {
        self.plus(&other.negated(), bits)
    }

    /// self · other.
    pub fn times(&self, other: &Interval, bits: u64) -> Result<Interval, Stop> {
        match (self, other) {
            (Interval::Point(x), Interval::Point(y)) => Interval::point(x * y),
            (Interval::Point(x), _) | (_, Interval::Point(x)) if x.is_zero() => Ok(0.into()),
            _ => {
                let (a, b, e) = self.cover(bits);
                let (c, d, f) = other.cover(bits);
                let products = [&a * &c, &a * &d, &b * &c, &b * &d];
                let low = products.iter().min().cloned().unwrap_or_default();
                let high = products.into_iter().max().unwrap_or_default();
                Interval::new(low, high, e + f, bits)
            }
        }
    }

    /// 1/x.
    pub fn inverse(&self, bits: u64) -> Result<Interval, Stop> {
        match (self.sign(), self) {
            (Some(0), _) => Err(Stop::Undefined("it divides by 0")),
            (None, _) => Err(Stop::Undecided("whether a divisor is 0")),
            (_, Interval::Point(x)) => Ok(Interval::Point(x.recip())),
            (_, Interval::Between { low, high, exponent }) => {
                // Both ends have the same sign.
                let places = bits + low.bits().max(high.bits());
                let one = BigInt::one() << places;
                let (least, most) = (one.div_floor(high), -(-&one).div_floor(low));
                Interval::new(least, most, -exponent - i64::try_from(places).unwrap_or(0), bits)
            }
        }
    }

    /// x^exponent.
    pub fn power(&self, exponent: i64, bits: u64) -> Result<Interval, Stop> {
        let base = if exponent < 0 { self.inverse(bits)? } else { self.clone() };
        let size = exponent.unsigned_abs();
        if let Interval::Point(base) = &base {
            let short = base.numer().abs().is_one() && base.denom().is_one() || base.is_zero();
            let length = base.numer().bits() + base.denom().bits();
            if !short && length.saturating_mul(size) > MAX_BITS {
                return Err(Stop::Capped("the size of a power"));
            }
            return Ok(Interval::Point(Pow::pow(base.clone(), size)));
        }
        let power = |mut square: Interval| -> Result<Interval, Stop> {
            let (mut power, mut left) = (Interval::from(1), size);
            while left > 0 {
                if left % 2 == 1 {
                    power = power.times(&square, bits)?;
                }
                left /= 2;
                if left > 0 {
                    square = square.times(&square, bits)?;
                }
            }
            Ok(power)
        };
        match (size % 2, base.sign()) {
            (0, _) => power(base.absolute()),
            // Products of an interval around 0 contain all powers.
            _ => power(base),
        }
    }

    /// √x.
    pub fn root(&self, bits: u64) -> Result<Interval, Stop> {
        if let Interval::Point(value) = self
            && !value.is_negative()
        {
            let parts = [value.numer(), value.denom()];
            let [top, bottom] = parts.map(BigInt::sqrt);
            if &top * &top == *parts[0] && &bottom * &bottom == *parts[1] {
                return Ok(Interval::Point(Q::new(top, bottom)));
            }
        }
        match self.sign() {
            Some(-1) => return Err(Stop::Undefined("it is the square root of a negative number")),
            None => return Err(Stop::Undecided("whether a number under a root is negative")),
            Some(_) => {}
        }
        // √(n·2^(2h)) = √n·2^h; n gets twice the digits of the root.
        let (mut low, mut high, mut exponent) = self.cover(2 * bits + 2);
        let places = (2 * bits + 2).saturating_sub(low.bits());
        // The exponent becomes even.
        let places = places + (places ^ exponent.cast_unsigned()) % 2;
        (low, high) = (low << places, high << places);
        exponent -= i64::try_from(places).unwrap_or(0);
        let (least, most) = (low.sqrt(), high.sqrt());
        let most = if &most * &most == high { most } else { most + 1 };
        Interval::new(least, most, exponent.div_euclid(2), bits)
    }

    /// ⌊x⌋.
    pub fn floor(&self) -> Result<BigInt, Stop> {
        let (low, high) = self.ends();
        let floor = low.floor();
        if floor == high.floor() {
            Ok(floor.to_integer())
        } else {
            Err(Stop::Undecided("an integer part"))
        }
    }

    /// The integer that this is, if it is at most the limit in absolute value.
    pub fn integer(&self, limit: i64) -> Result<i64, Stop> {
        let Interval::Point(value) = self else {
            return Err(Stop::Undecided("whether a number is an integer"));
        };
        if !value.is_integer() {
            return Err(Stop::Wrong(format!("{value} is no integer")));
        }
        capped(value.numer(), limit).ok_or(Stop::Capped("the size of an integer"))
    }
}
