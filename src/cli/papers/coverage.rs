//! `subcert coverage`.

use super::judged::{judge_all, papers, select};
use crate::cli::arguments::{CoverageArguments, Format};
use crate::cli::console::answer::{Answer, show};
use crate::cli::console::output::{Outcome, none_denied};
use crate::cli::console::quantity::written;
use subcert::audit::{CoverageState, PaperAudit};
use subcert::report::{Sheet, coverage_sheet, json::CoverageReport};

pub(crate) fn coverage(arguments: &CoverageArguments) -> Outcome {
    let papers = select(papers(&arguments.files)?, arguments.paper.as_deref())?;
    let audits = judge_all(&papers, arguments.output.format != Format::Json)?;
    show(&arguments.output, &Coverage(&audits))?;
    none_denied(&arguments.deny, CoverageState::name, |state| {
        let items = audits.iter().flat_map(PaperAudit::coverage);
        let count = items.filter(|coverage| coverage.state() == state).count();
        (count, ["numbered item", "numbered items"])
    })
}

/// Which numbered items of papers have claims.
pub(crate) struct Coverage<'a>(&'a [PaperAudit<'a>]);

written!(coverage: Coverage<'_> => CoverageReport<'_>, CoverageReport::of(coverage.0));

impl Answer for Coverage<'_> {
    const NAME: &'static str = "coverage";

    fn sheet(&self) -> Sheet {
        coverage_sheet(self.0)
    }
}
