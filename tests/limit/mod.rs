//! Limits and distances: against deep refinement, against closed forms, and
//! against what polygons do.

mod changes;
mod distances;
mod far;
mod local_rules;
mod natural;
mod open;
mod polygons;
mod refused;
mod surfaces;
mod values;
