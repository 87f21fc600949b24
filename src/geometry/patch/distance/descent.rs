//! From a level that is surely sufficient down to the least one, for meshes, solids and nets.

use crate::patch::place::FarPlace;

/// How many pieces are looked at, in f64 and exactly; for one level at most a half of what is left.
pub(super) const STEPS: u64 = 80_000_000;
const EXACT_STEPS: u64 = 20_000;

/// How many pieces may still be looked at, in f64 and exactly.
pub(crate) struct Budget {
    pub(super) rounded: u64,
    pub(crate) exact: u64,
}

/// What was found at a level.
#[derive(Default)]
pub(crate) struct LevelResult {
    /// A place that is beyond the tolerance.
    pub(crate) beyond: Option<FarPlace>,
    /// Whether some piece was not decided.
    pub(crate) open: bool,
    /// How many pieces were looked at exactly.
    pub(crate) exact_pieces: usize,
}

/// What was found at all levels.
pub(crate) struct Descent {
    /// The least level that is sufficient with all later ones, as far as they were decided.
    pub(crate) level: u32,
    /// The greatest level that is not sufficient, and a place that shows it.
    pub(crate) beyond: Option<(u32, FarPlace)>,
    pub(super) exact_pieces: usize,
}

/// Examines the levels below one that is sufficient with all later ones, the highest first, until
/// one is not sufficient.
pub(crate) fn descend(
    sure: u32,
    mut examine: impl FnMut(u32, &mut Budget) -> LevelResult,
) -> Descent {
    let mut descent = Descent { level: sure, beyond: None, exact_pieces: 0 };
    let mut left = Budget { rounded: STEPS, exact: EXACT_STEPS };
    let mut closed = true;
    for below in (0..sure).rev() {
        let found = examine(below, &mut left);
        descent.exact_pieces += found.exact_pieces;
        if let Some(place) = found.beyond {
            descent.beyond = Some((below, place));
            break;
        }
        closed = closed && !found.open;
        if closed {
            descent.level = below;
        }
    }
    descent
}
