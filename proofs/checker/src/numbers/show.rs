//! The display of values as formulas.

use super::decimal::Q;
use super::number::Number;
use super::value::Value;
use num_traits::Zero;
use std::fmt::{Display, Formatter, Result};
use std::rc::Rc;

/// The text of a sum of terms. A term is a coefficient and a factor.
fn sum(terms: impl Iterator<Item = (String, String)>) -> String {
    let term = |(coefficient, factor): (String, String)| match (&coefficient[..], &factor[..]) {
        (_, "") => coefficient,
        ("1", _) => factor,
        ("-1", _) => format!("-{factor}"),
        _ if coefficient.contains(' ') => format!("({coefficient})*{factor}"),
        _ => format!("{coefficient}*{factor}"),
    };
    let terms: Vec<String> = terms.map(term).collect();
    if terms.is_empty() { "0".to_owned() } else { terms.join(" + ").replace("+ -", "- ") }
}

fn power(base: &str, exponent: u32) -> String {
    if exponent == 1 { base.to_owned() } else { format!("{base}^{exponent}") }
}

impl Display for Number {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let (n, coefficients) = self.coordinates();
        let terms = (0..).zip(coefficients).filter(|(_, coefficient)| !coefficient.is_zero());
        let base = format!("(2*cos(2*pi/{n}))");
        let term = |(i, coefficient): (u32, Q)| {
            let factor = if i == 0 { String::new() } else { power(&base, i) };
            (coefficient.to_string(), factor)
        };
        f.write_str(&sum(terms.map(term)))
    }
}

impl Display for Value {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let term = |(monomial, coefficient): (&[(Rc<str>, u32)], &Number)| {
            let factors: Vec<String> = monomial.iter().map(|(name, i)| power(name, *i)).collect();
            (coefficient.to_string(), factors.join("*"))
        };
        f.write_str(&sum(self.all().map(term)))
    }
}

/// The text of a value, or `undefined`.
pub fn shown(value: Option<&Value>) -> String {
    value.map_or("undefined".to_owned(), Value::to_string)
}
