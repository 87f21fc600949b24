//! Polygons, meshes, nets and solids of files: `subcert refine`, `limit` and `oracle`.

pub(super) mod commands;
pub(super) mod mesh;
mod mesh_form;
pub(super) mod mesh_input;
pub(super) mod net;
mod oracle;
pub(super) mod polygon;
pub(super) mod solid;

pub(super) use commands::limit;
pub(super) use commands::refine;
pub(super) use oracle::oracle;
