//! Sets of values of a parameter.

use crate::cli::console::quantity::written;
use subcert::exact::{
    Enclosed as _, IntervalSet, Rational, RealAlgebraic, SturmSequence,
    format::{fixed, short},
};
use subcert::report::json::Interval;
use subcert::report::{Sheet, found_texts, interval_texts, number, polynomial, proved_texts};

/// A set of values of a parameter, by its name: intervals in JSON.
pub(crate) struct Set(pub(crate) IntervalSet, String);

written!(set: Set => Vec<Interval>, Interval::all(&set.0, &set.1));

impl Set {
    pub(crate) fn of(set: &IntervalSet, parameter: &str) -> Set {
        Set(set.clone(), parameter.to_owned())
    }

    /// A set that is known exactly, one interval on a line.
    pub(crate) fn words(&self) -> String {
        lines(&interval_texts(&self.0, &self.1), &format!("no {}", self.1))
    }

    /// What is found of a set: where that is nothing, there may be some all the same.
    pub(crate) fn found(&self) -> String {
        lines(&found_texts(&self.0, &self.1), "none found")
    }

    /// The same, beside the set for which the opposite is proved.
    pub(crate) fn proved(&self, opposite: &Set) -> String {
        lines(&proved_texts(&self.0, &opposite.0, &self.1), "none found")
    }
}

fn lines(texts: &[String], empty: &str) -> String {
    if texts.is_empty() { empty.to_owned() } else { texts.join("\n") }
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
        let name = number(end);
        let decimal =
            if name.contains('√') { format!("{}, ", short(end, 12)) } else { String::new() };
        (name, format!("{decimal}{root}\nthe only one between {low} and {high}"))
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
