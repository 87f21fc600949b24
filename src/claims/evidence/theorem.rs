//! The evidence of certificates about theorems.

use crate::bound::Budget;
use crate::claim::{Paper, Quantity};
use crate::diagnostic::Diagnostic;
use crate::evidence::constants::{MAX_STEPS, SearchedConstant, convergence};
use crate::finding::{EveryShift, Naturally, TheoremFinding};
use crate::judge::theorem::schemes_of;
use std::collections::BTreeSet;

/// The constants that show the convergence of the masks in the refutation of a distance; only those
/// with many residue classes are listed.
///
/// # Errors
/// When a formula of the claim file is wrong.
pub fn theorem_evidence(
    paper: &Paper,
    finding: &TheoremFinding<'_>,
) -> Result<Vec<SearchedConstant>, Diagnostic> {
    let refutation = finding.refutation.as_ref();
    let far = refutation.filter(|found| found.violation.quantity == Quantity::Distance);
    let Some(refutation) = far else { return Ok(Vec::new()) };
    let mut labels = BTreeSet::from([&refutation.case[..]]);
    if let Some(Naturally::Refuted { case, .. }) = &refutation.natural {
        labels.insert(case);
    }
    if let Some(EveryShift::Refuted { case, .. }) = &refutation.every_shift {
        labels.insert(case);
    }
    let schemes = schemes_of(paper, finding.theorem, &labels)?;
    let budget = Budget::new(MAX_STEPS);
    Ok(schemes.iter().flat_map(|scheme| convergence(scheme, &budget)).collect())
}
