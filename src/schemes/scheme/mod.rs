//! Subdivision schemes: masks, difference masks, tensor products, rings, the catalogue.
//!
//! A scheme of arity n refines `x'_{ni+α} = Σ_j a_{α,j} x_{i+o+j}`, with
//! α = 0, …, n−1, j = 0, …, N−1, an index offset o, and Σ_j a_{α,j} = 1. Around an
//! extraordinary vertex or face the rules depend on the valence: there a [`LocalRules`] of v
//! points is refined by a v×v matrix.

mod axes;
mod catalogue;
mod composed;
mod definition;
mod error;
mod fields;
mod file;
mod file_rules;
mod foreign;
mod interpolation;
mod lattice;
mod local;
mod mask;
mod parameters;
mod parse;
mod parse_any;
mod parse_open;
mod powers;
mod reference;
mod rules;
mod spanned;
mod toml_file;
mod typed;

pub use axes::{Axes, Scheme};
pub use catalogue::{Entry, catalogue, find, notes};
pub use definition::{CatalogueFacts, ParameterSpec, SchemeDefinition};
pub use error::{ReferenceError, SchemeError};
pub use fields::{definitions, formula, identifier};
pub use file::{OtherSchemes, SchemeTable};
pub use interpolation::lagrange_mask;
pub use lattice::dilation::{Dilation, DilationError, MAX_DIMENSION, Point, difference, sum};
pub use lattice::mask::{LatticeError, LatticeMask};
pub(crate) use lattice::matrices::{adjugate, apply, determinant};
pub use local::definition::VALENCE_NAMES;
pub use local::every::{EveryRing, EveryWeight};
pub(crate) use local::rules::point_name;
pub use local::rules::{LocalError, LocalRules, MAX_LOCAL_POINTS, Orbit};
pub use local::symmetry::Representatives;
pub use mask::{Mask, MaskError};
pub use parse::find_in_catalogue;
pub use parse::{
    files_without_offset, find_definition, names_ring, parse_local_rules, parse_rules_of_valence,
    parse_scheme, read_scheme,
};
pub use parse_any::{AnyScheme, parse_algebraic, parse_any_scheme, parse_lattice};
pub use parse_open::{
    open_parameters, parse_in_parameters, parse_lattice_in_parameter, parse_lattice_in_parameters,
    parse_parametric, parse_rules_in_parameter,
};
pub use powers::{SymbolPower, SymbolPowers};
pub use reference::{Instance, Reference, split_name};
pub use rules::{MAX_ARITY, MAX_WIDTH, Rules, RulesError};
pub use spanned::Spanned;
pub use toml_file::from_toml;
