//! The summary of the cells of a paper's tables, at the end of its report.

use crate::audit::{Cause, CellOutcome, CellStanding, CellSummary, PaperAudit, Word};
use crate::report::words::sheet::Sheet;

const STANDINGS: [CellStanding; 6] = [
    CellStanding::Confirmed,
    CellStanding::Reproduced,
    CellStanding::Explained,
    CellStanding::Misprinted,
    CellStanding::Refuted,
    CellStanding::NotCheckable,
];

/// The section that counts the cells, when there are any.
pub(crate) fn section(sheet: &mut Sheet, audit: &PaperAudit<'_>) {
    let summary = audit.cell_summary();
    if summary.groups.is_empty() {
        return;
    }
    sheet.heading(2, "Summary");
    let mut facts = vec![("cells".to_owned(), summary.cells().to_string())];
    for standing in STANDINGS {
        if summary.count(standing) > 0 {
            let name = format!("{} {}", marks(&summary, standing), standing.name());
            facts.push((name, lines(&summary, standing).join("\n")));
        }
    }
    sheet.facts(facts);
}

/// The marks that the cells of a standing have in their tables: explained ones are rounded, or read differently.
fn marks(summary: &CellSummary, standing: CellStanding) -> String {
    let mark = |cause: &Option<Cause>| match cause {
        Some(Cause::Rounded(_)) => Word::Rounding.mark(),
        _ => standing_mark(standing),
    };
    let groups = summary.groups.iter().filter(|group| group.outcome.standing == standing);
    let mut marks: Vec<&str> = groups.map(|group| mark(&group.outcome.cause)).collect();
    marks.sort_unstable();
    marks.dedup();
    marks.concat()
}

pub(crate) fn standing_mark(standing: CellStanding) -> &'static str {
    match standing {
        CellStanding::Confirmed => Word::Confirmed,
        CellStanding::Reproduced => Word::Reproduced,
        CellStanding::Explained => Word::OtherReading,
        CellStanding::Misprinted => Word::Misprint,
        CellStanding::Refuted => Word::Refuted,
        CellStanding::NotCheckable => Word::NotCheckable,
    }
    .mark()
}

/// The number of cells of a standing, and then the number for each cause.
fn lines(summary: &CellSummary, standing: CellStanding) -> Vec<String> {
    let groups = || summary.groups.iter().filter(|group| group.outcome.standing == standing);
    let mut causes: Vec<&Option<Cause>> = groups().map(|group| &group.outcome.cause).collect();
    causes.sort_unstable();
    causes.dedup();
    let count = |cause: &&Option<Cause>| -> usize {
        groups().filter(|group| group.outcome.cause == **cause).map(|group| group.count).sum()
    };
    causes.sort_by_key(|cause| std::cmp::Reverse(count(cause)));
    let all = summary.count(standing);
    // One cause of all stands beside their number.
    let mut lines = match causes[..] {
        [Some(cause)] => vec![format!("{all}: {cause}")],
        _ => vec![all.to_string()],
    };
    let several = causes.len() > 1;
    for cause in causes {
        if let Some(cause) = cause.as_ref().filter(|_| several) {
            lines.push(format!("{}: {cause}", count(&&Some(cause.clone()))));
        }
        let shown = groups().filter(|group| group.outcome.cause == *cause);
        lines.extend(shown.filter_map(|group| {
            let outcome = words(group.if_assumed.as_ref()?);
            Some(format!("– as shown, {} {outcome}", group.count))
        }));
    }
    lines
}

/// An outcome in a few words.
pub(crate) fn words(outcome: &CellOutcome) -> String {
    match &outcome.cause {
        Some(cause) => format!("{} ({cause})", outcome.standing.name()),
        None => outcome.standing.name().to_owned(),
    }
}
