//! The rounding of a depth.

use crate::audit::reading::{Choice, Effect, Way};

/// Up, as a depth needs, or otherwise.
pub(in crate::audit) const DEPTH_ROUNDING: Choice = Choice {
    name: "rounding of the depth",
    effect: Effect::Option { option: "rounded", functions: &["levels"] },
    ways: &[
        Way { word: "up", says: "depths rounded up" },
        Way { word: "nearest", says: "depths rounded to the nearest" },
        Way { word: "down", says: "depths rounded down" },
    ],
    source: "Mustafa et al. 2020, Tables 2 and 6",
};
