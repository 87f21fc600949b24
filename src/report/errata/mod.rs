//! The errata of a paper, as one could send them to a journal.

mod cells;
mod claims;
mod json;

use super::sheet::{Grid, Sheet};
use super::{consistency, mark, summary, theorem};
use crate::audit::{Consequences, Errata, Erratum, PaperAudit, Standing, Subject};
use crate::claim::Promise;
pub use json::errata_json;

/// The errata of papers.
#[must_use]
pub fn errata_sheet(audits: &[PaperAudit<'_>]) -> Sheet {
    let mut sheet = Sheet::default();
    for audit in audits {
        paper(&mut sheet, &audit.errata());
    }
    sheet
}

fn paper(sheet: &mut Sheet, errata: &Errata<'_, '_>) {
    let audit = errata.audit;
    let bibliography = &audit.paper.bibliography;
    sheet.heading(1, format!("Errata · {}", bibliography.short()));
    let doi = bibliography.doi.as_ref().map(|doi| format!(" DOI {doi}.")).unwrap_or_default();
    sheet.text(format!("{}. {}.{doi}", bibliography.title, bibliography.venue));
    if let Some(note) = &bibliography.note {
        sheet.text(format!(
            "{note} A wrong digit may be the transcription's: compare with the printed page."
        ));
    }
    if errata.errata.is_empty() {
        sheet.text("Nothing wrong was found.");
    } else {
        sheet.text(
            "An arrow leads from what is printed to what the definition gives as it is printed; \
             where the definition is wrong itself, it has an entry of its own.",
        );
    }
    for (i, erratum) in errata.errata.iter().enumerate() {
        one(sheet, i + 1, erratum);
    }
    if !audit.theorems.is_empty() {
        sheet.heading(2, "Theorems, and what they rest on that fails");
        let row = |finding: &crate::audit::TheoremFinding<'_>| {
            vec![finding.theorem.locus.clone(), theorem::outcome(finding)]
        };
        let header = ["theorem", "verdict"].map(str::to_owned).to_vec();
        let rows = audit.theorems.iter().map(row).collect();
        sheet.grid(Grid { header, rows, left_columns: 2 });
    }
    consistency::section(sheet, audit);
    cells::unchecked(sheet, errata);
    summary::section(sheet, audit);
}

fn one(sheet: &mut Sheet, number: usize, erratum: &Erratum<'_, '_>) {
    let subject = &erratum.subject;
    let name = subject.verdict();
    let name = match subject {
        Subject::Cells(cells) if cells.outcome.standing == Standing::Confirmed => {
            "✗ a promise that is not kept, or not shown to be".to_owned()
        }
        _ => format!("{} {name}", mark(name)),
    };
    sheet.heading(2, format!("{number}. {} · {name}", subject.locus()));
    let mut facts = match subject {
        Subject::Cells(cells) => cells::facts(cells),
        Subject::Equation(finding) => claims::equation(finding),
        Subject::Function(finding) => claims::function(finding),
        Subject::Range(finding) => claims::range(finding),
        Subject::Theorem(finding) => claims::theorem(finding),
    };
    facts.push(("what it changes".to_owned(), changes(subject, &erratum.consequences)));
    sheet.facts(facts);
    if let Subject::Cells(cells) = subject {
        sheet.grid(cells::grid(cells));
    }
}

/// What an erratum changes, in sentences.
fn changes(subject: &Subject<'_, '_>, consequences: &Consequences<'_, '_>) -> String {
    let Consequences { smaller, larger, broken_by_formula, kept, broken, open, .. } = consequences;
    let mut lines = Vec::new();
    if let Subject::Cells(cells) = subject {
        let what = match cells.finding.table.promise {
            Some(Promise::Depth { .. }) => "depths",
            Some(Promise::Bound { .. }) => "bounds",
            None => "numbers",
        };
        let all = cells.cells.len();
        if smaller + larger > 0 {
            lines.push(format!(
                "Of {all} printed {what}, {smaller} are smaller than the definition's and {larger} \
                 larger."
            ));
        }
        if *broken_by_formula > 0 {
            lines.push(format!(
                "{broken_by_formula} of {all} printed {what} do not keep their promise by the \
                 printed formula."
            ));
        }
        let promises = [
            (kept, "keep their promise for all control data"),
            (broken, "break their promise for some control data"),
            (open, "are not shown to keep their promise, nor to break it"),
        ];
        let promises = promises.into_iter().filter(|(count, _)| **count > 0);
        lines.extend(
            promises.map(|(count, do_what)| format!("{count} of {all} printed {what} {do_what}.")),
        );
    }
    if !consequences.used_by.is_empty() {
        lines.push(format!("It is used by {}.", consequences.used_by.join("; ")));
    }
    if !consequences.theorems.is_empty() {
        let theorem = |finding: &&crate::audit::TheoremFinding<'_>| {
            format!("{} ({})", finding.theorem.locus, finding.verdict.name())
        };
        let theorems: Vec<String> = consequences.theorems.iter().map(theorem).collect();
        lines.push(format!("On it rest {}.", theorems.join("; ")));
    }
    if lines.is_empty() {
        lines.push("No other claim of the paper rests on it.".to_owned());
    }
    lines.join("\n")
}
