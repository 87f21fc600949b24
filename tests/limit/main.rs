//! Limits and distances: against deep refinement, against closed forms, and
//! against what polygons do.

mod changes;
#[path = "../common/mod.rs"]
mod common;
mod distances;
mod far;
mod polygons;
mod refused;
mod rings;
mod surfaces;
mod values;
