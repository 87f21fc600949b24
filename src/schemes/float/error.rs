//! Errors and caps of the certification.

use crate::bound::ClassCap;
use crate::exact::Rational;

/// The greatest level k whose error bound is computed.
pub const MAX_CERTIFIED_LEVEL: u32 = 1_000;

/// The cap on steps for the norms of powers, in each arithmetic.
pub const MAX_STEPS: u64 = 2_000_000_000;

/// Why a scheme is not certified.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum CertifyError {
    /// Too many residue classes.
    #[error(transparent)]
    Classes(#[from] ClassCap),
    /// Visiting every residue class in f64 takes more steps than the cap.
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
        /// What must be positive.
        what: &'static str,
        /// Its value.
        value: Rational,
    },
    /// A level beyond [`MAX_CERTIFIED_LEVEL`].
    #[error("level {0} is too high for an error bound; at most {MAX_CERTIFIED_LEVEL} is")]
    Level(u32),
}
