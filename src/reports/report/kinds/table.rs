//! Tables in reports.

use crate::audit::{CellFinding, PaperAudit, TableFinding, Verdict};
use crate::diagnostic::Diagnostic;
use crate::report::html::context::Context;
use crate::report::html::table;
use crate::report::json::exact::{Named, decimal};
use crate::report::json::tables::cell::{AsRead, CellSound};
use crate::report::json::{Claim, Details, Sound, joined, names};
use crate::report::papers::audit::{remarks, table_values};
use crate::report::tables::{headers, reading, tried};
use crate::report::told::{Background, Counted, Facts, Told};
use crate::report::words::parts::definition;
use crate::report::words::sheet::Sheet;
use maud::Markup;
use std::borrow::Cow;

impl<'a> Told<'a> for TableFinding<'a> {
    fn heading(&self) -> [&'static str; 2] {
        ["Tables", "tables"]
    }

    fn counted(&self) -> Option<&'static Counted> {
        None
    }

    fn outcome(&self) -> String {
        let cells = || self.cells.iter().flatten();
        let good =
            cells().filter(|cell| matches!(cell.verdict, Verdict::Confirmed | Verdict::Reproduced));
        format!(
            "{} of the {} numbers of {} are as the printed definition gives them.",
            good.count(),
            cells().filter(|cell| cell.printed.is_some()).count(),
            self.table.locus
        )
    }

    fn states(&self, audit: &PaperAudit<'_>) -> Facts {
        definition(audit, self, headers::schemes(self.table))
    }

    fn form<'s>(&'s self, _: &'s PaperAudit<'_>) -> Vec<Claim<'s>> {
        self.claiming().map(cell).collect()
    }

    fn in_full(
        &self,
        sheet: &mut Sheet,
        audit: &PaperAudit<'_>,
        background: Background<'_>,
        all: bool,
    ) {
        sheet.facts(self.states(audit));
        sheet.grid(table_values(self));
        for line in remarks(self).into_iter().chain(self.table.note.clone()) {
            sheet.text(line);
        }
        for search in self.searches() {
            sheet.facts(reading::facts(self.table, search));
        }
        tried::section(sheet, self, background.readings, None, all);
    }

    fn contents(&self, context: &Context<'_, '_>) -> Result<Markup, Diagnostic> {
        table::section(context, self)
    }
}

/// A cell.
fn cell(cell: &CellFinding) -> Claim<'_> {
    let why = match &cell.verdict {
        Verdict::Rounding(direction) => Some(direction.to_string()),
        Verdict::Misprint(slip) => Some(slip.to_string()),
        Verdict::NotCheckable(missing) => Some(missing.to_string()),
        _ => cell.undefined.clone(),
    };
    let assumed = cell.assumed.iter();
    let assumed = assumed.map(|(name, value)| (name.clone(), value.to_string())).collect();
    let sound = cell.sound.as_ref();
    Claim {
        id: &cell.id,
        locus: &cell.locus,
        kind: "number",
        printed: cell.printed.as_deref().map(Cow::Borrowed),
        exact: cell.exact.as_ref().map(ToString::to_string),
        decimal: cell.exact.as_ref().map(decimal),
        trial: None,
        verdict: cell.verdict.word().name(),
        reading: cell.as_read.as_ref().map(AsRead::of),
        sound: sound.map(|sound| Sound::Cell(Box::new(CellSound::of(sound, cell)))),
        checked_by_coq: names(&cell.by_kernel),
        note: joined(why, cell.note.as_deref()),
        details: Details::Cell {
            assumed: (!cell.assumed.is_empty()).then_some(Named(assumed)),
            verdict_if_assumed: cell
                .verdict_if_assumed
                .as_ref()
                .map(|verdict| verdict.word().name()),
        },
        certificate: None,
    }
}
