//! The JSON forms of what commands about schemes write. The documentation of the types is their
//! schema, as in [`subcert::report::json`] for papers.

pub(super) mod certify;
pub(super) mod constants;
pub(super) mod depth;
pub(super) mod flags;
pub(super) mod geometric_depth;
pub(super) mod listing;
pub(super) mod mesh_depth;
pub(super) mod offset;
pub(super) mod range;
pub(super) mod schemes;
pub(super) mod smoothness;
pub(super) mod spectrum;
pub(super) mod vertex;

/// The version of the JSON form.
pub(super) const SCHEMA: u32 = 1;
