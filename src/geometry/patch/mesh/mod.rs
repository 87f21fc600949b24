//! Meshes and solids as pieces.

pub(super) mod apriori;
pub(super) mod distances;
pub(super) mod formula;
pub(super) mod levels;
pub(super) mod model;
pub(super) mod piece;
pub(super) mod roots;
pub(super) mod search;
