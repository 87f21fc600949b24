//! The JSON forms of what commands about schemes write. The documentation of the types is their
//! schema, as in [`subcert::report::json`] for papers.

pub(super) mod listing;

pub(super) use subcert::report::json::SCHEMA;
