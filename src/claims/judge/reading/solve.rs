//! Solving for a parameter that the paper does not state.

use crate::finding::Explanation;
use crate::judge::reading::space::{Change, ReadingSpace};
use crate::judge::reading::tried::Evaluated;
use crate::judge::reading::{parameter, spread};

/// The readings, with the unknown parameter solved for, that explain at least as many cells as the
/// best reading without. If it is a parameter of the scheme, they explain more than half of the
/// cells.
pub(crate) fn solve(
    space: &ReadingSpace<'_>,
    all: &[Evaluated],
    best: &[Explanation],
) -> Vec<Explanation> {
    let readings: Vec<Vec<Change>> = all.iter().map(|one| one.reading.clone()).collect();
    let least = best.first().map_or(0, Explanation::count).max(1);
    let cells = space.printed.iter().flatten().flatten().count();
    // Some value fits any single cell; a value that fits more than half of the cells says
    // something.
    let mut found = parameter::search(space, &readings, least.max(cells / 2 + 1));
    if let Some(name) = spread::unknown(space) {
        // If a reading explains every cell, only the range of the spread remains to be found.
        let worth = |one: &&Evaluated| {
            let differences = space.differences(&one.reading);
            least < cells || best.iter().any(|best| best.differences == differences)
        };
        let worth: Vec<&Evaluated> = all.iter().filter(worth).collect();
        found.extend(spread::search(space, name, &worth, least));
    }
    found
}
