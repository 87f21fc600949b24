//! Judging claims about the smoothness of limits.

mod exponent;
mod range;
mod trial;
mod vertex_range;
mod vertices;

use crate::claim::{Paper, PrintedValences, SmoothnessBody, SmoothnessClaim, SmoothnessStatement};
use crate::diagnostic::Diagnostic;
use crate::evaluation::library::Library;
use crate::evaluation::limits::LimitScheme;
use crate::exact::RealCyclotomic;
use crate::finding::{Known, Limits, SmoothnessFinding, SmoothnessVerdict};
use crate::scheme::Mask;
use crate::smoothness::Smoothness;

/// Judges a claim about the limits of a scheme.
pub(crate) fn judge<'a>(
    paper: &Paper,
    claim: &'a SmoothnessClaim,
    library: &Library<'_>,
) -> Result<SmoothnessFinding<'a>, Diagnostic> {
    let (verdict, known) = match &claim.body {
        SmoothnessBody::NotCheckable(absent) => {
            (SmoothnessVerdict::NotCheckable, Known::Absent(absent.clone()))
        }
        SmoothnessBody::Statement(located, statement) => {
            of(&LimitScheme { paper, library, located, given: &claim.given }, statement)?
        }
    };
    Ok(SmoothnessFinding { id: format!("{}:{}", paper.key, claim.id), claim, verdict, known })
}

fn of(
    scheme: &LimitScheme<'_>,
    statement: &SmoothnessStatement,
) -> Result<(SmoothnessVerdict, Known), Diagnostic> {
    if let SmoothnessStatement::Range(range) = statement {
        return range::judge(scheme, range);
    }
    if let Some(instances) = scheme.ring_instances::<RealCyclotomic>(None)? {
        return vertices::judge(scheme, &instances, statement);
    }
    let limits = match limits(scheme.mask(None)?) {
        Ok(limits) => limits,
        Err(capped) => return Ok((SmoothnessVerdict::NotCheckable, Known::Capped(capped))),
    };
    let smoothness = &limits.smoothness;
    let verdict = match statement {
        SmoothnessStatement::Continuity { valences: Some(valences), .. } => {
            return Err(no_valences(scheme, valences));
        }
        SmoothnessStatement::Continuity { continuous, not_continuous, valences: None } => {
            together(&[
                continuous.map_or(Some(true), |m| is_continuous(smoothness, m)),
                not_continuous.map_or(Some(true), |m| {
                    is_continuous(smoothness, m).map(|continuous| !continuous)
                }),
            ])
        }
        SmoothnessStatement::Exponent { exponent, attained } => {
            exponent::judge(smoothness, exponent, *attained)
        }
        SmoothnessStatement::Range(_) => unreachable!("ranges are judged above"),
    };
    Ok((verdict, Known::Limits(Box::new(limits))))
}

/// A mask has no valences.
fn no_valences(scheme: &LimitScheme<'_>, valences: &PrintedValences) -> Diagnostic {
    scheme
        .error(format!("`valences = '{}'` of a mask", valences.text))
        .with_help("valences are those of rules around a vertex or on a face, such as `loop`")
}

/// What is proved of the limits of a mask, or the cap that its rules are beyond.
fn limits(mask: Mask) -> Result<Limits, String> {
    let smoothness = Smoothness::of(&mask).map_err(|error| error.to_string())?;
    Ok(Limits { mask, smoothness })
}

/// Whether all limits are C^m, where that is decided.
fn is_continuous(smoothness: &Smoothness, m: usize) -> Option<bool> {
    if smoothness.continuity.is_some_and(|proved| m <= proved) {
        return Some(true);
    }
    smoothness.continuity_fails.is_some_and(|fails| fails <= m).then_some(false)
}

/// The verdict of a claim that says all of these.
fn together(parts: &[Option<bool>]) -> SmoothnessVerdict {
    if parts.contains(&Some(false)) {
        SmoothnessVerdict::Refuted
    } else if parts.contains(&None) {
        SmoothnessVerdict::Open
    } else {
        SmoothnessVerdict::Confirmed
    }
}
