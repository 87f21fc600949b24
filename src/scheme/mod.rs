//! Subdivision schemes: masks, difference masks, tensor products, the catalogue.
//!
//! A scheme of arity n refines x'_{ni+α} = Σ_j a_{α,j} x_{i+o+j}, with
//! α = 0, …, n−1, j = 0, …, N−1, an index offset o, and Σ_j a_{α,j} = 1.

mod catalogue;
mod definition;
mod file;
mod interpolation;
mod mask;
mod reference;
mod rules;

pub use catalogue::{Entry, catalogue, find};
pub use definition::{ParameterSpec, SchemeDefinition};
pub use file::read_scheme;
pub use interpolation::lagrange_mask;
pub use mask::{Mask, MaskError};
pub use reference::{Reference, ReferenceError, SchemeError, parse_scheme};
pub use rules::{MAX_ARITY, MAX_WIDTH, Rules, RulesError};

use crate::exact::Rational;

/// A scheme for curves, or the tensor product of two for surfaces.
#[derive(Clone, Debug, PartialEq)]
pub enum Scheme<S = Rational> {
    /// One mask, for curves.
    Curve(Mask<S>),
    /// Two masks, one for each direction of a surface.
    Tensor(Mask<S>, Mask<S>),
}

impl<S> Scheme<S> {
    /// The masks, one per direction.
    #[must_use]
    pub fn masks(&self) -> Vec<&Mask<S>> {
        match self {
            Scheme::Curve(mask) => vec![mask],
            Scheme::Tensor(first, second) => vec![first, second],
        }
    }
}
