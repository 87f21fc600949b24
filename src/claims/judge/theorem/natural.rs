//! Whether a refuted theorem is also refuted with each point at its natural parameter.

use crate::claim::{Paper, Quantity, Statement, Theorem};
use crate::diagnostic::Diagnostic;
use crate::finding::{CaseFinding, Control, EveryShift, Naturally, Outcome, Violation};
use crate::judge::distance::has_words;
use crate::judge::theorem::case::Case;
use crate::judge::theorem::trial::Trial;
use crate::limit::Parametrisation;
use crate::scheme::Mask;

/// Whether the natural parameters differ from i/n^k in some case.
fn moves(cases: &[Case<'_>]) -> bool {
    let moves =
        |case: &Case<'_>| case.setting.as_deref().is_some_and(|own| own.natural().is_some());
    cases.iter().any(moves)
}

/// Whether the parameters of points matter to a theorem: it is not about differences, and in some
/// case the natural parameters differ from i/n^k.
pub(crate) fn placed(theorem: &Theorem, cases: &[Case<'_>]) -> bool {
    let differences =
        matches!(theorem.statement, Statement::Bound { quantity: Quantity::Difference, .. });
    !differences && moves(cases)
}

/// The outcome of each case with the points at their natural parameters.
pub(crate) fn outcomes(
    paper: &Paper,
    theorem: &Theorem,
    cases: &[Case<'_>],
    indexed: &[CaseFinding],
) -> Result<Vec<Outcome>, Diagnostic> {
    if theorem.tried.natural || !placed(theorem, cases) {
        return Ok(indexed.iter().map(|case| case.outcome.clone()).collect());
    }
    let trial =
        Trial { paper, theorem, corrections: &[], parametrisation: Parametrisation::Natural };
    cases.iter().map(|case| trial.of(case)).collect()
}

/// Whether the theorem is refuted in a case; `None` where that is not known.
pub(crate) fn refutes(outcome: &Outcome) -> Option<bool> {
    match outcome {
        Outcome::Refuted(_) => Some(true),
        Outcome::Proved | Outcome::UpTo(_) | Outcome::Outside(_) => Some(false),
        Outcome::Unknown(_) => None,
    }
}

/// The result for the theorem, from the outcomes of its cases.
pub(crate) fn naturally(
    cases: &[Case<'_>],
    outcomes: &[Outcome],
    every_shift: Option<&EveryShift>,
) -> Naturally {
    let refuted = cases.iter().zip(outcomes).filter_map(|(case, outcome)| match outcome {
        Outcome::Refuted(violation) => Some((case, violation)),
        _ => None,
    });
    match refuted.min_by_key(|(_, violation)| size(violation)) {
        Some((case, violation)) => {
            let resolved = case.resolved.iter().flat_map(|scheme| scheme.constants.iter());
            let masks: Vec<&Mask> = resolved.map(|axis| axis.mask()).collect();
            Naturally::Refuted {
                case: case.label.clone(),
                scheme: case.scheme.clone(),
                values: case.chosen.clone(),
                certifiable: has_words(&masks, &violation.attained),
                violation: violation.clone(),
            }
        }
        None if matches!(every_shift, Some(EveryShift::Refuted { .. })) => {
            Naturally::AsInEveryShift
        }
        None if outcomes.iter().all(|outcome| refutes(outcome) == Some(false)) => Naturally::Holds,
        None => Naturally::Open,
    }
}

/// The effort of checking a violation: its level, the number of its points, the length of its
/// numbers.
pub(crate) fn size(violation: &Violation) -> (u32, usize, usize) {
    let points = match &violation.attained.control {
        Control::Polygon(polygon) => polygon.points.len(),
        Control::Net { rows, .. } => rows.iter().map(Vec::len).sum(),
        Control::Points(points) => points.len(),
    };
    let text = format!("{}{}", violation.attained.value, violation.bound);
    (violation.level, points, text.len())
}
