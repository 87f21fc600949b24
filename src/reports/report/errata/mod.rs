//! The errata of a paper, as one could send them to a journal.

pub(super) mod cells;
pub(super) mod differences;
pub(crate) mod latex_table;

pub use differences::differences_sheet;

use crate::audit::{Consequences, Errata, Erratum, PaperAudit, Subject};
use crate::claim::Promise;
use crate::report::papers::consistency;
use crate::report::papers::headline::unstated_offsets;
use crate::report::papers::summary;
use crate::report::tables::reading::capital;
use crate::report::theorems::theorem;
use crate::report::told::told;
use crate::report::words::sheet::{Block, Grid, Sheet};

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
    sheet.text(format!("{}{doi}", bibliography.title_and_venue()));
    if let Some(note) = &bibliography.note {
        sheet.text(format!(
            "{note} A wrong digit may be the transcription's: compare with the printed page."
        ));
    }
    for said in unstated_offsets(audit) {
        sheet.text(capital(&said));
    }
    if errata.errata.is_empty() {
        let judged = audit.findings().next().is_some();
        let said = if judged {
            "Nothing wrong was found."
        } else {
            "There is nothing to check: the claim file has no claims."
        };
        sheet.text(said);
    } else {
        sheet.text(
            "An arrow leads from what is printed to what the definition gives as it is printed; \
             where the definition is wrong itself, it has an entry of its own.",
        );
    }
    let entries: Vec<Entry> =
        errata.errata.iter().zip(1..).map(|(erratum, number)| Entry::of(number, erratum)).collect();
    for alike in entries.chunk_by(Entry::is_like) {
        group(sheet, alike);
    }
    if !audit.theorems.is_empty() {
        sheet.heading(2, "Theorems, and what they rest on that fails");
        let row = |finding: &crate::audit::TheoremFinding<'_>| {
            vec![finding.theorem.locus.clone(), theorem::outcome(finding)]
        };
        sheet.grid(Grid::of(["theorem", "verdict"], audit.theorems.iter().map(row), 2));
    }
    consistency::section(sheet, audit);
    cells::recovered(sheet, errata);
    cells::unchecked(sheet, errata);
    summary::section(sheet, audit);
}

/// An erratum in words.
struct Entry {
    number: usize,
    /// The locus and the verdict.
    heading: String,
    /// The title of the claim; `None` for cells.
    title: Option<String>,
    facts: Vec<(String, String)>,
    /// How it came about, and what it changes. Claims that fail for one reason have this in common.
    causes: Vec<(String, String)>,
    grid: Option<Grid>,
}

impl Entry {
    fn of(number: usize, erratum: &Erratum<'_, '_>) -> Entry {
        let subject = &erratum.subject;
        let word = subject.verdict();
        let name = match subject {
            Subject::Cells(cells) if cells.as_defined => {
                "✗ a promise that is not kept, or not shown to be".to_owned()
            }
            _ => format!("{} {word}", word.mark()),
        };
        let (title, facts, origin) = match subject {
            Subject::Cells(cells) => (None, cells::facts(cells), cells::origin(cells)),
            Subject::Claim(finding) => {
                let (facts, reasons) = told(*finding).erratum();
                let origin = if reasons.is_empty() {
                    "not explained".to_owned()
                } else {
                    reasons.join("\n")
                };
                (Some(finding.claim().title().to_owned()), facts, origin)
            }
        };
        let mut causes = vec![("how it came about".to_owned(), origin)];
        let mut grid = None;
        if let Subject::Cells(cells) = subject {
            causes.extend(cells.finding.table.note.clone().map(|note| ("note".to_owned(), note)));
            grid = Some(cells::grid(cells));
        }
        causes.push(("what it changes".to_owned(), changes(subject, &erratum.consequences)));
        let heading = format!("{} · {name}", subject.locus());
        Entry { number, heading, title, facts, causes, grid }
    }

    /// Claims that fail at one place for one reason.
    fn is_like(&self, other: &Entry) -> bool {
        self.title.is_some() && self.heading == other.heading && self.causes == other.causes
    }
}

/// Writes errata that are alike; what they have in common is written once.
fn group(sheet: &mut Sheet, alike: &[Entry]) {
    let [first, .., last] = alike else {
        for Entry { number, heading, title, facts, causes, grid } in alike {
            sheet.heading(2, format!("{number}. {heading}"));
            let says = title.clone().filter(|title| !title.is_empty());
            let says = says.map(|title| ("says".to_owned(), title));
            sheet.facts(says.into_iter().chain(facts.clone()).chain(causes.clone()).collect());
            sheet.blocks.extend(grid.clone().map(Block::Grid));
        }
        return;
    };
    sheet.heading(2, format!("{} to {}. {}", first.number, last.number, first.heading));
    sheet.facts(first.causes.clone());
    for entry in alike {
        let title = entry.title.as_deref().unwrap_or_default();
        sheet.heading(3, format!("{}. {title}", entry.number));
        sheet.facts(entry.facts.clone());
    }
}

/// The consequences of an erratum, in sentences.
fn changes(subject: &Subject<'_, '_>, consequences: &Consequences<'_, '_>) -> String {
    let Consequences { smaller, larger, broken_by_formula, kept, broken, open, .. } = consequences;
    let mut lines = Vec::new();
    if let Subject::Cells(cells) = subject {
        let all = cells.cells.len();
        let what = match (&cells.finding.table.promise, all) {
            (Some(Promise::Depth { .. }), 1) => "depth",
            (Some(Promise::Depth { .. }), _) => "depths",
            (Some(Promise::Bound { .. }), 1) => "bound",
            (Some(Promise::Bound { .. }), _) => "bounds",
            (None, 1) => "number",
            (None, _) => "numbers",
        };
        if smaller + larger > 0 {
            let is = if *smaller == 1 { "is" } else { "are" };
            lines.push(format!(
                "Of {all} printed {what}, {smaller} {is} smaller than the definition's and {larger} \
                 larger."
            ));
        }
        let promises = [
            (
                broken_by_formula,
                ["does not keep its", "do not keep their"],
                "by the printed formula",
            ),
            (kept, ["keeps its", "keep their"], "for all control data"),
            (broken, ["breaks its", "break their"], "for some control data"),
            (open, ["may keep its", "may keep their"], "or break it: neither is shown"),
        ];
        let promises = promises.into_iter().filter(|(count, ..)| **count > 0);
        lines.extend(promises.map(|(count, words, how)| {
            let does = words[usize::from(*count != 1)];
            format!("{count} of {all} printed {what} {does} promise {how}.")
        }));
    }
    if !consequences.used_by.is_empty() {
        lines.push(format!("It is used by {}.", consequences.used_by.join("; ")));
    }
    if !consequences.theorems.is_empty() {
        let theorem = |finding: &&crate::audit::TheoremFinding<'_>| {
            format!("{} ({})", finding.theorem.locus, finding.verdict.word())
        };
        let theorems: Vec<String> = consequences.theorems.iter().map(theorem).collect();
        lines.push(format!("On it rest {}.", theorems.join("; ")));
    }
    if lines.is_empty() {
        lines.push("No other claim of the paper rests on it.".to_owned());
    }
    lines.join("\n")
}
