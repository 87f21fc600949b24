//! Functionals with integer coefficients, and their refinement.

use super::functional::Functional;
use crate::exact::{CommonDenominator, Integer, Rational};
use crate::scheme::Rules;

/// A functional with integer coefficients at consecutive indices.
#[derive(Clone)]
pub(super) struct Row {
    first: i64,
    coefficients: Vec<Integer>,
}

impl Row {
    /// The functional times its common denominator, and this denominator.
    pub(super) fn of(functional: &Functional) -> (Row, Integer) {
        let (first, last) = functional.support().unwrap_or((0, 0));
        let dense: Vec<Rational> = (first..=last).map(|i| functional.coefficient(i)).collect();
        let CommonDenominator { mut numerators, denominator } = CommonDenominator::of(&[dense]);
        let coefficients = numerators.pop().unwrap_or_default();
        (Row { first, coefficients }, denominator)
    }

    /// This row divided by `multiple`, as a functional.
    pub(super) fn functional(&self, multiple: &Integer) -> Functional {
        let coefficient = |c: &Integer| Rational::new(c.clone(), multiple.clone());
        Functional::new(self.first, self.coefficients.iter().map(coefficient))
    }

    /// The sum of the absolute coefficients.
    pub(super) fn norm(&self) -> Integer {
        magnitude(&self.coefficients)
    }
}

/// The rules of a scheme as integers over one denominator.
pub(super) struct Refinement {
    common: CommonDenominator,
    offset: i64,
    arity: i64,
}

impl Refinement {
    pub(super) fn of(rules: &Rules) -> Refinement {
        Refinement {
            common: CommonDenominator::of(rules.rows()),
            offset: rules.offset(),
            arity: i64::try_from(rules.arity()).expect("the arity is capped"),
        }
    }

    /// n.
    pub(super) fn arity(&self) -> i64 {
        self.arity
    }

    /// N.
    pub(super) fn width(&self) -> usize {
        self.common.numerators[0].len()
    }

    /// The common denominator of the rules.
    pub(super) fn denominator(&self) -> &Integer {
        &self.common.denominator
    }

    /// The refined points of a polygon that is constant beyond its ends, times the denominator of
    /// the rules, with the index of the first one. They include all points that may differ from the
    /// values at the ends.
    pub(super) fn refine(&self, first: i64, points: &[Integer]) -> (i64, Vec<Integer>) {
        let width = self.width();
        let last = points.len() - 1;
        let rule = |start: usize, rule: &Vec<Integer>| {
            // The index of point j of a window; the first window begins width − 1 places
            // before the first point.
            let place = |j: usize| (start + j).saturating_sub(width - 1).min(last);
            (0..).zip(rule).fold(Integer::zero(), |mut sum, (j, entry)| {
                sum.add_product(entry, &points[place(j)]);
                sum
            })
        };
        let windows = 0..last + width;
        let refined = windows
            .flat_map(|start| self.common.numerators.iter().map(move |row| rule(start, row)));
        let before = first - self.offset - i64::try_from(width - 1).expect("masks are capped");
        (self.arity * before, refined.collect())
    }

    /// The functional x ↦ (row shifted by `shift`)(y), times the denominator of the rules,
    /// where y_{ni+α} = Σ_j r_{α,j} x_{i+o+j}.
    pub(super) fn pull_back(&self, row: &Row, shift: i64) -> Row {
        let width = self.width();
        let first = (row.first + shift).div_euclid(self.arity);
        let last = row.coefficients.len().saturating_sub(1);
        let last =
            (row.first + shift + i64::try_from(last).unwrap_or(i64::MAX)).div_euclid(self.arity);
        let span = usize::try_from(last - first).expect("a row is not empty") + width;
        let mut coefficients = vec![Integer::zero(); span];
        for (i, coefficient) in (row.first + shift..).zip(&row.coefficients) {
            let start = usize::try_from(i.div_euclid(self.arity) - first).expect("first is least");
            let rule = usize::try_from(i.rem_euclid(self.arity)).expect("a residue");
            for (to, entry) in coefficients[start..].iter_mut().zip(&self.common.numerators[rule]) {
                to.add_product(coefficient, entry);
            }
        }
        Row { first: first + self.offset, coefficients }
    }
}

/// Σ |x|, without copies of the entries.
pub(super) fn magnitude(row: &[Integer]) -> Integer {
    row.iter().fold(Integer::zero(), |mut sum, x| {
        if x.sign() < 0 {
            sum -= x;
        } else {
            sum += x;
        }
        sum
    })
}
