//! Mismatches between f64 values and exact values, and their messages.

use crate::exact::{Rational, RealCyclotomic, format};
use crate::float::{hexadecimal, nearest, shortest, ulps_between};
use std::fmt::{self, Display};

/// The greatest length of a value that a message shows in full.
const MAX_SHOWN: usize = 100;

/// The allowed distance of an f64 from the exact value.
#[derive(Clone, Debug, PartialEq)]
pub enum Tolerance {
    /// In units in the last place of the nearest f64.
    Ulps(f64),
    /// In absolute value.
    Absolute(Rational),
}

impl fmt::Display for Tolerance {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Tolerance::Ulps(ulps) => write!(f, "{ulps} ulps"),
            Tolerance::Absolute(tolerance) => write!(f, "{}", shown(tolerance)),
        }
    }
}

/// An f64 that is farther from its exact value than allowed.
#[derive(Clone, Debug, PartialEq)]
pub struct Deviation {
    /// The index in the slice, if slices were compared.
    pub index: Option<usize>,
    /// The f64.
    pub value: f64,
    /// The exact value.
    pub exact: RealCyclotomic,
}

impl Deviation {
    /// The f64 nearest to the exact value.
    #[must_use]
    pub fn nearest(&self) -> f64 {
        nearest(&self.exact)
    }

    /// The distance in units in the last place; `None` when the f64 is not finite.
    #[must_use]
    pub fn ulps(&self) -> Option<RealCyclotomic> {
        ulps_between(self.value, &self.exact)
    }
}

/// p/q or a sum of cosines, or its number of digits if it is longer than [`MAX_SHOWN`].
fn shown(value: &impl Display) -> String {
    let text = value.to_string();
    let digits = |text: &str| text.bytes().filter(u8::is_ascii_digit).count();
    match text.contains("cos") {
        _ if text.len() <= MAX_SHOWN => text,
        true => format!("a sum of cosines of {} digits", digits(&text)),
        false => format!("p/q of {} digits", digits(&text)),
    }
}

impl fmt::Display for Deviation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let both = |value: f64| format!("{} ({})", shortest(value), hexadecimal(value));
        if let Some(index) = self.index {
            writeln!(f, "  at index     {index}")?;
        }
        writeln!(f, "  exact        {}", shown(&self.exact))?;
        writeln!(f, "  decimal      {}", format::scientific(&self.exact, 17))?;
        writeln!(f, "  nearest f64  {}", both(self.nearest()))?;
        writeln!(f, "  found f64    {}", both(self.value))?;
        match self.ulps() {
            Some(ulps) => write!(f, "  distance     {} ulps", format::short(&ulps, 4)),
            None => write!(f, "  distance     none: it is not finite"),
        }
    }
}

/// Why a check of f64 values failed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Mismatch {
    /// One value is too far off.
    #[error("an f64 is not within {tolerance} of its exact value\n{deviation}")]
    Value {
        /// The allowed distance.
        tolerance: Tolerance,
        /// The value that failed.
        deviation: Box<Deviation>,
    },
    /// Some values of a slice are too far off.
    #[error(
        "{wrong} of {total} f64 are not within {tolerance} of their exact values\nthe first:\n\
         {first}\nthe worst:\n{worst}"
    )]
    Slice {
        /// The allowed distance.
        tolerance: Tolerance,
        /// The number of values that failed.
        wrong: usize,
        /// The number of all values.
        total: usize,
        /// The first value that failed.
        first: Box<Deviation>,
        /// The value with the greatest distance in units in the last place. A value that
        /// is not finite counts as worse than all finite ones.
        worst: Box<Deviation>,
    },
    /// The two slices differ in length.
    #[error("{values} f64 were compared with {exact} exact values")]
    Length {
        /// The number of f64 values.
        values: usize,
        /// The number of exact values.
        exact: usize,
    },
}
