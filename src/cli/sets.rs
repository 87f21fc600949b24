//! Sets of values of a parameter, as text and as JSON.

use super::json::range as form;
use std::ops::Bound;
use subcert::exact::{
    Enclosed as _, Integer, Interval, IntervalSet, Rational, RationalPolynomial, RealAlgebraic,
    SturmSequence,
    format::{fixed, short},
};
use subcert::report::{interval_texts, json::Exact};

/// The digits of a decimal in the text.
const DIGITS: u32 = 12;

/// The longest exact fraction that stands in the text in place of its decimal.
const SHOWN_LENGTH: usize = 16;

/// A parameter, by its name.
#[derive(Clone, Copy)]
pub(super) struct Parameter<'a>(pub(super) &'a str);

impl Parameter<'_> {
    /// A set that is known exactly, one interval on a line.
    pub(super) fn set(self, set: &IntervalSet) -> String {
        self.or(set, &format!("no {}", self.0))
    }

    /// What is found of a set: where that is nothing, there may be some all the same.
    pub(super) fn found(self, set: &IntervalSet) -> String {
        self.or(set, "none found")
    }

    fn or(self, set: &IntervalSet, empty: &str) -> String {
        if set.is_empty() {
            return empty.to_owned();
        }
        interval_texts(set, self.0, "≤", number).join("\n")
    }

    /// The irrational ones of these numbers, each by its decimal, as roots.
    pub(super) fn irrational<'n>(
        self,
        numbers: impl Iterator<Item = &'n RealAlgebraic>,
    ) -> Vec<(String, String)> {
        let mut ends: Vec<&RealAlgebraic> =
            numbers.filter(|end| end.as_rational().is_none()).collect();
        ends.sort();
        ends.dedup();
        let fact = |end: &RealAlgebraic| {
            let root = format!("root of {}", self.polynomial(end));
            let (low, high) = decimal_enclosure(end);
            (number(end), format!("{root}\nthe only one between {low} and {high}"))
        };
        ends.into_iter().map(fact).collect()
    }

    /// The minimal polynomial of a number.
    fn polynomial(self, number: &RealAlgebraic) -> String {
        let (polynomial, note) = match number.minimal_polynomial() {
            Some(minimal) => (minimal, ""),
            None => (number.polynomial(), ", which may have factors"),
        };
        let polynomial = RationalPolynomial::over(&polynomial, &Integer::one());
        format!("{}{note}", polynomial.describe(self.0))
    }

    /// A set as JSON.
    pub(super) fn set_form(self, set: &IntervalSet) -> Vec<form::Interval> {
        let end = |end: &Bound<RealAlgebraic>| place(end).map(|end| self.number_form(end));
        let interval = |interval: &Interval| form::Interval {
            low: end(&interval.low),
            high: end(&interval.high),
        };
        set.intervals().iter().map(interval).collect()
    }

    /// A number as JSON.
    pub(super) fn number_form(self, number: &RealAlgebraic) -> form::Number {
        let (low, high) = number.bounds();
        form::Number {
            value: Exact::of(number),
            minimal_polynomial: self.polynomial(number),
            enclosure: [low.to_string(), high.to_string()],
        }
    }
}

fn place(end: &Bound<RealAlgebraic>) -> Option<&RealAlgebraic> {
    match end {
        Bound::Unbounded => None,
        Bound::Included(place) | Bound::Excluded(place) => Some(place),
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
pub(super) fn number(number: &RealAlgebraic) -> String {
    match number.as_rational().map(ToString::to_string) {
        Some(exact) if exact.len() <= SHOWN_LENGTH => exact,
        _ => short(number, DIGITS),
    }
}
