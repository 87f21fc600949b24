//! The report of what a search for readings has found.

use super::mark;
use crate::audit::{Explanation, Search};
use crate::exact::format::short;

/// How many equally good readings are named.
const MAX_LISTED: usize = 3;

/// The outcome in a sentence or two, below a table.
pub(super) fn remark(search: &Search) -> String {
    let Search { tried, cells, as_printed, chance, .. } = search;
    let Some(first) = search.best.first() else {
        return format!(
            "Readings: none of {tried} explains more than the {as_printed} of {cells} cells that \
             are as printed."
        );
    };
    let others = search.best[1..].iter().take(MAX_LISTED - 1);
    let others = others.map(|other| format!(" Or: {}.", other.differs()));
    format!(
        "{} Read otherwise: {}.{} That explains {} of {cells} cells, {as_printed} as printed; of \
         {tried} readings, luck would find {} that do.",
        mark("other-reading"),
        first.differs(),
        others.collect::<String>(),
        first.count(),
        short(chance, 1),
    )
}

/// What was searched and found, as facts.
pub(super) fn facts(search: &Search) -> Vec<(String, String)> {
    let mut facts = vec![
        ("readings differ in".to_owned(), search.choices.join(", ")),
        ("readings tried".to_owned(), search.tried.to_string()),
        ("as printed".to_owned(), format!("explains {} of {}", search.as_printed, search.cells)),
    ];
    for explanation in search.best.iter().take(MAX_LISTED) {
        facts.push(("best reading".to_owned(), best(explanation, search.cells)));
    }
    if !search.best.is_empty() {
        facts
            .push(("as good by luck".to_owned(), format!("{} readings", short(&search.chance, 2))));
    }
    facts
}

fn best(explanation: &Explanation, cells: usize) -> String {
    let solved = explanation.solved.iter().map(|solved| {
        let (low, high) = (short(&solved.between.0, 8), short(&solved.between.1, 8));
        format!("\n{} is between {low} and {high}", solved.name)
    });
    let explained = explanation.count();
    let differs = explanation.differs();
    format!("{differs}\nexplains {explained} of {cells}{}", solved.collect::<String>())
}
