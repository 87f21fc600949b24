//! The recursion of the convolution coefficients.

use crate::audit::reading::{Choice, Effect, Way};

/// C¹·C^{c−1}, which c convolutions have, or C^{c−1}·C^{c−1}.
pub(in crate::audit) const RECURSION: Choice = Choice {
    name: "recursion",
    effect: Effect::Option {
        option: "recursion",
        functions: &["convolution", "convolved", "convolution_norm"],
    },
    ways: &[
        Way { word: "derived", says: "coefficients of c convolutions" },
        Way { word: "printed", says: "coefficients by C^{c−1}·C^{c−1}" },
    ],
    source: "Mustafa et al. 2020, (6) against (26); Khan et al. 2022, (9)",
};
