//! How sharp an edge or a vertex is.

use crate::exact::Rational;
use std::fmt;

/// The least number that means infinitely sharp, as in OpenSubdiv: an edge of sharpness 10 would
/// be smooth only after ten levels.
pub const INFINITE_FROM: i64 = 10;

/// The sharpness of an edge or a vertex that is not smooth.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::mesh::Sharpness;
///
/// let sharp = Sharpness::new(&Rational::new(3, 2)).expect("above 0");
/// assert_eq!(sharp.lowered(), Sharpness::new(&Rational::new(1, 2)));
/// assert_eq!(sharp.lowered().and_then(|sharp| sharp.lowered()), None);
/// assert_eq!(Sharpness::new(&Rational::from(10)), Some(Sharpness::Infinite));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Sharpness {
    /// A number s with 0 < s < 10: sharp for ⌈s⌉ levels.
    Finite(Rational),
    /// Sharp at every level.
    Infinite,
}

impl Sharpness {
    /// The sharpness of a number: `None` if it is not positive, and infinite from
    /// [`INFINITE_FROM`] on.
    #[must_use]
    pub fn new(value: &Rational) -> Option<Sharpness> {
        if value.sign() <= 0 {
            None
        } else if *value >= Rational::from(INFINITE_FROM) {
            Some(Sharpness::Infinite)
        } else {
            Some(Sharpness::Finite(value.clone()))
        }
    }

    /// The number, if it is finite.
    #[must_use]
    pub fn finite(&self) -> Option<&Rational> {
        match self {
            Sharpness::Finite(value) => Some(value),
            Sharpness::Infinite => None,
        }
    }

    /// The number as files have it: [`INFINITE_FROM`] if it is infinite.
    #[must_use]
    pub fn number(&self) -> Rational {
        self.finite().cloned().unwrap_or_else(|| Rational::from(INFINITE_FROM))
    }

    /// The sharpness one level later: s − 1, `None` (smooth) from 0 down.
    #[must_use]
    pub fn lowered(&self) -> Option<Sharpness> {
        match self {
            Sharpness::Finite(value) => Sharpness::new(&(value - &Rational::one())),
            Sharpness::Infinite => Some(Sharpness::Infinite),
        }
    }
}

impl fmt::Display for Sharpness {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.number())
    }
}
