//! Masks on Z^d.

mod examples;
mod laws;
mod smoothness;
mod typing;
