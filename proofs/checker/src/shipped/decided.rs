//! Statements about every point of an enclosure.

use super::number::Written;
use super::rounding::ten;
use crate::numbers::{Q, int};
use crate::text::Stop;

/// The ends of an enclosure.
pub type Ends = (Q, Q);

/// A statement that holds for all points, for none, or perhaps for some.
pub fn decided(all: bool, none: bool, what: &'static str) -> Result<bool, Stop> {
    if all || none { Ok(all) } else { Err(Stop::Undecided(what)) }
}

/// Whether all points are in a closed interval.
pub fn within(x: &Ends, low: &Q, high: &Q, what: &'static str) -> Result<bool, Stop> {
    decided(*low <= x.0 && x.1 <= *high, x.1 < *low || *high < x.0, what)
}

/// Whether w is x, rounded to its digits.
pub fn is_rounded(x: &Ends, written: &Written) -> Result<bool, Stop> {
    let half = ten(-written.places) / int(2);
    let (low, high) = (&written.value - &half, &written.value + &half);
    within(x, &low, &high, "whether the number is rounded")
}
