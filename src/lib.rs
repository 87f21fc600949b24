//! Exact constants of subdivision schemes, and audits of the papers that publish
//! them.
//!
//! | you want to | start at |
//! |---|---|
//! | test your own f64 code against exact values | [`oracle`], [`assert_slice_within_ulps!`] |
//! | name a scheme, read one from a file or from text | [`parse_scheme`](scheme::parse_scheme), [`parse_local_rules`](scheme::parse_local_rules) |
//! | make a mask of numbers of your own | [`Mask::new`](scheme::Mask::new); `Ratio<i64>` and `BigRational` are [`Rational`](exact::Rational)s by `into()` |
//! | refine a polygon, a net, a mesh exactly | [`refine_polygon`](oracle::refine_polygon), [`refine_grid`](oracle::refine_grid), [`refine_mesh`](mesh::refine_mesh) |
//! | know the constants T_c, Λ_c and the depth | [`Constants`](bound::Constants), [`Distances`](limit::Distances), [`MeshDistances`](patch::MeshDistances) |
//! | know how smooth limits are | [`Smoothness`](smoothness::Smoothness), [`smooth_range`](smoothness::smooth_range), [`characteristic`] |
//! | know eigenvalues and stencils | [`spectrum`] |
//! | audit a paper or a program | [`audit`](mod@audit), [`shipped`] |
//!
//! Your own code is tested like this:
//!
//! ```
//! use subcert::assert_slice_within_ulps;
//! use subcert::oracle::{Boundary, refine_polygon};
//! use subcert::scheme::parse_scheme;
//!
//! /// Chaikin's corner cutting of a closed polygon.
//! fn mine(points: &[f64]) -> Vec<f64> {
//!     let next = points.iter().cycle().skip(1);
//!     let pair = |(a, b): (&f64, &f64)| [0.75 * a + 0.25 * b, 0.25 * a + 0.75 * b];
//!     points.iter().zip(next).flat_map(pair).collect()
//! }
//!
//! let scheme = parse_scheme("chaikin")?;
//! let exact = refine_polygon(scheme.masks()[0].rules(), &[0, 4, 4, 0], 1, Boundary::Closed)?;
//! assert_slice_within_ulps!(mine(&[0.0, 4.0, 4.0, 0.0]), exact, 2.0, "one level");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! What can go wrong is an error of its type, and not a panic, but for division by 0, negative tolerances, and what the
//! documentation of a function states under *Panics*. Without the program, `default-features = false` leaves out
//! the feature `cli` and its crates; `gmp` takes GMP for large numbers.
//!
//! How many levels until every polygon is close to its limit:
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
//! | [`subcert_numbers`] | [`cap`], [`cores`], [`exact`], [`formula`], [`diagnostic`], [`files`], [`stop`], [`suggestion`] |
//! | [`subcert_schemes`] | [`scheme`], [`bound`], [`limit`], [`float`], [`joint`], [`lattice`], [`smoothness`], [`spectrum`], [`characteristic`], [`facts`] |
//! | [`subcert_geometry`] | [`mesh`], [`net`], [`solid`], [`patch`], [`oracle`] |
//! | [`subcert_claims`] | [`literal`], [`claim`], [`shipped`], [`audit`] |
//! | [`subcert_reports`] | [`certificate`], `report` (feature `cli`) |

pub use subcert_claims::{audit, claim, literal, shipped};
pub use subcert_geometry::{
    assert_slice_within_ulps, assert_within, assert_within_ulps, mesh, net, oracle, patch, solid,
};
pub use subcert_numbers::{cap, cores, diagnostic, exact, files, formula, stop, suggestion};
pub use subcert_reports::certificate;
#[cfg(feature = "cli")]
pub use subcert_reports::report;
pub use subcert_schemes::{
    bound, characteristic, facts, float, joint, lattice, limit, scheme, smoothness, spectrum,
};

/// The examples of README.md, run as tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
