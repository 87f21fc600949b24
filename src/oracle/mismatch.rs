//! An f64 that is not what it should be, and how to say so.

use crate::exact::{Rational, RealCyclotomic, format};
use crate::float::{hexadecimal, nearest, shortest, ulps_between};
use std::fmt::{self, Display};

/// The longest p/q that a message shows in full.
const MAX_SHOWN: usize = 100;

/// How far an f64 may be off.
#[derive(Clone, Debug, PartialEq)]
pub enum Tolerance {
    /// In units in the last place of the nearest f64.
    Ulps(f64),
    /// In absolute terms.
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

/// One f64 that is farther from its exact value than was allowed.
#[derive(Clone, Debug, PartialEq)]
pub struct Deviation {
    /// The place in the slice, if there was one.
    pub index: Option<usize>,
    /// The f64 that was found.
    pub value: f64,
    /// The value that it stands for.
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

/// p/q or a sum of cosines, or its length if that is beyond reason.
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

/// Why f64 values are not what they should be.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Mismatch {
    /// One value is too far off.
    #[error("an f64 is not within {tolerance} of its exact value\n{deviation}")]
    Value {
        /// What was allowed.
        tolerance: Tolerance,
        /// What was found.
        deviation: Box<Deviation>,
    },
    /// Some values of a slice are too far off.
    #[error(
        "{wrong} of {total} f64 are not within {tolerance} of their exact values\nthe first:\n\
         {first}\nthe worst:\n{worst}"
    )]
    Slice {
        /// What was allowed.
        tolerance: Tolerance,
        /// How many are too far off.
        wrong: usize,
        /// Of how many.
        total: usize,
        /// The first of them.
        first: Box<Deviation>,
        /// The one that is most units in the last place off; one that is not finite
        /// counts as worse than any other.
        worst: Box<Deviation>,
    },
    /// The two slices differ in length.
    #[error("{values} f64 were compared with {exact} exact values")]
    Length {
        /// How many f64.
        values: usize,
        /// How many exact values.
        exact: usize,
    },
}
