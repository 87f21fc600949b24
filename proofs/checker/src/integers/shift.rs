//! Formulas of weights that depend on the difference of two indices only, by their text.

#![warn(clippy::arithmetic_side_effects)]

use crate::formulas::{Definitions, Expr, Head};
use crate::numbers::{Meter, Q};
use crate::text::Stop;
use num_traits::{One as _, Zero};

/// The indices of a new point and of an old one.
pub const INDICES: [&str; 2] = ["i", "j"];

/// The greatest depth of formulas with those that they name.
const MAX_DEPTH: usize = 200;

/// Formulas with those that names stand for.
pub struct Shifts<'s> {
    pub meter: &'s Meter,
    pub definitions: &'s Definitions,
}

impl Shifts<'_> {
    /// How much greater a value becomes if both indices become greater by 1; `None` if the text does not show that.
    pub fn of(&self, expr: &Expr, depth: usize) -> Result<Option<Q>, Stop> {
        self.meter.spend(1)?;
        if depth >= MAX_DEPTH {
            return Err(Stop::Capped("the nesting of formulas"));
        }
        let deeper = depth.saturating_add(1);
        match expr {
            Expr::Number(_) => Ok(Some(Q::zero())),
            Expr::Name(name) if INDICES.contains(&name.as_str()) => Ok(Some(Q::one())),
            Expr::Name(name) => match self.definitions.get(name) {
                Some(definition) => self.of(definition, deeper),
                None => Ok(Some(Q::zero())),
            },
            Expr::Of(head, parts) => {
                let shifts = parts.iter().map(|part| self.of(part, deeper));
                let Some(shifts) = shifts.collect::<Result<Option<Vec<Q>>, Stop>>()? else {
                    return Ok(None);
                };
                Ok(joined(head, parts, &shifts))
            }
        }
    }
}

/// The same of an operation on values that become greater by so much.
fn joined(head: &Head, parts: &[Expr], shifts: &[Q]) -> Option<Q> {
    let still = || shifts.iter().all(Zero::is_zero).then(Q::zero);
    match head {
        Head::Minus => shifts.first().map(|shift| -shift),
        Head::Chain(operators) if operators.iter().all(|sign| matches!(sign, '+' | '-')) => {
            let (first, rest) = shifts.split_first()?;
            let signed =
                |(sign, shift): (&char, &Q)| if *sign == '-' { -shift } else { shift.clone() };
            Some(operators.iter().zip(rest).map(signed).fold(first.clone(), |sum, x| sum + x))
        }
        Head::Chain(operators) => still().or_else(|| multiple(operators, parts, shifts)),
        Head::Call(name, options) if options.is_empty() => match shifts {
            [a, b] if name == "kronecker" && a == b => Some(Q::zero()),
            _ => still(),
        },
        Head::Power => still(),
        Head::Over(_, index) if !INDICES.contains(&index.as_str()) => still(),
        Head::Over(..) | Head::Call(..) | Head::Member(_) => None,
    }
}

/// A product of written numbers and one other factor, over written numbers.
fn multiple(operators: &[char], parts: &[Expr], shifts: &[Q]) -> Option<Q> {
    let mut product = Q::one();
    let mut found = false;
    let signs = std::iter::once(&'*').chain(operators);
    for ((sign, part), shift) in signs.zip(parts).zip(shifts) {
        match part {
            Expr::Number(value) => {
                let number = value.rational()?;
                if *sign != '/' {
                    product *= number;
                } else if number.is_zero() {
                    return None;
                } else {
                    product /= number;
                }
            }
            _ if found || *sign == '/' => return None,
            _ => {
                product *= shift;
                found = true;
            }
        }
    }
    Some(product)
}
