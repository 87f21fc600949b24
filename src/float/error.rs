//! Why nothing is certified, and the caps.

use crate::bound::ClassCap;
use crate::exact::Rational;

/// The greatest level k whose error bound is computed.
pub const MAX_CERTIFIED_LEVEL: u32 = 1_000;

/// The most steps for the norms of powers, in each of the arithmetics.
pub const MAX_STEPS: u64 = 2_000_000_000;

/// Why nothing is certified.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum CertifyError {
    /// Too many residue classes.
    #[error(transparent)]
    Classes(#[from] ClassCap),
    /// The f64 path visits every residue class, and these are too many for so many steps.
    #[error(
        "the f64 path visits every residue class, which up to c = {levels} takes more than the \
         cap of {steps} steps; take a smaller number of levels"
    )]
    Walk {
        /// c.
        levels: u32,
        /// The cap.
        steps: u64,
    },
    /// A spread or a tolerance that is not positive.
    #[error("{what} must be positive, and is {value}")]
    NotPositive {
        /// Which of the two.
        what: &'static str,
        /// What it is.
        value: Rational,
    },
    /// A level beyond [`MAX_CERTIFIED_LEVEL`].
    #[error("level {0} is too high for an error bound; at most {MAX_CERTIFIED_LEVEL} is")]
    Level(u32),
}
