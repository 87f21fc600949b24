//! Certificates that the program writes, and the checker.

mod constants;
mod coq;
mod depth;
mod levels;
mod papers;
mod printed;
mod relations;
mod smoothness;
mod symbols;
mod theorems;
mod vertex;
mod vertex_range;
