//! Real numbers between multiples of 2^−PLACES.

use crate::enclosures::Interval;
use crate::numbers::{Number, Q};
use crate::text::Stop;
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, Zero};

/// The binary places of both ends.
const PLACES: u64 = 320;

/// The binary digits of polynomials whose coefficients are such numbers.
pub const DIGITS: u64 = 2 * PLACES;

/// A number from low·2^−PLACES to high·2^−PLACES.
#[derive(Clone, Debug)]
pub struct Ball {
    low: BigInt,
    high: BigInt,
}

impl From<&Q> for Ball {
    fn from(value: &Q) -> Ball {
        let top = value.numer() << PLACES;
        Ball { low: top.div_floor(value.denom()), high: -(-top).div_floor(value.denom()) }
    }
}

impl From<i64> for Ball {
    fn from(value: i64) -> Ball {
        Ball::from(&Q::from_integer(value.into()))
    }
}

impl Ball {
    /// A number between two rational ones.
    pub fn between(low: &Q, high: &Q) -> Ball {
        Ball { low: Ball::from(low).low, high: Ball::from(high).high }
    }

    /// A number of a field Q(2cos(2π/n)).
    pub fn of(number: &Number) -> Result<Ball, Stop> {
        let (low, high) = Interval::of(number, PLACES)?.ends();
        Ok(Ball::between(&low, &high))
    }

    /// As an interval.
    pub fn interval(&self) -> Result<Interval, Stop> {
        let exponent = i64::try_from(PLACES).unwrap_or(i64::MAX).saturating_neg();
        Interval::new(self.low.clone(), self.high.clone(), exponent, DIGITS)
    }

    /// self + other.
    pub fn plus(&self, other: &Ball) -> Ball {
        Ball { low: &self.low + &other.low, high: &self.high + &other.high }
    }

    /// The sum of multiples.
    pub fn combined<'b>(terms: impl Iterator<Item = (&'b Ball, Q)>) -> Ball {
        terms.fold(Ball::from(0), |sum, (x, factor)| sum.plus(&x.times(&Ball::from(&factor))))
    }

    /// self − other.
    pub fn minus(&self, other: &Ball) -> Ball {
        Ball { low: &self.low - &other.high, high: &self.high - &other.low }
    }

    /// self · other.
    pub fn times(&self, other: &Ball) -> Ball {
        let (a, b, c, d) = (&self.low, &self.high, &other.low, &other.high);
        let products = [a * c, a * d, b * c, b * d];
        let low = products.iter().min().cloned().unwrap_or_default();
        let high = products.into_iter().max().unwrap_or_default();
        // A shift of a negative integer rounds down too.
        Ball { low: low >> PLACES, high: -(-high >> PLACES) }
    }

    /// 1/self; `None` where it may be 0.
    pub fn inverse(&self) -> Option<Ball> {
        self.sign()?;
        let unit = BigInt::one() << (2 * PLACES);
        Some(Ball { low: unit.div_floor(&self.high), high: -(-&unit).div_floor(&self.low) })
    }

    /// 1 or −1, where all numbers between the ends have this sign; otherwise `None`.
    pub fn sign(&self) -> Option<i8> {
        if self.low.is_positive() {
            Some(1)
        } else if self.high.is_negative() {
            Some(-1)
        } else {
            None
        }
    }

    /// The least absolute value, as a number.
    pub fn least_size(&self) -> Ball {
        let size = match self.sign() {
            Some(_) => self.low.abs().min(self.high.abs()),
            None => BigInt::zero(),
        };
        Ball { low: size.clone(), high: size }
    }

    /// Whether it is certainly below the other.
    pub fn is_below(&self, other: &Ball) -> bool {
        self.high < other.low
    }
}
