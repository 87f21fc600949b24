//! Refinement around one vertex, until no edge there has a sharpness that falls.

use super::super::connectivity::Connectivity;
use super::super::crease::{Sharpness, Tags};
use super::super::error::MeshError;
use super::super::polygon::PolygonMesh;
use super::super::refine::refine_mesh;
use super::super::scheme::MeshScheme;
use super::super::star::Star;
use crate::exact::RealCyclotomic;
use std::collections::{BTreeMap, BTreeSet, HashMap};

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
    let own = connectivity.star(vertex).faces;
    let inner: BTreeSet<usize> =
        own.iter().flat_map(|&face| &mesh.faces()[face]).copied().collect();
    let faces: BTreeSet<usize> =
        inner.iter().flat_map(|&point| connectivity.star(point).faces).collect();
    let mut points = Vec::new();
    // The inner points first; then the others, one for each run of faces around them, since those
    // need not hang together.
    let mut numbers: HashMap<(usize, usize), usize> = HashMap::new();
    let outer: BTreeSet<usize> =
        faces.iter().flat_map(|&face| &mesh.faces()[face]).copied().collect();
    for &point in inner.iter().chain(outer.difference(&inner)) {
        for run in runs(&connectivity.star(point), &faces) {
            numbers.extend(run.into_iter().map(|face| ((point, face), points.len())));
            points.push(mesh.points()[point].clone());
        }
    }
    let number = |face: usize| {
        mesh.faces()[face].iter().map(|&point| numbers[&(point, face)]).collect::<Vec<usize>>()
    };
    let part = PolygonMesh::new(points, faces.iter().map(|&face| number(face)).collect())?;
    let tags = tags(mesh, &part, &faces, &numbers)?;
    Ok((part.with_tags(tags), numbers[&(vertex, own[0])]))
}

/// The faces of a star that are among these, in runs that hang together by edges at the vertex.
fn runs(star: &Star, faces: &BTreeSet<usize>) -> Vec<Vec<usize>> {
    let mut runs: Vec<Vec<usize>> = Vec::new();
    let mut open = false;
    for face in &star.faces {
        let kept = faces.contains(face);
        match runs.last_mut().filter(|_| open && kept) {
            Some(run) => run.push(*face),
            None if kept => runs.push(vec![*face]),
            None => {}
        }
        open = kept;
    }
    let ends = [star.faces.first(), star.faces.last()];
    let around = !star.boundary && ends.iter().all(|end| end.is_some_and(|f| faces.contains(f)));
    if around && runs.len() > 1 {
        let last = runs.pop().unwrap_or_default();
        runs[0].extend(last);
    }
    runs
}

/// The tags of the edges and points of a part.
fn tags(
    mesh: &Mesh,
    part: &Mesh,
    faces: &BTreeSet<usize>,
    numbers: &HashMap<(usize, usize), usize>,
) -> Result<Tags, MeshError> {
    let (connectivity, old): (&Connectivity, &Tags) = (mesh.connectivity(), mesh.tags());
    let mut tags = Tags::default();
    (tags.boundary, tags.creasing) = (old.boundary, old.creasing);
    let faces: Vec<usize> = faces.iter().copied().collect();
    for (index, edge) in part.connectivity().edges().iter().enumerate() {
        let before = connectivity.face_edges(faces[edge.face.0])[edge.face.1];
        tags.set_edge(index, old.edges().get(&before).cloned());
    }
    let points: BTreeMap<usize, usize> =
        numbers.iter().map(|(&(point, _), &number)| (number, point)).collect();
    for (number, point) in points {
        tags.corner(part.connectivity(), number, old.vertices().get(&point).cloned())?;
    }
    Ok(tags)
}
