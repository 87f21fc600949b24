//! Masks on Z^d.

mod distance;
mod examples;
mod laws;
mod range;
mod smoothness;
mod typing;
