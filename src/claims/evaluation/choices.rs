//! The choices of readings: one table.

use crate::evaluation::{Choice, Effect, Way};

/// The terms of a contraction constant: Σ|b| or |Σ b|.
pub(crate) const CONTRACTION_TERMS: Choice = Choice {
    key: "contraction-terms",
    name: "norm of the difference mask",
    effect: Effect::Option { option: "terms", functions: &["contraction"] },
    ways: &[
        Way { word: "each", says: "Σ|b| in the contraction constant" },
        Way { word: "total", says: "|Σ b| in the contraction constant" },
    ],
    source: "Khan et al. 2019, (6.26)",
};

/// The rounding of printed decimals: to the nearest, cut, or away from zero.
pub(crate) const DECIMAL_ROUNDING: Choice = Choice {
    key: "decimals",
    name: "rounding of the decimals",
    effect: Effect::Decimal,
    ways: &[
        Way { word: "nearest", says: "decimals rounded to the nearest" },
        Way { word: "cut", says: "decimals cut" },
        Way { word: "away", says: "decimals rounded away from zero" },
    ],
    source: "Khan et al. 2019, Tables 1 to 3",
};

/// The rounding of depths: up, as the definition of a depth needs, to the nearest, or down.
pub(crate) const DEPTH_ROUNDING: Choice = Choice {
    key: "rounded",
    name: "rounding of the depth",
    effect: Effect::Option { option: "rounded", functions: &["levels"] },
    ways: &[
        Way { word: "up", says: "depths rounded up" },
        Way { word: "nearest", says: "depths rounded to the nearest" },
        Way { word: "down", says: "depths rounded down" },
    ],
    source: "Mustafa et al. 2020, Tables 2 and 6",
};

/// The terms of a displacement: Σ|ã| or |Σ ã|.
pub(crate) const DISPLACEMENT_TERMS: Choice = Choice {
    key: "displacement-terms",
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

/// The exponent of a bound: one power of the constant for each level, as printed, or for each block
/// of c levels, as is sound.
pub(crate) const EXPONENT: Choice = Choice {
    key: "exponent",
    name: "exponent",
    effect: Effect::Option { option: "exponent", functions: &["levels"] },
    ways: &[
        Way { word: "level", says: "one power of the constant for each level" },
        Way { word: "block", says: "one power of the constant for each block of c levels" },
    ],
    source: "Mustafa et al. 2020, Theorem 6; Khan et al. 2022, Theorem 6",
};

/// The tolerance behind a printed header. A header that was computed and then rounded stands for
/// some number of its rounding interval. If a bound equals the tolerance at some level, the ends of
/// this interval may give different depths.
pub(crate) const HEADER: Choice = Choice {
    key: "tolerance",
    name: "tolerance",
    effect: Effect::Header,
    ways: &[
        Way { word: "exact", says: "tolerances as printed" },
        Way { word: "less", says: "tolerances that were rounded up to what is printed" },
        Way { word: "more", says: "tolerances that were rounded down to what is printed" },
    ],
    source: "Khan et al. 2022, Tables 3 and 4, whose tolerances are cells of Table 2",
};

/// Every choice.
pub const FAMILY: [&Choice; 10] = [
    &ORDER,
    &SUPREMA,
    &CONTRACTION_TERMS,
    &DISPLACEMENT_TERMS,
    &OFFSET,
    &RECURSION,
    &EXPONENT,
    &DEPTH_ROUNDING,
    &DECIMAL_ROUNDING,
    &HEADER,
];

/// The word of the offset at which σ is least.
pub(crate) const BEST_OFFSET: &str = "best";

/// The index offset of a displacement: 0, as the papers print it, or the scheme's own; and, of schemes whose offset the
/// claim file does not state, the best one.
pub(crate) const OFFSET: Choice = Choice {
    key: "offset",
    name: "offset",
    effect: Effect::Option { option: "offset", functions: &["displacement"] },
    ways: &[
        Way { word: "0", says: "displacement at offset 0" },
        Way { word: "own", says: "displacement at the scheme's own offset" },
        Way { word: BEST_OFFSET, says: "displacement at the scheme's best offset" },
    ],
    source: "the papers print their masks from index 0, whatever the scheme's own offset is",
};

/// The word of masks that are read forwards, whose constants depend on the numbers of the points.
pub(crate) const FORWARD: &str = "forward";

/// The order of the sequence t: t_{nu+β} = b_{β,N−1−u} or b_{β,u}.
pub(crate) const ORDER: Choice = Choice {
    key: "order",
    name: "order",
    effect: Effect::Option {
        option: "order",
        functions: &["contraction", "norm", "tensor", "convolution"],
    },
    ways: &[
        Way { word: "adjoint", says: "masks read backwards" },
        Way { word: FORWARD, says: "masks read forwards" },
    ],
    source: "Mustafa et al. 2020: (3) reads the mask of a curve forwards, (23) that of a surface \
             backwards",
};

/// The recursion of convolutions: C¹·C^{c−1}, which gives c convolutions, or C^{c−1}·C^{c−1}.
pub(crate) const RECURSION: Choice = Choice {
    key: "recursion",
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

/// The suprema in a product of two norms: each over its own residue classes, or both at one class.
pub(crate) const SUPREMA: Choice = Choice {
    key: "suprema",
    name: "suprema",
    effect: Effect::Option { option: "suprema", functions: &["tensor", "convolution_norm"] },
    ways: &[
        Way { word: "independent", says: "two independent suprema" },
        Way { word: "joint", says: "one supremum over a common index" },
    ],
    source: "Mustafa et al. 2020, (29) and (30); Khan et al. 2022, (79)",
};
