//! Intervals around real numbers, and what they print as.

pub(super) mod enclosure;
pub mod format;
pub(super) mod log_sum;
pub(super) mod logarithm;
