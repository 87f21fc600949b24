//! Where the tables of a paper need different readings.

use crate::audit::{Contradiction, Opposed, PaperAudit, Side, TablePart};
use crate::report::tables::reading::place;
use crate::report::words::parts::titled;
use crate::report::words::sheet::Sheet;

/// The sections on contradictions between claims, when there are any.
pub(crate) fn section(sheet: &mut Sheet, audit: &PaperAudit<'_>) {
    let opposed = audit.opposed();
    if !opposed.is_empty() {
        sheet.heading(2, "Claims that contradict each other");
        let said = |Opposed { smooth, m, rough, fails }: Opposed<'_, '_>| {
            let [smooth, rough] =
                [smooth, rough].map(|one| titled(&[&one.claim.locus, &one.claim.id]));
            format!(
                "{smooth} says that the limits are C^{m}, and {rough}, of the same mask, that not all are C^{fails}."
            )
        };
        opposed.into_iter().map(said).for_each(|line| sheet.text(line));
    }
    tables(sheet, audit);
}

fn tables(sheet: &mut Sheet, audit: &PaperAudit<'_>) {
    if audit.contradictions.is_empty() {
        return;
    }
    sheet.heading(2, "Contradictions between tables");
    sheet.text(
        "What explains one table explains fewer cells of another, by more than one. In brackets: \
         the cells explained, and those explained with what another line says.",
    );
    let fact = |contradiction: &Contradiction| {
        let sides = contradiction.sides.iter().map(|side| line(audit, side));
        (contradiction.about.clone(), sides.collect::<Vec<String>>().join("\n"))
    };
    sheet.facts(audit.contradictions.iter().map(fact).collect());
}

fn line(audit: &PaperAudit<'_>, side: &Side) -> String {
    let one = |place: &TablePart| {
        format!("{} ({}, {})", locus(audit, place), place.explained, place.otherwise)
    };
    let places: Vec<String> = side.places.iter().map(one).collect();
    format!("{}: {}", side.needs, places.join("; "))
}

/// The locus of a table, or of a row or column of it.
pub(crate) fn locus(audit: &PaperAudit<'_>, at: &TablePart) -> String {
    let Some(table) = at.table_of(audit.paper) else { return at.table.clone() };
    match at.line {
        None => table.locus.clone(),
        Some(line) => format!("{}, {}", table.locus, place(table, line)),
    }
}
