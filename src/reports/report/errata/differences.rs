//! Where the literature and the exact values differ: the errata of many papers in one table for each kind of harm.

use super::cells;
use crate::audit::{
    Beyond, CellErratum, CellFinding, Erratum, Harm, NotSharp, PaperAudit, SmoothnessFinding,
    SmoothnessVerdict, Subject, Word,
};
use crate::claim::{ExponentStatement, SmoothnessBody, SmoothnessClaim, SmoothnessStatement};
use crate::exact::{Enclosed as _, format::fixed};
use crate::report::smooth::{limits, smoothness};
use crate::report::told::told;
use crate::report::words::sheet::{Grid, Sheet};
use crate::smoothness::Hoelder;

/// The longest text of a cell; longer ones are cut.
pub(crate) const LONGEST: usize = 160;

/// The longest formula of an exponent.
const SHORT: usize = 40;

/// The places of the decimals of a bound.
const PLACES: u32 = 4;

/// A claim that is not what it should be.
pub(crate) struct Line {
    key: String,
    pub(crate) id: String,
    source: String,
    /// What is said of it.
    pub(crate) word: Word,
    /// Where it stands, and what it is about.
    pub(crate) place: String,
    pub(crate) printed: String,
    pub(crate) exact: String,
    /// How the printed one came about, where that is known.
    pub(crate) origin: String,
}

/// What differs in a paper.
pub(crate) fn lines(audit: &PaperAudit<'_>) -> Vec<(Harm, Line)> {
    let errata = audit.errata();
    let wrong = errata.errata.iter().map(|one| (one.harm(), Line::of_erratum(audit, one)));
    let not_sharp = audit.not_sharp();
    let not_sharp = not_sharp.iter().map(|one| (Harm::NotSharp, Line::of_not_sharp(audit, one)));
    wrong.chain(not_sharp).collect()
}

/// What differs in papers, the worst first: a table for each [`Harm`], whose first column has the ids of claims.
#[must_use]
pub fn differences_sheet(audits: &[PaperAudit<'_>]) -> Sheet {
    let lines: Vec<(Harm, Line)> = audits.iter().flat_map(lines).collect();
    let mut sheet = Sheet::titled("Where the literature and the exact values differ");
    let with = |audit: &&PaperAudit<'_>| lines.iter().any(|(_, line)| line.key == audit.paper.key);
    sheet.text(format!(
        "{} differences in {} of {} papers, the worst first. Each line has the claim, by which `subcert explain` finds \
         it, what is printed, what is exact, and how the printed one came about, where that is known.",
        lines.len(),
        audits.iter().filter(with).count(),
        audits.len()
    ));
    for harm in Harm::ALL {
        let rows: Vec<Vec<String>> =
            lines.iter().filter(|(of, _)| *of == harm).map(|(_, line)| line.row()).collect();
        if !rows.is_empty() {
            sheet.heading(2, heading(harm));
            let header = ["claim", "source", "place", "printed", "exact", "how it came about"];
            sheet.grid(Grid::of(header, rows, 6));
        }
    }
    let without: Vec<String> =
        audits.iter().filter(|audit| !with(audit)).map(without_difference).collect();
    if !without.is_empty() {
        sheet.heading(2, "Papers without a difference");
        sheet.text(format!("{}.", without.join(", ")));
    }
    sheet
}

/// `Kobbelt 2000 (kobbelt2000, of which 1 claim is not decided)`.
fn without_difference(audit: &PaperAudit<'_>) -> String {
    let undecided = |finding: &&SmoothnessFinding<'_>| {
        matches!(finding.verdict, SmoothnessVerdict::Open | SmoothnessVerdict::NotCheckable)
    };
    let open = match audit.smoothness.iter().filter(undecided).count() {
        0 => String::new(),
        1 => ", of which 1 claim is not decided".to_owned(),
        count => format!(", of which {count} claims are not decided"),
    };
    format!("{} ({}{open})", audit.paper.bibliography.short(), audit.paper.key)
}

/// What the lines of a table have in common.
fn heading(harm: Harm) -> &'static str {
    match harm {
        Harm::Refuted => "Refuted theorems and refuted smoothness",
        Harm::Broken => "Promises that are broken for some control data",
        Harm::Unshown => "Promises that are not shown to be kept",
        Harm::Formula => "Formulas that are not what they should be",
        Harm::Number => "Numbers that are not what their definitions give",
        Harm::NotSharp => "True, but not sharp",
    }
}

impl Line {
    fn of_erratum(audit: &PaperAudit<'_>, erratum: &Erratum<'_, '_>) -> Line {
        let subject = &erratum.subject;
        let (title, printed, exact, origin) = match subject {
            Subject::Cells(cells) => {
                let [printed, exact] = numbers(cells, erratum.harm());
                let origin = cells::origin(cells);
                (cells.finding.table.title.as_str(), printed, exact, Some(origin))
            }
            Subject::Claim(finding) => {
                let told = told(*finding);
                let [printed, exact] = told.difference();
                (finding.claim().title(), printed, exact, told.origin())
            }
        };
        let word = match erratum.harm() {
            Harm::Broken => Word::Broken,
            Harm::Unshown => Word::Open,
            _ => subject.verdict(),
        };
        let place = place(subject.locus(), title);
        Line::new(audit, subject.id(), word, place, [printed, exact], origin)
    }

    fn of_not_sharp(audit: &PaperAudit<'_>, more: &NotSharp<'_, '_>) -> Line {
        let claim = more.finding.claim;
        let known = smoothness::outcome(more.finding);
        let exact = match (&more.beyond, &more.finding.known) {
            // Where the limits are so smooth, and where not.
            (Beyond::Range(_), _) => {
                known.iter().take(2).cloned().collect::<Vec<String>>().join("; ")
            }
            (Beyond::Exponent, known) => {
                let exponent = known.proven().and_then(|proven| proven.hoelder).map(exponent);
                format!("the exponent is {}", exponent.unwrap_or_default())
            }
            _ => known.first().cloned().unwrap_or_default(),
        };
        let decimal = bound(claim).map(|value| format!(" ≈ {value}")).unwrap_or_default();
        let printed = format!("{}{decimal}", smoothness::statement(claim).unwrap_or_default());
        let place = place(&claim.locus, &claim.title);
        let word = more.finding.verdict.word();
        Line::new(audit, &claim.id, word, place, [printed, exact], claim.note.clone())
    }

    fn new(
        audit: &PaperAudit<'_>,
        id: &str,
        word: Word,
        place: String,
        [printed, exact]: [String; 2],
        origin: Option<String>,
    ) -> Line {
        let first = |text: String| text.lines().next().unwrap_or_default().to_owned();
        Line {
            key: audit.paper.key.clone(),
            id: id.to_owned(),
            source: audit.paper.bibliography.short(),
            word,
            place,
            printed: cut(printed, LONGEST),
            exact: cut(exact, LONGEST),
            origin: origin.map(first).unwrap_or_default(),
        }
    }

    fn row(&self) -> Vec<String> {
        let Line { key, id, source, place, printed, exact, origin, .. } = self;
        let told = [source, place, printed, exact, origin].map(Clone::clone);
        std::iter::once(format!("{key}:{id}")).chain(told).collect()
    }
}

/// Where a claim stands, and what it is about.
fn place(locus: &str, title: &str) -> String {
    [locus, title].into_iter().filter(|text| !text.is_empty()).collect::<Vec<&str>>().join(": ")
}

/// An exponent: its formula where that is short, and its decimals where it is irrational.
fn exponent(hoelder: &Hoelder) -> String {
    let [low, high] = limits::decimals(hoelder);
    let decimals = if low == high { low } else { format!("{low} to {high}") };
    match &hoelder.formula {
        Some(formula) if formula.as_rational().is_some() => formula.to_string(),
        Some(formula) if formula.to_string().chars().count() <= SHORT => {
            format!("{formula}, {decimals}")
        }
        _ => decimals,
    }
}

/// The only bound of an exponent that a claim states, in decimals.
fn bound(claim: &SmoothnessClaim) -> Option<String> {
    let SmoothnessBody::Statement(_, statement) = &claim.body else { return None };
    let SmoothnessStatement::Exponent { exponent, .. } = &**statement else { return None };
    let ExponentStatement::Bounds { at_least, at_most } = exponent else { return None };
    let ((Some(bound), None) | (None, Some(bound))) = (at_least, at_most) else { return None };
    Some(fixed(&bound.value.enclosure(1).middle(), PLACES))
}

/// The first of the cells as printed and as it should be, and how many there are. Where promises are broken, or not
/// shown to be kept, the first of those.
fn numbers(cells: &CellErratum<'_, '_>, harm: Harm) -> [String; 2] {
    let counts = |cell: &CellFinding| match harm {
        Harm::Broken => cell.keeps_promise() == Some(false),
        Harm::Unshown => cell.may_break_promise(),
        _ => true,
    };
    let mut of_harm = cells.cells.iter().zip(cells.findings()).filter(|(_, cell)| counts(cell));
    let Some((&(row, column), cell)) = of_harm.next() else { return Default::default() };
    let Some(printed) = cells.finding.table.cells[row][column].printed() else {
        return Default::default();
    };
    let promised = cells.finding.table.promise.is_some();
    let by_definition = cells::correct(cell.exact.as_ref(), printed, promised);
    let exact = match harm {
        Harm::Broken | Harm::Unshown => {
            format!("{by_definition} by definition; sound: {}", cells::sound(cell))
        }
        _ => by_definition,
    };
    let all = cells.cells.len();
    let these = 1 + of_harm.count();
    let printed = match (all, these) {
        (1, _) => printed.text.clone(),
        (_, 1) => format!("{}, one of {all} numbers", printed.text),
        (all, these) if all == these => format!("{all} numbers, the first {}", printed.text),
        (all, these) => format!("{these} of {all} numbers, the first {}", printed.text),
    };
    [printed, exact]
}

/// A text of no more than `longest` characters.
pub(crate) fn cut(text: String, longest: usize) -> String {
    if text.chars().count() <= longest {
        return text;
    }
    text.chars().take(longest.saturating_sub(1)).chain(['…']).collect()
}
