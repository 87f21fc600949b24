//! What Coq's kernel accepts of findings.

use super::sheet::Grid;
use crate::audit::{CellFinding, KernelCounts, KernelProof, PaperAudit, Share, TableFinding};

/// What is said after a finding that Coq's kernel accepts.
pub(crate) const CHECKED: &str = " · checked by Coq";

/// The parts of a finding that Coq's kernel accepts, in the words of a list.
fn part(proof: KernelProof) -> &'static str {
    match proof {
        KernelProof::Value => "the exact value",
        KernelProof::Constant => "a constant that the value rests on",
        KernelProof::Sound => "the sound value",
        KernelProof::Broken => "that the promise is broken",
        KernelProof::BrokenNaturally => "that it is broken at natural parameters",
        KernelProof::Refuted => "that it is refuted",
        KernelProof::RefutedNaturally => "that it is refuted at natural parameters",
        _ => proof.name(),
    }
}

/// The fact about a cell.
pub(crate) fn fact(cell: &CellFinding) -> Option<(String, String)> {
    let parts: Vec<&str> = cell.by_kernel.iter().map(|proof| part(*proof)).collect();
    (!parts.is_empty()).then(|| ("checked by Coq".to_owned(), parts.join("; ")))
}

/// How many findings about the cells of a table Coq's kernel accepts.
pub(crate) fn remark(finding: &TableFinding<'_>) -> Option<String> {
    let count = |proof| {
        finding.cells.iter().flatten().filter(|cell| cell.by_kernel.contains(&proof)).count()
    };
    let several = |count, what: &str| match count {
        0 => None,
        1 => Some(format!("1 {what}")),
        _ => Some(format!("{count} {what}s")),
    };
    // A constant is one step on the way to a value.
    let parts = [
        several(count(KernelProof::Value), "exact value"),
        several(count(KernelProof::Sound), "sound value"),
        several(count(KernelProof::Broken), "broken promise"),
        several(count(KernelProof::BrokenNaturally), "promise")
            .map(|promises| format!("{promises} broken at natural parameters")),
    ];
    let parts: Vec<String> = parts.into_iter().flatten().collect();
    (!parts.is_empty()).then(|| format!("Checked by Coq: {}.", parts.join(", ")))
}

/// How many findings of each paper Coq's kernel accepts; `None` where it accepts none.
pub(crate) fn grid(audits: &[PaperAudit<'_>]) -> Option<Grid> {
    let header = [
        "paper",
        "values of cells",
        "sound bounds",
        "broken promises",
        "broken at natural parameters",
        "refuted theorems",
        "refuted at natural parameters",
        "others",
        "all findings",
    ];
    let counts: Vec<KernelCounts> = audits.iter().map(PaperAudit::kernel_counts).collect();
    if counts.iter().all(|counts| counts.total().proved == 0) {
        return None;
    }
    let share = |Share { proved, all }: Share| match all {
        0 => "·".to_owned(),
        _ => format!("{proved} of {all}"),
    };
    let row = |(audit, counts): (&PaperAudit<'_>, &KernelCounts)| {
        let KernelCounts { values, sound, broken, broken_naturally, .. } = *counts;
        let KernelCounts { refuted, refuted_naturally, others, .. } = *counts;
        let shares = [values, sound, broken, broken_naturally, refuted, refuted_naturally, others];
        let mut row = vec![audit.paper.key.clone()];
        row.extend(shares.into_iter().chain([counts.total()]).map(share));
        row
    };
    Some(Grid::of(header, audits.iter().zip(&counts).map(row), 1))
}
