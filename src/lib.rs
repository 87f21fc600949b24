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
//! # Modules
//!
//! Imports run one way: a module imports those above it in this list only.
//!
//! | module | what it holds |
//! |---|---|
//! | [`exact`] | numbers, no geometry |
//! | [`formula`] | the expression language of masks and claims |
//! | [`scheme`] | masks, difference masks, tensor products, rings, the catalogue |
//! | [`bound`] | contraction constants, also of rings, displacement, error bounds, depth |
//! | [`limit`] | limits at rational parameters, distances of polygons from them in both parametrisations |
//! | [`float`] | the same in f64, certified against the exact path |
//! | [`joint`] | the joint spectral radius of rational matrices, from both sides |
//! | [`smoothness`] | how smooth limits are: C^m, and the Hölder exponent |
//! | [`spectrum`] | eigenvalues of the rules around a vertex or on a face, stencils of limits and tangents |
//! | [`characteristic`] | whether surfaces are C¹ at an extraordinary vertex: the characteristic map |
//! | [`mesh`] | polygon meshes: files, refinement, limit points and normals |
//! | [`net`] | tensor nets: files, refinement, limit points |
//! | [`solid`] | hexahedral meshes: files, refinement by Bajaj's scheme, limit points |
//! | [`patch`] | how far meshes, nets and solids are from their limits |
//! | [`oracle`] | reference values and checks for other programs' tests |
//! | [`claim`] | what a paper asserts |
//! | [`shipped`] | tables of constants in programs: claim files about them, and verdicts |
//! | `evaluation` | from the formulas of claims to values, under a reading |
//! | `finding` | what the audit says of claims, as plain data |
//! | `judge` | verdicts, one file for each kind of claim |
//! | `digest` | what follows from findings: errata, coverage, contradictions |
//! | `evidence` | what certificates need beyond the findings |
//! | [`audit`] | the face of these five: from claims to verdicts |
//! | [`certificate`] | verdicts as certificates, for a checker that trusts nothing of this |
//! | `report` | findings as text, Markdown and JSON (feature `cli`) |
//!
//! [`diagnostic`] serves them all: errors that point at a place in a file. So does [`suggestion`]: what a
//! misspelt name may have meant.

pub mod audit;
pub mod bound;
pub mod certificate;
pub mod characteristic;
pub mod claim;
pub mod diagnostic;
mod digest;
mod evaluation;
mod evidence;
pub mod exact;
mod finding;
pub mod float;
pub mod formula;
pub mod joint;
mod judge;
pub mod limit;
pub mod literal;
pub mod mesh;
pub mod net;
pub mod oracle;
pub mod patch;
#[cfg(feature = "cli")]
pub mod report;
pub mod scheme;
pub mod shipped;
pub mod smoothness;
pub mod solid;
pub mod spectrum;
pub mod suggestion;

/// The examples of README.md, run as tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
