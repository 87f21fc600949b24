//! The norm in a displacement.

use crate::audit::reading::{Choice, Effect, Way};

/// Σ|ã| or |Σ ã|.
pub(in crate::audit) const DISPLACEMENT_TERMS: Choice = Choice {
    name: "norm of the displacement",
    effect: Effect::Option {
        option: "terms",
        functions: &["displacement", "surface_displacement"],
    },
    ways: &[
        Way { word: "each", says: "Σ|ã| in the displacement" },
        Way { word: "total", says: "|Σ ã| in the displacement" },
    ],
    source: "Khan et al. 2019, Lemma 6.1; Mustafa et al. 2020, Theorem 5",
};
