//! Judging claims about surfaces at a vertex or on a face.

use crate::characteristic::{Vertex, smooth_for_all_valences};
use crate::claim::{PrintedValences, SmoothnessStatement};
use crate::diagnostic::Diagnostic;
use crate::evaluation::limits::LimitScheme;
use crate::exact::RealCyclotomic;
use crate::finding::{KnownLimits, Reason, SmoothnessVerdict, Vertices};
use crate::scheme::{Instance, LocalRules};

/// The valences that are tried where a claim is about all of them, and nothing is proved.
pub(super) const TRIED: std::ops::RangeInclusive<usize> = 3..=12;

/// Judges a claim about rules around a vertex or on a face.
pub(super) fn judge(
    scheme: &LimitScheme<'_>,
    instances: &[Instance<RealCyclotomic>],
    statement: &SmoothnessStatement,
) -> Result<(SmoothnessVerdict, KnownLimits), Diagnostic> {
    let SmoothnessStatement::Continuity { continuous, not_continuous, valences } = statement else {
        return Err(scheme.error("this is claimed of masks only").with_help(
            "for rules around a vertex or on a face, `continuous` and `not_continuous` are judged",
        ));
    };
    let says = |vertex: &Vertex| {
        SmoothnessVerdict::of_all(&[
            continuous.map_or(Some(true), |m| vertex.is_continuous(m)),
            not_continuous.map_or(Some(true), |m| vertex.is_continuous(m).map(|yes| !yes)),
        ])
    };
    let (first, last) = match valences {
        None => (None, None),
        Some(PrintedValences { first, last: Some(last), .. }) => (Some(*first), Some(*last)),
        Some(PrintedValences { last: None, .. }) => {
            return of_all(
                scheme,
                instances,
                says,
                continuous.is_some_and(|m| m <= 1) && not_continuous.is_none(),
            );
        }
    };
    let mut vertices = Vec::new();
    for valence in first.unwrap_or(0)..=last.unwrap_or(0) {
        let ring = scheme.ring(None, first.map(|_| valence))?;
        match Vertex::of_ring(ring) {
            Ok(vertex) => {
                scheme.check_valence(first.map(|_| valence), vertex.spectrum.order)?;
                vertices.push(vertex);
            }
            Err(error) => return Ok(capped(error)),
        }
    }
    let verdicts: Vec<SmoothnessVerdict> = vertices.iter().map(says).collect();
    Ok((of_each(&verdicts), KnownLimits::Vertices(Box::new(Vertices { all: None, vertices }))))
}

/// A claim about all valences from 3 on: one that is proved for all at once, or refuted at one.
fn of_all(
    scheme: &LimitScheme<'_>,
    instances: &[Instance<RealCyclotomic>],
    says: impl Fn(&Vertex) -> SmoothnessVerdict,
    smooth: bool,
) -> Result<(SmoothnessVerdict, KnownLimits), Diagnostic> {
    let name = scheme.library.in_catalogue(instances);
    let all = name.and_then(smooth_for_all_valences).filter(|_| smooth);
    let known = |vertices| KnownLimits::Vertices(Box::new(Vertices { all, vertices }));
    if all.is_some() {
        return Ok((SmoothnessVerdict::Confirmed, known(Vec::new())));
    }
    let mut vertices = Vec::new();
    for valence in TRIED {
        let ring: LocalRules = scheme.ring(None, Some(valence))?;
        let vertex = match Vertex::of_ring(ring) {
            Ok(vertex) => vertex,
            Err(error) => return Ok(capped(error)),
        };
        let verdict = says(&vertex);
        vertices.push(vertex);
        if verdict == SmoothnessVerdict::Refuted {
            return Ok((verdict, known(vertices)));
        }
    }
    Ok((SmoothnessVerdict::Open, known(vertices)))
}

pub(super) fn capped(error: impl Into<Reason>) -> (SmoothnessVerdict, KnownLimits) {
    (SmoothnessVerdict::NotCheckable, KnownLimits::Capped(error.into()))
}

/// The verdict on a claim that is made at each of several valences.
pub(super) fn of_each(verdicts: &[SmoothnessVerdict]) -> SmoothnessVerdict {
    let has = |verdict| verdicts.contains(&verdict);
    if has(SmoothnessVerdict::Refuted) {
        SmoothnessVerdict::Refuted
    } else if has(SmoothnessVerdict::Open) {
        SmoothnessVerdict::Open
    } else if has(SmoothnessVerdict::RoundedEnds) {
        SmoothnessVerdict::RoundedEnds
    } else {
        SmoothnessVerdict::Confirmed
    }
}
