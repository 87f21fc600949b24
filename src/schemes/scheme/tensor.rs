//! Schemes of one mask for curves, and of two for surfaces.

use super::mask::Mask;
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
    /// When there are no masks, or more than two.
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
