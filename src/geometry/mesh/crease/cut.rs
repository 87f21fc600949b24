//! Meshes with sharp creases as meshes with boundaries.

use super::super::connectivity::Connectivity;
use super::super::error::MeshError;
use super::super::polygon::PolygonMesh;
use super::super::star::Star;
use super::sharpness::Sharpness;
use super::tags::Tags;

/// A mesh without tags whose limit, and whose levels, are the same sets of points.
///
/// An infinitely sharp crease has the rules of a boundary, and what is on one side of it does not depend on the other
/// side. So the mesh is cut along its creases: the faces are the same ones in the same order, and a vertex on a crease
/// has a copy for the second of its two sectors, after all vertices.
///
/// Source: `proofs/THEOREMS.md`, 169.
///
/// # Errors
/// When something else is said of the mesh: a finite sharpness, a corner, the end of a crease, a hole.
pub(crate) fn cut_at_creases<S: Clone>(mesh: PolygonMesh<S>) -> Result<PolygonMesh<S>, MeshError> {
    let (tags, connectivity) = (mesh.tags(), mesh.connectivity());
    if tags.is_plain() {
        return Ok(mesh);
    }
    check(tags, connectivity)?;
    let (mut points, mut faces) = (mesh.points().to_vec(), mesh.faces().to_vec());
    for vertex in 0..connectivity.point_count() {
        let star = connectivity.star(vertex);
        let sharp = check_vertex(tags, connectivity, vertex, &star)?;
        let [first, second] = sharp[..] else { continue };
        if star.boundary {
            continue;
        }
        points.push(mesh.points()[vertex].clone());
        for i in first..second {
            faces[star.faces[i]][star.corners[i]] = points.len() - 1;
        }
    }
    PolygonMesh::new(points, faces)
}

fn check(tags: &Tags, connectivity: &Connectivity) -> Result<(), MeshError> {
    let holes = tags.holes(connectivity);
    if let Some(&face) = holes.first() {
        let reason = "distances are not bounded for meshes with holes, as faces at a boundary `none` are; take \
                      another boundary, or remove the face";
        return Err(MeshError::Face { face, reason: reason.to_owned() });
    }
    let finite = tags.edges().iter().find(|(_, sharp)| **sharp != Sharpness::Infinite);
    if let Some((&edge, sharp)) = finite {
        let point = connectivity.edges()[edge].ends[0];
        let reason = format!(
            "an edge here has the sharpness {sharp}: distances are bounded for infinitely sharp creases, of sharpness 10 and \
             more; refine the mesh until it has fallen"
        );
        return Err(MeshError::Vertex { point, reason });
    }
    Ok(())
}

/// The places of the sharp edges around a vertex: none or two.
fn check_vertex(
    tags: &Tags,
    connectivity: &Connectivity,
    vertex: usize,
    star: &Star,
) -> Result<Vec<usize>, MeshError> {
    let is_sharp = |&place: &usize| tags.edge(connectivity, star.edges[place]).is_some();
    let sharp: Vec<usize> = (0..star.edges.len()).filter(is_sharp).collect();
    let what = match sharp.len() {
        _ if tags.vertex(vertex, star).is_some() => "this vertex is sharp by itself".to_owned(),
        0 | 2 => return Ok(sharp),
        1 => "a crease ends at this vertex".to_owned(),
        count => format!("{count} creases and boundary edges meet at this vertex, a corner"),
    };
    let reason = format!(
        "{what}: distances are bounded for creases without ends and corners; remove the tag, or ask `subcert refine` \
         and `subcert limit`"
    );
    Err(MeshError::Vertex { point: vertex, reason })
}
