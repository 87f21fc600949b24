//! Contraction constants, displacement, error bounds, subdivision depth.

mod algebraic_depth;
mod branch;
mod constants;
mod contraction;
mod convolution;
mod delta;
mod depth;
mod displacement;
mod parameter_range;
mod ring;
mod ring_power;
mod sound;
mod surface;
mod transport;
mod walk;

pub use algebraic_depth::log_level_algebraic;
pub use branch::{
    Closed, JointSearch, Leaf, MAX_LEVELS, PowerSearch, SearchTree, Searched, SearchedOperator,
    UniformBound,
};
pub use constants::{Constants, Operator, Suprema};
pub use contraction::{
    ClassCap, MAX_CLASSES, Order, PowerNorm, joint_norm, power_norm, power_norm_generic,
    walked_joint_norm, walked_norm,
};
pub use convolution::{Recursion, convolution_coefficient, convolution_window, sequence};
pub use delta::DeltaCondition;
pub use depth::{DepthError, MAX_DEPTH, Rounded, least_level, log_level};
pub use displacement::{Terms, best_offset, displacement};
pub use parameter_range::{
    MAX_RANGE_WORK, ParameterRange, RangeError, joint_norm_function_on, norm_below, norm_function,
    norm_function_on, polynomial_rules,
};
pub use ring::{RingConstants, RingLevel};
pub use ring_power::{MAX_RING_WORK, RingWork};
pub(crate) use ring_power::{displaced_rows, power_rows};
pub use sound::{SoundBound, SoundDepth};
pub use surface::{surface_coefficients, surface_displacement, surface_factor};
pub use transport::{Transport, transport, transport_at_costs};
