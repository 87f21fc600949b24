//! The names, in certificates, of quantities that a reading takes from another place of the paper.

use crate::numbers::{Q, read_rational};

/// A quantity from another place. Numbers are counted from 0.
#[derive(Clone, Debug)]
pub enum Copied<'r> {
    /// A definition has the printed numbers of the table with this id: `DEFINITION@ID`.
    Printed(&'r str, &'r str),
    /// A definition has its value for another value of a parameter: `DEFINITION@NAME=VALUE`.
    Parameter(&'r str, &'r str, Q),
    /// A definition has its value for another scheme of the tables: `DEFINITION@scheme#NUMBER`.
    Scheme(&'r str, usize),
    /// The tolerances are those at which the depth in this row or column is a whole number before
    /// it is rounded: `tolerance@line#NUMBER`.
    Tolerance(usize),
    /// The points of all schemes are numbered from this one on: `scheme@row#NUMBER`.
    Numbers(usize),
}

impl<'r> Copied<'r> {
    /// Reads the name of such a quantity.
    pub fn read(text: &'r str) -> Option<Copied<'r>> {
        let (of, from) = text.split_once('@')?;
        let number = |digits: &str| digits.parse::<usize>().ok()?.checked_sub(1);
        if let Some((name, value)) = from.split_once('=') {
            return Some(Copied::Parameter(of, name, read_rational(value)?));
        }
        match from.split_once('#') {
            Some(("scheme", place)) => Some(Copied::Scheme(of, number(place)?)),
            Some(("line", place)) if of == "tolerance" => Some(Copied::Tolerance(number(place)?)),
            Some(("row", place)) if of == "scheme" => {
                Some(Copied::Numbers(number(place).filter(|first| *first > 0)?))
            }
            Some(_) => None,
            None => Some(Copied::Printed(of, from)),
        }
    }
}
