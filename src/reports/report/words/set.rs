//! Sets of values of a parameter, in words.

use crate::exact::{Interval, IntervalSet, RealAlgebraic, format::short};
use std::ops::Bound;

/// The digits of an irrational end.
const DIGITS: u32 = 12;

/// The longest exact fraction that stands in place of its decimal.
const LONGEST: usize = 12;

/// The values of a parameter for which something is proved: its irrational ends are decimals. A search that
/// proves it for no value has found none, which is not to say that there are none.
pub(crate) fn set_text(set: &IntervalSet, variable: &str) -> String {
    if set.is_empty() {
        return format!("no {variable} that is found");
    }
    let number = |place: &RealAlgebraic| {
        let exact = place.as_rational().map(ToString::to_string);
        exact.filter(|text| text.len() <= LONGEST).unwrap_or_else(|| short(place, DIGITS))
    };
    interval_texts(set, variable, "<=", number).join(" or ")
}

/// Each interval of a set as a condition on a variable, such as `1/4 < w <= 1/2`, with this sign for `at most`
/// and numbers written so.
#[must_use]
pub fn interval_texts(
    set: &IntervalSet,
    variable: &str,
    at_most: &str,
    number: impl Fn(&RealAlgebraic) -> String,
) -> Vec<String> {
    let end = |end: &Bound<RealAlgebraic>| match end {
        Bound::Unbounded => None,
        Bound::Included(place) => Some((number(place), at_most.to_owned())),
        Bound::Excluded(place) => Some((number(place), "<".to_owned())),
    };
    let interval = |interval: &Interval| match (&interval.low, &interval.high) {
        (Bound::Unbounded, Bound::Unbounded) => format!("every {variable}"),
        (Bound::Included(low), Bound::Included(high)) if low == high => {
            format!("{variable} = {}", number(low))
        }
        (low, high) => {
            let left = end(low).map(|(place, sign)| format!("{place} {sign} "));
            let right = end(high).map(|(place, sign)| format!(" {sign} {place}"));
            format!("{}{variable}{}", left.unwrap_or_default(), right.unwrap_or_default())
        }
    };
    set.intervals().iter().map(interval).collect()
}
