//! Real numbers in relations: roots, eigenvalues and what is known by bounds only.

#![warn(clippy::arithmetic_side_effects)]

mod compare;
mod evaluate;
mod known;
mod masks;
mod size;

pub use compare::{Pair, pair};
