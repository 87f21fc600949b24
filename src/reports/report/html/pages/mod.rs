//! Whole pages.

pub(super) mod atlas;
pub(super) mod depth;
pub(super) mod explain;
pub(super) mod finding;
pub(super) mod index;
pub(super) mod page;
pub(super) mod plot;
pub(super) mod ring;
pub(super) mod shipped;
