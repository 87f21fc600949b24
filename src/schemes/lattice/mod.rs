//! Masks on Z^d with a dilation matrix M: exact facts, constants, smoothness.
//!
//! (Sp)_α = Σ_β a(α − Mβ) p_β. Data are measured by their differences along the edges of the mask.
//!
//! ```
//! use subcert::exact::Rational;
//! use subcert::lattice::{LatticeConstants, sum_rules};
//! use subcert::scheme::parse_lattice;
//!
//! let courant = parse_lattice("(1+x)*(1+y)*(1+x*y)/2:edges=[[1,0],[0,1],[1,1]]")?;
//! assert_eq!(sum_rules(&courant), 2);
//! let mut constants = LatticeConstants::new(&courant);
//! constants.advance().expect("few classes");
//! assert_eq!(constants.contraction()?.value, Rational::new(1, 2));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod constants;
mod displacement;
mod distance;
mod exponent;
mod limit;
mod monomials;
mod norm;
mod places;
mod polynomials;
mod powers;
mod product;
mod radius;
mod range;
mod shape;
mod smoothness;
mod span;
mod tiling;
mod values;
mod window;

pub use constants::{Contraction, LatticeConstants, MAX_FUNCTIONALS};
pub use displacement::{Between, displacement, weights};
pub use distance::LatticeDistance;
pub use limit::limit_values;
pub use norm::{Edges, Norm, NormError, proves};
pub use polynomials::{MAX_ORDER, mean, natural_shift, reproduction, sum_rules};
pub use powers::{Functional, Steps, convolved};
pub use product::{directions, factors, least_cut};
pub use radius::LatticeRadius;
pub use range::{
    LatticeRange, LatticeRangeError, MAP_BOXES, RangePiece, RangeProof, lattice_map, lattice_range,
};
pub use shape::{is_interpolating, is_isotropic, support, symmetries};
pub use smoothness::LatticeSmoothness;
pub use tiling::{Figure, Motion, Tiling};
pub use values::{ValueSpace, values_at_integers, window};
pub use window::{MAX_WINDOW, attractor};
