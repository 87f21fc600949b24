//! Real numbers with proven errors.

use crate::exact::{Enclosed, Enclosure, Integer, Rational, Scalar};

/// The ends are multiples of 2^(−BITS).
const BITS: u32 = 192;

/// An interval around a real number. The ends of results are rounded outward to multiples of 2^(−192), which are
/// integers here: they need no common divisors.
#[derive(Clone, Debug)]
pub struct Ball {
    lower: Integer,
    upper: Integer,
}

impl Ball {
    /// A number of about 128 correct binary digits.
    #[must_use]
    pub fn of(number: &impl Enclosed) -> Ball {
        Ball::within(&number.enclosure(1))
    }

    /// Any number of an interval.
    #[must_use]
    pub fn within(interval: &Enclosure) -> Ball {
        let (lower, upper) = (interval.lower(), interval.upper());
        let scaled = |x: &Rational| x.numerator().shifted_left(BITS);
        let ceiling = |x: &Rational| -(-scaled(x)).div_floor(&x.denominator());
        Ball { lower: scaled(lower).div_floor(&lower.denominator()), upper: ceiling(upper) }
    }

    /// The interval.
    #[must_use]
    pub fn enclosure(&self) -> Enclosure {
        Enclosure::new(self.lower(), self.upper())
    }

    /// Its lower end.
    #[must_use]
    pub fn lower(&self) -> Rational {
        over(&self.lower)
    }

    /// Its upper end.
    #[must_use]
    pub fn upper(&self) -> Rational {
        over(&self.upper)
    }

    /// The sign of the number; `None` where the interval does not show it.
    #[must_use]
    pub fn sign(&self) -> Option<i8> {
        let (lower, upper) = (self.lower.sign(), self.upper.sign());
        (lower == upper).then_some(lower)
    }

    /// Whether the interval shows that the number is not 0.
    #[must_use]
    pub fn is_apart(&self) -> bool {
        matches!(self.sign(), Some(1 | -1))
    }
}

fn over(end: &Integer) -> Rational {
    Rational::new(end.clone(), Integer::one().shifted_left(BITS))
}

impl Scalar for Ball {
    fn from_rational(value: &Rational) -> Self {
        Ball::within(&Enclosure::exact(value.clone()))
    }
    fn plus(&self, other: &Self) -> Self {
        Ball { lower: &self.lower + &other.lower, upper: &self.upper + &other.upper }
    }
    fn minus(&self, other: &Self) -> Self {
        Ball { lower: &self.lower - &other.upper, upper: &self.upper - &other.lower }
    }
    fn times(&self, other: &Self) -> Self {
        let product = |x: &Integer| [x * &other.lower, x * &other.upper];
        let [a, b] = product(&self.lower);
        let [c, d] = product(&self.upper);
        let lower = (&a).min(&b).min(&c).min(&d).shifted_right(BITS);
        let upper = a.max(b).max(c).max(d);
        Ball { lower, upper: -(-upper).shifted_right(BITS) }
    }
}
