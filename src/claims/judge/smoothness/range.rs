//! Judging the values of a parameter for which the limits are said to be C^m.

use super::{is_continuous, limits};
use crate::bound::{Order, norm_function};
use crate::claim::{RangeEnd, SmoothRangeStatement};
use crate::diagnostic::Diagnostic;
use crate::evaluation::limits::LimitScheme;
use crate::exact::{
    Interval, IntervalSet, PiecewisePolynomial, Rational, RationalPolynomial, RealAlgebraic,
};
use crate::finding::{Contraction, Known, RangeOfLimits, SmoothnessVerdict, Witness};
use crate::scheme::Rules;
use crate::smoothness::{ParametricSymbol, SmoothRange, SmoothRangeError, smooth_range};
use std::ops::Bound;

/// The numbers of levels up to which contraction is looked for; the next one where the first is beyond a
/// cap.
const LEVELS: [u32; 3] = [4, 2, 1];

/// Intervals that are not wider than this are not divided.
const CLOSER: (i64, i64) = (1, 1 << 20);

/// The greatest denominator of the simple values that are tried.
const MAX_DENOMINATOR: i64 = 1_000;

/// The digits that an end needs to be called rounded.
const MIN_DIGITS: usize = 2;

/// Judges a range.
pub(super) fn judge(
    scheme: &LimitScheme<'_>,
    statement: &SmoothRangeStatement,
) -> Result<(SmoothnessVerdict, Known), Diagnostic> {
    let rules = scheme.rules(&statement.variable)?;
    let sets = match sets(&rules, statement.m) {
        Ok(sets) => sets,
        Err(capped) => return Ok((SmoothnessVerdict::NotCheckable, Known::Capped(capped))),
    };
    let mut trial = Trial { scheme, statement, sets };
    let printed = trial.printed(0);
    trial.look_closer(&printed);
    let undecided = trial.undecided(&printed, &printed);
    let right = trial.witness(&printed, &printed)?.is_none() && !trial.excludes(&printed);
    let (witness, verdict) = if right && undecided.is_empty() {
        (None, SmoothnessVerdict::Confirmed)
    } else {
        // The range without the last unit of its rounded ends, and with one unit more.
        let (less, more) = (trial.printed(-1), trial.printed(1));
        match trial.witness(&less, &more)? {
            Some(witness) => (Some(witness), SmoothnessVerdict::Refuted),
            None if trial.excludes(&less) => (None, SmoothnessVerdict::Refuted),
            None if trial.undecided(&less, &more).is_empty() => {
                (None, SmoothnessVerdict::RoundedEnds)
            }
            None => (None, SmoothnessVerdict::Open),
        }
    };
    let contraction = match verdict {
        SmoothnessVerdict::Confirmed => trial.contraction(&rules, &printed),
        _ => None,
    };
    let range = RangeOfLimits { sets: trial.sets, printed, undecided, witness, contraction };
    Ok((verdict, Known::Range(Box::new(range))))
}

/// A number of an interval with a small denominator, if there is one.
fn simple(interval: &Interval) -> Option<Rational> {
    let any = interval.rational()?;
    let near = (1..=MAX_DENOMINATOR).find_map(|d| {
        let d = Rational::from(d);
        let below = Rational::from((&any * &d).floor());
        let ends = [&below / &d, (below + Rational::one()) / &d];
        ends.into_iter().find(|x| interval.contains(x))
    });
    near.or(Some(any))
}

/// Where the limits are C^m, and where not; `None` where the sum rules that this needs do not hold for
/// all values. An error says which cap is met.
fn sets(rules: &Rules<RationalPolynomial>, m: usize) -> Result<Option<SmoothRange>, String> {
    let mut reason = String::new();
    for levels in LEVELS {
        match smooth_range(rules, m, levels) {
            Ok(range) => return Ok(Some(range)),
            Err(SmoothRangeError::SumRules { .. }) => return Ok(None),
            Err(error @ SmoothRangeError::TooLong(_)) => return Err(error.to_string()),
            Err(error) => reason = error.to_string(),
        }
    }
    Err(reason)
}

struct Trial<'t> {
    scheme: &'t LimitScheme<'t>,
    statement: &'t SmoothRangeStatement,
    sets: Option<SmoothRange>,
}

impl Trial<'_> {
    /// The printed range, with so many units of the last digit more at each rounded end.
    fn printed(&self, units: i64) -> IntervalSet {
        let SmoothRangeStatement { from, to, closed, .. } = self.statement;
        let end = |end: &Option<RangeEnd>, outwards: i64| {
            let Some(end) = end else { return Bound::Unbounded };
            let place = match &end.decimal {
                Some(decimal) if units != 0 && decimal.significant_digits() >= MIN_DIGITS => {
                    let more = decimal.unit() * Rational::from(units * outwards);
                    RealAlgebraic::from(decimal.value() + more)
                }
                _ => end.value.clone(),
            };
            if *closed { Bound::Included(place) } else { Bound::Excluded(place) }
        };
        let (low, high) = (end(from, -1), end(to, 1));
        let ordered = match (&low, &high) {
            (
                Bound::Included(low) | Bound::Excluded(low),
                Bound::Included(high) | Bound::Excluded(high),
            ) => low < high,
            _ => true,
        };
        if ordered { IntervalSet::from(Interval { low, high }) } else { IntervalSet::default() }
    }

    /// The values that decide nothing: those of `inner` at which C^m is not proved; and, if the paper says
    /// that there are no others, those beyond `outer` at which it is not refuted.
    fn undecided(&self, inner: &IntervalSet, outer: &IntervalSet) -> IntervalSet {
        let beyond = IntervalSet::everything().without(outer);
        let Some(sets) = &self.sets else { return inner.clone() };
        let open = inner.without(&sets.inside);
        if !self.statement.only {
            return open;
        }
        // With exceptions, of which there are finitely many, nothing is sure outside.
        let refuted = if sets.but_finitely_many { &IntervalSet::default() } else { &sets.outside };
        open.union(&beyond.without(refuted))
    }

    /// Looks closer at the bounded parts of what is open.
    fn look_closer(&mut self, printed: &IntervalSet) {
        let open = self.undecided(printed, printed);
        if let Some(sets) = self.sets.as_mut().filter(|_| !open.is_empty()) {
            let known = sets.inside.union(&sets.outside);
            let width = Rational::new(CLOSER.0, CLOSER.1);
            // The sets are computed already, so that no cap is met.
            let _ = sets.look_closer(&open.without(&known), &width);
        }
    }

    /// The least number of levels in which the differences contract for all values of the range.
    fn contraction(
        &self,
        rules: &Rules<RationalPolynomial>,
        range: &IntervalSet,
    ) -> Option<Contraction> {
        let levels = (1_u32..).zip(&self.sets.as_ref()?.contraction.levels);
        let covers = |set: &IntervalSet| range.without(set).is_empty();
        let (levels, below) = levels.into_iter().find(|(_, set)| covers(set))?;
        let m = self.statement.m;
        let derived = (0..=m).try_fold(ParametricSymbol::of(rules), |s, _| s.over_sigma())?;
        let factor = Rational::from(rules.arity()).pow(i32::try_from(m).ok()?);
        let norm = norm_function(&derived.scaled(&factor).rules(), levels, Order::Adjoint).ok()?;
        let above = norm.exceeds(&PiecewisePolynomial::constant(Rational::one()));
        Some(Contraction { levels, below: below.clone(), above })
    }

    /// Whether a value of the range is certainly excluded.
    fn excludes(&self, range: &IntervalSet) -> bool {
        self.sets.as_ref().is_some_and(|sets| {
            !sets.but_finitely_many && !range.intersection(&sets.outside).is_empty()
        })
    }

    /// A rational value of `inner` at which not all limits are C^m; or, if the paper says that there are no
    /// others, one beyond `outer` at which they are.
    fn witness(
        &self,
        inner: &IntervalSet,
        outer: &IntervalSet,
    ) -> Result<Option<Witness>, Diagnostic> {
        let everything = IntervalSet::everything();
        let failing = match &self.sets {
            Some(sets) => inner.intersection(&sets.outside),
            None => inner.clone(),
        };
        if let Some(witness) = self.first(&failing, true)? {
            return Ok(Some(witness));
        }
        match &self.sets {
            Some(sets) if self.statement.only => {
                self.first(&everything.without(outer).intersection(&sets.inside), false)
            }
            _ => Ok(None),
        }
    }

    /// The first interval of these with a rational value that decides as expected.
    fn first(&self, set: &IntervalSet, inside: bool) -> Result<Option<Witness>, Diagnostic> {
        let SmoothRangeStatement { variable, m, .. } = self.statement;
        for at in set.intervals().iter().filter_map(simple) {
            let mask = self.scheme.mask(Some((variable, &at)))?;
            let Ok(limits) = limits(mask) else { continue };
            if is_continuous(&limits.smoothness, *m) == Some(!inside) {
                return Ok(Some(Witness { at, inside, limits }));
            }
        }
        Ok(None)
    }
}
