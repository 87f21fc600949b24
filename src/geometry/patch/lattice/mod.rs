//! How far a net in the plane is from the limit of a mask on Z², for any dilation matrix (`proofs/THEOREMS.md`, 153).
//!
//! A piece is a unit square of the indices of a level. The distance of two levels there is greatest at a corner of their pieces; later levels are
//! within a bound by second differences of points nearby.

mod corners;
mod distances;
mod levels;
mod points;
mod quotients;
mod search;
mod square;
mod tail;

pub use distances::LatticeNetDistances;
