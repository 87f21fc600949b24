//! Judging the values of a parameter for which the limits are said to be C^m.

use super::mask::{limits, no_valences};
use super::trial::{Judged, Sides, Trial};
use super::vertex_range;
use crate::bound::{Order, norm_function};
use crate::claim::{Ends, SmoothRangeStatement};
use crate::diagnostic::Diagnostic;
use crate::evaluation::limits::LimitScheme;
use crate::exact::{IntervalSet, Parametric, PiecewisePolynomial, Rational, RationalPolynomial};
use crate::finding::{
    Contraction, KnownLimits, Proven, RangeOfLimits, Reason, SmoothnessVerdict, Witness,
};
use crate::scheme::Rules;
use crate::smoothness::{SmoothRange, SmoothRangeError, smooth_range};

/// The numbers of levels up to which contraction is looked for; the next one where the first is beyond a
/// cap.
const LEVELS: [u32; 3] = [4, 2, 1];

/// Intervals that are not wider than this are not divided.
const CLOSER: (i64, i64) = (1, 1 << 20);

/// Judges a range.
pub(super) fn judge(
    scheme: &LimitScheme<'_>,
    statement: &SmoothRangeStatement,
) -> Result<(SmoothnessVerdict, KnownLimits), Diagnostic> {
    let variable = &statement.variable;
    let first = statement.valences.as_ref().map(|valences| valences.first);
    let instances = scheme.instances(Some((variable, Parametric::variable())), first)?;
    if scheme.is_ring(&instances)? {
        return vertex_range::judge(scheme, statement);
    }
    if let Some(valences) = &statement.valences {
        return Err(no_valences(scheme, valences));
    }
    let rules = scheme.rules(variable)?;
    let sets = match sets(&rules, statement.m) {
        Ok(sets) => sets,
        Err(capped) => return Ok((SmoothnessVerdict::NotCheckable, KnownLimits::Capped(capped))),
    };
    let at = |at: &Rational| {
        let Ok(limits) = limits(scheme.mask(&[(variable, at)])?) else { return Ok(None) };
        Ok(Proven::of_curve(&limits.smoothness)
            .is_continuous(statement.m)
            .map(|smooth| (smooth, limits)))
    };
    let sides = |sets: &SmoothRange| Sides {
        inside: sets.inside.clone(),
        outside: sets.outside.clone(),
        but_finitely_many: sets.but_finitely_many,
    };
    let printed = statement.domain.interval(Ends::Printed);
    let mut trial = Trial { statement, sides: sets.as_ref().map(sides), at: &at };
    let mut sets = sets;
    if let Some(sets) = &mut sets
        && look_closer(sets, &trial.undecided(&printed, &printed))
    {
        trial.sides = Some(sides(sets));
    }
    let Judged { verdict, undecided, witness } = trial.judged()?;
    let witness = witness.map(|(at, inside, limits)| Witness { at, inside, limits });
    let contraction = match (verdict, &sets) {
        (SmoothnessVerdict::Confirmed, Some(sets)) => contraction(sets, &printed),
        _ => None,
    };
    let range = RangeOfLimits { sets, printed, undecided, witness, contraction };
    Ok((verdict, KnownLimits::Range(Box::new(range))))
}

/// Where the limits are C^m, and where not; `None` where the sum rules that this needs do not hold for
/// all values. An error says which cap is met.
fn sets(rules: &Rules<RationalPolynomial>, m: usize) -> Result<Option<SmoothRange>, Reason> {
    let mut reason = None;
    for levels in LEVELS {
        match smooth_range(rules, m, levels) {
            Ok(range) => return Ok(Some(range)),
            Err(SmoothRangeError::SumRules { .. }) => return Ok(None),
            Err(error @ SmoothRangeError::TooLong(_)) => return Err(error.into()),
            Err(error) => reason = Some(error),
        }
    }
    Err(reason.map_or(Reason::Unsaid, Reason::from))
}

/// Looks closer at the bounded parts of what is open. Whether there are any.
fn look_closer(sets: &mut SmoothRange, open: &IntervalSet) -> bool {
    let known = sets.inside.union(&sets.outside);
    let width = Rational::new(CLOSER.0, CLOSER.1);
    // The sets are computed already, so that no cap is met.
    !open.is_empty() && sets.look_closer(&open.without(&known), &width).is_ok()
}

/// The least number of levels in which the differences contract for all values of the range.
fn contraction(sets: &SmoothRange, range: &IntervalSet) -> Option<Contraction> {
    let levels = (1_u32..).zip(&sets.contraction.levels);
    let covers = |set: &IntervalSet| range.without(set).is_empty();
    let (levels, below) = levels.into_iter().find(|(_, set)| covers(set))?;
    if sets.converges.is_some() {
        // The norm alone does not prove it.
        return None;
    }
    let norm = norm_function(&sets.differences, levels, Order::Adjoint).ok()?;
    let above = norm.exceeds(&PiecewisePolynomial::constant(Rational::one()));
    Some(Contraction { levels, reduction: sets.reduction.clone(), below: below.clone(), above })
}
