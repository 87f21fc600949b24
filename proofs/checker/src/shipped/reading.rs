//! How a table came about that is not what it is said to be.

#![warn(clippy::arithmetic_side_effects)]

use super::rounding::{SINGLE, rounded, ten};
use super::table::{Exact, Table};
use crate::enclosures::Interval;
use crate::formulas::Definitions;
use crate::numbers::Q;
use crate::text::{Checked, Reason, Stop};
use num_traits::Signed;

/// The most digits after the point that a definition is rounded to.
const MAX_PLACES: i64 = 17;

/// What a certificate says of the whole table.
pub enum Reading {
    /// It has the values of the convention at this place.
    Convention(usize),
    /// The definition of this name was rounded before it was used.
    Early(String, Rounding),
}

/// How a definition was rounded.
#[derive(Clone, Copy)]
pub enum Rounding {
    /// To so many digits after the point.
    Places(i64),
    /// Cut after so many digits.
    Cut(i64),
    /// To binary32.
    Single,
}

impl Reading {
    /// Reads `convention I`, counted from 1.
    pub fn convention(text: &str, table: &Table<'_>) -> Checked<Reading> {
        let place = text.parse::<usize>().ok().and_then(|number| number.checked_sub(1));
        let place = place.filter(|place| *place < table.conventions.len());
        Ok(Reading::Convention(
            place.ok_or_else(|| Reason::NotInFamily(format!("convention {text}")))?,
        ))
    }

    /// Reads `early NAME D`, `early NAME cut D` or `early NAME single`.
    pub fn early(text: &str, definitions: &Definitions) -> Checked<Reading> {
        let otherwise = || Reason::NotInFamily(format!("early {text}"));
        let places = |text: &str| {
            let places: Option<i64> = text.parse().ok();
            places.filter(|places| (1..=MAX_PLACES).contains(places)).ok_or_else(otherwise)
        };
        let (name, rounding) = match text.split_whitespace().collect::<Vec<_>>()[..] {
            [name, "single"] => (name, Rounding::Single),
            [name, "cut", digits] => (name, Rounding::Cut(places(digits)?)),
            [name, digits] => (name, Rounding::Places(places(digits)?)),
            _ => return Err(otherwise().into()),
        };
        if !definitions.contains_key(name) {
            return Err(otherwise().into());
        }
        Ok(Reading::Early(name.to_owned(), rounding))
    }

    /// The values of the numbers by this reading.
    pub fn exact<'t>(&self, table: &'t Table<'_>) -> &'t Exact {
        match self {
            Reading::Convention(place) => &table.conventions[*place],
            Reading::Early(..) => &table.exact,
        }
    }
}

impl Rounding {
    /// The rounded number, if it is decided which one this is.
    pub fn of(self, value: &Interval) -> Result<Interval, Stop> {
        let (low, high) = value.ends();
        let low = self.one(&low)?;
        if low == self.one(&high)? {
            return Interval::point(low);
        }
        Err(Stop::Undecided("to which number a definition is rounded"))
    }

    fn one(self, value: &Q) -> Result<Q, Stop> {
        Ok(match self {
            Rounding::Places(places) => rounded(value, places),
            Rounding::Cut(places) => {
                let size = (value.abs() * ten(places)).floor() / ten(places);
                if value.is_negative() { -size } else { size }
            }
            Rounding::Single => {
                SINGLE.round(value).ok_or(Stop::Capped("numbers that are not finite"))?
            }
        })
    }
}
