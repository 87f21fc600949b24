//! Hexahedral meshes: files, validity, refinement by Bajaj's scheme, limit points.
//!
//! A solid is cut into hexahedra. Bajaj's scheme divides each into eight and smooths: inside, a point
//! moves to the mean of the centroids of the hexahedra around it, and at the boundary to that of the
//! quadrilaterals of the boundary. So the boundary is refined by the rules `bajaj` of the catalogue,
//! whatever is inside. Around points of eight hexahedra the limit is a tricubic B-spline.
//!
//! | item | what it is |
//! |---|---|
//! | [`read_solid`], [`SolidFormat`], [`SolidFile`] | VTK and MEDIT files, with the place of every error |
//! | [`HexMesh`] | points and hexahedra that make up a solid |
//! | [`refine_solid`], [`solid_limit_points`] | refined meshes, and where vertices go |
//! | [`to_vtk`], [`to_medit`], [`solid_to_json`] | meshes as text |
//!
//! Distances of solids from their limits are in [`patch`](crate::patch). Sharp edges and other tags are
//! not supported: the boundary is smooth everywhere.

mod average;
mod check;
mod complex;
mod cube;
mod error;
mod hexes;
mod limit;
mod read;
mod refine;
mod write;

pub(crate) use average::{refined_points, split_points};
pub(crate) use complex::Complex;
pub(crate) use cube::FACES;
pub use error::SolidError;
pub use hexes::{HexMesh, SolidBoundary};
pub(crate) use limit::limit_rows;
pub use limit::solid_limit_points;
pub use read::{SolidFile, SolidFormat, read_solid};
pub use refine::refine_solid;
pub(crate) use refine::{check_bits, part_corners};
pub use write::{solid_to_json, to_medit, to_vtk};

pub use crate::mesh::MAX_POINTS;

/// The name of Bajaj's scheme, which is that of the rules at the boundary in the catalogue.
pub const SOLID_SCHEME: &str = "bajaj";

/// The highest level to which solids are refined.
pub const MAX_SOLID_LEVEL: u32 = 12;

/// The most hexahedra at a point.
pub const MAX_CELLS_AT_POINT: usize = 64;
