//! Contraction constants, displacement, error bounds, subdivision depth.

mod algebraic_depth;
mod branch;
mod budget;
mod constants;
mod convolution;
mod delta;
mod depth;
mod displacement;
mod extreme;
mod local_power;
mod local_rules;
mod norm;
mod norm_function;
mod parameter_range;
mod parametric_rows;
mod power;
mod sound;
mod surface;
mod transport;
mod walk;
mod walked_norm;

pub use algebraic_depth::log_level_algebraic;
pub use branch::{
    Closed, JointSearch, Leaf, PowerSearch, SearchTree, Searched, SearchedOperator, UniformBound,
};
pub use budget::Budget;
pub(crate) use budget::Share;
pub use constants::{Constants, Operator, Suprema};
pub use convolution::{Recursion, convolution_coefficient, convolution_window, sequence};
pub use delta::DeltaCondition;
pub use depth::{DepthError, MAX_DEPTH, Rounded, least_level, log_level};
pub use displacement::{BetterOffset, Terms, best_offset, displacement};
pub use local_power::{LocalWork, MAX_LOCAL_WORK};
pub(crate) use local_power::{displaced_rows, power_rows};
pub use local_rules::{LocalConstants, LocalLevel};
pub use norm::{joint_norm, power_norm};
pub use norm_function::{joint_norm_function_on, norm_function, norm_function_on};
pub use parameter_range::{ParameterRange, norm_below};
pub use parametric_rows::{MAX_RANGE_WORK, RangeError, polynomial_rules};
pub use power::{ClassCap, MAX_CLASSES, MAX_LEVELS, MAX_WORK, Order, PowerNorm};
pub use sound::{SoundBound, SoundDepth};
pub use surface::{surface_coefficients, surface_displacement, surface_factor};
pub use transport::{Transport, transport, transport_at_costs};
pub use walk::levels_within;
pub(crate) use walk::steps_of_visit;
pub use walked_norm::{power_norm_generic, walked_joint_norm, walked_norm};
