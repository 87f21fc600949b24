//! Real numbers with proven errors.

use crate::exact::{Enclosed, Enclosure, Integer, Rational, Scalar};

/// The ends are multiples of 2^(−BITS).
const BITS: u32 = 192;

/// An interval around a real number. The ends of results are rounded outward, so that they stay short.
#[derive(Clone, Debug)]
pub struct Ball(Enclosure);

impl Ball {
    /// A number of about 128 correct binary digits.
    #[must_use]
    pub fn of(number: &impl Enclosed) -> Ball {
        Ball::outward(&number.enclosure(1))
    }

    /// Any number of an interval.
    #[must_use]
    pub fn within(interval: &Enclosure) -> Ball {
        Ball::outward(interval)
    }

    /// The interval.
    #[must_use]
    pub fn enclosure(&self) -> &Enclosure {
        &self.0
    }

    /// The sign of the number; `None` where the interval does not show it.
    #[must_use]
    pub fn sign(&self) -> Option<i8> {
        self.0.sign()
    }

    /// Whether the interval shows that the number is not 0.
    #[must_use]
    pub fn is_apart(&self) -> bool {
        matches!(self.sign(), Some(1 | -1))
    }

    fn outward(exact: &Enclosure) -> Ball {
        let scale = Integer::one().shifted_left(BITS);
        let times = |x: &Rational| x * &Rational::from(scale.clone());
        let over = |x: Integer| Rational::new(x, scale.clone());
        Ball(Enclosure::new(over(times(exact.lower()).floor()), over(times(exact.upper()).ceil())))
    }
}

impl Scalar for Ball {
    fn from_rational(value: &Rational) -> Self {
        Ball::outward(&Enclosure::exact(value.clone()))
    }
    fn plus(&self, other: &Self) -> Self {
        Ball(&self.0 + &other.0)
    }
    fn minus(&self, other: &Self) -> Self {
        Ball(&self.0 - &other.0)
    }
    fn times(&self, other: &Self) -> Self {
        Ball::outward(&(&self.0 * &other.0))
    }
}
