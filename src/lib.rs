//! Exact constants of subdivision schemes, and audits of the papers that publish
//! them.
//!
//! ```
//! use subcert::bound::{Constants, SoundBound};
//! use subcert::exact::Rational;
//! use subcert::scheme::parse_scheme;
//!
//! // How many levels until every control polygon with differences at most 1/10
//! // is within 1/1000 of its limit?
//! let scheme = parse_scheme("six-point:w=3/256")?;
//! let constants = Constants::new(scheme.masks()[0].clone());
//! let bound = SoundBound::curve(&constants, 4)?;
//! let depth = bound.depth(&Rational::new(1, 10), &Rational::new(1, 1000))?;
//! assert_eq!(depth.level, 7);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Notation
//!
//! | papers | here |
//! |---|---|
//! | n, N, a_{α,j} | [arity](scheme::Mask::arity), [width](scheme::Mask::width), [`Mask`](scheme::Mask) |
//! | x_{i+j}, with o = 0 | [offset](scheme::Mask::offset) |
//! | b_{β,j}; d_j, e_j, f_j | [difference mask](scheme::Mask::difference) |
//! | T_c; δ for c = 1; ξ | contraction constant, [`Operator::Difference`](bound::Operator) |
//! | Λ_c, Σ\|a_{α,j}\| | scheme norm, [`Operator::Scheme`](bound::Operator) |
//! | Y_c Z_c; δ of a surface | [`Constants::tensor`](bound::Constants::tensor) |
//! | t_{nu+β} = b_{β,N−1−u} or b_{β,u} | [`Order`](bound::Order) |
//! | σ, γ | [`displacement`](bound::displacement) |
//! | η, ν | [`surface_coefficients`](bound::surface_coefficients) |
//! | ω_{i,j}; (1) of the rules around a vertex | weights of a [`LocalRules`](scheme::LocalRules) |
//! | T_c of a ring | [`LocalConstants`](bound::LocalConstants), by [`transport`](bound::transport()) |
//! | β, τ, ϑ | spread: the largest difference of neighbouring control points |
//! | sup ‖P^∞ − P^k‖ for spread 1 | distance constant, [`Distances`](limit::Distances) |
//! | the same of a surface, of a ring | [`SurfaceDistances`](limit::SurfaceDistances), [`LocalDistances`](limit::LocalDistances) |
//! | k ≥ log_T(…) | [`log_level`](bound::log_level), [`least_level`](bound::least_level) |
//!
//! # Crates
//!
//! The library is five crates, one floor upon the other, and this one, which has all their modules
//! and the program. Imports run downwards only.
//!
//! | crate | modules |
//! |---|---|
//! | [`subcert_numbers`] | [`cap`], [`exact`], [`formula`], [`diagnostic`], [`stop`], [`suggestion`] |
//! | [`subcert_schemes`] | [`scheme`], [`bound`], [`limit`], [`float`], [`joint`], [`smoothness`], [`spectrum`], [`characteristic`], [`facts`] |
//! | [`subcert_geometry`] | [`mesh`], [`net`], [`solid`], [`patch`], [`oracle`] |
//! | [`subcert_claims`] | [`literal`], [`claim`], [`shipped`], [`audit`] |
//! | [`subcert_reports`] | [`certificate`], `report` (feature `cli`) |

pub use subcert_claims::{audit, claim, literal, shipped};
pub use subcert_geometry::{
    assert_slice_within_ulps, assert_within, assert_within_ulps, mesh, net, oracle, patch, solid,
};
pub use subcert_numbers::{cap, diagnostic, exact, formula, stop, suggestion};
pub use subcert_reports::certificate;
#[cfg(feature = "cli")]
pub use subcert_reports::report;
pub use subcert_schemes::{
    bound, characteristic, facts, float, joint, limit, scheme, smoothness, spectrum,
};

/// The examples of README.md, run as tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
