//! Polygon meshes: files, validity, refinement, limit points.
//!
//! A control mesh is read exactly: a decimal is read as a fraction. Whole meshes are refined by the
//! rules that the catalogue has for a vertex or a face, and by the published rules at the
//! boundary. Limit points and normals are exact too.
//!
//! | item | what it is |
//! |---|---|
//! | [`read_mesh`], [`MeshFormat`], [`MeshFile`] | OBJ, OFF and PLY files, with the place of every error |
//! | [`PolygonMesh`], [`Connectivity`] | points and faces; edges, boundary, the faces around a vertex in order |
//! | [`MeshScheme`], [`refine_mesh`] | Catmull–Clark, Doo–Sabin and Loop on whole meshes |
//! | [`limit_points`], [`LimitPoint`] | where vertices go, and the normal of the limit surface there |
//! | [`to_obj`], [`to_ply`], [`to_json`] | meshes as text |
//!
//! Creases, corners and other tags are not supported: a boundary is smooth, and there are no
//! sharp edges inside.

mod connectivity;
mod error;
mod field;
mod limit;
mod point;
mod polygon;
mod read;
mod refine;
mod root;
mod scheme;
mod star;
mod stencil;
mod write;

pub use connectivity::{Connectivity, Edge};
pub use error::MeshError;
pub(crate) use field::{check_field, check_rules};
pub(crate) use limit::loop_limit_weights;
pub use limit::{LimitPoint, Normal, limit_points};
pub use point::Point;
pub use polygon::PolygonMesh;
pub(crate) use read::parse_coordinate;
pub(crate) use read::{About, Lines, Parts, Places, Word};
pub use read::{MAX_FILE_BYTES, MeshFile, MeshFormat, read_mesh};
pub use refine::{MAX_MESH_LEVEL, refine_mesh};
pub(crate) use refine::{step_with, weighted_valences};
pub use scheme::MeshScheme;
pub use star::Star;
pub(crate) use stencil::Stencils;
pub use write::{BeyondF64, to_json, to_obj, to_ply};
pub(crate) use write::{decimals, list, numbers, one_line};

/// The most points of a mesh, refined or not.
pub const MAX_POINTS: usize = 1_000_000;

/// The greatest valence of a vertex, and the most vertices of a face, that rules are computed for.
pub const MAX_VALENCE: usize = 256;
