//! Control data: polygons, nets and rings, their refinement, and witnesses.

mod displacement;
mod functional;
mod polygon;
mod setting;
mod witness;

pub use displacement::{best_offset, gather, moved, surface};
pub use functional::Rules;
pub use polygon::Polygon;
pub use setting::{MAX_CLASSES, Setting, contracts, converges, converges_on};
pub use witness::{Points, Witness, violated};
