//! The parameters i/n^m, by their n-adic digits.

use super::error::{LimitError, MAX_PARAMETER_DIGITS};
use super::functional::Functional;
use super::row::{Refinement, Row};
use crate::exact::{Rational, format};
use crate::scheme::Rules;

/// t = whole + Σ_m d_m/n^m, m = 1, 2, …, with digits d_m from 0 to n − 1.
pub(super) struct Parameter {
    whole: i64,
    digits: Vec<i64>,
}

impl Parameter {
    /// The expansion of t.
    pub(super) fn new(t: &Rational, arity: usize) -> Result<Parameter, LimitError> {
        let refused = || LimitError::Parameter { parameter: format::short(t, 12), arity };
        let whole = t.floor();
        // Far from the ends of i64, to which the indices of points are added.
        let near = whole.bits() <= 60;
        let mut rest = t - Rational::from(whole.clone());
        let mut digits = Vec::new();
        while !rest.is_zero() {
            if digits.len() == MAX_PARAMETER_DIGITS as usize {
                return Err(refused());
            }
            rest = rest * Rational::from(arity);
            let digit = rest.floor();
            rest -= &Rational::from(digit.clone());
            digits.push(digit.to_i64().ok_or_else(refused)?);
        }
        let whole = whole.to_i64().filter(|_| near).ok_or_else(refused)?;
        Ok(Parameter { whole, digits })
    }

    /// The first `level` digits, as a parameter, and what is left of n^level·t: the
    /// place of t between two neighbouring points of that level, from 0 to 1.
    pub(super) fn split(&self, level: u32, arity: usize) -> (Parameter, Rational) {
        let level = level as usize;
        let digits = (0..level).map(|m| self.digits.get(m).copied().unwrap_or(0)).collect();
        let rest = self.digits.iter().skip(level).rev().fold(Rational::zero(), |rest, digit| {
            (rest + Rational::from(*digit)) / Rational::from(arity)
        });
        (Parameter { whole: self.whole, digits }, rest)
    }

    /// A functional of the sequence of level m = the number of digits, whose index 0
    /// stands for the index n^m·t, as a functional of that of level 0; `rules` take
    /// each level to the next.
    pub(super) fn pull_back(&self, functional: &Functional, rules: &Rules) -> Functional {
        if self.digits.is_empty() {
            return functional.shifted(self.whole);
        }
        let refinement = Refinement::of(rules);
        let (row, denominator) = Row::of(functional);
        let level_by_level = |fine: Row, digit: &i64| refinement.pull_back(&fine, *digit);
        let coarse = self.digits.iter().rev().fold(row, level_by_level);
        let levels = u32::try_from(self.digits.len()).expect("the digits are capped");
        let multiple = denominator * refinement.denominator().pow(levels);
        coarse.functional(&multiple).shifted(self.whole)
    }
}
