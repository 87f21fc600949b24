//! The types of numbers, and the numbers of a type that are nearest to a number.

use crate::numbers::{Q, int};
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Pow, Signed, ToPrimitive, Zero};
use std::cmp::Ordering;

/// The most digits of a decimal after its point.
const MAX_PLACES: u32 = 100;

/// A binary format of IEEE 754. Its numbers are counted from 0 on, ascending; the negative ones have
/// negative counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Format {
    /// The binary digits of a number.
    digits: u32,
    /// The exponent of the least positive number.
    least: i64,
    /// The exponent of the last digit of the greatest numbers.
    greatest: i64,
}

/// IEEE binary32.
pub const SINGLE: Format = Format { digits: 24, least: -149, greatest: 104 };

/// IEEE binary64.
pub const DOUBLE: Format = Format { digits: 53, least: -1074, greatest: 971 };

/// The type of the numbers of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Type {
    /// `f32` or `f64`.
    Binary(Format),
    /// `decimal:D`.
    Decimal(u32),
}

impl Type {
    /// The type of this name.
    pub fn read(name: &str) -> Option<Type> {
        match name {
            "f32" => Some(Type::Binary(SINGLE)),
            "f64" => Some(Type::Binary(DOUBLE)),
            _ => {
                let places: u32 = name.strip_prefix("decimal:")?.parse().ok()?;
                let plain = name == format!("decimal:{places}");
                (plain && (1..=MAX_PLACES).contains(&places)).then_some(Type::Decimal(places))
            }
        }
    }

    /// The ends of the closed interval of the numbers to which none of the type is nearer than `held`.
    pub fn cell(self, held: &Q) -> (Q, Q) {
        match self {
            Type::Binary(format) => {
                let count = format.nearest(held);
                let middle = |side: i64| (held + format.value(count + side)) / int(2);
                (middle(-1), middle(1))
            }
            Type::Decimal(places) => {
                let half = ten(-i64::from(places)) / int(2);
                (held - &half, held + half)
            }
        }
    }

    /// The nearest number of the type; `None` beyond the greatest one.
    pub fn nearest(self, x: &Q) -> Option<Q> {
        match self {
            Type::Binary(format) => format.round(x),
            Type::Decimal(places) => Some(rounded(x, places.into())),
        }
    }

    /// How many numbers of the type `held` is away from the one that is nearest to x. `None` if there is
    /// no such number.
    pub fn steps(self, x: &Q, held: &Q) -> Option<u64> {
        let nearest = self.nearest(x)?;
        match self {
            Type::Binary(format) => {
                let counts = [&nearest, held].map(|number| format.nearest(number));
                Some(counts[0].abs_diff(counts[1]))
            }
            Type::Decimal(places) => {
                let steps = (nearest - held).abs() * ten(places.into());
                steps.is_integer().then(|| steps.to_integer().to_u64())?
            }
        }
    }
}

/// 10^exponent.
pub fn ten(exponent: i64) -> Q {
    let power = Pow::pow(BigInt::from(10), exponent.unsigned_abs());
    if exponent < 0 { Q::new_raw(BigInt::one(), power) } else { Q::from_integer(power) }
}

/// x rounded to so many digits after the point, half to even.
pub fn rounded(x: &Q, places: i64) -> Q {
    Q::from_integer(half_even(&(x * ten(places)))) / ten(places)
}

/// The integer nearest to x; of two, the even one.
pub fn half_even(x: &Q) -> BigInt {
    let (whole, rest) = x.numer().div_mod_floor(x.denom());
    let double: BigInt = rest * 2;
    let up = match double.cmp(x.denom()) {
        Ordering::Less => false,
        Ordering::Equal => whole.is_odd(),
        Ordering::Greater => true,
    };
    if up { whole + 1 } else { whole }
}

impl Format {
    /// The count of the number nearest to x, half to even. Numbers beyond the greatest one have the count
    /// after its own.
    fn nearest(self, x: &Q) -> i64 {
        let size = x.abs();
        if size.is_zero() {
            return 0;
        }
        let length = |n: &BigInt| i64::try_from(n.bits()).unwrap_or(i64::MAX / 4);
        // 2^(place − 1) < size < 2^(place + 1)
        let mut place = length(size.numer()) - length(size.denom());
        if size < power(place) {
            place -= 1;
        }
        let exponent = (place - i64::from(self.digits) + 1).max(self.least);
        if exponent > self.greatest {
            return self.infinite() * if x.is_negative() { -1 } else { 1 };
        }
        let mantissa = half_even(&(size / power(exponent)));
        let count = (exponent - self.least) << (self.digits - 1);
        let count = count + mantissa.to_i64().unwrap_or(0);
        if x.is_negative() { -count } else { count }
    }

    /// The count after that of the greatest number.
    fn infinite(self) -> i64 {
        ((self.greatest - self.least) << (self.digits - 1)) + (1 << self.digits)
    }

    /// The number of a count.
    fn value(self, count: i64) -> Q {
        let size = count.abs();
        let step = ((size >> (self.digits - 1)) - 1).max(0);
        let mantissa = size - (step << (self.digits - 1));
        let value = Q::from_integer(mantissa.into()) * power(self.least + step);
        if count < 0 { -value } else { value }
    }

    /// The number nearest to x, half to even. `None` if that is infinite.
    pub fn round(self, x: &Q) -> Option<Q> {
        let count = self.nearest(x);
        (count.unsigned_abs() < self.infinite().unsigned_abs()).then(|| self.value(count))
    }
}

/// 2^exponent.
fn power(exponent: i64) -> Q {
    let power = BigInt::one() << exponent.unsigned_abs();
    if exponent < 0 { Q::new_raw(BigInt::one(), power) } else { Q::from_integer(power) }
}
