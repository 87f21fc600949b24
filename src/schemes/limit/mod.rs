//! Exact limits of curve schemes, tensor products and rings, and exact distances of
//! polygons, nets and rings from their limits.
//!
//! The underlying theorems, with hypotheses and proofs, are in `proofs/THEOREMS.md`;
//! comments cite them by number.

mod cell;
mod comparison;
mod convergence;
mod depth;
mod distance;
mod error;
mod far;
mod fraction;
mod functional;
mod local_distance;
mod local_rules;
mod natural;
mod overshoot;
mod parameter;
mod points;
mod polygon;
mod remainder;
mod row;
mod search;
mod step;
mod summit;
mod surface;
mod surface_axis;
mod surface_search;
mod value;
mod window;

pub use comparison::{Comparison, Witness};
pub use convergence::first_contraction;
pub use depth::TwoSidedDepth;
pub use distance::{Distance, Distances, MAX_CELLS};
pub use error::{LimitError, MAX_LEVEL, MAX_OFFSET, MAX_PARAMETER_DIGITS, MAX_PERIOD, MAX_WINDOW};
pub use far::FarPolygon;
pub use functional::{ExtremalPolygon, Functional, rule_at};
pub use local_distance::{LocalDepth, LocalDistances, LocalWitness, least_flows};
pub use local_distance::{minus, unit};
pub use local_rules::{LocalLimit, LocalLimitError};
pub use natural::{NaturalShift, Parametrisation, natural_shift};
pub use overshoot::{Later, Overshoots};
pub use overshoot::{Overshoot, Shown};
pub use parameter::is_fraction;
pub use points::Points;
pub use points::{Combination, LimitWeights};
pub use polygon::ControlPolygon;
pub use remainder::second_contraction_constants;
pub use step::step_supremum;
pub use step::{Attained, greatest_change, greatest_difference, greatest_step, greatest_step_from};
pub use surface::{MAX_NET_POINTS, Spreads, SurfaceDistances, SurfaceError, SurfaceWitness};
pub use value::Limit;
pub use window::{Window, determined};
