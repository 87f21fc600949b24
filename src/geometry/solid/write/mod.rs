//! Solids as text.

mod json;
mod medit;
mod vtk;

pub use json::solid_to_json;
pub use medit::to_medit;
pub use vtk::to_vtk;
