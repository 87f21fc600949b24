//! Surfaces at an extraordinary vertex or on an extraordinary face (proofs/format/smoothness.md, Vertices and faces).

// Numbers with proven errors, linear equations and polynomials.
mod ball;
mod bernstein;
mod equations;

// The regular parts, the rules, and the ring of an eigenvector.
mod inner;
mod lattice;
mod net;
mod pieces;
mod spectrum;

mod check;

pub use bernstein::halved;
pub use check::{Found, check_vertex};
