//! `subcert coverage`.

use super::arguments::{CoverageArguments, Format};
use super::output::{Outcome, denied, show};
use super::papers::{judge_all, papers, select};
use subcert::audit::PaperAudit;
use subcert::report::{coverage_sheet, json::CoverageReport};

pub(super) fn coverage(arguments: &CoverageArguments) -> Outcome {
    let papers = select(papers(&arguments.files)?, arguments.paper.as_deref())?;
    let audits = judge_all(&papers, arguments.output.format != Format::Json)?;
    show(&arguments.output, || coverage_sheet(&audits), || CoverageReport::of(&audits))?;
    denied(&arguments.deny, |state| {
        let items = audits.iter().flat_map(PaperAudit::coverage);
        let count = items.filter(|coverage| coverage.state().name() == state).count();
        (count, ["numbered item", "numbered items"])
    })
}
