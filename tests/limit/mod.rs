//! Limits and distances: against deep refinement, against closed forms, and
//! against what polygons do.

mod changes;
mod distances;
mod far;
mod polygons;
mod refused;
mod rings;
mod surfaces;
mod values;
