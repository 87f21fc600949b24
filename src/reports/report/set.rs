//! Sets of values of a parameter, in words.

use crate::exact::{Interval, IntervalSet, RealAlgebraic, format::short};
use std::ops::Bound;

/// The digits of an irrational end.
const DIGITS: u32 = 12;

/// The longest exact fraction that stands in place of its decimal.
const LONGEST: usize = 12;

/// A set of values of a parameter: its irrational ends are decimals.
pub(super) fn set_text(set: &IntervalSet, variable: &str) -> String {
    if set.is_empty() {
        return format!("no {variable}");
    }
    let sign = |end: &Bound<RealAlgebraic>| match end {
        Bound::Included(_) => "<=",
        _ => "<",
    };
    let interval = |interval: &Interval| match (&interval.low, &interval.high) {
        (Bound::Unbounded, Bound::Unbounded) => format!("every {variable}"),
        (Bound::Included(low), Bound::Included(high)) if low == high => {
            format!("{variable} = {}", short(low, DIGITS))
        }
        (low, high) => {
            let left = place(low).map(|place| format!("{place} {} ", sign(low)));
            let right = place(high).map(|place| format!(" {} {place}", sign(high)));
            format!("{}{variable}{}", left.unwrap_or_default(), right.unwrap_or_default())
        }
    };
    set.intervals().iter().map(interval).collect::<Vec<String>>().join(" or ")
}

fn place(end: &Bound<RealAlgebraic>) -> Option<String> {
    let (Bound::Included(place) | Bound::Excluded(place)) = end else { return None };
    let rational = place.as_rational().map(ToString::to_string);
    let brief = rational.filter(|text| text.len() <= LONGEST);
    Some(brief.unwrap_or_else(|| short(place, DIGITS)))
}
