//! Closed intervals that enclose a real number.

use crate::exact::Rational;
use std::ops::{Add, Mul, Neg, Sub};

/// A closed interval [lower, upper] with rational ends that contains some real number.
///
/// The operations give the exact range: X ∘ Y is the set of all x ∘ y with x in X and y
/// in Y.
///
/// ```
/// use subcert::exact::{Enclosure, Rational};
///
/// let x = Enclosure::new(Rational::from(-1), Rational::from(2));
/// let y = Enclosure::new(Rational::from(3), Rational::from(4));
/// assert_eq!(&x * &y, Enclosure::new(Rational::from(-4), Rational::from(8)));
/// assert_eq!((x.sign(), y.sign()), (None, Some(1)));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Enclosure {
    lower: Rational,
    upper: Rational,
}

impl Enclosure {
    /// [lower, upper].
    ///
    /// # Panics
    /// When `lower` > `upper`.
    #[must_use]
    pub fn new(lower: Rational, upper: Rational) -> Enclosure {
        assert!(lower <= upper, "an interval from {lower} down to {upper}");
        Enclosure { lower, upper }
    }

    /// [value, value].
    #[must_use]
    pub fn exact(value: Rational) -> Enclosure {
        Enclosure { lower: value.clone(), upper: value }
    }

    /// The lower end.
    #[must_use]
    pub fn lower(&self) -> &Rational {
        &self.lower
    }

    /// The upper end.
    #[must_use]
    pub fn upper(&self) -> &Rational {
        &self.upper
    }

    /// The fraction with the least denominator in it, by continued fractions.
    ///
    /// ```
    /// use subcert::exact::{Enclosure, Rational};
    ///
    /// let near = Enclosure::new(Rational::new(62_499, 1_000_000), Rational::new(62_501, 1_000_000));
    /// assert_eq!(near.simplest(), Rational::new(1, 16));
    /// ```
    #[must_use]
    pub fn simplest(&self) -> Rational {
        let (mut lower, mut upper) = (self.lower().clone(), self.upper().clone());
        let mut quotients = Vec::new();
        let last = loop {
            let whole = lower.ceil();
            if Rational::from(whole.clone()) <= upper {
                break Rational::from(whole);
            }
            // Both ends lie strictly between two neighbouring integers.
            let floor = Rational::from(lower.floor());
            (lower, upper) = ((upper - &floor).recip(), (lower - &floor).recip());
            quotients.push(floor);
        };
        quotients.into_iter().rev().fold(last, |value, quotient| quotient + value.recip())
    }

    /// (lower + upper)/2.
    #[must_use]
    pub fn middle(&self) -> Rational {
        (&self.lower + &self.upper) / Rational::from(2)
    }

    /// upper − lower.
    #[must_use]
    pub fn width(&self) -> Rational {
        &self.upper - &self.lower
    }

    /// Whether `value` is in the interval.
    #[must_use]
    pub fn contains(&self, value: &Rational) -> bool {
        self.lower <= *value && *value <= self.upper
    }

    /// The common sign of all numbers in the interval: −1, 0 or 1; `None` when the signs
    /// differ.
    #[must_use]
    pub fn sign(&self) -> Option<i8> {
        let (lower, upper) = (self.lower.sign(), self.upper.sign());
        (lower == upper).then_some(lower)
    }
}

impl Neg for &Enclosure {
    type Output = Enclosure;
    fn neg(self) -> Enclosure {
        Enclosure { lower: -&self.upper, upper: -&self.lower }
    }
}

impl Add for &Enclosure {
    type Output = Enclosure;
    fn add(self, other: &Enclosure) -> Enclosure {
        Enclosure { lower: &self.lower + &other.lower, upper: &self.upper + &other.upper }
    }
}

impl Sub for &Enclosure {
    type Output = Enclosure;
    fn sub(self, other: &Enclosure) -> Enclosure {
        Enclosure { lower: &self.lower - &other.upper, upper: &self.upper - &other.lower }
    }
}

impl Mul for &Enclosure {
    type Output = Enclosure;
    fn mul(self, other: &Enclosure) -> Enclosure {
        let product = |x: &Rational| [x * &other.lower, x * &other.upper];
        let [a, b] = product(&self.lower);
        let [c, d] = product(&self.upper);
        let lower = (&a).min(&b).min(&c).min(&d).clone();
        let upper = a.max(b).max(c).max(d);
        Enclosure { lower, upper }
    }
}

/// A real number with enclosures of any width.
///
/// [`format`](super::format) prints such numbers correctly rounded, and
/// [`nearest`](crate::machine::nearest) converts them to f64.
pub trait Enclosed {
    /// An enclosure of this number. Its width is about 2^(−64·2^level); it is 0 at every
    /// level for a rational number.
    fn enclosure(&self, level: u32) -> Enclosure;

    /// The value of a monotone step function, such as rounding or truncation, at this
    /// number. `function` evaluates the step function at rationals. Its steps must be at
    /// rationals.
    ///
    /// The enclosure is refined until the function has the same value at both ends. This
    /// happens at some level, since an irrational number is not at a step.
    fn step<T: PartialEq>(&self, function: impl Fn(&Rational) -> T) -> T
    where
        Self: Sized,
    {
        let mut level = 0;
        loop {
            let enclosure = self.enclosure(level);
            let value = function(enclosure.lower());
            if enclosure.lower == enclosure.upper || value == function(enclosure.upper()) {
                return value;
            }
            level += 1;
        }
    }
}

impl Enclosed for Rational {
    fn enclosure(&self, _: u32) -> Enclosure {
        Enclosure::exact(self.clone())
    }
    fn step<T: PartialEq>(&self, function: impl Fn(&Rational) -> T) -> T {
        function(self)
    }
}

impl<E: Enclosed> Enclosed for &E {
    fn enclosure(&self, level: u32) -> Enclosure {
        (*self).enclosure(level)
    }
    fn step<T: PartialEq>(&self, function: impl Fn(&Rational) -> T) -> T {
        (*self).step(function)
    }
}
