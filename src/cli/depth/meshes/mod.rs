//! The depth of meshes, nets and solids.

mod as_sets;
mod face_depths;
mod faces;
mod kind;
mod lattice;
mod mesh;
mod net;
mod parametric;
mod pictures;
mod promise;
mod refined;
mod solid;
mod subject;

#[cfg(feature = "schema")]
pub(in crate::cli) use as_sets::SetDepth;
pub(super) use mesh::mesh_depth;
pub(super) use net::net_depth;
#[cfg(feature = "schema")]
pub(in crate::cli) use parametric::ParametricDepth;
pub(super) use solid::solid_depth;
