//! `subcert explain` of constants that programs ship.

use super::select_project;
use crate::cli::arguments::ExplainArguments;
use crate::cli::console::answer::{Answer, deliver, show};
use crate::cli::console::destination::Destination;
use crate::cli::console::output::{Failure, Outcome};
use crate::cli::console::quantity::written;
use crate::cli::papers::listing::Listing;
use subcert::claim::Target;
use subcert::report::json::ExplainedTable;
use subcert::report::{Sheet, finding_sheet, shipped_headline};
use subcert::shipped::{Project, ShippedFinding, audit_shipped};
use subcert::suggestion::did_you_mean;

/// Explains a table of a project, number by number; of a key alone, lists the tables.
pub(in crate::cli) fn explain(arguments: &ExplainArguments, projects: Vec<Project>) -> Outcome {
    let id = &arguments.id;
    let target = Target::of(id);
    let (key, name) = (target.key, target.within());
    let chosen = select_project(projects, Some(key))?;
    let [project] = &chosen[..] else { return Ok(()) };
    if name.is_empty() {
        return list(project, arguments);
    }
    let Some(claim) = project.shipped.iter().find(|claim| claim.id == name) else {
        let meant = did_you_mean(&name, project.shipped.iter().map(|claim| claim.id.as_str()));
        return Err(Failure::Input(format!(
            "`{key}` has no table `{name}`; `subcert explain {key} {}` lists its tables{meant}",
            project.source.name
        )));
    };
    let to = Destination::of(&arguments.output, &id.replace(':', "."))?;
    deliver(&to, &Shipped { project, finding: audit_shipped(project, claim)? })
}

/// A table of a project, number by number.
pub(crate) struct Shipped<'a> {
    project: &'a Project,
    finding: ShippedFinding<'a>,
}

written!(shipped: Shipped<'_> => ExplainedTable<'_>, ExplainedTable::of(&shipped.finding));

impl Answer for Shipped<'_> {
    const NAME: &'static str = "explain-project";

    fn sheet(&self) -> Sheet {
        finding_sheet(self.project, &self.finding, true)
    }

    fn sentence(&self) -> String {
        shipped_headline(&self.finding)
    }
}

/// Lists the tables of a project.
fn list(project: &Project, arguments: &ExplainArguments) -> Outcome {
    let Destination::Output(to) = Destination::of(&arguments.output, &project.key)? else {
        return Err(no_page());
    };
    show(&to, &Listing::of_project(project))
}

fn no_page() -> Failure {
    Failure::Input(
        "a list of tables is no page; name a table, or write the pages of all of them with \
         `subcert audit FILE --format html -o DIR`"
            .to_owned(),
    )
}
