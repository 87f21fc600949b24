//! Control data: polygons, nets and rings, their refinement, and witnesses.

pub mod displacement;
pub mod functional;
pub mod polygon;
pub mod setting;
pub mod witness;
