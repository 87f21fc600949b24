//! Judging the values of a parameter for which the limits are said to be C^m.

use super::mask::{lattice_limits, limits, no_valences};
use super::trial::{Judged, Sides, Trial};
use super::vertex_range;
use crate::bound::{Order, norm_function};
use crate::claim::{Ends, SmoothRangeStatement};
use crate::diagnostic::Diagnostic;
use crate::evaluation::limits::LimitScheme;
use crate::exact::{
    IntervalSet, Parametric, PiecewisePolynomial, Rational, RationalPolynomial, RealCyclotomic,
};
use crate::finding::{
    Contraction, KnownLimits, RangeOfLimits, Reason, SmoothSets, SmoothnessVerdict, Witness,
};
use crate::lattice::{LatticeRangeError, lattice_range};
use crate::scheme::{LatticeMask, Rules};
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
    let lattice = scheme.lattice_in(variable, &instances)?;
    let sets = match &lattice {
        Some(mask) => lattice_sets(mask, statement.m),
        None => sets(&scheme.rules(variable)?, statement.m),
    };
    let mut sets = match sets {
        Ok(sets) => sets,
        Err(capped) => return Ok((SmoothnessVerdict::NotCheckable, KnownLimits::Capped(capped))),
    };
    let at = |at: &Rational| {
        let limits = if lattice.is_some() {
            let value = RealCyclotomic::from(at.clone());
            let instances = scheme.instances(Some((variable, value)), None)?;
            scheme.lattice(&instances)?.map(lattice_limits)
        } else {
            limits(scheme.mask(&[(variable, at)])?).ok()
        };
        let Some(limits) = limits else { return Ok(None) };
        let smooth = limits.proven().and_then(|proven| proven.is_continuous(statement.m));
        Ok(smooth.map(|smooth| (smooth, limits)))
    };
    let sides = |sets: &SmoothSets| Sides {
        inside: sets.inside().clone(),
        outside: sets.outside().clone(),
        but_finitely_many: sets.but_finitely_many(),
    };
    let printed = statement.domain.interval(Ends::Printed);
    let mut trial = Trial { statement, sides: sets.as_ref().map(sides), at: &at };
    if let Some(sets) = &mut sets
        && look_closer(sets, &trial.undecided(&printed, &printed))
    {
        trial.sides = Some(sides(sets));
    }
    let Judged { verdict, undecided, witness } = trial.judged()?;
    let witness = witness.map(|(at, inside, limits)| Witness { at, inside, limits });
    let contraction = match (verdict, &sets) {
        (SmoothnessVerdict::Confirmed, Some(SmoothSets::Curve(sets))) => {
            contraction(sets, &printed)
        }
        _ => None,
    };
    let range = RangeOfLimits { sets, printed, undecided, witness, contraction };
    Ok((verdict, KnownLimits::Range(Box::new(range))))
}

/// Where the limits are C^m, and where not; `None` where the sum rules that this needs do not hold for
/// all values. An error says which cap is met.
fn sets(rules: &Rules<RationalPolynomial>, m: usize) -> Result<Option<SmoothSets>, Reason> {
    let mut reason = None;
    for levels in LEVELS {
        match smooth_range(rules, m, levels) {
            Ok(range) => return Ok(Some(SmoothSets::Curve(Box::new(range)))),
            Err(SmoothRangeError::SumRules { .. }) => return Ok(None),
            Err(error @ SmoothRangeError::TooLong(_)) => return Err(error.into()),
            Err(error) => reason = Some(error),
        }
    }
    Err(reason.map_or(Reason::Unsaid, Reason::from))
}

/// The same of a mask on Z^d.
fn lattice_sets(
    mask: &LatticeMask<RationalPolynomial>,
    m: usize,
) -> Result<Option<SmoothSets>, Reason> {
    match lattice_range(mask, u32::try_from(m).unwrap_or(u32::MAX)) {
        Ok(range) => Ok(Some(SmoothSets::Lattice(Box::new(range)))),
        Err(LatticeRangeError::SumRules { .. }) => Ok(None),
        Err(error) => Err(error.into()),
    }
}

/// Looks closer at the bounded parts of what is open, of a mask of curves. Whether there are any.
fn look_closer(sets: &mut SmoothSets, open: &IntervalSet) -> bool {
    let SmoothSets::Curve(sets) = sets else { return false };
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
