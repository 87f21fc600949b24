//! The numbered items of papers, the claims about them, and what Coq checks.

use crate::audit::{ClaimVerdict, Coverage, CoverageState, PaperAudit};
use crate::report::words::kernel;
use crate::report::words::sheet::{Grid, Sheet};

/// Each paper's numbered items, with the claims that cover them or the reason that
/// there is none.
#[must_use]
pub fn coverage_sheet(audits: &[PaperAudit<'_>]) -> Sheet {
    let mut sheet = Sheet::titled("Coverage");
    sheet.text("The numbered items of the papers, and the claims that cover them.");
    sheet.grid(summary(audits));
    if let Some(grid) = kernel::grid(audits) {
        sheet.heading(2, "Checked by Coq");
        sheet.text(
            "Findings that are theorems of Coq, which the project compiles, of all findings of their kind. Others are \
             theorems that are proved or open, equations, functions, ranges and claims about smoothness.",
        );
        sheet.grid(grid);
    }
    for audit in audits {
        sheet.heading(2, format!("{} · {}", audit.paper.key, audit.paper.bibliography.short()));
        let coverage = audit.coverage();
        if coverage.is_empty() {
            sheet.text("The claim file does not list what the paper numbers.");
            continue;
        }
        let row = |coverage: &Coverage<'_>| vec![coverage.item.label.to_string(), what(coverage)];
        let header = ["item", "claims and verdicts, or why there is none"];
        let rows = coverage.iter().map(row);
        sheet.grid(Grid::of(header, rows, 2));
    }
    sheet
}

fn summary(audits: &[PaperAudit<'_>]) -> Grid {
    let mut header = vec!["paper".to_owned(), "items".to_owned()];
    header.extend(CoverageState::ALL.map(|state| state.name().to_owned()));
    let rows = audits.iter().map(|audit| {
        let coverage = audit.coverage();
        let count = |state| coverage.iter().filter(|coverage| coverage.state() == state).count();
        let mut row = vec![audit.paper.key.clone(), coverage.len().to_string()];
        row.extend(CoverageState::ALL.map(|state| match count(state) {
            0 => "·".to_owned(),
            count => count.to_string(),
        }));
        row
    });
    Grid::of(header, rows, 1)
}

fn what(coverage: &Coverage<'_>) -> String {
    match (coverage.state(), &coverage.item.reason) {
        (CoverageState::Claimed, _) => {
            coverage.claims.iter().map(verdict).collect::<Vec<String>>().join("\n")
        }
        (_, Some(reason)) => reason.clone(),
        (_, None) => "missing".to_owned(),
    }
}

/// `✗ eq-24 fails`, or `table-1: ✓ 6 confirmed, ✗ 12 refuted`.
fn verdict(claim: &ClaimVerdict<'_>) -> String {
    let mut verdicts = claim.verdicts.iter();
    if let (Some((verdict, 1)), None) = (verdicts.next(), verdicts.next()) {
        return format!("{} {} {verdict}", verdict.mark(), claim.id);
    }
    let counts = claim.verdicts.iter();
    let counts = counts.map(|(verdict, count)| format!("{} {count} {verdict}", verdict.mark()));
    format!("{}: {}", claim.id, counts.collect::<Vec<String>>().join(", "))
}
