//! Verdicts, readings and places of shipped constants in words.

use crate::exact::{Rational, format::short};
use crate::report::words::numbers::grouped;
use crate::shipped::{
    DECIDING_BITS, Early, Misprint, NumberType, Outcome, Project, Reading, ShippedCell,
    ShippedClaim, Verdict,
};

/// The digits of an error.
const ERROR_DIGITS: u32 = 3;

/// What a mark means.
pub(crate) fn meaning(outcome: Outcome) -> &'static str {
    match outcome {
        Outcome::Nearest => "the nearest number of its type",
        Outcome::Cut | Outcome::Ulps => "rounded or cut to its digits, or off in the last places",
        Outcome::Misprint => "a misprint",
        Outcome::Otherwise => "another table than it is said to be",
        Outcome::Refuted => "wrong, or right to fewer digits than are written",
        Outcome::Open => "not decided",
    }
}

/// From so many digits on that agree, a number is not called wrong.
const FAIR_DIGITS: u32 = 3;

/// Whether a number is called wrong, and not right to fewer digits than are written.
pub(super) fn is_wrong(verdict: Verdict) -> bool {
    matches!(verdict, Verdict::Refuted(agree) if agree < FAIR_DIGITS)
}

/// What is said of a number of this type, which is written with so many digits.
pub(super) fn verdict(cell: &ShippedCell, kind: NumberType, written: Option<usize>) -> String {
    match cell.verdict {
        Verdict::Nearest => format!("the nearest {}", type_name(kind)),
        Verdict::Rounded(digits) => format!("rounded to {digits} digits"),
        Verdict::Cut(digits) => format!("cut after {digits} digits"),
        Verdict::Ulps(1) => "1 unit in the last place away".to_owned(),
        Verdict::Ulps(units) => format!("{units} units in the last place away"),
        Verdict::Misprint(slip) => format!("misprint: {}", slip_text(slip)),
        Verdict::Refuted(agree) if agree >= FAIR_DIGITS => {
            let of = written.map(|digits| format!(" of {digits}")).unwrap_or_default();
            format!("right to {agree}{of} digits only")
        }
        Verdict::Refuted(_) => {
            let by = cell.error.as_ref().map(|by| format!(" by {}", error(by)));
            format!("wrong{}", by.unwrap_or_default())
        }
        Verdict::Open => match &cell.exact {
            Ok(_) => format!("not decided within {} binary digits", grouped(DECIDING_BITS)),
            Err(cap) => format!("not decided: {cap}"),
        },
    }
}

fn slip_text(slip: Misprint) -> &'static str {
    match slip {
        Misprint::Sign => "the sign is wrong",
        Misprint::Point => "the point stands in the wrong place",
        Misprint::Digit => "one digit is wrong",
        Misprint::Exchanged => "two digits are exchanged",
        Misprint::Dropped => "a digit is missing",
    }
}

/// What a type is called in a sentence: `f32`, `decimal of 6 places`.
pub(super) fn type_name(kind: NumberType) -> String {
    match kind {
        NumberType::Single => "f32".to_owned(),
        NumberType::Double => "f64".to_owned(),
        NumberType::Decimal(1) => "decimal of 1 place".to_owned(),
        NumberType::Decimal(digits) => format!("decimal of {digits} places"),
    }
}

/// How a table came about.
pub(crate) fn reading(claim: &ShippedClaim, reading: &Reading) -> String {
    match reading {
        Reading::Convention(number) => {
            format!("The numbers follow another convention: {}.", claim.conventions[*number].label)
        }
        Reading::Early(name, early) => {
            let how = match early {
                Early::Places(1) => "rounded to 1 digit after the point".to_owned(),
                Early::Places(digits) => format!("rounded to {digits} digits after the point"),
                Early::Cut(1) => "cut after 1 digit behind the point".to_owned(),
                Early::Cut(digits) => format!("cut after {digits} digits behind the point"),
                Early::Single => "rounded to f32".to_owned(),
            };
            format!("{name} was {how} before it was used. This gives all numbers of the table.")
        }
    }
}

/// Where a number stands: `n = 3, k = 1`; empty of a table of one number.
pub(super) fn at(claim: &ShippedClaim, place: usize) -> String {
    let parts: Vec<String> =
        claim.at(place).iter().map(|(name, value)| format!("{name} = {value}")).collect();
    parts.join(", ")
}

/// As [`at`], after ` at `.
pub(super) fn after_at(claim: &ShippedClaim, place: usize) -> String {
    let at = at(claim, place);
    if at.is_empty() { at } else { format!(" at {at}") }
}

/// An error, to three digits.
pub(super) fn error(error: &Rational) -> String {
    short(error, ERROR_DIGITS)
}

/// The definitions that the formulas of a table use, with their formulas.
pub(super) fn definitions(project: &Project, claim: &ShippedClaim) -> Vec<(String, String)> {
    let used = project.used_by(&claim.exact);
    used.into_iter()
        .map(|name| (format!("where {name}"), project.definitions[name].text.clone()))
        .collect()
}

/// `1 number`, `3 numbers`.
pub(super) fn count(count: usize, one: &str, several: &str) -> String {
    if count == 1 { format!("1 {one}") } else { format!("{count} {several}") }
}
