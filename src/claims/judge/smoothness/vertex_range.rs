//! Judging the values of a parameter for which surfaces at a vertex or on a face are said to be C¹.

use super::trial::{Judged, Sides, Trial};
use super::vertices::{TRIED, capped, of_each};
use crate::characteristic::{Vertex, VertexRangeError, vertex_range};
use crate::claim::{PrintedValences, SmoothRangeStatement};
use crate::diagnostic::Diagnostic;
use crate::evaluation::limits::LimitScheme;
use crate::exact::{Polynomial, Rational, RealCyclotomic};
use crate::finding::{KnownLimits, RangeAtValence, SmoothnessVerdict, VertexWitness};

/// Judges a range of rules around a vertex or on a face, at each valence of which it speaks. Of a range
/// for all valences some are tried, and it is refuted or open.
pub(super) fn judge(
    scheme: &LimitScheme<'_>,
    statement: &SmoothRangeStatement,
) -> Result<(SmoothnessVerdict, KnownLimits), Diagnostic> {
    if statement.m != 1 {
        return Err(scheme
            .error(format!("`smoothness = '{}'` of rules", statement.m))
            .with_help("for rules around a vertex or on a face, the range of C^1 is judged"));
    }
    let (valences, all) = match &statement.valences {
        None => (vec![None], false),
        Some(PrintedValences { first, last: Some(last), .. }) => {
            ((*first..=*last).map(Some).collect(), false)
        }
        Some(PrintedValences { last: None, .. }) => (TRIED.map(Some).collect(), true),
    };
    let (mut verdicts, mut found) = (Vec::new(), Vec::new());
    for valence in valences {
        let (verdict, range) = match of_valence(scheme, statement, valence)? {
            Ok(judged) => judged,
            Err(error) => return Ok(capped(error)),
        };
        verdicts.push(verdict);
        found.push(range);
        if all && verdict == SmoothnessVerdict::Refuted {
            break;
        }
    }
    let verdict = match of_each(&verdicts) {
        SmoothnessVerdict::Refuted => SmoothnessVerdict::Refuted,
        _ if all => SmoothnessVerdict::Open,
        verdict => verdict,
    };
    Ok((verdict, KnownLimits::VertexRanges(found)))
}

type AtOneValence = (SmoothnessVerdict, RangeAtValence);

fn of_valence(
    scheme: &LimitScheme<'_>,
    statement: &SmoothRangeStatement,
    valence: Option<usize>,
) -> Result<Result<AtOneValence, VertexRangeError>, Diagnostic> {
    let variable = &statement.variable;
    let ring = scheme.ring(Some((variable, Polynomial::variable(variable))), valence)?;
    let range = match vertex_range(&ring, variable) {
        Ok(range) => range,
        Err(error) => return Ok(Err(error)),
    };
    scheme.check_valence(valence, range.order)?;
    let at = |at: &Rational| {
        let ring = scheme.ring(Some((variable, RealCyclotomic::from(at.clone()))), valence)?;
        let Ok(vertex) = Vertex::of_ring(ring) else { return Ok(None) };
        Ok(vertex.is_continuous(1).map(|smooth| (smooth, vertex)))
    };
    let sides = Some(Sides {
        inside: range.inside.clone(),
        outside: range.outside.clone(),
        but_finitely_many: false,
    });
    let Judged { verdict, undecided, witness } = Trial { statement, sides, at: &at }.judged()?;
    let witness = witness.map(|(at, inside, vertex)| VertexWitness { at, inside, vertex });
    Ok(Ok((verdict, RangeAtValence { range, undecided, witness })))
}
