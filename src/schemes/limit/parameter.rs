//! Rational parameters and their n-adic digits.

use super::error::{LimitError, MAX_PARAMETER_DIGITS};
use super::functional::Functional;
use super::row::{Refinement, Row};
use crate::exact::{Integer, Rational, format};
use crate::scheme::Rules;

/// t = whole + Σ_m d_m/n^m + rest/n^M, m = 1, …, M, with digits d_m from 0 to n − 1.
pub(super) struct Parameter {
    whole: i64,
    digits: Vec<i64>,
    /// The rest in [0, 1), whose own digits are purely periodic.
    pub(super) rest: Rational,
}

impl Parameter {
    /// The n-adic expansion of t.
    pub(super) fn new(t: &Rational, arity: usize) -> Result<Parameter, LimitError> {
        let refused = || LimitError::Parameter { parameter: format::short(t, 12), arity };
        let whole = t.floor();
        // Indices of points are added to `whole`; this must not overflow `i64`.
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

    /// The parameter of the first `level` digits, and the fractional part of n^level·t:
    /// the place of t between two neighbouring points of this level.
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

    /// One period of the digits of a number in [0, 1) with purely periodic digits; `None` when
    /// the period is longer than `most`.
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

    /// Let m be the number of digits. Takes a functional of the sequence of level m, with
    /// indices relative to n^m·t, to a functional of the sequence of level 0. `rules`
    /// refine each level to the next.
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

/// Whether t = i/n^m for some integers i and m ≥ 0.
#[must_use]
pub fn is_fraction(t: &Rational, arity: usize) -> bool {
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

/// The first n-adic digit of `rest` in [0, 1). Replaces `rest` by the fractional part of n·`rest`.
pub(super) fn next_digit(rest: &mut Rational, arity: usize) -> Option<i64> {
    let scaled = &*rest * Rational::from(arity);
    *rest = scaled.fract();
    scaled.floor().to_i64()
}
