//! Refinement around one vertex, until no edge there has a sharpness that falls.

use super::super::crease::Sharpness;
use super::super::error::MeshError;
use super::super::polygon::PolygonMesh;
use super::super::refine::refine_mesh;
use super::super::region::{cut, grown};
use super::super::scheme::MeshScheme;
use super::super::star::Star;
use crate::exact::RealCyclotomic;

type Mesh = PolygonMesh<RealCyclotomic>;

/// Whether the sharpness of the vertex or of an edge there is finite.
pub(super) fn falls<S>(mesh: &PolygonMesh<S>, vertex: usize, star: &Star) -> bool {
    let tags = mesh.tags();
    let finite = |sharp: Option<&Sharpness>| sharp.is_some_and(|sharp| sharp.finite().is_some());
    tags.has_sharp()
        && (finite(tags.vertex(vertex, star))
            || star.edges.iter().any(|&edge| finite(tags.edge(mesh.connectivity(), edge))))
}

/// The faces around a vertex at the first level at which nothing falls there, and the number of the
/// vertex in it.
///
/// The limit of a vertex does not change with the level. A new point around it depends on the
/// faces that have a point of a face of the vertex: two rings. The new two rings are made of
/// the first old one.
pub(super) fn settled(
    mesh: &Mesh,
    vertex: usize,
    scheme: MeshScheme,
) -> Result<(Mesh, usize), MeshError> {
    let (mut part, mut at) = two_rings(mesh, vertex)?;
    while falls(&part, at, &part.connectivity().star(at)) {
        let refined = refine_mesh(&part, scheme, 1)?;
        (part, at) = two_rings(&refined, at)?;
    }
    Ok((part, at))
}

/// The faces that have a point of a face of the vertex, as a mesh.
fn two_rings(mesh: &Mesh, vertex: usize) -> Result<(Mesh, usize), MeshError> {
    let connectivity = mesh.connectivity();
    let mut faces = grown(connectivity, &connectivity.star(vertex).faces, 1);
    // In their order, so that faces go around a vertex from the same one on.
    faces.sort_unstable();
    let (part, origins) = cut(mesh, &faces)?;
    let at = origins.iter().position(|origin| *origin == vertex);
    Ok((part, at.expect("the vertex is one of its faces")))
}
