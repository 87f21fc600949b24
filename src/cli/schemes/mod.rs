//! The schemes of the catalogue: `subcert schemes`, `scheme`, `atlas` and `plot`.

mod atlas;
mod atlas_pages;
mod compare;
mod lattice;
mod list;
mod numbers;
mod plot;
mod scheme;
mod words;

pub(super) use atlas::atlas;
pub(super) use list::schemes;
pub(super) use plot::plot;
pub(super) use scheme::scheme;
#[cfg(feature = "schema")]
pub(super) use {atlas::Atlas, compare::Comparison, list::Catalogue, scheme::Scheme};
