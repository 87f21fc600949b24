//! Polygon meshes: files, validity, refinement, limit points.
//!
//! A control mesh is read exactly: a decimal is read as a fraction. Whole meshes are refined by the
//! rules that the catalogue has for a vertex or a face, and by the published rules at the
//! boundary. Limit points and normals are exact too.
//!
//! | item | what it is |
//! |---|---|
//! | [`read_mesh`], [`read_welded_mesh`], [`read_binary_mesh`], [`MeshFormat`], [`MeshFile`] | OBJ, OFF, PLY, STL, USD, VTK and MEDIT files, with the place of every error |
//! | [`PolygonMesh`], [`Connectivity`] | points and faces; edges, boundary, the faces around a vertex in order |
//! | [`MeshScheme`], [`refine_mesh`] | Catmull–Clark, Doo–Sabin and Loop on whole meshes |
//! | [`limit_points`], [`LimitPoint`], [`NoNormal`] | where vertices go, and the normal of the limit surface there, or why there is none |
//! | [`to_obj`], [`to_off`], [`to_ply`], [`to_stl`], [`to_usda`], [`to_json`] | meshes as text |
//! | [`Tags`], [`Sharpness`], [`VertexBlend`] | creases, corners, holes and boundaries, and the rules that follow from them |
//! | [`Texture`] | texture coordinates, which are refined linearly on each face |

mod connectivity;
mod crease;
mod error;
mod field;
mod limit;
mod point;
mod polygon;
mod read;
mod refine;
mod region;
mod root;
mod scheme;
mod star;
mod stencil;
mod texture;
mod write;

pub use connectivity::{Connectivity, Edge};
pub use crease::{Boundary, Creasing, INFINITE_FROM, Sharpness, Tags, VertexBlend, VertexMask};
pub use error::MeshError;
pub(crate) use field::{check_common_field, check_rules, check_tags};
pub(crate) use limit::limit_weights;
pub use limit::{LimitPoint, NoNormal, Normal, Sector, Tangents, limit_points, without_normals};
pub use point::Point;
pub(crate) use point::combination;
pub use polygon::PolygonMesh;
pub(crate) use read::{About, Denominator, Medit, Parts, Places, medit, vtk_cell, vtk_solid};
pub use read::{
    MAX_FILE_BYTES, MeshFile, MeshFormat, read_binary_mesh, read_mesh, read_welded_mesh,
};
pub use refine::{MAX_MESH_LEVEL, refine_mesh};
pub(crate) use refine::{step_with, weighted_valences};
pub(crate) use region::{cut, groups, grown};
pub use scheme::MeshScheme;
pub use star::Star;
pub(crate) use stencil::{Stencils, ring};
pub use texture::Texture;
pub use write::{BeyondF64, to_json, to_obj, to_off, to_ply, to_stl, to_usda};
pub(crate) use write::{decimals, list, numbers, one_line};

/// The most points of a mesh, refined or not.
pub const MAX_POINTS: usize = 1_000_000;

/// The greatest valence of a vertex, and the most vertices of a face, that rules are computed for.
pub const MAX_VALENCE: usize = 256;
