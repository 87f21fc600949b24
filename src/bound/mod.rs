//! Contraction constants, displacement, error bounds, subdivision depth.

mod algebraic_depth;
mod constants;
mod contraction;
mod convolution;
mod delta;
mod depth;
mod displacement;
mod sound;
mod surface;
mod walk;

pub use algebraic_depth::log_level_algebraic;
pub use constants::{Constants, Operator, Suprema};
pub use contraction::{
    ClassCap, MAX_CLASSES, Order, PowerNorm, joint_norm, power_norm, power_norm_generic,
};
pub use convolution::{Recursion, convolution_coefficient, convolution_window, sequence};
pub use delta::DeltaCondition;
pub use depth::{DepthError, MAX_DEPTH, Rounded, least_level, log_level};
pub use displacement::{Terms, best_offset, displacement};
pub use sound::{SoundBound, SoundDepth};
pub use surface::{surface_coefficients, surface_displacement, surface_factor};
