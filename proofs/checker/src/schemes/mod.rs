//! Schemes: the catalogue, masks and rules around vertices, and products of their sequences.

mod catalogue;
mod convolution;
mod factors;
mod families;
mod family;
mod lattice;
mod laurent;
mod library;
mod limits;
mod local_rules;
mod orbits;
mod powers;
mod products;
mod quotient;
mod reference;
mod scheme;
mod symbol;
mod tables;
mod typed;

pub use catalogue::catalogue;
pub use convolution::{Convolution, MAX_LENGTH, Product, Sequence, Sums};
pub use family::{Every, Factor, Family};
pub use lattice::{Dilation, Lattice, Vector, is_lattice, plus, times, variables};
pub use library::{Constant, Library, Named};
pub use limits::Conditions;
pub use local_rules::{LocalRules, VALENCE_NAMES, less};
pub use powers::{Operator, PLACES};
pub use reference::names;
pub use scheme::{Integrals, MAX_OFFSET, Ring, Scheme};
pub use tables::ROOTS;
