//! Solving for parameters that the paper does not state.

use crate::exact::Integer;
use crate::finding::Explanation;
use crate::judge::reading::found::Found;
use crate::judge::reading::parameter::RANGE;
use crate::judge::reading::space::{Change, Space};
use crate::judge::reading::tried::Evaluated;
use crate::judge::reading::{parameter, spread};

/// The readings with a parameter of the scheme, or the spread of the data, solved for
/// that explain as many cells as the best without; with a parameter of the scheme, more
/// than half of them.
pub(crate) fn solve(space: &Space<'_>, all: &[Evaluated], best: &[Explanation]) -> Found {
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
        found.explanations.extend(spread::search(space, name, &worth, least));
        found.tried += worth.len();
        found.candidates += &(spread::candidates(space) * Integer::from(readings.len()));
    }
    found
}

/// Drops what another reading says too, with a parameter solved for: that says more.
pub(crate) fn drop_unsolved(best: &mut Vec<Explanation>, solved: &Explanation) {
    best.retain(|best| {
        !best.solved.is_empty()
            || best.count() != solved.count()
            || best.differences != solved.differences
    });
}

/// What is solved for, in words.
pub(crate) fn names(space: &Space<'_>) -> impl Iterator<Item = String> {
    let spread = spread::unknown(space).map(str::to_owned);
    let range = |name: &String| format!("{name} from -{RANGE} to {RANGE}");
    let scale = space.scale.as_ref().map(|scale| format!("{} = p/q, p, q up to 100", scale.name));
    spread.into_iter().chain(scale).chain(parameter::unknowns(space).map(range))
}
