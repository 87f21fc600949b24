//! Why there is no range of a parameter in which the limits of a mask on Z^d are smooth.

use crate::cap::Cap;
use crate::joint::MatrixSetError;

/// Why there is no range.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum LatticeRangeError {
    /// C^m needs sum rules of a higher order than hold for all values.
    #[error(
        "C^{m} needs sum rules of an order above {m}, and those of order {found} hold for all values of the parameter, but no more: on no interval are the limits C^{m}"
    )]
    SumRules {
        /// m.
        m: u32,
        /// The order that holds.
        found: u32,
    },
    /// The dilation matrix is not isotropic.
    #[error(
        "the eigenvalues of the dilation matrix have several moduli, or it is not diagonalisable: ask for C^0"
    )]
    Anisotropic,
    /// Something is too large.
    #[error("{0}")]
    Cap(Cap),
    /// The blocks are too large.
    #[error(transparent)]
    Size(#[from] MatrixSetError),
}

impl From<Cap> for LatticeRangeError {
    fn from(cap: Cap) -> LatticeRangeError {
        LatticeRangeError::Cap(cap)
    }
}
