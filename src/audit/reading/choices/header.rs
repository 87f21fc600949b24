//! The tolerance behind a printed header.

use crate::audit::reading::{Choice, Effect, Way};

/// A header that was computed and then rounded stands for a number of its rounding
/// interval: where a depth is decided at equality, either end may decide otherwise.
pub(in crate::audit) const HEADER: Choice = Choice {
    name: "tolerance",
    effect: Effect::Header,
    ways: &[
        Way { word: "exact", says: "tolerances as printed" },
        Way { word: "less", says: "tolerances that were rounded up to what is printed" },
        Way { word: "more", says: "tolerances that were rounded down to what is printed" },
    ],
    source: "Khan et al. 2022, Tables 3 and 4, whose tolerances are cells of Table 2",
};
