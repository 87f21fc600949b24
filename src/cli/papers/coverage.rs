//! `subcert coverage`.

use super::judged::{judge_all, papers, select};
use crate::cli::arguments::{CoverageArguments, Format};
use crate::cli::console::output::{Outcome, denied, show};
use subcert::audit::PaperAudit;
use subcert::report::{coverage_sheet, json::CoverageReport};

pub(crate) fn coverage(arguments: &CoverageArguments) -> Outcome {
    let papers = select(papers(&arguments.files)?, arguments.paper.as_deref())?;
    let audits = judge_all(&papers, arguments.output.format != Format::Json)?;
    show(&arguments.output, || coverage_sheet(&audits), || CoverageReport::of(&audits))?;
    denied(&arguments.deny, |state| {
        let items = audits.iter().flat_map(PaperAudit::coverage);
        let count = items.filter(|coverage| coverage.state().name() == state).count();
        (count, ["numbered item", "numbered items"])
    })
}
