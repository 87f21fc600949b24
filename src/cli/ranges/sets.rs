//! Sets of values of a parameter, as text and as JSON.

use crate::cli::json::range as form;
use subcert::exact::{
    Enclosed as _, IntervalSet, Rational, RealAlgebraic, SturmSequence,
    format::{fixed, short},
};
use subcert::report::{interval_texts, json::root_polynomial as polynomial};

/// The digits of a decimal in the text.
const DIGITS: u32 = 12;

/// The longest exact fraction that stands in the text in place of its decimal.
const SHOWN_LENGTH: usize = 16;

/// A parameter, by its name.
#[derive(Clone, Copy)]
pub(crate) struct Parameter<'a>(pub(crate) &'a str);

impl Parameter<'_> {
    /// A set that is known exactly, one interval on a line.
    pub(crate) fn set(self, set: &IntervalSet) -> String {
        self.or(set, &format!("no {}", self.0))
    }

    /// What is found of a set: where that is nothing, there may be some all the same.
    pub(crate) fn found(self, set: &IntervalSet) -> String {
        self.or(set, "none found")
    }

    fn or(self, set: &IntervalSet, empty: &str) -> String {
        if set.is_empty() {
            return empty.to_owned();
        }
        interval_texts(set, self.0, "≤", number).join("\n")
    }

    /// The irrational ones of these numbers, each by its decimal, as roots.
    pub(crate) fn irrational<'n>(
        self,
        numbers: impl Iterator<Item = &'n RealAlgebraic>,
    ) -> Vec<(String, String)> {
        let mut ends: Vec<&RealAlgebraic> =
            numbers.filter(|end| end.as_rational().is_none()).collect();
        ends.sort();
        ends.dedup();
        let fact = |end: &RealAlgebraic| {
            let root = format!("root of {}", polynomial(end, self.0));
            let (low, high) = decimal_enclosure(end);
            (number(end), format!("{root}\nthe only one between {low} and {high}"))
        };
        ends.into_iter().map(fact).collect()
    }

    /// A set as JSON.
    pub(crate) fn set_form(self, set: &IntervalSet) -> Vec<form::Interval> {
        form::Interval::all(set, self.0)
    }

    /// A number as JSON.
    pub(crate) fn number_form(self, number: &RealAlgebraic) -> form::Number {
        form::Number::of(number, self.0)
    }
}

/// Short decimals below and above an irrational number, with no other root of its
/// polynomial between them.
fn decimal_enclosure(number: &RealAlgebraic) -> (String, String) {
    let sturm = SturmSequence::new(&number.polynomial());
    let mut places = 1;
    loop {
        let unit = Rational::power_of_ten(-places);
        let below = number.step(|x| (x / &unit).floor());
        let (low, high) =
            (Rational::from(below.clone()) * &unit, Rational::from(below) * &unit + &unit);
        if sturm.count_roots(&low, &high) == 1 {
            let text = |x: &Rational| fixed(x, places.unsigned_abs());
            return (text(&low), text(&high));
        }
        places += 1;
    }
}

/// A number, exact where that is short.
pub(crate) fn number(number: &RealAlgebraic) -> String {
    match number.as_rational().map(ToString::to_string) {
        Some(exact) if exact.len() <= SHOWN_LENGTH => exact,
        _ => short(number, DIGITS),
    }
}
