//! Exact limits of curve schemes, tensor products and rings, and exact distances of
//! polygons, nets and rings from their limits.
//!
//! The underlying theorems, with hypotheses and proofs, are in `proofs/THEOREMS.md`;
//! comments cite them by number.

mod convergence;
mod distances;
mod error;
mod extremes;
mod functional;
mod natural;
mod parameter;
mod points;
mod rings;
mod row;
mod surfaces;
mod value;
mod window;

pub use convergence::first_contraction;
pub use distances::comparison::{Comparison, Witness};
pub use distances::depth::TwoSidedDepth;
pub use distances::distance::{Distance, Distances, MAX_CELLS};
pub use distances::polygon::ControlPolygon;
pub use distances::remainder::second_contraction_constants;
pub use error::{LimitError, MAX_LEVEL, MAX_OFFSET, MAX_PARAMETER_DIGITS, MAX_PERIOD, MAX_WINDOW};
pub use extremes::far_polygon::FarPolygon;
pub use extremes::overshoot::{Later, Overshoot, Overshoots, ProofOfGreatest};
pub use extremes::step::{
    Attained, greatest_change, greatest_difference, greatest_step, greatest_step_from,
    step_supremum,
};
pub use extremes::supremum::{greatest_of_bounded, greatest_of_step};
pub use functional::{ExtremalPolygon, Functional, rule_at};
pub(crate) use natural::rule_shifts;
pub use natural::{NaturalShift, Parametrisation, natural_shift};
pub use parameter::is_fraction;
pub use points::{Combination, LimitWeights, Points};
pub use rings::distance::{LocalDepth, LocalDistances, LocalWitness};
pub use rings::flows::{least_flows, minus, unit};
pub use rings::limit::{LocalLimit, LocalLimitError};
pub use surfaces::surface::{
    MAX_NET_POINTS, Spreads, SurfaceDistances, SurfaceError, SurfaceWitness,
};
pub use value::Limit;
pub use window::{Window, determined};
