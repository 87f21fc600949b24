//! The ledger: a line for each claim of the five papers, with its id, its verdict and its exact value.
//!
//! `SNAPSHOTS=overwrite cargo test ledger` writes it anew.

use crate::common::papers::AUDITS;
use snapbox::{assert_data_eq, file};
use std::fmt::Write;
use subcert::audit::{
    CellFinding, EquationVerdict, FunctionVerdict, Kept, PaperAudit, TheoremFinding,
};

/// The verdict, what it would be under assumptions, the promise, the exact value and the reading.
fn cell(cell: &CellFinding) -> String {
    let mut line = format!("{} {}", cell.id, cell.verdict.word().name());
    if let Some(assumed) = &cell.verdict_if_assumed {
        write!(line, "/{}", assumed.word().name()).expect("a text");
    }
    line += match &cell.kept {
        None => "",
        Some(Kept::Yes) => " kept",
        Some(Kept::No(_)) => " broken",
        Some(Kept::Open(_)) => " promise-open",
    };
    let exact = cell.exact.as_ref().map_or_else(|| "undefined".to_owned(), ToString::to_string);
    write!(line, " {exact}").expect("a text");
    if let Some(read) = &cell.as_read {
        write!(line, " [{}: {}]", read.differs(), read.value).expect("a text");
    }
    line
}

fn theorem(finding: &TheoremFinding<'_>) -> String {
    let mut line = format!("{} {}", finding.id, finding.verdict.word().name());
    if let Some(refutation) = &finding.refutation {
        let violation = &refutation.violation;
        let (value, bound) = (&violation.attained.value, &violation.bound);
        let (case, level) = (&refutation.case, violation.level);
        write!(line, " [{case}, level {level}: {value} > {bound}]").expect("a text");
    }
    line
}

fn lines(audit: &PaperAudit<'_>) -> Vec<String> {
    let mut lines: Vec<String> =
        audit.tables.iter().flat_map(|table| table.cells.iter().flatten()).map(cell).collect();
    for finding in &audit.equations {
        let detail = match &finding.verdict {
            EquationVerdict::Holds { cases } => format!("in {cases}"),
            EquationVerdict::Fails { cases, failures, .. } => {
                format!("in {} of {cases}: {}", failures.len(), failures[0].difference())
            }
            EquationVerdict::Proved => "for all".to_owned(),
            EquationVerdict::Tried { cases } => format!("tried in {cases}"),
            EquationVerdict::Undecided { cases, open } => format!("{} of {cases} open", open.len()),
            EquationVerdict::Reals(found) => {
                found.cases.iter().flat_map(|case| &case.truth).map(ToString::to_string).collect()
            }
            EquationVerdict::NotCheckable | EquationVerdict::BeyondCap(_) => String::new(),
        };
        lines.push(format!("{} {} {detail}", finding.id, finding.verdict.word().name()));
    }
    for finding in &audit.functions {
        let detail = match &finding.verdict {
            FunctionVerdict::Fails { example, .. } => {
                format!("at {}: {} and {}", example.at, example.left, example.right)
            }
            FunctionVerdict::Holds | FunctionVerdict::BeyondCap(_) => String::new(),
        };
        lines.push(format!("{} {} {detail}", finding.id, finding.verdict.word().name()));
    }
    for finding in &audit.ranges {
        let exact = finding
            .found
            .as_ref()
            .map_or_else(ToString::to_string, |found| found.exact.to_string());
        lines.push(format!("{} {} {exact}", finding.id, finding.verdict().name()));
    }
    lines.extend(audit.theorems.iter().map(theorem));
    lines
}

#[test]
fn every_claim_of_the_papers() {
    let lines: Vec<String> = AUDITS.iter().flat_map(lines).collect();
    let lines = lines.iter().map(|line| line.trim_end()).collect::<Vec<&str>>().join("\n");
    assert_data_eq!(format!("{lines}\n"), file!["ledger.txt"]);
}
