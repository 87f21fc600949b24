//! The spectra of the rules around a vertex or on a face, and the stencils that follow.
//!
//! | file | subject |
//! |---|---|
//! | `error` | the errors |
//! | `circulant` | circulant matrices |
//! | `blocks` | the Fourier blocks of a ring |
//! | `polynomial` | monic polynomials over Q(2cos(2π/n)) |
//! | `extension` | the field that a root generates |
//! | `roots` | roots of these polynomials |
//! | `moduli` | how large complex roots are that are not computed |
//! | `eigenvalues` | all eigenvalues with their multiplicities |
//! | `jordan` | the sizes of Jordan blocks |
//! | `stencil` | left eigenvectors: limit and tangents |
//! | `conditions` | what the literature asks of the eigenvalues |
//! | `schemes` | schemes by name, and the wider rings whose eigenvalues are taken |
//! | `ring_spectrum` | all of this for one ring |
//! | `every` | the same for all valences from one on |
//! | `sector` | the rules between two sharp edges at a vertex |
//! | [`table`] | tables by valence, as source code |

mod blocks;
mod circulant;
mod conditions;
mod eigenvalues;
mod error;
mod every;
mod extension;
mod jordan;
mod moduli;
mod polynomial;
mod ring_spectrum;
mod roots;
mod schemes;
mod sector;
mod stencil;
pub mod table;

pub use conditions::{Conditions, Curvature};
pub use eigenvalues::Eigenvalue;
pub use error::SpectrumError;
pub use every::{CurvaturePart, EverySpectrum};
pub use jordan::Chain;
pub use moduli::ComplexEigenvalues;
pub use ring_spectrum::Spectrum;
pub use schemes::{Surroundings, surroundings};
pub use sector::{Across, Sector};
pub use stencil::Stencil;

/// The most orbits that depend on each other.
pub const MAX_COMPONENT: usize = 12;

/// The greatest value of (number of orbits that depend on each other)³·(order of the rotation).
pub const MAX_WORK: usize = 20_000;

/// The most faces of a sector.
pub const MAX_SECTOR_FACES: usize = 64;
