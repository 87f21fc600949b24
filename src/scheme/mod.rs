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
    /// The scheme of one mask, or the tensor product of two.
    ///
    /// # Panics
    /// When there is none, or more than two.
    #[must_use]
    pub fn of(masks: Vec<Mask<S>>) -> Scheme<S> {
        let count = masks.len();
        let mut masks = masks.into_iter();
        match (masks.next(), masks.next(), masks.next()) {
            (Some(only), None, _) => Scheme::Curve(only),
            (Some(first), Some(second), None) => Scheme::Tensor(first, second),
            _ => panic!("a scheme of {count} masks; there are one or two"),
        }
    }

    /// The masks, one per direction.
    #[must_use]
    pub fn masks(&self) -> Vec<&Mask<S>> {
        match self {
            Scheme::Curve(mask) => vec![mask],
            Scheme::Tensor(first, second) => vec![first, second],
        }
    }
}

/// The mask of a scheme for curves.
impl TryFrom<Scheme> for Mask {
    type Error = Scheme;
    fn try_from(scheme: Scheme) -> Result<Mask, Scheme> {
        match scheme {
            Scheme::Curve(mask) => Ok(mask),
            tensor @ Scheme::Tensor(..) => Err(tensor),
        }
    }
}
