//! Rational parameters, by their n-adic digits.

use super::error::{LimitError, MAX_PARAMETER_DIGITS};
use super::functional::Functional;
use super::row::{Refinement, Row};
use crate::exact::{Integer, Rational, format};
use crate::scheme::Rules;

/// t = whole + Σ_m d_m/n^m + rest/n^M, m = 1, …, M, with digits d_m from 0 to n − 1.
pub(super) struct Parameter {
    whole: i64,
    digits: Vec<i64>,
    /// From 0 to below 1: what is left when the digits that follow repeat from the first on.
    pub(super) rest: Rational,
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
        let common = Integer::from(arity);
        while rest.denominator().gcd(&common) != Integer::one() {
            if digits.len() == MAX_PARAMETER_DIGITS as usize {
                return Err(refused());
            }
            digits.push(next_digit(&mut rest, arity).ok_or_else(refused)?);
        }
        let whole = whole.to_i64().filter(|_| near).ok_or_else(refused)?;
        Ok(Parameter { whole, digits, rest })
    }

    /// The first `level` digits, as a parameter, and what is left of n^level·t: the
    /// place of t between two neighbouring points of that level, from 0 to 1.
    pub(super) fn split(&self, level: u32, arity: usize) -> (Parameter, Rational) {
        let level = level as usize;
        let mut rest = self.rest.clone();
        let beyond = level.saturating_sub(self.digits.len());
        let repeated = (0..beyond).filter_map(|_| next_digit(&mut rest, arity)).collect::<Vec<_>>();
        let digits = self.digits.iter().copied().take(level).chain(repeated).collect();
        let rest = self
            .digits
            .iter()
            .skip(level)
            .rev()
            .fold(rest, |rest, digit| (rest + Rational::from(*digit)) / Rational::from(arity));
        (Parameter { whole: self.whole, digits, rest: Rational::zero() }, rest)
    }

    /// The digits of a number from 0 to below 1 up to where they repeat, which they do from the
    /// first on; `None` when these are more than so many.
    pub(super) fn period(rest: &Rational, arity: usize, most: u32) -> Option<Parameter> {
        let (mut digits, mut left) = (Vec::new(), rest.clone());
        loop {
            digits.push(next_digit(&mut left, arity)?);
            if left == *rest {
                return Some(Parameter { whole: 0, digits, rest: Rational::zero() });
            }
            if digits.len() >= most as usize {
                return None;
            }
        }
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

/// Whether t is i/n^m for some m.
pub(crate) fn is_fraction(t: &Rational, arity: usize) -> bool {
    let (mut rest, n) = (t.denominator(), Integer::from(arity));
    while rest != Integer::one() {
        let common = rest.gcd(&n);
        if common == Integer::one() {
            return false;
        }
        rest = rest.div_floor(&common);
    }
    true
}

/// The first n-adic digit of a number from 0 to below 1, which becomes what is left of n times it.
pub(super) fn next_digit(rest: &mut Rational, arity: usize) -> Option<i64> {
    let scaled = &*rest * Rational::from(arity);
    *rest = scaled.fract();
    scaled.floor().to_i64()
}
