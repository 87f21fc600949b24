//! Numbers and masks in Coq's notation.

use crate::exact::{Integer, Rational};
use crate::scheme::Rules;

pub(super) fn rational(number: &Rational) -> String {
    if number.is_integer() && number.sign() >= 0 {
        return number.to_string();
    }
    format!("({} # {})", number.numerator(), number.denominator())
}

pub(super) fn integers(numbers: &[i64]) -> String {
    let numbers: Vec<String> = numbers.iter().map(ToString::to_string).collect();
    format!("[{}]%Z", numbers.join("; "))
}

pub(super) fn signed(number: i64) -> String {
    if number < 0 { format!("({number})") } else { number.to_string() }
}

/// The common denominator of all entries, and the rows times it.
pub(super) fn over_one(rows: &[Vec<Rational>]) -> (Integer, String) {
    let denominator = common(rows);
    (denominator.clone(), over(rows, &denominator))
}

fn common(rows: &[Vec<Rational>]) -> Integer {
    rows.iter().flatten().fold(Integer::one(), |common, entry| {
        let rest = (entry * Rational::from(common.clone())).denominator();
        common * rest
    })
}

fn over(rows: &[Vec<Rational>], denominator: &Integer) -> String {
    let times = |entry: &Rational| (entry * Rational::from(denominator.clone())).to_string();
    let row = |row: &Vec<Rational>| {
        format!("[{}]", row.iter().map(times).collect::<Vec<String>>().join("; "))
    };
    if let [only] = rows {
        return format!("{}%Z", row(only));
    }
    format!("[{}]%Z", rows.iter().map(row).collect::<Vec<String>>().join("; "))
}

pub(super) fn rules(rules: &Rules) -> String {
    rules_over(rules, rules)
}

/// Rules over the common denominator of a mask.
pub(super) fn rules_over(rules: &Rules, mask: &Rules) -> String {
    let denominator = common(mask.rows());
    format!("Scheme {denominator} {} {}", signed(mask.offset()), over(rules.rows(), &denominator))
}
