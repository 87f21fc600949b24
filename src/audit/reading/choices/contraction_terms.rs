//! The norm in a contraction constant.

use crate::audit::reading::{Choice, Effect, Way};

/// Σ|b| or |Σ b|.
pub(in crate::audit) const CONTRACTION_TERMS: Choice = Choice {
    name: "norm of the difference mask",
    effect: Effect::Option { option: "terms", functions: &["contraction"] },
    ways: &[
        Way { word: "each", says: "Σ|b| in the contraction constant" },
        Way { word: "total", says: "|Σ b| in the contraction constant" },
    ],
    source: "Khan et al. 2019, (6.26)",
};
