//! The errors of spectra.

use super::{MAX_COMPONENT, MAX_SECTOR_FACES, MAX_WORK};
use crate::scheme::SchemeError;

/// Why there is no spectrum.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SpectrumError {
    /// The scheme or its parameters.
    #[error(transparent)]
    Scheme(#[from] SchemeError),
    /// The weights are not the same around the vertex or face.
    #[error(
        "the weights are not symmetric under the rotation of the ring, so that they have no Fourier blocks; \
         write them as formulas in mod(j - i, N)"
    )]
    NotSymmetric,
    /// No orbits of several points.
    #[error(
        "the ring has no rotation of order 3 or more; its orbits must be single points or have multiples of the valence"
    )]
    NoRotation,
    /// The coefficients of the characteristic polynomials are not real.
    #[error(
        "the weights differ from their mirror image, so that the eigenvalues of block {block} and of its \
         conjugate are not the same; rules that turn the ring, as one step of the √3 scheme does, are to be \
         given for two steps"
    )]
    NoReflection {
        /// The block.
        block: usize,
    },
    /// Too many orbits depend on each other.
    #[error(
        "{orbits} orbits of {points} points depend on each other; spectra are computed for at most \
         {MAX_COMPONENT} of these, and where (number of orbits)³·(number of points) is at most {MAX_WORK}"
    )]
    TooLarge {
        /// The number of orbits.
        orbits: usize,
        /// The number of points of each.
        points: usize,
    },
    /// A factor of a characteristic polynomial with complex roots that are not computed.
    #[error(
        "block {block}: the characteristic polynomial has {count} complex roots that are not computed, and that decide here; complex \
         roots are computed of factors of degree 2, and of degree 3 with one real root"
    )]
    Complex {
        /// The block.
        block: usize,
        /// The number of these roots.
        count: usize,
    },
    /// A factor of a characteristic polynomial with multiple roots.
    #[error(
        "block {block}: a factor of degree {degree} of the characteristic polynomial has multiple roots beside complex ones, which are \
         not computed"
    )]
    Multiple {
        /// The block.
        block: usize,
        /// The degree of the factor.
        degree: usize,
    },
    /// A scheme without rules at sharp edges.
    #[error(
        "sectors between sharp edges exist for `catmull-clark`, `loop` and `loop-warren`, by these names without a \
         valence, and not for `{scheme}`"
    )]
    NoSectors {
        /// The scheme.
        scheme: String,
    },
    /// A sector of no faces, or of too many.
    #[error("a sector of {faces} faces; there must be from 1 to {MAX_SECTOR_FACES}")]
    Faces {
        /// The number of faces.
        faces: usize,
    },
}
