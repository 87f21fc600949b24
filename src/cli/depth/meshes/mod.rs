//! The depth of meshes, nets and solids.

mod faces;
mod geometric;
mod kind;
mod mesh;
mod net;
mod pictures;
mod promise;
mod refined;
mod solid;

pub(super) use mesh::mesh_depth;
pub(super) use net::net_depth;
pub(super) use solid::solid_depth;
