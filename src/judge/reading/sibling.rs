//! Parameters that one table of a paper gives away, for the others.

use crate::claim::Table;
use crate::finding::{Search, Sibling, TableFinding};

/// The parameters that other tables of the same scheme were solved for, where this
/// table leaves them open too and no reading explains it whole.
pub(crate) fn siblings(finding: &TableFinding<'_>, all: &[TableFinding<'_>]) -> Vec<Sibling> {
    let whole =
        |search: &Search| search.best.first().is_some_and(|best| best.count() == search.cells);
    // The search of the cells that need assumptions, if any does.
    let Some(search) = finding.searches().last() else { return Vec::new() };
    if whole(search) {
        return Vec::new();
    }
    let mut found = Vec::new();
    for other in all.iter().filter(|other| same_scheme(finding.table, other.table)) {
        let best = other.searches().filter(|search| whole(search)).flat_map(|s| &s.best);
        for solved in best.flat_map(|best| &best.solved) {
            let sibling = Sibling {
                name: solved.name.clone(),
                value: solved.simplest.clone(),
                locus: other.table.locus.clone(),
            };
            let open = finding.table.unstated.contains_key(&solved.name);
            if open && other.table.id != finding.table.id && !found.contains(&sibling) {
                found.push(sibling);
            }
        }
    }
    found
}

fn same_scheme(one: &Table, other: &Table) -> bool {
    match (&one.scheme, &other.scheme) {
        (Some(one), Some(other)) => {
            let names: Vec<&str> = one.reference.names().collect();
            other.reference.names().all(|name| names.contains(&name))
        }
        _ => false,
    }
}
