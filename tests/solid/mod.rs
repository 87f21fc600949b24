//! Hexahedral solids: files, validity, refinement and limit points.

mod laws;
mod naive;
mod read;
mod validity;
