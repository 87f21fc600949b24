//! A piece with what is around it, whatever its points are.

use super::neighbourhood::Neighbourhood;
use super::rules::{Local, Rules};
use super::scheme::PieceScheme;
use crate::patch::hexes::{HexLocal, Layers, parts_of};
use crate::patch::number::Number;

/// The faces or the cells around a piece.
pub(crate) enum Surroundings {
    Surface(Local),
    Solid(HexLocal),
}

impl Surroundings {
    pub(crate) fn new(scheme: PieceScheme, neighbourhood: &Neighbourhood) -> Surroundings {
        match scheme {
            PieceScheme::Surface(scheme) => {
                Surroundings::Surface(Local::new(scheme, neighbourhood))
            }
            PieceScheme::Solid => {
                Surroundings::Solid(HexLocal::new(neighbourhood.points.len(), &neighbourhood.faces))
            }
        }
    }

    /// The layers of a piece of a solid that is the same in each.
    pub(crate) fn layers(&self) -> Option<&Layers> {
        match self {
            Surroundings::Surface(_) => None,
            Surroundings::Solid(local) => local.layers.as_ref(),
        }
    }

    /// The neighbourhoods of the parts of the piece at the next level.
    pub(crate) fn parts(&self) -> Vec<Neighbourhood> {
        match self {
            Surroundings::Surface(local) => {
                let refined = local.refined();
                let parts = local.parts(&refined).into_iter();
                let (connectivity, tags) = (refined.connectivity(), refined.tags());
                parts.map(|piece| Neighbourhood::of(connectivity, tags, piece)).collect()
            }
            Surroundings::Solid(local) => parts_of(&local.complex),
        }
    }

    /// The weights, where the parts need these points of the next level.
    pub(crate) fn rules<W: Number>(&self, wanted: &[usize], parts: &[Vec<usize>]) -> Rules<W> {
        match self {
            Surroundings::Surface(local) => local.rules(wanted),
            Surroundings::Solid(local) => local.rules(wanted, parts),
        }
    }
}
