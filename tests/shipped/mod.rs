//! Constants that programs ship.

#[cfg(feature = "cli")]
mod certificates;
mod follows;
mod naive;
mod reader;
mod readings;
mod report;
mod verdicts;

use subcert::diagnostic::SourceText;
use subcert::shipped::{Project, ShippedFinding, audit_shipped, read_project};

const HEAD: &str = "key = 'k'\n[project]\nname = 'Program'\nrepository = 'https://example.org/program'\n\
     commit = '0123456789012345678901234567890123456789'\nlicence = 'MIT'\n";

/// A project with these definitions and tables.
fn project(rest: &str) -> Project {
    let text = format!("{HEAD}{rest}");
    read_project(&SourceText::new("k.toml", text)).unwrap_or_else(|errors| panic!("{errors}"))
}

/// The fields of a table `t` of this type.
fn table(kind: &str, indices: &str, equals: &str, cells: &[&str]) -> String {
    let cells: Vec<String> = cells.iter().map(|cell| format!("'{cell}'")).collect();
    format!(
        "[[shipped]]\nid = 't'\nlocus = 'f.c, t'\ntitle = 'a table'\ntype = '{kind}'\nindices = [{indices}]\n\
         equals = '{equals}'\ncells = [{}]\n",
        cells.join(", ")
    )
}

/// The finding of the first table.
fn found(project: &Project) -> ShippedFinding<'_> {
    audit_shipped(project, &project.shipped[0]).unwrap_or_else(|error| panic!("{error}"))
}
