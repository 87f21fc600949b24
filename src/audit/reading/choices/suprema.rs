//! The suprema of a product of two norms.

use crate::audit::reading::{Choice, Effect, Way};

/// Each norm over its own residue class, or both over the same.
pub(in crate::audit) const SUPREMA: Choice = Choice {
    name: "suprema",
    effect: Effect::Option { option: "suprema", functions: &["tensor", "convolution_norm"] },
    ways: &[
        Way { word: "independent", says: "two independent suprema" },
        Way { word: "joint", says: "one supremum over a common index" },
    ],
    source: "Mustafa et al. 2020, (29) and (30); Khan et al. 2022, (79)",
};
