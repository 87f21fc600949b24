//! What the lines about the limits of a mask show, and which claims follow.

use super::radius::LimitLines;
use crate::audit::{Direction, SmoothnessVerdict};
use crate::claim::{ExponentStatement, PrintedExponent};
use crate::exact::{Decimal, LogSum, LogTerm, Rational};
use std::cmp::Ordering;

/// What is shown of the limits of a mask.
#[derive(Clone, Debug, Default)]
pub(super) struct Shown {
    /// All limits are C^m for this m.
    pub(super) continuous: Option<usize>,
    /// Not all limits are C^m for this m; 0 of a scheme that diverges.
    pub(super) not_continuous: Option<usize>,
    /// The exponent is at least the least of these; nothing is known where there is none.
    pub(super) lower: Vec<LogSum>,
    /// It is at most each of these.
    pub(super) upper: Vec<LogSum>,
    /// The bases of the logarithms that are compared.
    pub(super) bases: Vec<usize>,
}

impl Shown {
    /// What the lines about a mask of curves show.
    pub(super) fn of_curve(lines: &LimitLines, arity: usize) -> Shown {
        let bound = |of: &Rational, degree: usize| {
            let factor = -Rational::from(degree).recip();
            let term = LogTerm { factor, base: arity, of: of.clone() };
            LogSum { rational: Rational::from(lines.order), terms: vec![term] }
        };
        let lower = lines.continuous.map(|_| bound(&lines.at_most, 1));
        let upper = lines.at_least.as_ref().map(|(of, degree)| bound(of, *degree));
        Shown {
            continuous: lines.continuous,
            not_continuous: lines.not_continuous,
            lower: lower.into_iter().collect(),
            upper: upper.into_iter().collect(),
            bases: vec![arity],
        }
    }

    /// What follows for a product.
    pub(super) fn of_factors(all: Vec<Shown>) -> Shown {
        let proven = all.iter().map(|one| one.continuous).collect::<Option<Vec<usize>>>();
        let known = all.iter().all(|one| !one.lower.is_empty());
        let mut shown = Shown {
            continuous: proven.and_then(|all| all.into_iter().min()),
            not_continuous: all.iter().filter_map(|one| one.not_continuous).min(),
            ..Shown::default()
        };
        for one in all {
            shown.lower.extend(one.lower.into_iter().filter(|_| known));
            shown.upper.extend(one.upper);
            shown.bases.extend(one.bases);
        }
        shown
    }

    /// The verdict that is shown of a claim about C^m.
    pub(super) fn continuity(
        &self,
        continuous: Option<usize>,
        not_continuous: Option<usize>,
    ) -> Option<SmoothnessVerdict> {
        let [yes, no] = [continuous, not_continuous].map(|m| {
            m.map(|m| {
                let yes = self.continuous.is_some_and(|shown| m <= shown);
                (yes, self.not_continuous.is_some_and(|shown| shown <= m))
            })
        });
        let refuted = yes.is_some_and(|(_, fails)| fails) || no.is_some_and(|(holds, _)| holds);
        let confirmed = yes.is_none_or(|(holds, _)| holds) && no.is_none_or(|(_, fails)| fails);
        judged(refuted, confirmed)
    }

    /// The verdict that is shown of a claim about the exponent.
    pub(super) fn exponent(
        &self,
        exponent: &ExponentStatement,
        attained: Option<bool>,
    ) -> Option<SmoothnessVerdict> {
        let diverges = self.not_continuous == Some(0);
        let found = if diverges { Some(SmoothnessVerdict::Refuted) } else { self.judged(exponent) };
        found.filter(|found| attained.is_none() || *found == SmoothnessVerdict::Refuted)
    }

    /// Whether all logarithms of a printed exponent have a base that is compared.
    pub(super) fn compares(&self, exponent: &ExponentStatement) -> bool {
        let printed = match exponent {
            ExponentStatement::Value(value) => [Some(value), None],
            ExponentStatement::Bounds { at_least, at_most } => {
                [at_least.as_ref(), at_most.as_ref()]
            }
            ExponentStatement::Decimal { .. } => [None, None],
        };
        let mut terms = printed.into_iter().flatten().flat_map(|value| &value.value.terms);
        terms.all(|term| self.bases.iter().all(|base| *base == term.base))
    }

    /// Whether the exponent is at least this number; with `strictly`, greater.
    fn at_least(&self, value: &LogSum, strictly: bool) -> bool {
        let reaches = |lower: &LogSum| match lower.compare(value) {
            Some(Ordering::Greater) => true,
            Some(Ordering::Equal) => !strictly,
            _ => false,
        };
        !self.lower.is_empty() && self.lower.iter().all(reaches)
    }

    /// Whether the exponent is at most this number; with `strictly`, less.
    fn at_most(&self, value: &LogSum, strictly: bool) -> bool {
        self.upper.iter().any(|upper| match upper.compare(value) {
            Some(Ordering::Less) => true,
            Some(Ordering::Equal) => !strictly,
            _ => false,
        })
    }

    fn judged(&self, statement: &ExponentStatement) -> Option<SmoothnessVerdict> {
        let bounds = |low: Option<&PrintedExponent>, high: Option<&PrintedExponent>| {
            let refuted = low.is_some_and(|value| self.at_most(&value.value, true))
                || high.is_some_and(|value| self.at_least(&value.value, true));
            let confirmed = low.is_none_or(|value| self.at_least(&value.value, false))
                && high.is_none_or(|value| self.at_most(&value.value, false));
            judged(refuted, confirmed)
        };
        match statement {
            ExponentStatement::Value(value) => bounds(Some(value), Some(value)),
            ExponentStatement::Bounds { at_least, at_most } => {
                bounds(at_least.as_ref(), at_most.as_ref())
            }
            ExponentStatement::Decimal { decimal, .. } => self.rounded(decimal),
        }
    }

    fn rounded(&self, decimal: &Decimal) -> Option<SmoothnessVerdict> {
        let half = decimal.unit() / Rational::from(2);
        let place = |halves: i64| LogSum::from(decimal.value() + &half * Rational::from(halves));
        let between = |low, high, strictly| {
            self.at_least(&place(low), strictly) && self.at_most(&place(high), strictly)
        };
        // Of an exponent that is cut some digit is left, and none is below half a unit and rounded to one.
        let above = if decimal.mantissa().is_zero() { (1, true) } else { (2, false) };
        let below = if decimal.is_one_unit() { (-1, true) } else { (-2, false) };
        if self.at_least(&place(above.0), above.1) || self.at_most(&place(below.0), below.1) {
            Some(SmoothnessVerdict::Refuted)
        } else if between(-1, 1, false) {
            Some(SmoothnessVerdict::Confirmed)
        } else if between(1, 2, true) {
            Some(SmoothnessVerdict::Rounding(Direction::Cut))
        } else {
            between(-2, -1, true).then_some(SmoothnessVerdict::Rounding(Direction::Away))
        }
    }
}

fn judged(refuted: bool, confirmed: bool) -> Option<SmoothnessVerdict> {
    let confirmed = confirmed.then_some(SmoothnessVerdict::Confirmed);
    if refuted { Some(SmoothnessVerdict::Refuted) } else { confirmed }
}
