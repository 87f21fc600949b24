//! Sets of values of a parameter.

use crate::cli::console::quantity::written;
use subcert::exact::{
    Enclosed as _, IntervalSet, Rational, RealAlgebraic, SturmSequence,
    format::{fixed, short},
};
use subcert::report::json::{Interval, root_polynomial as polynomial};
use subcert::report::{Sheet, interval_texts};

/// The digits of a decimal in the text.
const DIGITS: u32 = 12;

/// The longest exact fraction that stands in the text in place of its decimal.
const SHOWN_LENGTH: usize = 16;

/// A set of values of a parameter, by its name: intervals in JSON.
pub(crate) struct Set(pub(crate) IntervalSet, String);

written!(set: Set => Vec<Interval>, Interval::all(&set.0, &set.1));

impl Set {
    pub(crate) fn of(set: &IntervalSet, parameter: &str) -> Set {
        Set(set.clone(), parameter.to_owned())
    }

    /// A set that is known exactly, one interval on a line.
    pub(crate) fn words(&self) -> String {
        self.or(&format!("no {}", self.1))
    }

    /// What is found of a set: where that is nothing, there may be some all the same.
    pub(crate) fn found(&self) -> String {
        self.or("none found")
    }

    fn or(&self, empty: &str) -> String {
        if self.0.is_empty() {
            return empty.to_owned();
        }
        interval_texts(&self.0, &self.1, "≤", number).join("\n")
    }
}

/// Says of the irrational ones of the ends of sets, and of other numbers, of which polynomials they are roots.
pub(crate) fn write_irrational<'n>(
    sheet: &mut Sheet,
    parameter: &str,
    sets: impl Iterator<Item = &'n Set>,
    numbers: impl Iterator<Item = &'n RealAlgebraic>,
) {
    let numbers = sets.flat_map(|set| set.0.ends()).map(|(end, _)| end).chain(numbers);
    let mut ends: Vec<&RealAlgebraic> = numbers.filter(|end| end.as_rational().is_none()).collect();
    ends.sort();
    ends.dedup();
    let fact = |end: &RealAlgebraic| {
        let root = format!("root of {}", polynomial(end, parameter));
        let (low, high) = decimal_enclosure(end);
        (number(end), format!("{root}\nthe only one between {low} and {high}"))
    };
    if !ends.is_empty() {
        sheet.heading(2, "Irrational numbers");
        sheet.facts(ends.into_iter().map(fact).collect());
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
