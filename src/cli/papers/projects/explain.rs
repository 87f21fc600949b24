//! `subcert explain` of constants that programs ship.

use super::select_project;
use crate::cli::arguments::ExplainArguments;
use crate::cli::console::destination::{Destination, command};
use crate::cli::console::output::{Failure, Outcome, show};
use crate::cli::json::{SCHEMA, listing as form};
use subcert::claim::Target;
use subcert::report::html::FindingPage;
use subcert::report::json::ShippedTable;
use subcert::report::{Grid, Sheet, finding_sheet, shipped_headline};
use subcert::shipped::{Project, audit_shipped};
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
            "`{key}` has no table `{name}`{meant}; `subcert explain {key} {}` lists its tables",
            project.source.name
        )));
    };
    let to = Destination::of(&arguments.output, &id.replace(':', "."))?;
    let finding = audit_shipped(project, claim)?;
    to.deliver(
        || finding_sheet(project, &finding, true),
        || ShippedTable::of(&finding),
        || {
            let sheet = finding_sheet(project, &finding, true);
            let sentence = &shipped_headline(&finding);
            let page = FindingPage { sentence, sheet: &sheet, pictures: &[], command: &command() };
            Ok(page.to_html())
        },
    )
}

/// Lists the tables of a project.
fn list(project: &Project, arguments: &ExplainArguments) -> Outcome {
    let Destination::Output(to) = Destination::of(&arguments.output, &project.key)? else {
        return Err(no_page());
    };
    let row = |claim: &subcert::shipped::ShippedClaim| {
        vec![
            claim.id.clone(),
            claim.locus.clone(),
            claim.title.clone(),
            claim.numbers.len().to_string(),
        ]
    };
    show(
        &to,
        || {
            let mut sheet = Sheet::default();
            sheet.heading(1, format!("{} · {}", project.key, project.name));
            let header = ["id", "where", "what", "numbers"].map(str::to_owned).to_vec();
            sheet.grid(Grid {
                header,
                rows: project.shipped.iter().map(row).collect(),
                left_columns: 3,
            });
            sheet.text(format!(
                "`subcert explain {}:ID {}` shows every number of one table.",
                project.key, project.source.name
            ));
            sheet
        },
        || form::Listing {
            schema: SCHEMA,
            key: &project.key,
            claims: project
                .shipped
                .iter()
                .map(|claim| form::Claim {
                    id: &claim.id,
                    kind: "shipped",
                    locus: &claim.locus,
                    title: &claim.title,
                })
                .collect(),
        },
    )
}

fn no_page() -> Failure {
    Failure::Input(
        "a list of tables is no page; name a table, or write the pages of all of them with \
         `subcert audit FILE --format html -o DIR`"
            .to_owned(),
    )
}
