//! What pieces have in common, whatever their points are: neighbourhoods, weights, bounds.

pub(super) mod bezier;
pub(super) mod convergence;
pub(super) mod fans;
pub(super) mod library;
pub(super) mod neighbourhood;
pub(super) mod regular;
pub(super) mod ring;
pub(super) mod rules;
pub(super) mod scheme;
pub(super) mod shape;
pub(super) mod surroundings;
