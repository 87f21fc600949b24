//! The head of an audit's report: the counts of each paper's claims.

use super::headline::headline;
use crate::audit::{PaperAudit, TableFinding, Tally, Word};
use crate::claim::Kind;
use crate::report::told::counts;
use crate::report::words::sheet::{Grid, Sheet};

/// The text in place of a count of 0.
const NONE: &str = "·";

/// The head of an audit's report by itself.
#[must_use]
pub fn overview_sheet(audits: &[PaperAudit<'_>]) -> Sheet {
    let mut sheet = Sheet::default();
    overview(&mut sheet, audits);
    sheet
}

/// A sentence for each paper, the cells of the papers' tables by verdict, and then their other
/// claims, by the kinds that occur.
pub(crate) fn overview(sheet: &mut Sheet, audits: &[PaperAudit<'_>]) {
    for audit in audits {
        sheet.text(headline(audit));
    }
    if audits.iter().any(|audit| !audit.tables.is_empty()) {
        sheet.grid(cells(audits));
    }
    let promises: Vec<Tally> = audits.iter().map(promises).collect();
    let mut columns = vec![("promises\n✓ kept ✗ broken ? open", promises)];
    let own: Vec<_> = audits.iter().map(|audit| counts(std::slice::from_ref(audit))).collect();
    columns.extend(counts(audits).into_iter().map(|(kind, _)| {
        let tallies = own.iter().map(|counts| {
            let known = counts.iter().find(|(other, _)| *other == kind);
            known.map(|(_, tally)| tally.clone()).unwrap_or_default()
        });
        (kind.column, tallies.collect())
    }));
    columns.retain(|(_, tallies)| tallies.iter().any(|tally| tally.total() > 0));
    if !columns.is_empty() {
        sheet.grid(others(audits, &columns));
    }
}

fn cells(audits: &[PaperAudit<'_>]) -> Grid {
    let header = ["paper", "cells\n(+ lost)"].map(str::to_owned).into_iter();
    let verdicts = Word::OF_CELLS
        .iter()
        .map(|word| format!("{} {}", word.mark(), word.name().replace('-', "-\n")));
    let rows = audits.iter().map(|audit| {
        let counts = audit.tally(&[Kind::Table]);
        let cells = audit.tables.iter().flat_map(TableFinding::claiming);
        let lost = cells.filter(|cell| cell.printed.is_none()).count();
        let printed = counts.total() - lost;
        let all = match (printed, lost) {
            (0, 0) => NONE.to_owned(),
            (printed, 0) => printed.to_string(),
            (printed, lost) => format!("{printed} + {lost}"),
        };
        let count = |word: Word| match counts.of(word) {
            0 => NONE.to_owned(),
            count => count.to_string(),
        };
        let verdicts = Word::OF_CELLS.map(count);
        [audit.paper.key.clone(), all].into_iter().chain(verdicts).collect()
    });
    Grid::of(header.chain(verdicts), rows, 1)
}

fn others(audits: &[PaperAudit<'_>], columns: &[(&str, Vec<Tally>)]) -> Grid {
    let header = columns.iter().map(|(heading, _)| (*heading).to_owned());
    let rows = audits.iter().enumerate().map(|(place, audit)| {
        let tallies = columns.iter().map(|(_, tallies)| tally(&tallies[place]));
        std::iter::once(audit.paper.key.clone()).chain(tallies).collect()
    });
    Grid::of(std::iter::once("paper".to_owned()).chain(header), rows, 1)
}

/// `cells 5 ✓, 48 ⇄; equations 18 ✓, 12 ✗`: how often each verdict is given to the claims of a paper.
pub(crate) fn counted(audit: &PaperAudit<'_>) -> String {
    let numbers = [("cells", audit.tally(&[Kind::Table])), ("promises", promises(audit))];
    let others = counts(std::slice::from_ref(audit)).into_iter();
    let all = numbers.into_iter().chain(others.map(|(kind, tally)| (kind.several, tally)));
    let judged = all.filter(|(_, counts)| counts.total() > 0);
    judged.map(|(name, counts)| format!("{name} {}", tally(&counts))).collect::<Vec<_>>().join("; ")
}

fn promises(audit: &PaperAudit<'_>) -> Tally {
    let counts = audit.promise_counts();
    let named =
        [(Word::Kept, counts.kept), (Word::Broken, counts.broken), (Word::Open, counts.open)];
    named.into_iter().flat_map(|(word, count)| std::iter::repeat_n(word, count)).collect()
}

/// `55 ✓, 164 ✗, 1 ?`.
fn tally(counts: &Tally) -> String {
    let mut of_marks: Vec<(&str, usize)> = Vec::new();
    for word in Word::ALL {
        match of_marks.iter_mut().find(|(mark, _)| *mark == word.mark()) {
            Some((_, count)) => *count += counts.of(*word),
            None => of_marks.push((word.mark(), counts.of(*word))),
        }
    }
    let parts = of_marks.iter().filter(|(_, count)| *count > 0);
    let parts: Vec<String> = parts.map(|(mark, count)| format!("{count} {mark}")).collect();
    if parts.is_empty() { NONE.to_owned() } else { parts.join(", ") }
}
