//! Schemes: the catalogue, masks and rules around vertices, and products of their sequences.

pub mod catalogue;
pub mod convolution;
pub mod library;
pub mod local_rules;
pub mod orbits;
pub mod powers;
pub mod products;
pub mod scheme;
