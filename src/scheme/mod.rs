//! Subdivision schemes: masks, difference masks, tensor products, rings, the catalogue.
//!
//! A scheme of arity n refines x'_{ni+α} = Σ_j a_{α,j} x_{i+o+j}, with
//! α = 0, …, n−1, j = 0, …, N−1, an index offset o, and Σ_j a_{α,j} = 1. Around an
//! extraordinary vertex or face the rules depend on the valence: there a [`Ring`] of v
//! points is refined by a v×v matrix.

mod catalogue;
mod definition;
mod fields;
mod file;
mod interpolation;
mod mask;
mod parse;
mod reference;
mod ring;
mod ring_definition;
mod ring_file;
mod ring_formulas;
mod ring_symmetry;
mod rules;
mod tensor;

pub use catalogue::{Entry, catalogue, find};
pub use definition::{ParameterSpec, SchemeDefinition};
pub(crate) use fields::{definitions, formula, from_toml, identifier};
pub(crate) use file::SchemeTable;
pub use file::read_scheme;
pub use interpolation::lagrange_mask;
pub use mask::{Mask, MaskError};
pub(crate) use parse::find_in_catalogue;
pub use parse::{AnyScheme, parse_any_scheme, parse_parametric, parse_ring, parse_scheme};
pub use reference::{Instance, Reference, ReferenceError, SchemeError};
pub use ring::{MAX_RING_POINTS, Orbit, Ring, RingError};
pub use ring_symmetry::Representatives;
pub use rules::{MAX_ARITY, MAX_WIDTH, Rules, RulesError};
pub use tensor::Scheme;
