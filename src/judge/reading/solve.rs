//! Solving for a parameter that the paper does not state.

use crate::finding::Explanation;
use crate::judge::reading::space::{Change, Space};
use crate::judge::reading::tried::Evaluated;
use crate::judge::reading::{parameter, spread};

/// The readings with the unknown parameter solved for that explain as many cells as the best
/// without; with a parameter of the scheme, more than half of them.
pub(crate) fn solve(
    space: &Space<'_>,
    all: &[Evaluated],
    best: &[Explanation],
) -> Vec<Explanation> {
    let readings: Vec<Vec<Change>> = all.iter().map(|one| one.reading.clone()).collect();
    let least = best.first().map_or(0, Explanation::count).max(1);
    let cells = space.printed.iter().flatten().flatten().count();
    // One cell gives the parameter; half of them say something.
    let mut found = parameter::search(space, &readings, least.max(cells / 2 + 1));
    if let Some(name) = spread::unknown(space) {
        // Where a reading explains every cell, only its spread is left to be found.
        let worth = |one: &&Evaluated| {
            let differences = space.differences(&one.reading);
            least < cells || best.iter().any(|best| best.differences == differences)
        };
        let worth: Vec<&Evaluated> = all.iter().filter(worth).collect();
        found.extend(spread::search(space, name, &worth, least));
    }
    found
}
