//! How smooth the limits of a curve scheme are: convergence, C^m, the Hölder exponent, polynomials.
//!
//! A scheme of arity n has the symbol A(z) = Σ_s a_s z^s, where x'_r = Σ_k a_{r−nk} x_k. With
//! σ(z) = 1 + z + … + z^{n−1}, A = σ^K B, and B not divisible by σ, K is the order of the sum rules. The differences
//! of order K are refined by the scheme of B. Its spectral radius is the joint spectral radius of n
//! matrices, which [`joint`](crate::joint) bounds. `proofs/THEOREMS.md`, 103 to 112. The coefficients are rational, or of one
//! real field Q(α) (120, 121).
//!
//! ```
//! use subcert::scheme::parse_scheme;
//! use subcert::smoothness::Smoothness;
//!
//! let scheme = parse_scheme("four-point:w=1/16")?;
//! let smoothness = Smoothness::of(scheme.masks()[0])?;
//! assert_eq!((smoothness.continuity, smoothness.continuity_fails), (Some(1), Some(2)));
//! let exponent = smoothness.hoelder.expect("it converges");
//! assert_eq!((exponent.formula.expect("exact").to_string(), exponent.attained), ("2".to_owned(), Some(false)));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod coefficient;
mod contraction;
mod excluded;
mod exponent;
mod family;
mod formula;
mod functions;
mod independence;
mod independence_on;
mod parametric;
mod plane;
mod range;
mod range_error;
mod reproduction;
mod search;
mod shape;
mod special;
mod symbol;
mod transition;

pub use coefficient::Coefficient;
pub use contraction::contractions;
pub use exponent::{Hoelder, Smoothness, SmoothnessError};
pub use family::SymbolFamily;
pub use formula::ExponentFormula;
pub(crate) use formula::log_of;
pub use functions::{
    BasicError, BasicValues, InnerProductError, InnerProducts, LimitValues, basic,
    derivative_symbol, integral_symbol, is_contractive, is_hurwitz, is_shape_kept, keeps_ratios,
    modulus, modulus_extremes, moments, riesz_bounds, sobolev_exponent, vanishing_moments,
};
pub use independence::is_independent;
pub use independence_on::independence_conditions;
pub(crate) use parametric::{PolynomialMatrix, bernstein, multiplied};
pub use plane::{
    BestExponent, Certain, MAX_BOXES, MapBox, RegionProof, Sides, SmoothMap, best_exponent,
    plane_rules, polygon_contraction, smooth_map,
};
pub(crate) use plane::{PlaneSearch, map_of};
pub(crate) use range::gap;
pub use range::{SmoothRange, smooth_range};
pub use range_error::SmoothRangeError;
pub use reproduction::{reproduction_degree, reproduction_degree_at};
pub(crate) use search::{Search, outer_ends};
pub use shape::{Kept, Shape, shape_kept};
pub use special::{SpecialValue, SpecialValues};
pub use symbol::Symbol;
pub use transition::transition_matrices;
