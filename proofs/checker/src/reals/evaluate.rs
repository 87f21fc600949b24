//! The values of formulas as real numbers.

#![warn(clippy::arithmetic_side_effects)]

use super::known::{Digits, Known};
use crate::formulas::{Asked, Expr, Head, Indices, MAX_INTEGER, Range, Scope, of_nothing, range};
use crate::functions::real;
use crate::numbers::{Q, Value};
use crate::schemes::Library;
use crate::text::Stop;
use num_traits::Signed as _;
use std::cell::Cell;

/// The greatest depth of an evaluation.
const MAX_DEPTH: usize = 200;

/// The value of a function of a mask with roots that lie in no field of cosines; `None` if it is none.
pub type OfMask = fn(&Reals<'_>, Asked<'_>) -> Result<Option<Known>, Stop>;

/// The values of formulas with so many digits.
pub struct Reals<'r> {
    pub library: &'r Library<'r>,
    pub scope: &'r Scope<'r>,
    depth: Cell<usize>,
    digits: Digits<'r>,
    of_mask: OfMask,
}

impl<'r> Reals<'r> {
    pub fn new(
        library: &'r Library<'r>,
        scope: &'r Scope<'r>,
        bits: u64,
        of_mask: OfMask,
    ) -> Reals<'r> {
        let digits = Digits { bits, meter: library.meter };
        Reals { library, scope, depth: Cell::new(0), digits, of_mask }
    }

    /// The digits.
    pub fn digits(&self) -> Digits<'r> {
        self.digits
    }

    /// The value of a formula.
    pub fn value(&self, expr: &Expr) -> Result<Known, Stop> {
        self.evaluate(expr, &mut Vec::new())
    }

    /// As a formula of numbers of fields Q(2cos(2π/n)) if it is one, and otherwise by its parts.
    fn evaluate(&self, expr: &Expr, indices: &mut Indices) -> Result<Known, Stop> {
        let stop = match self.scope.evaluate(expr, indices) {
            Ok(value) => return self.digits.exact(value.number()?),
            Err(stop) => stop,
        };
        // A meter that has run out stays so.
        self.digits.meter.spend(1)?;
        if self.depth.get() == MAX_DEPTH {
            return Err(Stop::Capped("the nesting of formulas"));
        }
        self.depth.set(self.depth.get().saturating_add(1));
        let found = self.parts(expr, indices);
        self.depth.set(self.depth.get().saturating_sub(1));
        found?.ok_or(stop)
    }

    /// The value by those of the parts; `None` if there is no other way.
    fn parts(&self, expr: &Expr, indices: &mut Indices) -> Result<Option<Known>, Stop> {
        let digits = self.digits;
        Ok(Some(match expr {
            Expr::Name(name) => match self.scope.definitions.get(name) {
                Some(definition) if !self.scope.values.contains_key(name) => {
                    self.evaluate(definition, indices)?
                }
                _ => return Ok(None),
            },
            Expr::Of(Head::Minus, parts) if parts.len() == 1 => {
                self.evaluate(&parts[0], indices)?.negated(digits)?
            }
            Expr::Of(Head::Chain(operators), parts) => {
                let Some((first, rest)) = parts.split_first() else { return Ok(None) };
                let mut value = self.evaluate(first, indices)?;
                for (operator, part) in operators.iter().zip(rest) {
                    let right = self.evaluate(part, indices)?;
                    value = match operator {
                        '+' => digits.sum(&value, 1, &right)?,
                        '-' => digits.sum(&value, -1, &right)?,
                        '/' => digits.quotient(&value, &right)?,
                        _ => digits.product(&value, &right)?,
                    };
                }
                value
            }
            Expr::Of(Head::Power, parts) if parts.len() == 2 => {
                let exponent = self.scope.evaluate(&parts[1], indices)?.integer(64)?;
                let base = self.evaluate(&parts[0], indices)?;
                let mut power = digits.integer(1)?;
                for _ in 0..exponent.unsigned_abs() {
                    power = digits.product(&power, &base)?;
                }
                if exponent < 0 { digits.quotient(&digits.integer(1)?, &power)? } else { power }
            }
            Expr::Of(Head::Over(fold, index), parts) => self.over(fold, index, parts, indices)?,
            Expr::Of(head @ Head::Call(name, _), parts) => {
                return self.call((head, name), parts, indices);
            }
            _ => return Ok(None),
        }))
    }

    fn call(
        &self,
        (head, name): (&Head, &str),
        parts: &[Expr],
        indices: &mut Indices,
    ) -> Result<Option<Known>, Stop> {
        let digits = self.digits;
        let own = ["sqrt", "root", "abs", "max", "min", "floor", "ceil"];
        if own.contains(&name) {
            let values = parts.iter().map(|part| self.evaluate(part, indices));
            let values = values.collect::<Result<Vec<Known>, Stop>>()?;
            return Ok(Some(match (name, &values[..]) {
                ("sqrt", [x]) => digits.square_root(x)?,
                ("root", [coefficients @ .., number]) => {
                    let number = number.number.clone().map(Value::from);
                    let number =
                        number.ok_or(Stop::Wrong("the number of a root is an integer".into()))?;
                    digits.root_of(coefficients, number.integer(MAX_INTEGER)?)?
                }
                ("abs", [x]) => greater(x, &x.negated(digits)?)?,
                ("max", [first, rest @ ..]) => {
                    rest.iter().try_fold(first.clone(), |best, x| greater(&best, x))?
                }
                ("min", [first, rest @ ..]) => {
                    rest.iter().try_fold(first.clone(), |best, x| lesser(&best, x))?
                }
                ("floor", [x]) => self.floor(x)?,
                ("ceil", [x]) => self.floor(&x.negated(digits)?)?.negated(digits)?,
                _ => return Ok(None),
            }));
        }
        match name {
            // What it is asked of is an angle.
            "cos" => return Ok(None),
            "kronecker" | "mod" | "binomial" | "factorial" => {
                return Err(Stop::Capped("such a function of real numbers"));
            }
            _ => {}
        }
        let (parts, options) = self.scope.asked(head, parts, indices);
        let values = parts.iter().map(|part| self.scope.evaluate(part, indices));
        let values = values.collect::<Result<Vec<Value>, Stop>>()?;
        if let Some(found) = (self.of_mask)(self, (name, &values, &options))? {
            return Ok(Some(found));
        }
        let found = real(self.library, self.scope, (name, &values, &options))?;
        found.map(|found| digits.found(&found)).transpose()
    }

    fn over(
        &self,
        fold: &str,
        index: &str,
        parts: &[Expr],
        indices: &mut Indices,
    ) -> Result<Known, Stop> {
        let [from, to, body] = range(parts)?;
        self.scope.index(index)?;
        let from = self.scope.evaluate(from, indices)?.integer(MAX_INTEGER)?;
        let to = self.scope.evaluate(to, indices)?.integer(MAX_INTEGER)?;
        let range = Range { index, ends: [from, to], others: indices, value: Value::int };
        range.total(
            of_nothing(fold).map(|value| self.digits.integer(value)).transpose()?,
            |indices| self.evaluate(body, indices),
            |total, term| match fold {
                "sum" => self.digits.sum(total, 1, term),
                "product" => self.digits.product(total, term),
                "max" => greater(total, term),
                _ => lesser(total, term),
            },
        )
    }

    fn floor(&self, x: &Known) -> Result<Known, Stop> {
        if let Some(number) = &x.number {
            return self.digits.exact(&Q::from_integer(number.floor()?).into());
        }
        self.digits.exact(&Q::from_integer(x.near.floor()?).into())
    }
}

/// The greater one. If that is not known, it is neither of both, but enclosed.
fn greater(one: &Known, other: &Known) -> Result<Known, Stop> {
    match one.near.compare(&other.near) {
        Some(order) => Ok(if order.is_lt() { other } else { one }.clone()),
        None if one.is_made_as(other) => Ok(one.clone()),
        None => Err(Stop::Undecided("which of two numbers is greater")),
    }
}

fn lesser(one: &Known, other: &Known) -> Result<Known, Stop> {
    match one.near.compare(&other.near) {
        Some(order) => Ok(if order.is_gt() { other } else { one }.clone()),
        None if one.is_made_as(other) => Ok(one.clone()),
        None => Err(Stop::Undecided("which of two numbers is less")),
    }
}

/// The rational bounds of a number.
impl Known {
    /// Both ends.
    pub fn ends(&self) -> [Q; 2] {
        let (low, high) = self.near.ends();
        [low, high]
    }

    /// The greatest absolute value.
    pub fn most(&self) -> Q {
        let [low, high] = self.ends();
        low.abs().max(high.abs())
    }
}
