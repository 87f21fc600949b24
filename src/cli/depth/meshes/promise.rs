//! What formulas of papers promise of the depth of a mesh, a net or a solid.

use subcert::patch::{APriori, MeshDepth};

/// The levels that a formula promises to be enough, and that are guaranteed, in words.
pub(super) fn promises(promised: Option<&Formula>, guaranteed: &APriori) -> Vec<(u32, String)> {
    let by_formula = promised.and_then(|formula| Some((formula.level?, "by formula".to_owned())));
    by_formula.into_iter().chain([(guaranteed.level, "a priori".to_owned())]).collect()
}

/// How many levels a formula promises to be enough; `None` where it promises nothing.
#[derive(Clone, Copy, Debug)]
pub(super) struct Formula {
    pub(super) paper: &'static str,
    pub(super) level: Option<u32>,
}

/// A promised number of levels, compared with what is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Promise {
    TooFew,
    Enough,
    TooMany,
    Open,
}

impl Promise {
    pub(super) fn of(level: u32, found: &MeshDepth) -> Promise {
        if found.too_few.is_some_and(|few| level <= few) {
            Promise::TooFew
        } else if level > found.level {
            Promise::TooMany
        } else if level == found.level {
            Promise::Enough
        } else {
            Promise::Open
        }
    }

    pub(super) fn name(self) -> &'static str {
        match self {
            Promise::TooFew => "too few",
            Promise::Enough => "enough",
            Promise::TooMany => "more than needed",
            Promise::Open => "open",
        }
    }
}
