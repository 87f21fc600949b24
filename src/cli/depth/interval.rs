//! Intervals in a report.

use crate::cli::console::output::with_decimal;
use crate::cli::json::depth as form;
use subcert::exact::{Enclosure, Integer, Rational, format::short};
use subcert::report::json::Exact;

/// The most digits that an end of an interval can have here.
const DIGITS: u32 = 400;

/// Both ends as decimals, the lower one rounded down and the upper one up, to a tenth of
/// the width or less; of a single number its exact value.
pub(super) fn interval_text(interval: &Enclosure) -> String {
    let width = interval.width();
    if width.is_zero() {
        return with_decimal(interval.lower());
    }
    let mut places = 0;
    while Rational::power_of_ten(1 - places) > width {
        places += 1;
    }
    let scale = Rational::power_of_ten(places);
    let floor = |value: &Rational| value.numerator().div_floor(&value.denominator());
    let down: Integer = floor(&(interval.lower() * &scale));
    let up: Integer = -floor(&-(interval.upper() * &scale));
    let decimal = |value: Integer| short(&(Rational::from(value) / &scale), DIGITS);
    format!("{} to {}", decimal(down), decimal(up))
}

pub(super) fn interval_form(interval: &Enclosure) -> form::Interval {
    form::Interval { lower: Exact::of(interval.lower()), upper: Exact::of(interval.upper()) }
}
