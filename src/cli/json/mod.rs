//! The JSON forms of what commands about schemes write. The documentation of the types is their
//! schema, as in [`subcert::report::json`] for papers.

pub(super) mod depth;
pub(super) mod geometric_depth;
pub(super) mod listing;
pub(super) mod mesh_depth;

pub(super) use subcert::report::json::SCHEMA;
