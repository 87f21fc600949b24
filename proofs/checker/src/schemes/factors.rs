//! The factors of a symbol in which exponents depend on an index (proofs/format/relation.md, Families).

#![warn(clippy::arithmetic_side_effects)]

use super::family::Factor;
use super::laurent::Laurent;
use super::symbol::Expansion;
use crate::formulas::{Expr, Head, MAX_INTEGER};
use crate::numbers::{Integers, Q, Value, capped};
use crate::text::Stop;

/// How deep formulas may be nested, with those that they name.
const MAX_DEPTH: usize = 200;

/// The most factors of a symbol.
const MAX_FACTORS: usize = 4_096;

const NO_FACTORS: Stop = Stop::Family("a part of the symbol has no factors");
const NO_EXPONENT: Stop = Stop::Family("an exponent is not αt + β with integers α and β");
const NO_SYMBOL: Stop = Stop::Family("a part of the symbol may be no Laurent polynomial");

/// A symbol in whose formulas an index is a symbol.
pub(super) struct Factoring<'s> {
    /// What multiplies formulas out.
    pub(super) expansion: Expansion<'s>,
    /// The index.
    pub(super) integers: &'s Integers,
}

impl Factoring<'_> {
    /// The factors of a formula.
    pub(super) fn of(&self, expr: &Expr, depth: usize) -> Result<Vec<Factor>, Stop> {
        if depth >= MAX_DEPTH {
            return Err(Stop::Capped("the nesting of formulas"));
        }
        if let Some(value) = self.value(expr, depth)? {
            return Ok(vec![Factor::once(value)]);
        }
        let deeper = depth.saturating_add(1);
        let (head, parts) = match expr {
            Expr::Name(name) => {
                let definition = self.expansion.scope.definitions.get(name);
                return self.of(definition.ok_or(NO_FACTORS)?, deeper);
            }
            Expr::Of(head, parts) => (head, &parts[..]),
            Expr::Number(_) => return Err(NO_FACTORS),
        };
        match (head, parts) {
            (Head::Minus, [part]) => {
                let mut factors = self.of(part, deeper)?;
                factors.push(Factor::once(Laurent::from([(0, Value::int(-1))])));
                self.counted(factors)
            }
            (Head::Power, [base, exponent]) => {
                let exponent = self.exponent(exponent)?;
                let factors = self.of(base, deeper)?.into_iter();
                factors.map(|factor| self.raised(factor, exponent)).collect()
            }
            (Head::Chain(operators), [first, rest @ ..])
                if operators.iter().all(|operator| matches!(operator, '*' | '/')) =>
            {
                self.product(first, operators.iter().copied().zip(rest), deeper)
            }
            _ => Err(NO_FACTORS),
        }
    }

    /// The factors of a product, which is read from left to right: the longest beginning with a value is one factor.
    fn product<'e>(
        &self,
        first: &Expr,
        rest: impl Iterator<Item = (char, &'e Expr)>,
        depth: usize,
    ) -> Result<Vec<Factor>, Stop> {
        let mut beginning = self.value(first, depth)?;
        let mut factors = if beginning.is_none() { self.of(first, depth)? } else { Vec::new() };
        for (operator, part) in rest {
            if let Some(known) = beginning.take() {
                beginning = self.joined(&known, operator, part, depth)?;
                if beginning.is_some() {
                    continue;
                }
                factors.push(Factor::once(known));
            }
            let exponent = [if operator == '/' { -1 } else { 1 }, 0];
            for factor in self.of(part, depth)? {
                factors.push(self.raised(factor, exponent)?);
            }
            factors = self.counted(factors)?;
        }
        factors.extend(beginning.map(Factor::once));
        Ok(factors)
    }

    /// The Laurent polynomial that a formula is, with rational polynomials in the index as coefficients; `None` if it is none.
    fn value(&self, expr: &Expr, depth: usize) -> Result<Option<Laurent>, Stop> {
        self.rational(self.expansion.of(expr, &mut Vec::new(), depth))
    }

    /// The product or quotient of such a polynomial and a formula.
    fn joined(
        &self,
        known: &Laurent,
        operator: char,
        part: &Expr,
        depth: usize,
    ) -> Result<Option<Laurent>, Stop> {
        let Some(part) = self.value(part, depth)? else { return Ok(None) };
        let expansion = &self.expansion;
        let join = if operator == '/' { Expansion::over } else { Expansion::times };
        self.rational(join(expansion, known, &part))
    }

    fn rational(&self, found: Result<Laurent, Stop>) -> Result<Option<Laurent>, Stop> {
        // Without steps that are left, nothing is looked for.
        self.expansion.scope.spend(1)?;
        Ok(found.ok().filter(|value| value.values().all(|c| self.integers.has(c))))
    }

    fn counted(&self, factors: Vec<Factor>) -> Result<Vec<Factor>, Stop> {
        self.expansion.scope.spend(factors.len() as u64)?;
        if factors.len() > MAX_FACTORS {
            return Err(Stop::Capped("the factors of a symbol"));
        }
        Ok(factors)
    }

    /// β and α of an exponent αt + β.
    fn exponent(&self, expr: &Expr) -> Result<[i64; 2], Stop> {
        let value = self.expansion.scope.value(expr).map_err(|stop| open(stop, NO_EXPONENT))?;
        let coefficients = value.univariate(&self.integers.index).ok_or(NO_EXPONENT)?;
        if coefficients.len() > 2 || !coefficients.iter().all(Q::is_integer) {
            return Err(NO_EXPONENT);
        }
        let mut pair = [0; 2];
        for (place, c) in pair.iter_mut().zip(&coefficients) {
            *place = capped(c.numer(), MAX_INTEGER).ok_or(EXPONENT)?;
        }
        Ok(pair)
    }

    /// A factor of a^E, or of 1/a. It is a Laurent polynomial for each value of the index, as all parts of a symbol have to be:
    /// 1/(1/(1 + z)) is none, though the exponents of its factors are positive.
    fn raised(&self, factor: Factor, [b, a]: [i64; 2]) -> Result<Factor, Stop> {
        if a != 0 && factor.slope != 0 {
            return Err(NO_EXPONENT);
        }
        let [turned, kept] = [factor.constant.checked_mul(a), factor.slope.checked_mul(b)];
        let slope = turned.zip(kept).and_then(|(turned, kept)| turned.checked_add(kept));
        let within = |x: &i64| x.unsigned_abs() <= MAX_INTEGER.unsigned_abs();
        let slope = slope.filter(within).ok_or(EXPONENT)?;
        let constant = factor.constant.checked_mul(b).filter(within).ok_or(EXPONENT)?;
        let factor = Factor { slope, constant, ..factor };
        if factor.has_several() && !is_never_negative(&factor, self.integers) {
            return Err(NO_SYMBOL);
        }
        Ok(factor)
    }
}

const EXPONENT: Stop = Stop::Capped("the size of an exponent");

/// Why there is no value for all integers, where a formula has none while the index is a symbol. It may have values for integers.
pub(super) fn open(stop: Stop, why: Stop) -> Stop {
    if matches!(stop, Stop::Wrong(_) | Stop::OtherRoot) { why } else { stop }
}

/// Whether an exponent is negative for no value of the index.
fn is_never_negative(factor: &Factor, integers: &Integers) -> bool {
    let [slope, constant, least] = [factor.slope, factor.constant, integers.least].map(i128::from);
    // These are integers of 64 binary digits.
    slope >= 0 && slope.saturating_mul(least).saturating_add(constant) >= 0
}
