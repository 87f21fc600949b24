//! Theorems that are refuted in every shift of the parameter.

use crate::claim::{Quantity, Statement, Theorem};
use crate::diagnostic::Diagnostic;
use crate::evaluation::settings::Settings;
use crate::exact::{Rational, RealCyclotomic, comparable};
use crate::finding::{EveryShift, Outcome, Unshiftable};
use crate::judge::theorem::case::Case;
use crate::judge::theorem::evaluate::{LEVEL, TOLERANCE};
use crate::judge::theorem::natural::refutes;
use crate::judge::theorem::setting::later;
use crate::judge::theorem::simplest::slightly_less;

/// How many levels are tried, from the one on at which a case is refuted.
const MAX_LEVELS: u32 = 3;

/// Whether a theorem is refuted in every shift of the parameter, given its outcomes at natural
/// parameters. `None` for differences and for rings.
pub(crate) fn every_shift(
    theorem: &Theorem,
    cases: &[Case<'_>],
    natural: &[Outcome],
) -> Result<Option<EveryShift>, Diagnostic> {
    let (quantity, from) = match &theorem.statement {
        Statement::Bound { quantity, from, .. } => (*quantity, *from),
        Statement::Depth(_) => (Quantity::Distance, 0),
        Statement::Other(_) => return Ok(None),
    };
    if later(quantity).is_none() || cases.iter().any(Case::is_ring) {
        return Ok(None);
    }
    // What exceeds the bound in every shift does so at the natural parameters, though it may not
    // have been found there.
    let refuted = cases.iter().zip(natural).filter_map(|(case, outcome)| match outcome {
        Outcome::Refuted(violation) => Some((case, violation.level)),
        Outcome::Unknown(_) if case.beyond.is_none() => Some((case, from)),
        _ => None,
    });
    let mut tries: Vec<(u32, &Case<'_>)> = refuted
        .flat_map(|(case, first)| (first..first + MAX_LEVELS).map(move |level| (level, case)))
        .collect();
    tries.sort_by_key(|(level, _)| *level);
    for (level, case) in tries {
        if let Some(data) = exceeding(theorem, case, quantity, level)? {
            let Case { label, scheme, chosen, .. } = case;
            return Ok(Some(EveryShift::Refuted {
                case: label.clone(),
                scheme: scheme.clone(),
                values: chosen.clone(),
                data: Box::new(data),
            }));
        }
    }
    Ok(Some(if natural.iter().all(|outcome| refutes(outcome) == Some(false)) {
        EveryShift::Holds
    } else {
        EveryShift::Open
    }))
}

/// Data whose greatest values at this level and at the next one, or in the limit, differ by more
/// than the bound.
fn exceeding(
    theorem: &Theorem,
    case: &Case<'_>,
    quantity: Quantity,
    level: u32,
) -> Result<Option<Unshiftable>, Diagnostic> {
    if let Some((value, below)) = &theorem.tried.supposes {
        let settings = Settings::default();
        let sides = (case.evaluate(value, &[], &settings)?, case.evaluate(below, &[], &settings)?);
        let (Ok(value), Ok(below)) = sides else { return Ok(None) };
        if !comparable(&value, &below) || value >= below {
            return Ok(None);
        }
    }
    let found = case.setting.as_ref().and_then(|setting| setting.overshoot(quantity, level));
    let Some(overshoot) = found else { return Ok(None) };
    let gap = overshoot.gap();
    let bound = match &theorem.statement {
        Statement::Bound { by, .. } => {
            let names = [(LEVEL, Rational::from(level))];
            let settings = case.prepared(by, Settings::default());
            case.evaluate(by, &names, &settings)?.ok().filter(|bound| bound.sign() >= 0)
        }
        Statement::Depth(by) => match slightly_less(&gap.clone().into()) {
            None => None,
            Some(tolerance) => {
                let settings = case.prepared(by, Settings::default());
                let depth = case.evaluate(by, &[(TOLERANCE, tolerance.clone())], &settings)?;
                let deep = |depth: RealCyclotomic| {
                    depth.sign() >= 0 && depth <= RealCyclotomic::from(level)
                };
                depth.is_ok_and(deep).then(|| tolerance.into())
            }
        },
        Statement::Other(_) => None,
    };
    let gap = RealCyclotomic::from(gap);
    let exceeds = |bound: &RealCyclotomic| comparable(&gap, bound) && gap > *bound;
    let bound = bound.filter(exceeds);
    Ok(bound.map(|bound| Unshiftable { quantity, level, overshoot, bound }))
}
