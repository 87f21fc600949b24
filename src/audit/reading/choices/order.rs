//! The order in which a mask is read as a sequence.

use crate::audit::reading::{Choice, Effect, Way};

/// t_{nu+β} = b_{β,N−1−u} or b_{β,u}.
pub(in crate::audit) const ORDER: Choice = Choice {
    name: "order",
    effect: Effect::Option {
        option: "order",
        functions: &["contraction", "norm", "tensor", "convolution"],
    },
    ways: &[
        Way { word: "adjoint", says: "masks read backwards" },
        Way { word: "forward", says: "masks read forwards" },
    ],
    source: "Mustafa et al. 2020: (3) reads the mask of a curve forwards, (23) that of a surface \
             backwards",
};
