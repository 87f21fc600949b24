//! What a power of a constant of c levels counts.

use crate::audit::reading::{Choice, Effect, Way};

/// A power for each level, as printed, or for each block of c levels, as is sound.
pub(in crate::audit) const EXPONENT: Choice = Choice {
    name: "exponent",
    effect: Effect::Option { option: "exponent", functions: &["levels"] },
    ways: &[
        Way { word: "level", says: "one power of the constant for each level" },
        Way { word: "block", says: "one power of the constant for each block of c levels" },
    ],
    source: "Mustafa et al. 2020, Theorem 6; Khan et al. 2022, Theorem 6",
};
