//! Bounds: constants against explicit sequences and matrix powers, and what they
//! promise against exactly subdivided data.

mod branch;
mod constants;
mod convolution;
mod depth;
mod displacement;
mod extreme;
mod local_rules;
mod norm;
mod parameter_range;
mod row_bounds;
mod search_tree;
mod sound;
mod surface;
mod transport;
