//! Why there is no range of parameters with smooth limits.

use crate::bound::RangeError;
use crate::joint::MatrixSetError;

/// Why there is no range.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SmoothRangeError {
    /// C^m needs sum rules of a higher order than hold for all parameters.
    #[error(
        "C^{m} needs sum rules of order {needed}, and those of order {found} hold for all parameters, but no \
         more{}: on no interval are the limits C^{m}",
        if *.reduced { ", once the symbol is reduced to one with linearly independent shifts" } else { "" }
    )]
    SumRules {
        /// m.
        m: usize,
        /// m + 1.
        needed: usize,
        /// The order that holds.
        found: usize,
        /// Whether it is that of the symbol after a reduction.
        reduced: bool,
    },
    /// The rules are too long.
    #[error("the rules are too long for a proof of smoothness: {0}")]
    TooLong(#[from] MatrixSetError),
    /// The contraction is beyond a cap.
    #[error(transparent)]
    Range(#[from] RangeError),
}
